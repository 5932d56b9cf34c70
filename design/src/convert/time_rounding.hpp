// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/profiles/curve/jet.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce::design_detail {

/// The interval with whose motion knot i of a table moves when its time is rounded: the longer one
/// beside it. A long interval keeps its motion, a dwell its rest.
std::size_t motion_of_knot(const Table& given, std::size_t i);

/// Returns for each interval of `given` the greatest rise of the magnitude of its value and its
/// derivatives if knot i moves by `moved[i]`, along the motion of motion_of_knot(). The table is
/// quintic. An interval beside a longer one begins or ends with the motion of that one, which
/// differs there from its own motion by d_p, d_v, d_a. By the formulas of Hermite, the third
/// derivative in an interval of the length L changes by at most
///
///     60 d_p / L^3 + 36 d_v / L^2 + 9 d_a / L
///
/// from each end. An interval whose knots move apart also continues its own motion beyond them.
std::vector<Jet> time_rounding(const Table& given, std::span<const double> moved);

}  // namespace jounce::design_detail
