// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/executor/executor_options.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce::machine_detail {

/// Returns the cutter that the spec of an axis names, for the limits of both; nullopt: it names none.
/// Throws InputError with its place, for a file that is not a spec of a knife or a shear, for other
/// units than those of the axis, and for a list that the cutter cannot make at its line speed.
std::optional<ExecutorCutter> machine_cutter(const Spec& axis, const AxisConfig& config);

}  // namespace jounce::machine_detail
