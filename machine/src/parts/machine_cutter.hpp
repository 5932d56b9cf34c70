// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "jounce/executor/executor_options.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce::machine_detail {

/// Returns the path of the cutter's spec, which `file` gives relative to the spec of the axis.
std::string cutter_path(const Spec& axis, const std::string& file);

/// Returns the cutter that the spec of an axis names, for the limits of both; nullopt: it names none.
/// Throws InputError with its place, for a file that is not a spec of a knife or a shear, for other
/// units than those of the axis, and for a list that the cutter cannot make at its line speed.
std::optional<ExecutorCutter> machine_cutter(const Spec& axis, const AxisConfig& config);

}  // namespace jounce::machine_detail
