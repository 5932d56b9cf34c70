// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/profiles/limits/limits.hpp"
#include "jounce/pvt/detail/local_velocities.hpp"

#include "pvt/src/sample/corridor.hpp"

namespace jounce::pvt_detail {

/// The direction in which a piece must turn according to the data.
enum class Turn { any, left, right, neither };

/// Velocities for which the cubic piece of this length and chord stays within the limits of
/// velocity, acceleration and jerk. All accepted velocities satisfy the limits, to rounding. Near a
/// velocity limit, up to 2 % of the rejected velocities would satisfy the limits, too.
Demand within_limits(const Limits& limits, double length, double chord);

/// The factor by which a piece between two knots must be longer, so that its demand permits some
/// velocities in `from` and `to`; infinite if no length is sufficient.
double needed_stretch(const Limits& limits, double length, double chord, Gap from, Gap to);

/// Velocities for which the piece turns left (convex) or right (concave), or is straight. `slack`
/// is the rounding of the chord.
Demand turning(Turn turn, double chord, double slack);

/// For each piece, the direction in which the data turn at both of its knots; `any` if they differ.
std::vector<Turn> turns_of(const Chords& chords, const std::vector<double>& rounding,
                           bool periodic);

/// At each knot, the velocities for which the adjacent pieces are certainly monotone: between 0 and
/// three times the smaller chord; 0 if the chords differ in sign.
std::vector<Gap> monotone_gaps(const Chords& chords, bool periodic);

}  // namespace jounce::pvt_detail
