// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/live_clutch.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/axis/inputs.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/src/follow/live.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;

constexpr double steepest = 15.0 / 8;              ///< greatest slope of f in (1), at z = 1/2
constexpr double most_curved = 5.773502691896258;  ///< greatest curvature of f: 10 / sqrt 3

}  // namespace

LiveClutch::LiveClutch(std::uint64_t id, double ratio, double distance)
    : Movement(id, Course::live), to_(ratio), distance_(distance) {
  if (!(distance > 0 && distance <= most_magnitude))
    throw InputError("clutch", distance, "must be greater than 0, and at most 1e50");
}

Cause LiveClutch::begin(const MotionState& axis, const Moment& now) noexcept {
  if (!axis_detail::usable(now.master)) return Cause::no_master_input;
  const double follows = now.ratio * now.master[1];
  const double near = rounded_input * (std::abs(axis.velocity) + std::abs(follows));
  if (!(std::abs(axis.velocity - follows) <= near)) return Cause::in_motion;
  from_ = now.ratio;
  master_ = now.master[0];
  slave_ = axis.position;
  progress_ = Progress::engaging;
  last_ = axis_detail::setpoint(now.master, {axis.position, axis.velocity, axis.acceleration, 0});
  return Cause::none;
}

Setpoint LiveClutch::at(const Moment& now) noexcept {
  if (!axis_detail::usable(now.master)) progress_ = Progress::broken;
  if (progress_ == Progress::broken) return last_;
  const Jet& x = now.master;
  const double d = distance_;
  double u = x[0] - master_;
  const double side = u < 0 ? -1 : 1;
  if (progress_ == Progress::engaging && side * u >= d) {
    progress_ = Progress::running;
    master_ += side * d;
    slave_ += side * d * (from_ + to_) / 2;
    u = x[0] - master_;
  }
  if (progress_ == Progress::running)
    return last_ = axis_detail::setpoint(x, {slave_ + to_ * u, to_ * x[1], to_ * x[2], to_ * x[3]});
  const double z = side * u / d;
  const double change = to_ - from_;
  const double z2 = z * z;
  const double f = z2 * z * (10 + z * (-15 + 6 * z));
  const double F = z2 * z2 * (2.5 + z * (-3 + z));
  // The derivatives of the ratio with respect to the master.
  const double r = from_ + change * f;
  const double r1 = side * change * 30 * z2 * (1 - z) * (1 - z) / d;
  const double r2 = change * 60 * z * (1 - z) * (1 - 2 * z) / (d * d);
  return last_ =
             axis_detail::setpoint(x, {slave_ + side * d * (from_ * z + change * F), r * x[1],
                                       r * x[2] + r1 * x[1] * x[1],
                                       r * x[3] + 3 * r1 * x[1] * x[2] + r2 * x[1] * x[1] * x[1]});
}

Cause LiveClutch::cause() const noexcept {
  return progress_ == Progress::broken ? Cause::master_lost : Cause::none;
}

std::array<double, 3> LiveClutch::slopes() const noexcept {
  if (progress_ == Progress::running) return {std::abs(to_), 0, 0};
  const double change = std::abs(to_ - from_) / distance_;
  return {std::max(std::abs(from_), std::abs(to_)), steepest * change,
          most_curved * change / distance_};
}

/// For a master that keeps its velocity through the clutch.
Peaks LiveClutch::demand(const Moment& start) const noexcept {
  const auto [k1, k2, k3] = slopes();
  const double v = std::abs(start.master[1]);
  return {.velocity = k1 * v, .acceleration = k2 * v * v, .jerk = k3 * v * v * v};
}

}  // namespace jounce
