// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/extrema.hpp"

namespace jounce {

/// A part of a cam that leads from one slave position to another, with its properties.
/// characteristics.hpp computes the characteristic values of a rise, and certificate.hpp compares
/// them with their lower bounds.
///
///     for (const Rise& rise : rises(cam)) {
///       Characteristics c = characteristics(rise);   // Cv, Ca, Cj, Cm
///       Report best = certificates(rise);            // excess over the lower bounds
///     }
///
/// **Vocabulary.** A *rise* (or a fall) lies between two successive breaks at which the slave
/// rests, with zero velocity on both sides of each break. A dwell is not a rise, and neither is an
/// interval that returns to its start position. Positions are those of the cam: master m, slave u.
/// A rise across the end of a period continues beyond the cam's end.
///
/// "Zero" and "does not step" mean: within 1e-9 of the greatest magnitude of the derivative in the
/// rise (of the velocity: in the whole cam).
struct Rise {
  Cam cam;                ///< this part of the cam, as a cam
  std::size_t first = 0;  ///< index of its first segment in the original cam
  double stroke = 0;      ///< u, from its start to its end, signed, not 0
  /// Ranges inside the rise of the value and of four derivatives with respect to the master, by
  /// order: u, u/m, ..., u/m^4.
  std::array<Range, 5> ranges{};
  /// The greatest n (0 to 4) such that f', ..., f^(n) are zero at both ends and do not step between
  /// them.
  int smooth = 0;
  /// The greatest n (0 to 4) such that f', ..., f^(n) do not step, inside or against the neighbors.
  int continuous = 0;

  [[nodiscard]] double length() const { return cam.length(); }  ///< m
};

/// Returns all rises of a cam, in order. Outside its interval, a cam that holds is at rest, a
/// periodic cam continues at its other end, and a cam that refuses has no neighbor, so nothing
/// steps there.
std::vector<Rise> rises(const Cam& cam);

/// Returns the whole cam as one rise, for any states at its ends. Throws InputError("stroke", ...)
/// if it ends at its start position.
Rise as_rise(const Cam& law);

}  // namespace jounce
