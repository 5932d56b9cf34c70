// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/extrema.hpp"

namespace jounce {

/// A stretch of a cam that leads from one slave position to another, with what is known of it: what
/// characteristic values and certificates are made from.
///
///     for (const Rise& rise : rises(cam)) {
///       Characteristics c = characteristics(rise);   // Cv, Ca, Cj, Cm
///       Report best = certificates(rise);            // how far above what is possible
///     }
///
/// **Vocabulary.** A *rise* (a fall just as well) lies between two neighbouring breaks where the
/// slave rests: its velocity is zero there on both sides. Dwells are no rises, nor is a stretch
/// that comes back to where it began. Master positions m and slave positions u are the cam's; a
/// rise through the period's wrap runs on beyond the cam's end.
///
/// "Zero", and "does not step", mean: within 1e-9 of the greatest magnitude that the derivative has
/// in the rise (the velocity: in the whole cam).
struct Rise {
  Cam cam;                ///< the stretch alone
  std::size_t first = 0;  ///< the cam's segment it begins with
  double stroke = 0;      ///< u, from its start to its end, signed; not 0
  /// Value and four derivatives by master (u, u/m, ..., u/m^4) inside the rise, by order.
  std::array<Range, 5> ranges{};
  /// f', f'', ... up to this order (0 to 4) are zero at both ends and do not step in between.
  int smooth = 0;
  /// f', f'', ... up to this order (0 to 4) do not step, neither inside nor against the neighbours.
  int continuous = 0;

  [[nodiscard]] double length() const { return cam.length(); }
};

/// All rises of a cam, in order. Beyond its ends a cam that holds is at rest, one that wraps goes on
/// with its other end, and one that refuses has no neighbours to step against.
std::vector<Rise> rises(const Cam& cam);

/// The whole cam as one rise, wherever it starts and ends. Throws InputError("stroke", ...) if it
/// ends where it began.
Rise as_rise(const Cam& law);

}  // namespace jounce
