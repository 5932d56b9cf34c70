// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace jounce::pvt_detail {

/// Knots with the chords between them; chord i belongs to the piece from knot i.
struct Chords {
  std::span<const double> length;
  std::span<const double> chord;
};

/// The velocity at a knot between pieces of lengths h0, h1 and chords d0, d1: Fritsch and Butland's
/// weighted harmonic mean, 0 if the chords differ in sign. At most 3 times the smaller one.
double between_chords(double h0, double d0, double h1, double d1);

/// Velocities by those; at open ends the three-point formula, limited. Across the seam if
/// `periodic`.
void monotone_velocities(const Chords& chords, bool periodic, std::span<double> v);

/// True if the cubic piece with this chord and these velocities never runs against its chord (chord
/// 0: stands still). Exact, to rounding.
bool is_monotone(double chord, double v0, double v1);

}  // namespace jounce::pvt_detail
