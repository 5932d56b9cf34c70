// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/path/overlap.hpp"
#include "jounce/profiles/curve/query.hpp"

#include "path/src/corners/turn.hpp"
#include "path/src/timing/box.hpp"
#include "tests/path/paths.hpp"

// The closed forms of tests/oracle/path.json (60 digits), with 100 mm/s, 1000 mm/s^2 and 1e4 mm/s^3.
namespace jounce::closed_form_test {
namespace {

using path_tests::usual;

const nlohmann::json& forms() {
  static const nlohmann::json all =
      nlohmann::json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/path.json"))
          .at("closed_forms");
  return all;
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
