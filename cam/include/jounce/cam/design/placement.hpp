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
/// A cam that is not periodic holds its end values outside. Here a cam is any type with start(),
/// end(), length() and jet(x, side): a Cam, or a Table over master.
struct Placement {
  double master_scaling = 1;
  double master_offset = 0;  ///< master offset of the cam, after scaling
  double slave_scaling = 1;
  double slave_offset = 0;  ///< u, after scaling
  double advance = 0;       ///< u per period: advance of the slave in each
  bool periodic = false;

  [[nodiscard]] double at(double x) const { return master_scaling * x + master_offset; }  // (1)
};

/// A position on a cam: X = period * length + at.
struct Spot {
  double at = 0;       ///< in [start, start + length); also the end if it is not periodic
  double period = 0;   ///< whole number; 0 if it is not periodic
  bool inside = true;  ///< within the cam, except for rounding
};

/// Position X within a cam from `start` on.
inline Spot spot(double X, double start, double length, bool periodic) {
  if (periodic) {
    const double at = wrapped(X, start, length);
    return {at, std::nearbyint((X - at) / length), true};
  }
  const double at = std::clamp(X, start, start + length);
  constexpr double at_place = 1e-9;  // permits rounded input
  return {at, 0, std::abs(X - at) <= at_place * length};
}

/// Position X approached from one side. Within rounding (`near`) of the seam between two periods it
/// counts as on the seam: from the left as the end of one period, from the right as the start of
/// the next.
inline Spot spot_on(Side side, double X, double start, double end, double near) {
  const Spot s = spot(X, start, end - start, true);
  const bool behind = s.at - start <= near;
  if (!behind && end - s.at > near) return s;
  const double next = behind ? s.period : s.period + 1;
  return side == Side::left ? Spot{end, next - 1, true} : Spot{start, next, true};
}

/// The slave's motion, [y, y', y'', y'''] by time, for a master at [x, x', x'', x''']. `side`
/// selects the limit from after (right) or before (left) an instant. While the master runs
/// backwards, right and left limits of the cam are exchanged, as in Followed.
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
