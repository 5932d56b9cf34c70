// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/spec/spec.hpp"

namespace jounce {

/// The findings of the tables or the plan of a spec of kind "follow" ("follow/..."); they do not
/// depend on its limits. If the slave waits for its [master] to pass a position, there is a finding
/// with the time at which it begins. This master starts from rest at 0. Empty for all other kinds
/// of spec.
Report check_follow(const Spec& spec);

}  // namespace jounce
