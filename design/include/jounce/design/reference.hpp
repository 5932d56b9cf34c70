// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/design/input.hpp"
#include "jounce/validate/signal_view.hpp"

namespace jounce {

/// The slave's motion over time in seconds: the trajectory itself, or a cam behind its master.
using Reference = std::variant<Trajectory, Followed>;

/// The exact curve.
Reference exact_reference(const Input& input);

/// The interpolated table, as in the executor.
Reference table_reference(const Input& input);

/// The master that a cam follows, over seconds. Throws InputError if its motion is not given.
Trajectory master_of(const Input& input);

/// The slave's exact motion over the spec's unit of time: the trajectory itself; for a cam the
/// curve behind its master, exact or within 1e-9 of the stroke (cf. composed_within).
Trajectory motion_over_time(const Input& input);

SignalView view(const Reference& reference);
double duration(const Reference& reference);
Motion at(const Reference& reference, double t);

}  // namespace jounce
