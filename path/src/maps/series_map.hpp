// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "jounce/path/axis_map.hpp"

#include "path/src/maps/series.hpp"

namespace jounce::path_detail {

/// Coefficients of a segment with respect to s, enclosed over the whole of [0, 1].
inline Series<Interval, 9> enclosure(const Segment& f) {
  Series<Interval, 9> out;
  const auto degree = static_cast<std::size_t>(f.degree);
  const Interval s{0, 1};
  for (std::size_t k = 0; k < 9 && k <= degree; ++k) {
    Interval sum;
    for (std::size_t j = degree + 1; j-- > k;) {
      double binomial = 1;
      for (std::size_t i = 0; i < k; ++i)
        binomial = binomial * static_cast<double>(j - i) / static_cast<double>(i + 1);
      sum = sum * s + Interval(std::round(binomial)) * Interval(f.c[j]);
    }
    out[k] = sum;
  }
  for (int m = 0; m < f.sines; ++m) {
    const SineTerm& w = f.sine[static_cast<std::size_t>(m)];
    Interval factor = w.amplitude;
    for (std::size_t k = 0; k < 9; ++k) {
      const Interval turned = Interval(w.phase) + Interval(w.angle) * s +
                              Interval(static_cast<double>(k)) *
                                  outward(profiles_detail::two_pi / 4, profiles_detail::two_pi / 4);
      out[k] = out[k] + factor * sine(turned);
      factor = factor * Interval(w.angle) / Interval(static_cast<double>(k + 1));
    }
  }
  return out;
}

/// A map from one formula for numbers and for intervals. A Kinematics has
///   std::size_t axes, joints;  double turn(joint);  MapState state(const double* point);
///   template <class S> void joints_of(const S* point, S* joints)
///   std::optional<Point> tool_of(const double* joints)
template <class Kinematics>
class SeriesMap final : public AxisMap {
 public:
  explicit SeriesMap(Kinematics kinematics)
      : AxisMap(kinematics.axes, kinematics.joints), of_(std::move(kinematics)) {}

  MapState jets(std::span<const Jet> point, std::span<Jet> joints) const override {
    using S = Series<double, 4>;
    std::array<S, max_axes> in;
    std::array<S, max_axes> out;
    std::array<double, max_axes> at{};
    for (std::size_t i = 0; i < axes(); ++i) {
      at[i] = point[i][0];
      in[i].c = {point[i][0], point[i][1], point[i][2] / 2, point[i][3] / 6};
    }
    if (const MapState state = of_.state(at.data()); state != MapState::ok) return state;
    of_.joints_of(in.data(), out.data());
    for (std::size_t i = 0; i < this->joints(); ++i)
      joints[i] = {out[i][0], out[i][1], 2 * out[i][2], 6 * out[i][3]};
    return MapState::ok;
  }

  [[nodiscard]] double turn(std::size_t joint) const override { return of_.turn(joint); }

  [[nodiscard]] std::optional<Point> tool(std::span<const double> joints) const override {
    const std::optional<Point> point = of_.tool_of(joints.data());
    return point && gives(*point, joints) ? point : std::nullopt;
  }

  bool bounds(std::span<const Segment> point, std::span<JointBounds> joints) const override {
    using S = Series<Interval, 9>;
    std::array<S, max_axes> in;
    std::array<S, max_axes> out;
    for (std::size_t i = 0; i < axes(); ++i) in[i] = enclosure(point[i]);
    of_.joints_of(in.data(), out.data());
    for (std::size_t i = 0; i < this->joints(); ++i)
      joints[i] = {out[i][1].magnitude(), out[i][8].magnitude()};
    return true;
  }

 private:
  Kinematics of_;
};

}  // namespace jounce::path_detail
