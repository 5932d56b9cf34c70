// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "jounce/profiles/error.hpp"

#include "path/src/maps/series_map.hpp"

// Two arms a, b reach the wrist (x, y). With D = cos(A1), S = sin(A1):
//
//   (1)  D = (x^2 + y^2 - a^2 - b^2) / (2 a b),     S = +- sqrt(1 - D^2)
//   (2)  A0 is the angle of (x + i y) conj(a + b D + i b S)
//
// With a third arm c the wrist is the tool less c (cos C, sin C), and A2 = C - A0 - A1.

namespace jounce {
namespace {

constexpr double degrees_per_rad = 180 / std::numbers::pi;

struct Scara {
  std::size_t axes = 2, joints = 2;
  double a = 1, b = 1, c = 0, side = 1;
  bool with_z = false;
  std::array<double, 4> offset{};  ///< one for each joint

  [[nodiscard]] std::size_t arms() const { return c > 0 ? 3 : 2; }
  [[nodiscard]] double turn(std::size_t joint) const { return joint < arms() ? 360 : 0; }

  [[nodiscard]] MapState state(const double* p) const {
    double x = p[0];
    double y = p[1];
    if (c > 0) {
      const double C = p[with_z ? 3 : 2] / degrees_per_rad;
      x -= c * std::cos(C);
      y -= c * std::sin(C);
    }
    const double r = std::hypot(x, y);
    constexpr double rounding = 1e-12;
    if (r > (a + b) * (1 + rounding) || r < std::abs(a - b) * (1 - rounding))
      return MapState::out_of_reach;
    const bool stretched = r >= (a + b) * (1 - rounding);
    const bool folded = r <= std::abs(a - b) * (1 + rounding) || r <= rounding * (a + b);
    return stretched || folded ? MapState::singular : MapState::ok;
  }

  [[nodiscard]] std::optional<Point> tool_of(const double* joint) const {
    Point tool{};
    double angle = 0;  // deg
    const std::array<double, 3> arm{a, b, c};
    for (std::size_t i = 0; i < arms(); ++i) {
      angle += joint[i] - offset[i];
      tool[0] += arm[i] * std::cos(angle / degrees_per_rad);
      tool[1] += arm[i] * std::sin(angle / degrees_per_rad);
    }
    if (with_z) tool[2] = joint[arms()] - offset[arms()];
    if (c > 0) tool[with_z ? 3 : 2] = angle;
    return tool;
  }

  template <class S>
  void joints_of(const S* p, S* joint) const {
    S x = p[0];
    S y = p[1];
    if (c > 0) {
      S cs;
      S sn;
      cosine_and_sine((1 / degrees_per_rad) * p[with_z ? 3 : 2], cs, sn);
      x = x - c * cs;
      y = y - c * sn;
    }
    const S D = (1 / (2 * a * b)) * (squared(x) + squared(y) - S(a * a + b * b));  // (1)
    const S sine_of = side * root((S(1) - D) * (S(1) + D));
    const S k = S(a) + b * D;
    const S m = b * sine_of;
    joint[0] = degrees_per_rad * angle(x * k + y * m, y * k - x * m);  // (2)
    joint[1] = degrees_per_rad * angle(D, sine_of);
    if (c > 0) joint[2] = p[with_z ? 3 : 2] - joint[0] - joint[1];
    if (with_z) joint[arms()] = p[2];
    for (std::size_t i = 0; i < joints; ++i) joint[i] = joint[i] + S(offset[i]);
  }
};

}  // namespace

std::shared_ptr<const AxisMap> scara_map(const ScaraSpec& spec) {
  const std::size_t arms = spec.arms.size();
  if (arms != 2 && arms != 3)
    throw InputError("arms", std::to_string(arms), "must be the lengths of two or three arms");
  for (const double length : spec.arms) require_positive("arms", length);
  if (!spec.offsets.empty() && spec.offsets.size() != arms)
    throw InputError("offsets", std::to_string(spec.offsets.size()), "must be one an arm");
  for (const double offset : spec.offsets) require_finite("offsets", offset);
  require_finite("offset_z", spec.offset_z);
  Scara of;
  of.joints = arms + (spec.with_z ? 1 : 0);
  of.axes = of.joints;
  of.a = spec.arms[0];
  of.b = spec.arms[1];
  if (arms == 3) of.c = spec.arms[2];
  of.side = spec.elbow == Elbow::right ? 1 : -1;
  of.with_z = spec.with_z;
  std::copy(spec.offsets.begin(), spec.offsets.end(), of.offset.begin());
  if (spec.with_z) of.offset[arms] = spec.offset_z;
  return std::make_shared<path_detail::SeriesMap<Scara>>(of);
}

}  // namespace jounce
