// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "tests/path/paths.hpp"

// Random programs, each with transformed twins.
namespace jounce::property_test {
namespace {

using path_tests::Random;

/// A program as data that a test can transform.
struct Step {
  Point to{};
  bool arc = false;
  Point via{};
};
struct Case {
  std::size_t axes = 2;
  std::vector<Step> steps;
  PathSettings settings;
  GroupLimits limits;
};

Case random_case(std::uint64_t seed, bool arcs) {
  Random random(seed);
  Case c;
  c.axes = random() < 0.5 ? 2 : 3;
  const auto count = static_cast<std::size_t>(random.between(1, 12));
  Point at{};
  const double scale = random.log_between(0.1, 100);
  for (std::size_t i = 0; i < count; ++i) {
    Step s;
    s.to = at;
    const double reach = scale * random.log_between(0.01, 1);
    for (std::size_t k = 0; k < c.axes; ++k) s.to[k] += random.between(-reach, reach);
    s.arc = arcs && random() < 0.4;
    for (std::size_t k = 0; s.arc && k < c.axes; ++k)
      s.via[k] = (at[k] + s.to[k]) / 2 + random.between(-reach, reach);
    c.steps.push_back(s);
    at = s.to;
  }
  c.settings.velocity = random.log_between(1, 1000);
  const Corner corners[] = {Corner::stop, Corner::deviation, Corner::distance, Corner::curvature,
                            Corner::velocity};
  c.settings.corner = corners[static_cast<std::size_t>(random.between(0, 5))];
  c.settings.value = c.settings.corner == Corner::velocity ? random.log_between(0.1, 200)
                     : c.settings.corner == Corner::curvature
                         ? 1 / (scale * random.log_between(1e-4, 1))
                         : scale * random.log_between(1e-4, 1);
  for (std::size_t k = 0; k < c.axes; ++k)
    c.limits.axes.push_back({.velocity = random.log_between(10, 1000),
                             .acceleration = random.log_between(100, 1e4),
                             .jerk = random.log_between(1e3, 1e6)});
  return c;
}

Program program_of(const Case& c, std::size_t cut = 1) {
  Program p(c.axes);
  p.set(c.settings);
  int line = 0;
  for (const Step& s : c.steps) {
    ++line;
    const Point from = p.position();
    if (s.arc) {
      p.arc(arc_through(from, s.via, s.to, c.axes), line);
      continue;
    }
    for (std::size_t i = 1; i <= cut; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(cut);
      Point to = s.to;
      for (std::size_t k = 0; k < c.axes && i < cut; ++k) to[k] = from[k] + (s.to[k] - from[k]) * t;
      p.line(to, line);
    }
  }
  return p;
}

template <class Map>
Case mapped(Case c, Map map) {
  for (Step& s : c.steps) {
    s.to = map(s.to);
    s.via = map(s.via);
  }
  return c;
}

TEST(Properties, OfPolylines) {
  int rounded = 0;
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    const Case c = random_case(seed, false);
    SCOPED_TRACE(seed);
    const Program p = program_of(c);
    const Plan made = plan(p, c.limits);
    const PlanAxes axes = to_axes(made);
    path_tests::expect_whole(made, axes, p);
    ASSERT_LE(path_tests::excess(axes, c.limits), 1e-12);
    ASSERT_LE(made.duration(), made.stop_duration() * (1 + 1e-12));
    ASSERT_GE(made.duration(), lower_bound(made, 8) * (1 - 1e-12));
    for (const Jet& error : axes.error) EXPECT_EQ(error[0], 0);
    for (const CornerRecord& corner : made.corners()) {
      rounded += corner.stop ? 0 : 1;
      if (corner.asked == Corner::deviation) {
        ASSERT_LE(corner.deviation, corner.value * (1 + 1e-12));
        ASSERT_LE(corner.one_sided, corner.deviation * (1 + 1e-12));
      }
      if (corner.asked == Corner::distance) {
        ASSERT_LE(corner.trim, corner.value * (1 + 1e-12));
      }
      if (corner.asked == Corner::curvature && !corner.stop && corner.note == JunctionNote::none) {
        ASSERT_LE(corner.curvature, corner.value * (1 + 1e-9));
      }
    }
    if (HasFailure()) break;
  }
  EXPECT_GT(rounded, 500);
}

TEST(Properties, OfLinesAndArcs) {
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    const Case c = random_case(seed + 5000, true);
    SCOPED_TRACE(seed);
    const Program p = program_of(c);
    const Plan made = plan(p, c.limits);
    const double tolerance = 1e-7;
    const PlanAxes axes = to_axes(made, tolerance);
    path_tests::expect_whole(made, axes, p);
    ASSERT_LE(path_tests::excess(axes, c.limits), 1e-12);
    ASSERT_LE(made.duration(), made.stop_duration() * (1 + 1e-12));
    ASSERT_GE(made.duration(), lower_bound(made, 8) * (1 - 1e-12));
    for (const CornerRecord& corner : made.corners())
      if (corner.asked == Corner::deviation) {
        ASSERT_LE(corner.deviation, corner.value * (1 + 1e-9));
      }
    if (HasFailure()) break;
  }
}

TEST(Properties, TransformedTwins) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Case c = random_case(seed + 9000, seed % 4 == 0);
    SCOPED_TRACE(seed);
    const double T = plan(program_of(c), c.limits).duration();
    const auto same = [&](const Case& twin, double factor = 1) {
      EXPECT_NEAR(plan(program_of(twin), twin.limits).duration(), factor * T, 1e-9 * factor * T);
    };
    same(mapped(c, [](Point p) {
      for (double& x : p) x = -x;
      return p;
    }));
    Case swapped = mapped(c, [](Point p) {
      std::swap(p[0], p[1]);
      return p;
    });
    std::swap(swapped.limits.axes[0], swapped.limits.axes[1]);
    same(swapped);
    for (const double unit : {1e-6, 1e6}) {  // unit of length
      Case u = mapped(c, [unit](Point p) {
        for (double& x : p) x *= unit;
        return p;
      });
      u.settings.velocity *= unit;
      u.settings.value *= u.settings.corner == Corner::curvature ? 1 / unit : unit;
      for (Limits& l : u.limits.axes)
        l = {.velocity = *l.velocity * unit,
             .acceleration = *l.acceleration * unit,
             .jerk = *l.jerk * unit};
      same(u);
    }
    for (const double unit : {1e-3, 1e3}) {  // unit of time
      Case u = c;
      u.settings.velocity /= unit;
      if (u.settings.corner == Corner::velocity) u.settings.value /= unit;
      for (Limits& l : u.limits.axes)
        l = {.velocity = *l.velocity / unit,
             .acceleration = *l.acceleration / (unit * unit),
             .jerk = *l.jerk / (unit * unit * unit)};
      same(u, unit);
    }
    EXPECT_NEAR(plan(program_of(c, 2), c.limits).duration(), T, 1e-9 * T) << "cut in two";
    if (HasFailure()) break;
  }
}

TEST(Properties, RotationUnderPathLimits) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Case c = random_case(seed + 20000, false);
    c.limits = {.axes = std::vector<Limits>(c.axes),
                .path = {.acceleration = 1000, .jerk = 1e5, .normal_acceleration = 800}};
    const double T = plan(program_of(c), c.limits).duration();
    const double angle = static_cast<double>(seed);
    const Case turned = mapped(c, [angle](const Point& p) {
      Point q = p;
      q[0] = std::cos(angle) * p[0] - std::sin(angle) * p[1];
      q[1] = std::sin(angle) * p[0] + std::cos(angle) * p[1];
      return q;
    });
    EXPECT_NEAR(plan(program_of(turned), turned.limits).duration(), T, 1e-9 * T) << seed;
  }
}

TEST(Properties, DegenerateInput) {
  const GroupLimits limits = path_tests::usual(2);
  const auto planned = [&](std::vector<Point> points, const Point& start = {}) {
    Program p(2, start);
    p.set({.velocity = 100, .corner = Corner::deviation, .value = 0.05});
    int line = 0;
    for (const Point& q : points) p.line(q, ++line);
    const Plan made = plan(p, limits);
    const PlanAxes axes = to_axes(made);
    path_tests::expect_whole(made, axes, p);
    EXPECT_LE(path_tests::worst_ratio(axes, limits), 1 + 1e-12);
    EXPECT_LE(made.duration(), made.stop_duration() * (1 + 1e-12));
  };
  planned({{100, 0}, {100, 1e-9}, {0, 50}});                  // points 1e-9 apart
  planned({{1e-9, 0}, {1e-9, 1e-9}, {0, 1e-9}});              // a tiny program
  planned({{10, 0}, {0, 0}, {10, 0}, {0, 0}});                // reversals
  planned({{10, 0}, {0, 1e-7}, {10, 2e-7}});                  // nearly reversals
  planned({{0.01, 0}, {0.01, 0.01}, {0, 0.01}, {100, 100}});  // short sides
  planned({{1e9 + 1e-6, 0}, {1e9 + 1e-6, 1e-6}, {1e9 + 2e-6, 1e-6}}, {1e9, 0});
  planned({{1e9, 1e9}, {1e9 + 0.5, 1e9}, {1e9 + 0.5, 1e9 + 1}}, {1e9 - 1, 1e9});
}

}  // namespace
}  // namespace jounce::property_test
