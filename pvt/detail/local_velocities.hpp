#pragma once

#include <span>

namespace jounce::detail {

/// Knots with the chords between them; chord i belongs to the piece from knot i.
struct Chords {
  std::span<const double> length;
  std::span<const double> chord;
};

/// Velocities by Fritsch and Butland's weighted harmonic mean of the chords; at open ends the
/// three-point formula, limited. Across the seam if `periodic`.
void monotone_velocities(const Chords& chords, bool periodic, std::span<double> v);

/// Whether the cubic piece with this chord and these velocities never runs against its chord (chord
/// 0: stands still). Exact, to rounding.
bool is_monotone(double chord, double v0, double v1);

}  // namespace jounce::detail
