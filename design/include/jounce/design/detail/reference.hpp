// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/design/input.hpp"
#include "jounce/validate/signal_view.hpp"

namespace jounce {

/// The slave's motion over time in seconds: a trajectory, or a cam that follows its master.
using Reference = std::variant<Trajectory, Followed>;

/// Returns the exact motion of an input.
Reference exact_reference(const Input& input);

/// Returns the motion of the interpolated table, as the executor plays it.
Reference table_reference(const Input& input);

/// Returns the motion of the master of a cam over seconds. Throws InputError if the input is a
/// table, or its spec has no [master].
Trajectory master_of(const Input& input);

/// Returns the slave's exact motion over the spec's unit of time: the trajectory, or the curve of a
/// cam that follows its master. Exact, or within 1e-9 of the stroke (see composed_within() in
/// composed.hpp).
Trajectory motion_over_time(const Input& input);

/// Return, for a reference: a view of it, its duration (s), and its motion at t (s).
SignalView view(const Reference& reference);
double duration(const Reference& reference);
Motion at(const Reference& reference, double t);

}  // namespace jounce
