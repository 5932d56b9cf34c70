// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/profiles/limits/limits.hpp"
#include "jounce/pvt/detail/local_velocities.hpp"

#include "pvt/src/sample/corridor.hpp"

namespace jounce::detail {

/// Which way a piece has to turn for the data's sake.
enum class Turn { any, left, right, neither };

/// Velocities such that the cubic piece of this length and chord keeps velocity, acceleration and
/// jerk limits. What is kept is within the limits, to rounding; of what is refused beside a velocity
/// limit up to 2 % would be within them too.
Demand within_limits(const Limits& limits, double length, double chord);

/// The factor that the length of a piece between two knots needs for its demand to be kept from some
/// velocity in `from` to some in `to`; infinite where no time is enough.
double needed_stretch(const Limits& limits, double length, double chord, Gap from, Gap to);

/// Velocities such that the piece turns left (convex), right (concave) or, straight, neither way.
/// `slack` is the rounding of the chord.
Demand turning(Turn turn, double chord, double slack);

/// For each piece how the data turn at both of its knots; where they turn either way: any.
std::vector<Turn> turns_of(const Chords& chords, const std::vector<double>& rounding,
                           bool periodic);

/// At each knot the velocities for which the pieces beside it are certain to be monotone: between 0
/// and three times the smaller chord; 0 where the chords differ in sign.
std::vector<Gap> monotone_gaps(const Chords& chords, bool periodic);

}  // namespace jounce::detail
