// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/extrema.hpp"

namespace jounce {

/// An interval of a cam that leads from one slave position to another, with its properties: the
/// input of characteristic values and certificates.
///
///     for (const Rise& rise : rises(cam)) {
///       Characteristics c = characteristics(rise);   // Cv, Ca, Cj, Cm
///       Report best = certificates(rise);            // distance from the bounds
///     }
///
/// **Vocabulary.** A *rise* (or a fall) lies between two neighboring breaks at which the slave
/// rests: its velocity is zero on both sides of each. A dwell is not a rise. An interval that
/// returns to its start position is not a rise either. Master positions m and slave positions u are
/// the cam's; a rise through the period's wrap continues beyond the cam's end.
///
/// "Zero", and "does not step", mean: within 1e-9 of the greatest magnitude that the derivative has
/// in the rise (the velocity: in the whole cam).
struct Rise {
  Cam cam;                ///< the interval alone
  std::size_t first = 0;  ///< first segment of the cam in the rise
  double stroke = 0;      ///< u, from its start to its end, signed; not 0
  /// Value and four derivatives by master (u, u/m, ..., u/m^4) inside the rise, by order.
  std::array<Range, 5> ranges{};
  /// f', f'', ... up to this order (0 to 4) are zero at both ends and do not step in between.
  int smooth = 0;
  /// f', f'', ... up to this order (0 to 4) do not step, inside or against the neighbors.
  int continuous = 0;

  [[nodiscard]] double length() const { return cam.length(); }
};

/// All rises of a cam, in order. Beyond its ends, a cam that holds is at rest, a cam that wraps
/// continues with its other end, and a cam that rejects has no neighbors to step against.
std::vector<Rise> rises(const Cam& cam);

/// The whole cam as one rise, for any start and end. Throws InputError("stroke", ...) if it ends at
/// its start position.
Rise as_rise(const Cam& law);

}  // namespace jounce
