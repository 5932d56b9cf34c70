// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <numbers>

#include "jounce/profiles/error.hpp"

#include "path/src/maps/series_map.hpp"

// Let d be the rail's direction, |d| = 1, and w the vector from the rail's start to the tool, less
// the platform's radius:
//
//   (1)  |w - joint d| = arm:   joint = w d + sqrt(arm^2 - |w|^2 + (w d)^2)
//
// In the larger root, the carriage is above the tool.

namespace jounce {
namespace {

/// Share of the square of an arm: the arm lies across its rail.
constexpr double arm_across = 1e-24;

struct LinearDelta {
  std::size_t axes = 3, joints = 3;
  double radius = 0;  ///< outer minus inner radius
  double arm = 0, distance = 0;
  double sn = 0, cs = 1;                            ///< sine and cosine of the rail's angle
  std::array<std::array<double, 2>, 3> outwards{};  ///< direction of each rail

  [[nodiscard]] double turn(std::size_t) const { return 0; }

  /// w d, and the radicand of (1).
  template <class S>
  void terms(const S* p, std::size_t i, S& along, S& left) const {
    const auto [ex, ey] = outwards[i];
    const S wx = p[0] - S(radius * ex);
    const S wy = p[1] - S(radius * ey);
    const S wz = p[2] - S(distance);
    const S out = ex * wx + ey * wy;
    const S side = ex * wy - ey * wx;
    along = cs * wz - sn * out;
    const S across = sn * wz + cs * out;  // component perpendicular to d, in the plane of the rail
    left = S(arm * arm) - across * across - side * side;
  }

  [[nodiscard]] MapState state(const double* p) const {
    for (std::size_t i = 0; i < 3; ++i) {
      double along = 0;
      double left = 0;
      terms(p, i, along, left);
      if (left < 0) return MapState::out_of_reach;
      if (left <= arm_across * arm * arm) return MapState::singular;
    }
    return MapState::ok;
  }

  /// The tool is at the distance `arm` from three points, the ends of the arms less the radius of the
  /// platform, and below them: (2) in the plane of these points, tool - first = s u + t v - h w.
  [[nodiscard]] std::optional<Point> tool_of(const double* joint) const {
    using Vector = std::array<double, 3>;
    const auto dot = [](const Vector& p, const Vector& q) {
      return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    };
    const auto less = [](const Vector& p, const Vector& q, double factor) {
      return Vector{p[0] - factor * q[0], p[1] - factor * q[1], p[2] - factor * q[2]};
    };
    std::array<Vector, 3> end{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double out = radius - joint[i] * sn;
      end[i] = {out * outwards[i][0], out * outwards[i][1], distance + joint[i] * cs};
    }
    Vector u = less(end[1], end[0], 1);
    const double first = std::sqrt(dot(u, u));
    const Vector side = less(end[2], end[0], 1);
    if (!(first > 0)) return std::nullopt;
    for (double& component : u) component /= first;
    const double along = dot(side, u);
    Vector v = less(side, u, along);
    const double across = std::sqrt(dot(v, v));
    if (!(across > 0)) return std::nullopt;
    for (double& component : v) component /= across;
    const Vector w{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double s = first / 2;  // (2)
    const double t = (along * along + across * across - 2 * along * s) / (2 * across);
    const double square = arm * arm - s * s - t * t;
    if (!(square >= 0)) return std::nullopt;
    const double h = std::sqrt(square) * (w[2] > 0 ? 1 : -1);
    Point tool{};
    for (std::size_t i = 0; i < 3; ++i) tool[i] = end[0][i] + s * u[i] + t * v[i] - h * w[i];
    return tool;
  }

  template <class S>
  void joints_of(const S* p, S* joint) const {
    for (std::size_t i = 0; i < 3; ++i) {
      S along;
      S left;
      terms(p, i, along, left);
      joint[i] = along + root(left);  // (1)
    }
  }
};

}  // namespace

std::shared_ptr<const AxisMap> linear_delta_map(const LinearDeltaSpec& spec) {
  require_not_negative("outer_radius", spec.outer_radius);
  require_not_negative("inner_radius", spec.inner_radius);
  require_positive("arm", spec.arm);
  require_finite("distance", spec.distance);
  if (!(std::abs(spec.rail_angle) < 90))
    throw InputError("rail_angle", spec.rail_angle,
                     "must be greater than -90 and less than 90 deg");
  LinearDelta of;
  require_finite("first_rail", spec.first_rail);
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle =
        (spec.first_rail + 120 * static_cast<double>(i)) * (std::numbers::pi / 180);
    of.outwards[i] = {std::cos(angle), std::sin(angle)};
  }
  of.radius = spec.outer_radius - spec.inner_radius;
  of.arm = spec.arm;
  of.distance = spec.distance;
  of.sn = std::sin(spec.rail_angle * (std::numbers::pi / 180));
  of.cs = std::cos(spec.rail_angle * (std::numbers::pi / 180));
  return std::make_shared<path_detail::SeriesMap<LinearDelta>>(of);
}

}  // namespace jounce
