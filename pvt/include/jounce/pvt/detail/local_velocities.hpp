// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace jounce::pvt_detail {

/// The pieces between knots; piece i begins at knot i.
struct Chords {
  std::span<const double> length;  ///< length of each piece in time or master position
  /// Slope of the chord of each piece (the straight line between its knots).
  std::span<const double> chord;
};

/// Returns the velocity at a knot between two pieces of lengths h0, h1 with chords d0, d1: the
/// weighted harmonic mean of Fritsch and Butland; 0 if the chords differ in sign. Its magnitude is
/// at most 3 times the magnitude of the smaller chord.
double between_chords(double h0, double d0, double h1, double d1);

/// Writes the velocities of between_chords() to v. At open ends the limited three-point formula
/// applies; if `periodic`, the last piece is the neighbor of the first.
void monotone_velocities(const Chords& chords, bool periodic, std::span<double> v);

/// True if the cubic piece with this chord and these end velocities never moves against its chord
/// (chord 0: stands still). Exact, to rounding.
bool is_monotone(double chord, double v0, double v1);

}  // namespace jounce::pvt_detail
