// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/path/overlap.hpp"
#include "jounce/path/shapes.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/curve/query.hpp"
#include "jounce/profiles/vibration/moving_average.hpp"

#include "path/src/corners/blend.hpp"
#include "path/src/corners/turn.hpp"
#include "path/src/geometry/septic.hpp"
#include "path/src/timing/box.hpp"
#include "tests/path/paths.hpp"

// The closed forms of tests/oracle/path.json (60 digits), with 100 mm/s, 1000 mm/s^2 and 1e4 mm/s^3. By rows:
//
//   1            Plan.ALineWholeOrInPieces                       8   OfTheJerkOfACircle
//   2, 3, 4      OfSquaresWithTurns                              9   OfRampsOverALength
//   5            OfSquaresWithOverlap, OfThePeaksOfAnOverlap     10, 11   OfALineAndAnArc, Blend.TrimsOfALineAndAnArc
//   6, 7         OfTheRampsOnACircle, Plan.TheBoundOfACircle     12  OfAHelix, Plan.AHelixIsAsLongAsItsSpatialCurve
//
//   13           OfTheChordsOfACircle
//
// The manuals:
//
//   PMC600       Plan.TrapezoidsOfTheSeeds, PathExamples.OfThePmc600TakeTheirTimes, GroupExamples, OfThePmc600,
//                OfTheFilletsOfThePmc600
//   HIMC         PathExamples.OfHimcTakeTheirTimes, OfTheSmoothingTimeOfHimc (Ex 1),
//                Arc.HimcTurns (rows 6 to 9), OfTheCornersOfHimc (row 13), Frame (rows 16 to 20)
namespace jounce::closed_form_test {
namespace {

using path_tests::usual;

const nlohmann::json& forms() {
  static const nlohmann::json all =
      nlohmann::json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/path.json"))
          .at("closed_forms");
  return all;
}

double peak(const Trajectory& f, int order) {
  return std::abs(extrema(f, order).peak().value);
}

Program square(const PathSettings& settings) {
  Program p(2);
  p.set(settings);
  int line = 0;
  for (const auto& [x, y] : {std::pair{100.0, 0.0}, {100.0, 100.0}, {0.0, 100.0}, {0.0, 0.0}})
    p.line({x, y}, ++line);
  return p;
}

/// Rows 2 to 4: the turn, and the faster one of the motions with turns and with stops.
TEST(ClosedForms, OfSquaresWithTurns) {
  for (const double jerk : {1e4, 1e5}) {
    const double stops = forms().at(jerk == 1e4 ? "2_square_stop" : "2_square_stop_jerk_1e5");
    for (const auto& row :
         forms().at(jerk == 1e4 ? "3_square_t_blend" : "4_square_t_blend_jerk_1e5")) {
      const double e = row.at("deviation");
      const double offset = e / std::sqrt(2.0);
      SCOPED_TRACE(e);
      const Turn turn = fastest_turn({1000, jerk}, offset, 100);
      const double speed = row.at("corner_speed");
      if (speed < 100) {
        EXPECT_NEAR(turn.velocity, speed, 1e-12 * speed);
        EXPECT_NEAR(turn.share, row.at("share").get<double>(), 1e-9);
        EXPECT_NEAR(turn.length, row.at("blend_length").get<double>(), 1e-9);
      } else {
        EXPECT_GE(turn.velocity, speed);
      }
      const Plan made =
          plan(square({.velocity = 100, .corner = Corner::deviation, .value = e}), usual(2, jerk));
      EXPECT_NEAR(made.duration(), std::min(row.at("time").get<double>(), stops), 1e-12);
      EXPECT_NEAR(made.stop_duration(), stops, 1e-12);
    }
  }
}

/// Row 5.
TEST(ClosedForms, OfSquaresWithOverlap) {
  for (const auto& row : forms().at("5_square_overlap")) {
    const Overlapped motion = overlapped(square({.velocity = 100}), usual(2, row.at("jerk")),
                                         {.deviation = row.at("deviation")});
    EXPECT_NEAR(motion.corners[1].overlap, row.at("overlap").get<double>(), 1e-9);
    EXPECT_NEAR(motion.duration, row.at("time").get<double>(), 1e-9);
  }
}

/// Row 5: the overlapping legs use the whole acceleration and the whole jerk, and no more.
TEST(ClosedForms, OfThePeaksOfAnOverlap) {
  for (const double jerk : {1e4, 1e5}) {
    const Overlapped motion =
        overlapped(square({.velocity = 100}), usual(2, jerk), {.deviation = 1});
    for (const Trajectory& axis : motion.axes) {
      const Ranges ranges = extrema(axis);
      EXPECT_NEAR(std::abs(ranges[2].peak().value), 1000, 1e-9);
      EXPECT_NEAR(std::abs(ranges[3].peak().value), jerk, 1e-9 * jerk);
    }
  }
}

/// Rows 6 and 7: an arc of twice the ramp, from rest to rest. The bound has neither a jerk nor a ramp of its own; it
/// divides the arc into cells.
TEST(ClosedForms, OfTheRampsOnACircle) {
  const auto bound = [](double feed, double length) {
    const double sweep = length / 50;
    Program p(2, {50, 0});
    p.set({.velocity = feed});
    p.arc(arc_about({50, 0}, {}, {50 * std::cos(sweep), 50 * std::sin(sweep)}, Plane{0, 1},
                    ArcRotation::counterclockwise));
    const GroupLimits limits{.axes = std::vector<Limits>(2), .path = {.total_acceleration = 1000}};
    return lower_bound(plan(p, limits), 20000);
  };
  const auto& free = forms().at("6_circle_free");
  EXPECT_NEAR(bound(PathSettings::none, 2 * free.at("ramp_arc").get<double>()),
              2 * free.at("ramp_time").get<double>(), 2e-6);
  EXPECT_NEAR(free.at("speed").get<double>(), std::sqrt(1000.0 * 50), 1e-12);
  const auto& fed = forms().at("7_circle_feed_100");
  const double arc = 2 * fed.at("ramp_arc").get<double>();
  const double time = 2 * fed.at("ramp_time").get<double>();
  EXPECT_NEAR(arc, 2 * 5.033948, 1e-6);
  EXPECT_NEAR(bound(100, arc), time, 2e-6);
  EXPECT_NEAR(bound(100, arc + 10), time + 0.1, 2e-6);
}

/// A line of 100 mm, and perpendicular to it a line (side 0), or an arc of the radius 50 to the left (1) or right (-1).
Path perpendicular(int side) {
  Program p(2);
  p.line({100, 0});
  if (side == 0)
    p.line({100, 100});
  else
    p.arc(arc_about({100, 0}, {100.0 - 50 * side, 0}, {100.0 - 50 * side, 50}, Plane{0, 1},
                    side > 0 ? ArcRotation::counterclockwise : ArcRotation::clockwise));
  return plan(p, usual(2)).path();
}

/// Least distance of curves from a point near their middle, by golden section.
double distance_near_middle(std::span<const Segment> axes, const Point& p) {
  const auto at = [&](double s) {
    double square = 0;
    for (std::size_t i = 0; i < axes.size(); ++i)
      square += std::pow(evaluate(axes[i], s)[0] - p[i], 2);
    return std::sqrt(square);
  };
  double low = 0.4;
  double high = 0.6;
  for (int i = 0; i < 60; ++i) {
    const double a = high - 0.6180339887498949 * (high - low);
    const double b = low + 0.6180339887498949 * (high - low);
    (at(a) < at(b) ? high : low) = at(a) < at(b) ? b : a;
  }
  return at(low);
}

/// Rows 10 and 11: the trims of the blends of degree 5 and 7 whose deviation is 1, and their curvatures.
TEST(ClosedForms, OfALineAndAnArc) {
  for (const auto& row : forms().at("10_line_arc")) {
    const double radius = row.at("radius").is_null() ? 0 : row.at("radius").get<double>();
    const Path route = perpendicular(radius > 0 ? 1 : radius < 0 ? -1 : 0);
    const Point corner{100, 0};
    SCOPED_TRACE(radius);
    const double trim = row.at("quintic").at("trim");
    const Blend blend = blend_of(route, 0, trim);
    EXPECT_NEAR(least_distance(blend.segments(), corner, 2), 1, 1e-12);
    EXPECT_NEAR(distance_near_middle(blend.segments(), corner), 1, 1e-12);
    EXPECT_NEAR(greatest_curvature(blend.segments(), 2),
                row.at("quintic").at("curvature").get<double>(), 1e-9);
    const double wider = row.at("septic").at("trim");
    std::array<Jet, 2> before{};
    std::array<Jet, 2> behind{};
    route.jets(0, 100 - wider, before);
    route.jets(1, wider, behind);
    const std::array<Segment, 2> axes{septic(2 * wider, before[0], behind[0]),
                                      septic(2 * wider, before[1], behind[1])};
    EXPECT_NEAR(distance_near_middle(axes, corner), 1, 1e-12);
  }
}

/// HIMC, row 13: trims, deviations, curvatures of the corner of a square, as a parabola, as the blend of degree 4 and
/// as a turn with the share 1/2.
TEST(ClosedForms, OfTheCornersOfHimc) {
  const double bend = std::sqrt(2.0);
  const auto turn = [&](double share, double trim) { return bend * 2 * trim * turn_offset(share); };
  EXPECT_NEAR(turn(0, 40), 14.142136, 5e-7);
  EXPECT_NEAR(turn(0.5, 40), 9.428090, 5e-7);
  EXPECT_NEAR(4 / turn(0, 1), 11.313708, 5e-7);
  EXPECT_NEAR(4 / turn(0.5, 1), 16.970563, 5e-7);
  const Path route = perpendicular(0);
  const auto quartic = [&](double trim) {
    return least_distance(blend_of(route, 0, trim).segments(), {100, 0}, 2);
  };
  EXPECT_NEAR(quartic(40), 10.606602, 5e-7);
  EXPECT_NEAR(quartic(15.084945), 4, 5e-7);
  // Without limits of acceleration and jerk, the shortest turn of a curvature is the parabola; only it fits.
  const Turn least = curved_turn({}, bend / 0.5, 0.04);
  EXPECT_EQ(least.share, 0);
  EXPECT_NEAR(least.length / 2, 35.355339, 5e-7);
  EXPECT_LT(greatest_curvature(blend_of(route, 0, 53.033009).segments(), 2), 0.04 * (1 + 1e-7));
  EXPECT_GT(greatest_curvature(blend_of(route, 0, 50).segments(), 2), 0.04);
  EXPECT_GT(bend / 0.5 / (0.5 * 100), 0.04) << "a turn with the share 1/2 and the trim 50";
}

/// The recomputed examples of the PMC600 manual that are no plans of other tests: 8.3 with a total acceleration, 8.4,
/// 8.5 and 8.6.
TEST(ClosedForms, OfThePmc600) {
  const GroupLimits total{.axes = std::vector<Limits>(2), .path = {.total_acceleration = 20000}};
  Program half(2);
  half.set({.velocity = 10000, .acceleration = 20000});
  half.arc(arc_of_radius({}, 5000, {10000, 0}, Plane{0, 1}, ArcRotation::clockwise));
  EXPECT_NEAR(lower_bound(plan(half, total), 20000), 2.096427, 2e-6);

  Program round(2);
  round.set({.velocity = 10000, .acceleration = 20000});
  round.curve(ellipse({}, {5000, 0}, {10000, 0}, Plane{0, 1}, 0, 0.8, ArcRotation::clockwise, 2));
  const Plan passes = plan(round, {.axes = std::vector<Limits>(2)});
  double most = 0;
  for (std::size_t k = 0; k < passes.path().pieces().size(); ++k) {
    std::array<Jet, 2> r{};
    passes.path().jets(k, 0, r);
    most = std::max(most, std::hypot(r[0][2], r[1][2]));
  }
  EXPECT_NEAR(most * 1e8, 31250, 1);

  for (const auto& [rise, length] : {std::pair{10000.0, 110409.535}, {20000.0, 111759.856}}) {
    Program screw(3);
    screw.set({.velocity = 10000, .acceleration = 20000});
    Arc arc = arc_of_radius({}, 5000, {10000, 0, rise}, Plane{0, 1}, ArcRotation::clockwise, 3);
    screw.arc(arc);
    EXPECT_NEAR(plan(screw, {.axes = std::vector<Limits>(3)}).path().length(), length, 5e-4);
  }

  Program lines(2);
  lines.set({.velocity = 10000, .acceleration = 20000});
  lines.line({1000, 1000});
  lines.line({3000, 2000});
  lines.line({4000, 0});
  EXPECT_NEAR(plan(lines, {.axes = std::vector<Limits>(2)}).duration(), 1.869310, 5e-7);
}

/// The circular fillets of example 8.6, as a CAM program has them: tangent arcs between the lines, with the trims
/// R tan(t / 2). The plan passes them without a stop, and they leave the corners by R (1 / cos(t / 2) - 1).
TEST(ClosedForms, OfTheFilletsOfThePmc600) {
  const Point corners[] = {{0, 0}, {1000, 1000}, {3000, 2000}, {4000, 0}};
  const double printed[][2] = {{16.2278, 1.3081},
                               {100.0, 41.4214}};  // trim and deviation for R 100
  const auto toward = [&](std::size_t k, std::size_t other) {
    const double x = corners[other][0] - corners[k][0];
    const double y = corners[other][1] - corners[k][1];
    return Point{x / std::hypot(x, y), y / std::hypot(x, y)};
  };
  for (const double radius : {100.0, 50.0}) {
    Program p(2);
    p.set({.velocity = 10000, .acceleration = 20000});
    for (std::size_t k = 1; k < 3; ++k) {
      const Point back = toward(k, k - 1);
      const Point on = toward(k, k + 1);
      const double cosine = -(back[0] * on[0] + back[1] * on[1]);
      const double trim = radius * std::sqrt((1 - cosine) / (1 + cosine));
      EXPECT_NEAR(trim, printed[k - 1][0] * radius / 100, 5e-5);
      const Point begin{corners[k][0] + trim * back[0], corners[k][1] + trim * back[1]};
      p.line(begin);
      p.arc(arc_of_radius(begin, radius,
                          {corners[k][0] + trim * on[0], corners[k][1] + trim * on[1]}, Plane{0, 1},
                          ArcRotation::clockwise));
    }
    p.line(corners[3]);
    const Plan made = plan(p, {.axes = std::vector<Limits>(2)});
    EXPECT_TRUE(std::ranges::none_of(made.junctions(), &JunctionMark::rests));
    const Path& path = made.path();
    ASSERT_EQ(path.pieces().size(), 5U);
    for (const std::size_t k : {1U, 2U}) {
      const Point middle = path.point(2 * k - 1, path.pieces()[2 * k - 1].length / 2);
      EXPECT_NEAR(std::hypot(middle[0] - corners[k][0], middle[1] - corners[k][1]),
                  printed[k - 1][1] * radius / 100, 5e-5);
    }
  }
}

/// HIMC 8.1.6, example 1: the profile 100/5000/5000/200 over a diagonal of 100 mm. The smoothing time
/// is the window of an average of the trapezoid: s / v + v / a + Ts. Its jerk is a / Ts. A plan with
/// this jerk is 0.0935 s faster, because a window always adds Ts, although the acceleration reaches
/// only v / Ts, a tenth of its limit; the shortest ramp with this jerk reaches 1581 mm/s^2.
TEST(ClosedForms, OfTheSmoothingTimeOfHimc) {
  Program p(2);
  p.set({.velocity = 100, .acceleration = 5000});
  p.line({100, 100});
  const Plan trapezoid = plan(p, {.axes = std::vector<Limits>(2)});
  const Trajectory smoothed = moving_average(trapezoid.law().curve(), 0.2);
  EXPECT_NEAR(smoothed.end() - smoothed.start(), 1.634214, 5e-7);
  EXPECT_NEAR(peak(smoothed, 2), 100 / 0.2, 1e-6);
  EXPECT_NEAR(peak(smoothed, 3), 5000 / 0.2, 1e-3);

  p = Program(2);
  p.set({.velocity = 100, .acceleration = 5000, .jerk = 25000});
  p.line({100, 100});
  const Plan fastest = plan(p, {.axes = std::vector<Limits>(2)});
  EXPECT_NEAR(fastest.duration(), 1.540705, 5e-7);
  EXPECT_NEAR(peak(fastest.law().curve(), 2), std::sqrt(100 * 25000.0), 1e-6);
}

/// Row 13: at this velocity, the straight lines between points 1 ms apart leave a circle by 1 um.
TEST(ClosedForms, OfTheChordsOfACircle) {
  const double velocity = forms().at("13_chord_cap");
  EXPECT_NEAR(velocity, 632.456587, 1e-6);  // the note rounds up its last digit
  Program p(2, {50, 0});
  p.set({.velocity = velocity, .acceleration = 1e6});
  p.arc(arc_about({50, 0}, {0, 0}, {50, 0}, Plane{0, 1}, ArcRotation::counterclockwise), 1);
  const Plan round = plan(p, {.axes = std::vector<Limits>(2)});
  std::vector<Motion> from(2);
  std::vector<Motion> to(2);
  for (int k = 1; k < 400; ++k) {
    round.at(0.001 * k, from);
    round.at(0.001 * (k + 1), to);
    const double off =
        50 - std::hypot(from[0].position + to[0].position, from[1].position + to[1].position) / 2;
    EXPECT_NEAR(off, 0.001, 1e-9) << k;
  }
}

/// Row 8: a constant velocity v on a circle has the jerk v^3 / R^2.
TEST(ClosedForms, OfTheJerkOfACircle) {
  Program p(2);
  p.set({.velocity = 100});
  p.arc(arc_about({}, {50, 0}, {}, Plane{0, 1}, ArcRotation::counterclockwise), 1);
  const Plan round = plan(p, usual(2));
  const Rates jerk_only = rates_of({.axes = std::vector<Limits>(2, {.jerk = 1e4})}, 2, 2);
  const double fastest = velocity_with(jerk_only, derivatives_of(round.path(), 0, 2), 0, 0);
  EXPECT_NEAR(fastest, 292.401774, 5e-7);
}

/// Row 9: the velocity that a ramp reaches falls with its first velocity, and then rises.
TEST(ClosedForms, OfRampsOverALength) {
  const std::pair<double, double> rows[] = {{0, 21.544347}, {5, 20.445115}, {20, 24.949397}};
  for (const auto& [from, to] : rows)
    EXPECT_NEAR(entry_velocity(1, from, {.acceleration = 1e9, .jerk = 1e4}).value(), to, 5e-7);
}

/// Row 12: curvature and torsion by the derivatives of a helix over its length.
TEST(ClosedForms, OfAHelix) {
  Program p(3);
  p.set({.velocity = 100});
  p.arc(arc_about({}, {50, 0}, {0, 0, 20}, Plane{0, 1}, ArcRotation::counterclockwise), 1);
  const Plan screw = plan(p, usual(3));
  const auto& row = forms().at("12_helix");
  EXPECT_NEAR(screw.path().length(), row.at("turn").get<double>(), 1e-11);
  std::vector<Jet> r(3);
  screw.path().jets(0, 123, r);
  // The derivatives over the length are perpendicular: |r''| = k, and r' . (r'' x r''') = k^2 torsion.
  double square = 0;
  double triple = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t m = (i + 1) % 3;
    const std::size_t n = (i + 2) % 3;
    square += r[i][2] * r[i][2];
    triple += r[i][1] * (r[m][2] * r[n][3] - r[n][2] * r[m][3]);
  }
  EXPECT_NEAR(std::sqrt(square), row.at("curvature").get<double>(), 1e-14);
  EXPECT_NEAR(std::abs(triple) / square, row.at("torsion").get<double>(), 1e-14);
}

}  // namespace
}  // namespace jounce::closed_form_test
