// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/path/plan.hpp"
#include "jounce/profiles/curve/extrema.hpp"

// Programs, limits and laws that the tests of paths share.
namespace jounce::path_tests {

/// The conditions of most oracles: A = 1000, J = 1e4 an axis.
inline GroupLimits usual(std::size_t n, double jerk = 1e4) {
  return {.axes = std::vector<Limits>(n, {.acceleration = 1000, .jerk = jerk})};
}

/// A portable generator: xorshift64*, in [0, 1).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ULL + 1) {}
  double operator()() {
    state_ ^= state_ >> 12;
    state_ ^= state_ << 25;
    state_ ^= state_ >> 27;
    return static_cast<double>((state_ * 0x2545F4914F6CDD1DULL) >> 11) * 0x1p-53;
  }
  double between(double a, double b) { return a + (b - a) * (*this)(); }
  /// From a to b, evenly by magnitude.
  double log_between(double a, double b) { return a * std::pow(b / a, (*this)()); }

 private:
  std::uint64_t state_;
};

/// The largest of |rate| / limit over all axes and orders, from exact extrema.
inline double worst_ratio(const PlanAxes& axes, const GroupLimits& limits) {
  double worst = 0;
  for (std::size_t i = 0; i < axes.curves.size(); ++i) {
    const Ranges ranges = extrema(axes.curves[i]);
    const std::optional<double> limit[] = {
        {}, limits.axes[i].velocity, limits.axes[i].acceleration, limits.axes[i].jerk};
    for (std::size_t k = 1; k < 4; ++k)
      if (limit[k]) worst = std::max(worst, std::abs(ranges[k].peak().value) / *limit[k]);
  }
  return worst;
}

/// The excess of the worst ratio over 1, which a message shows with all its digits.
inline double excess(const PlanAxes& axes, const GroupLimits& limits) {
  return worst_ratio(axes, limits) - 1;
}

/// The plan's axes begin and end at rest at the program's ends, and join up to the acceleration.
inline void expect_whole(const Plan& plan, const PlanAxes& axes, const Program& program) {
  double arcs = 0;  // an arc has the rounding of its center and radius
  for (const Arc& arc : program.arcs())
    for (const double x : arc.center) arcs = std::max(arcs, std::abs(x) + arc.radius);
  for (std::size_t i = 0; i < axes.curves.size(); ++i) {
    const Trajectory& f = axes.curves[i];
    const double scale = std::abs(program.start()[i]) + std::abs(program.position()[i]) + 1e-300;
    const Ranges ranges = extrema(f);
    const double size =
        std::max(std::abs(ranges[0].min.value), std::abs(ranges[0].max.value)) + scale;
    EXPECT_NEAR(f.at(0).position, program.start()[i], 4e-16 * (size + arcs));
    EXPECT_NEAR(f.at(f.end(), Side::left).position, program.position()[i],
                1e-14 * (size + plan.path().length()) + 2 * axes.error[i][0]);
    EXPECT_NEAR(f.end(), plan.duration(), 1e-12 * plan.duration());
    const double v = ranges[1].peak().value == 0 ? 1 : std::abs(ranges[1].peak().value);
    EXPECT_NEAR(f.at(0).velocity, 0, 1e-9 * v);
    EXPECT_NEAR(f.at(f.end(), Side::left).velocity, 0, 1e-9 * v);
    EXPECT_LE(std::abs(largest_jump(f, 0).step), 1e-11 * size + 4 * axes.error[i][0]);
    EXPECT_LE(std::abs(largest_jump(f, 1).step), 2e-9 * v + 4 * axes.error[i][1]);
  }
}

}  // namespace jounce::path_tests
