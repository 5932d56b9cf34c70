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
/// rests, with zero velocity on both sides of each break. Three kinds of interval are not rises: a
/// dwell; an interval at whose end the slave is back at its start position; and an interval in
/// which the slave passes an end position by more than a tenth of the stroke. The positions of
/// master (unit m) and slave (unit u) are those of the whole cam. A rise across the end of a period
/// continues beyond the cam's end. f is the slave's position as a function of the master's.
///
/// "Zero" and "does not step" mean: within 1e-9 of the greatest magnitude of the derivative in the
/// rise (of the velocity: in the whole cam).
struct Rise {
  Cam cam;                ///< this part of the cam, as a cam
  std::size_t first = 0;  ///< index of its first segment in the original cam
  double stroke = 0;      ///< u, from its start to its end, signed, not 0
  /// Ranges inside the rise: of the value and of its derivatives with respect to the master up to
  /// order 4, in u, u/m, ..., u/m^4.
  std::array<Range, 5> ranges{};
  /// The greatest n (0 to 4) such that f', ..., f^(n) are zero at both ends and do not step between
  /// them.
  int smooth = 0;
  /// The greatest n (0 to 4) such that f', ..., f^(n) do not step, inside or against the neighbors.
  int continuous = 0;

  [[nodiscard]] double length() const { return cam.length(); }  ///< m
};

/// Returns all rises of a cam, in order. Outside its interval, a cam that holds is at rest, and a
/// periodic cam continues at its other end. A cam with Extrapolation::refuse has no neighbors, so no
/// derivative steps at its ends.
std::vector<Rise> rises(const Cam& cam);

/// Returns the whole cam as one rise, for any states at its ends. Throws InputError("stroke", ...)
/// if the cam ends at its start position.
Rise as_rise(const Cam& law);

}  // namespace jounce
