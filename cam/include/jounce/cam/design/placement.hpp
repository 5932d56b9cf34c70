// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "jounce/cam/coupling/followed.hpp"

namespace jounce {

/// Placement of a cam between a master x and a slave y (CODESYS MC_CamIn; PMC600 manual 6.2):
///
///     (1)  X = master_scaling x + master_offset
///     (2)  y = slave_scaling CAM(X) + n advance + slave_offset,    n: whole periods before X
///
/// Outside its interval, a cam that is not periodic holds its end values. The functions below
/// accept as a cam any type with start(), end(), length() and jet(x, side), such as a Cam, or a
/// Table over the master. u is the slave's unit, m the master's.

/// Scale and offset of a cam, for the master and for the slave.
struct Placement {
  double master_scaling = 1;  ///< > 0
  double master_offset = 0;   ///< m, added after scaling
  double slave_scaling = 1;   ///< > 0
  double slave_offset = 0;    ///< u, added after scaling
  double advance = 0;         ///< u, change of the slave in each period
  bool periodic = false;      ///< true: the cam repeats

  /// Returns the position X on the cam for a master at x: equation (1).
  [[nodiscard]] double at(double x) const { return master_scaling * x + master_offset; }
};

/// A position on a cam, reduced to one period: X = period * length + at.
struct Spot {
  double at = 0;      ///< m, in [start, start + length); for a cam that is not periodic, the end is
                      ///< included
  double period = 0;  ///< number of whole periods; 0 if the cam is not periodic
  bool inside = true;  ///< true if X is within the cam, or outside only by rounding
};

/// Returns the place of the position X on a cam that begins at `start`.
inline Spot spot(double X, double start, double length, bool periodic) {
  if (periodic) {
    const double at = wrapped(X, start, length);
    return {at, std::nearbyint((X - at) / length), true};
  }
  const double at = std::clamp(X, start, start + length);
  constexpr double at_place = 1e-9;  // permits rounded input
  return {at, 0, std::abs(X - at) <= at_place * length};
}

/// Returns the place of the position X on a periodic cam, approached from one side. A position
/// within `near` of the boundary between two periods counts as on the boundary: from the left as
/// the end of a period, from the right as the start of the next.
inline Spot spot_on(Side side, double X, double start, double end, double near) {
  const Spot s = spot(X, start, end - start, true);
  const bool behind = s.at - start <= near;
  if (!behind && end - s.at > near) return s;
  const double next = behind ? s.period : s.period + 1;
  return side == Side::left ? Spot{end, next - 1, true} : Spot{start, next, true};
}

/// Returns the motion of the slave, [y, y', y'', y'''] with respect to time, for a master at [x,
/// x', x'', x''']. `side` selects the limit before (left) or after (right) an instant. While the
/// master moves backwards, the right and left limits of the cam are exchanged, as in Followed.
template <class C>
Jet placed(const C& cam, const Placement& p, const Jet& x, Side side = Side::right) {
  const double k = p.master_scaling;
  const double X = p.at(x[0]);
  const Side cam_side = (side == Side::left) == backwards(x, side) ? Side::right : Side::left;
  constexpr double eps = std::numeric_limits<double>::epsilon();
  const double rounding =
      2 * eps * (std::abs(k * x[0]) + std::abs(p.master_offset));  // rounding of (1)
  constexpr double near_joint = 1e-12;
  const double near = std::max(near_joint * cam.length(), rounding);
  const Spot s = p.periodic ? spot_on(cam_side, X, cam.start(), cam.end(), near)
                            : spot(X, cam.start(), cam.length(), false);
  Jet f = cam.jet(s.at, cam_side);
  f[0] = p.slave_scaling * f[0] + s.period * p.advance + p.slave_offset;  // (2)
  if (!s.inside) return {f[0], 0, 0, 0};
  const double gain = p.slave_scaling * k;
  return chained({f[0], gain * f[1], gain * k * f[2], gain * k * k * f[3]}, x);
}

}  // namespace jounce
