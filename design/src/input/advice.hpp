// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/design/input.hpp"

namespace jounce::design_detail {

/// Velocity of the master in units per second; 0 if none is given.
double master_speed(const Spec& spec, const EngageState& at);

/// The severity of a moving end of a cam that runs once: a warning if the slave leaves its cam there.
/// Otherwise required: a slave at rest cannot follow a moving beginning, and a slave in gear goes
/// on.
Severity judge_end(const Finding& end, const Input& input);
/// The advice for such an end: the motion of the slave after it, or the jump of a resting slave at
/// the beginning.
std::string advice_for_end(const Finding& end, const Input& input, const EngageState& at);

/// Advice for a step at an edge of the grid of a compensation, where the correction ends while the
/// motion goes on; "" for another step.
std::string advice_at_edge(const Input& input, const Finding& step);

/// Adds the number of the error with which HIMC rejects a table that breaks a limit.
void name_himc_errors(Report& report);

}  // namespace jounce::design_detail
