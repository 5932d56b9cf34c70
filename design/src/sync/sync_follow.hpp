// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/spec/spec.hpp"

namespace jounce {

/// Findings of a spec of kind "follow" besides its limits: those of its tables or of its plan
/// ("follow/..."), and when it begins, if it waits for its [master] to pass a place. That master
/// starts from rest at 0. Empty for other kinds.
Report check_follow(const Spec& spec);

}  // namespace jounce
