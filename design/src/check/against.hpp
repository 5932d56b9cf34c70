// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "design/src/input/against_spec.hpp"

namespace jounce::design_detail {

/// Adds the finding for the deviation of a table from its spec, and gives the broken limits of the
/// table their remedy. Requires input.against.
void judge_against(const Input& input, Report& report);

/// The warning that a table is older than the spec that its header names. Requires
/// input.newer_spec.
Finding older_table(const Input& input);

}  // namespace jounce::design_detail
