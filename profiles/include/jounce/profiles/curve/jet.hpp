// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace jounce {

/// A value with its first three derivatives by the variable of the curve: [f, f', f'', f'''].
using Jet = std::array<double, 4>;

/// Side of a jump of a derivative. Curves are right-continuous, so right is the
/// rule.
enum class Side { right, left };

/// Policy outside [start, end]; chosen when a signal is made.
enum class Extrapolation {
  refuse,   ///< a query outside is the caller's mistake: asserts, and holds in a release build
  hold,     ///< the end value, at rest
  wrap,     ///< periodic: the query is reduced into [start, end)
  advance,  ///< like wrap, but every period continues from the end of the one before: a rotary slave
};

/// True if the derivatives are periodic: wrap or advance.
constexpr bool repeats(Extrapolation outside) {
  return outside == Extrapolation::wrap || outside == Extrapolation::advance;
}

/// Position and its derivatives by time, in user units u: u, u/s, u/s^2, u/s^3.
struct Motion {
  double position = 0;
  double velocity = 0;
  double acceleration = 0;
  double jerk = 0;
};

/// Slave position and its derivatives by *master position* (VDI 2143: transfer functions of order
/// 0 to 3). The prefix keeps them from being taken for derivatives by time: at master speed w the
/// slave's velocity is geo_velocity * w, its acceleration geo_acceleration * w^2.
struct Transfer {
  double position = 0;
  double geo_velocity = 0;
  double geo_acceleration = 0;
  double geo_jerk = 0;
};

/// Tags: a curve over time is a Trajectory, one over master position is a Cam. A compile-time tag,
/// so that one cannot be played as the other.
struct OverTime {
  using Point = Motion;
  static constexpr std::array<const char*, 4> names{"position", "velocity", "acceleration", "jerk"};
};
struct OverMaster {
  using Point = Transfer;
  static constexpr std::array<const char*, 4> names{"position", "geo_velocity", "geo_acceleration",
                                                    "geo_jerk"};
};

/// std::fmod(u, length) for u >= 0 and length > 0, to the bit: if the quotient of a division is
/// right, the remainder of a fused multiply-add has no rounding. Several times as fast.
inline double remainder_of(double u, double length) {
  const double quotient = u / length;
  if (!(quotient < 0x1p53)) return std::fmod(u, length);
  const double whole = static_cast<double>(static_cast<std::int64_t>(quotient));
  const double left = std::fma(-whole, length, u);
  return left >= 0 && left < length ? left : std::fmod(u, length);
}

/// x reduced into [start, start + length): the reduction of a query by Extrapolation::wrap and
/// advance.
inline double wrapped(double x, double start, double length) {
  const double u = x - start;
  const double turned = remainder_of(std::abs(u), length);
  const double at = start + (u < 0 && turned > 0 ? length - turned : turned);
  return at < start + length ? at : start;  // a hair below the end: no double is nearer
}

/// A query of a periodic signal: its place in [start, end] (the end for a left limit there), and how
/// many periods it is away.
struct InPeriod {
  double at = 0;
  double turns = 0;
};
inline InPeriod in_period(double x, Side side, double start, double end) {
  const double length = end - start;
  double at = wrapped(x, start, length);
  if (side == Side::left && at == start) at = end;
  return {at, std::round((x - at) / length)};
}

template <class Over>
constexpr typename Over::Point point(const Jet& f) {
  return {f[0], f[1], f[2], f[3]};
}

}  // namespace jounce
