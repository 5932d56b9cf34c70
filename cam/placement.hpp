#pragma once

#include <algorithm>
#include <cmath>

#include "jounce/cam/followed.hpp"

namespace jounce {

/// Where a cam lies between a master x and a slave y (CODESYS MC_CamIn; PMC600 manual 6.2):
///
///     (1)  X = master_scaling x + master_offset
///     (2)  y = slave_scaling CAM(X) + n advance + slave_offset,    n: whole periods before X
///
/// A cam that is not periodic holds its end values outside. Here a cam is whatever has start(),
/// end(), length() and jet(x, side): a Cam, or a Table over master.
struct Placement {
  double master_scaling = 1;
  double master_offset = 0;  ///< of the cam, after scaling
  double slave_scaling = 1;
  double slave_offset = 0;  ///< u, after scaling
  double advance = 0;       ///< u a period: what the slave gains in each
  bool periodic = false;

  [[nodiscard]] double at(double x) const { return master_scaling * x + master_offset; }  // (1)
};

/// A position on a cam: X = period * length + at.
struct Spot {
  double at = 0;       ///< in [start, start + length); the end too where it is not periodic
  double period = 0;   ///< whole number; 0 where it is not periodic
  bool inside = true;  ///< within the cam, but for rounding
};

/// Where X lies on a cam from `start` on.
inline Spot spot(double X, double start, double length, bool periodic) {
  if (periodic) {
    const double at = wrapped(X, start, length);
    return {at, std::nearbyint((X - at) / length), true};
  }
  const double at = std::clamp(X, start, start + length);
  return {at, 0, std::abs(X - at) <= 1e-9 * length};
}

/// The slave's motion, [y, y', y'', y'''] by time, behind a master that moves as [x, x', x'', x''']
/// does. A master that runs backwards meets the cam's left limits.
template <class C>
Jet placed(const C& cam, const Placement& p, const Jet& x) {
  const double k = p.master_scaling;
  Spot s = spot(p.at(x[0]), cam.start(), cam.length(), p.periodic);
  const Side side = x[1] < 0 ? Side::left : Side::right;
  if (side == Side::left && p.periodic && s.at == cam.start()) s = {cam.end(), s.period - 1, true};
  Jet f = cam.jet(s.at, side);
  f[0] = p.slave_scaling * f[0] + s.period * p.advance + p.slave_offset;  // (2)
  if (!s.inside) return {f[0], 0, 0, 0};
  const double gain = p.slave_scaling * k;
  return chained({f[0], gain * f[1], gain * k * f[2], gain * k * k * f[3]}, x);
}

}  // namespace jounce
