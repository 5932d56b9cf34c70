// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace jounce {

/// A value and its first three derivatives with respect to the variable of the curve: [f, f', f'',
/// f'''].
using Jet = std::array<double, 4>;

/// The side from which a derivative is taken at a jump. Curves are right-continuous, so the default
/// is right.
enum class Side { right, left };

/// Policy for queries outside [start, end] (key `outside` of a spec). It is set when a curve or a
/// table is made.
enum class Extrapolation {
  /// A query outside is a programming error: a library that was built with assertions ends the
  /// program, and an installed one returns the value of the nearer end, at rest. This is the
  /// default of Curve(segments). The curve of Profile::curve() has the policy `hold`. A function of
  /// one or two curves returns the policy of the first curve, unless its header states another. A
  /// sum of cycle times can pass the end by rounding, so play a curve that has the policy `hold`:
  /// with(curve, Extrapolation::hold).
  refuse,
  hold,  ///< the value of the nearer end, at rest
  wrap,  ///< periodic: the query is reduced to [start, end)
  /// Like wrap, but each period begins at the end value of the previous period (a rotary slave).
  advance,
};

/// True for a periodic policy: wrap or advance.
constexpr bool repeats(Extrapolation outside) {
  return outside == Extrapolation::wrap || outside == Extrapolation::advance;
}

/// Position and its derivatives with respect to time, in user units u: u, u/s, u/s^2, u/s^3.
struct Motion {
  double position = 0;
  double velocity = 0;
  double acceleration = 0;
  double jerk = 0;
};

/// Slave position and its derivatives with respect to the *master's position* (VDI 2143: transfer
/// functions of order 0 to 3). The prefix `geo_` distinguishes them from derivatives with respect
/// to time. At constant master speed w, the slave's velocity is geo_velocity * w and its
/// acceleration geo_acceleration * w^2.
struct Transfer {
  double position = 0;
  double geo_velocity = 0;
  double geo_acceleration = 0;
  double geo_jerk = 0;
};

/// Tags of the variable of a curve: a Curve<OverTime> is a Trajectory, a Curve<OverMaster> is a
/// Cam. Because the types differ, a program cannot play a cam as a trajectory by mistake.
struct OverTime {
  using Point = Motion;
  static constexpr std::array<const char*, 4> names{"position", "velocity", "acceleration", "jerk"};
};
struct OverMaster {
  using Point = Transfer;
  static constexpr std::array<const char*, 4> names{"position", "geo_velocity", "geo_acceleration",
                                                    "geo_jerk"};
};

/// Returns std::fmod(u, length) exactly, for u >= 0 and length > 0, but several times as fast. If
/// the quotient rounds to the correct whole number, the fused multiply-add gives the remainder
/// without rounding; otherwise std::fmod() does.
inline double remainder_of(double u, double length) {
  const double quotient = u / length;
  if (!(quotient < 0x1p53)) return std::fmod(u, length);
  const double whole = static_cast<double>(static_cast<std::int64_t>(quotient));
  const double left = std::fma(-whole, length, u);
  return left >= 0 && left < length ? left : std::fmod(u, length);
}

/// Returns x reduced to [start, start + length), as Extrapolation::wrap and advance reduce it.
inline double wrapped(double x, double start, double length) {
  const double u = x - start;
  const double turned = remainder_of(std::abs(u), length);
  const double at = start + (u < 0 && turned > 0 ? length - turned : turned);
  return at < start + length ? at : start;  // only rounding reaches the end: take the start
}

/// A position reduced to one period.
struct InPeriod {
  double at = 0;     ///< in [start, end); for Side::left in (start, end]
  double turns = 0;  ///< whole number of periods from `at` to the original position
};
/// Returns x reduced to [start, end), or to (start, end] for Side::left.
inline InPeriod in_period(double x, Side side, double start, double end) {
  const double length = end - start;
  double at = wrapped(x, start, length);
  if (side == Side::left && at == start) at = end;
  return {at, std::round((x - at) / length)};
}

/// Returns the jet as a point with named members.
template <class Over>
constexpr typename Over::Point point(const Jet& f) {
  return {f[0], f[1], f[2], f[3]};
}

}  // namespace jounce
