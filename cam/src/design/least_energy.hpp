// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "jounce/profiles/curve/segment.hpp"

namespace jounce::cam_detail {

/// A knot of a piecewise polynomial: its position, its value with two derivatives (value, u/m,
/// u/m^2), and flags for the fixed values.
struct EnergyKnot {
  double master = 0;
  std::array<double, 3> state{};
  std::array<bool, 3> fixed{};
};

/// The derivative in the energy integral; it sets the degree between knots.
enum class Energy {
  acceleration,  ///< second derivative; cubics; state[2] is neither read nor set
  jerk,          ///< third derivative; quintics
};

/// Sets the free states so that the energy is least. The given value of a free state[0] is used as
/// its origin and may be arbitrary. Periodic: the first and the last knot are the same, and the
/// given difference of their values is kept. The fixed states must determine the free ones: no
/// nonzero polynomial below the order of the energy may vanish in all fixed states. Exception: two
/// knots with only fixed values get the straight line.
void minimize(std::vector<EnergyKnot>& knots, Energy energy, bool periodic);

/// The segments between the knots.
std::vector<Segment> segments_between(const std::vector<EnergyKnot>& knots, Energy energy);

/// Integral of the square of the third derivative of segments of degree <= 5.
double square_jerk(const std::vector<Segment>& segments);

}  // namespace jounce::cam_detail
