// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/validate/follower.hpp"

namespace jounce::validate_detail {

/// Runs follow() for a follower and options that are valid, without the report.
FollowerResult run(const SignalView& lift, const SpringFollower& follower,
                   const FollowerOptions& options);

}  // namespace jounce::validate_detail
