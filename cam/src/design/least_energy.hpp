// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "jounce/profiles/curve/segment.hpp"

namespace jounce::detail {

/// A knot of a piecewise polynomial: where it is, its value with two derivatives (value, u/m, u/m^2),
/// and which of them are fixed.
struct EnergyKnot {
  double master = 0;
  std::array<double, 3> state{};
  std::array<bool, 3> fixed{};
};

/// Which derivative's square is integrated, and so the degree between knots.
enum class Energy {
  acceleration,  ///< second derivative; cubics; state[2] is neither read nor set
  jerk,          ///< third derivative; quintics
};

/// Sets what is not fixed so that the energy is least. The given value of a free state[0] is where
/// it is counted from: any value will do. Periodic: the first and the last knot are one, their values
/// apart by as much as they are given. The free states must be determined: no polynomial below the
/// order of the energy may vanish in all that is fixed. (But two knots with nothing fixed except the
/// values get the straight line.)
void minimise(std::vector<EnergyKnot>& knots, Energy energy, bool periodic);

/// The segments between the knots.
std::vector<Segment> segments_between(const std::vector<EnergyKnot>& knots, Energy energy);

/// Integral of the square of the third derivative of segments of degree <= 5.
double square_jerk(const std::vector<Segment>& segments);

}  // namespace jounce::detail
