// SPDX-License-Identifier: Apache-2.0
// The examples of the PMC600 manual, chapter 8, and of the HMPL manual, 8.1.6, take the times that closed forms give:
// a move of length L from rest to rest takes L / v + v / a without, and L / v + v / a + a / j with a limit of jerk.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "jounce/design/detail/path_text.hpp"
#include "jounce/design/input.hpp"
#include "jounce/path/along.hpp"
#include "jounce/pvt/check.hpp"
#include "jounce/pvt/sample.hpp"

namespace jounce::path_examples_test {
namespace {

const std::string examples = JOUNCE_SOURCE_DIR "/examples/";

double duration(const std::string& name) {
  const std::vector<Input> all = inputs_of(read_spec(examples + name), name);
  for (const Input& input : all) {
    EXPECT_TRUE(check_all(input).ok()) << name << " " << input.axis;
    EXPECT_NEAR(input.table.table.end(), all.front().plan->duration(), 1e-9) << name;
  }
  return all.front().plan->duration();
}

double move(double length, double v, double a) {
  return length / v + v / a;
}

TEST(PathExamples, OfThePmc600TakeTheirTimes) {
  const double pi = std::acos(-1);
  EXPECT_NEAR(duration("pmc600-path/lines.toml"),
              move(1500, 1000, 1000) + move(std::sqrt(3.5e6), 1000, 1000), 1e-9);
  EXPECT_NEAR(duration("pmc600-path/arcs.toml"),
              move(pi * 5000, 10000, 20000) + move(pi * 10000, 10000, 20000), 1e-9);
  EXPECT_NEAR(duration("pmc600-path/helix.toml"),
              move(std::hypot(7 * pi * 5000, 10000), 10000, 20000), 1e-9);
  // Half the perimeter: tests/oracle/path.json, pmc600 8.4.
  EXPECT_NEAR(duration("pmc600-path/ellipse.toml"), 2 * move(14180.833944487242, 10000, 20000),
              1e-6);
  EXPECT_NEAR(duration("pmc600-path/corners.toml"),
              move(std::sqrt(2) * 1000, 1000, 2000) + 2 * move(std::sqrt(5e6), 1000, 2000), 1e-9);
  const double diagonal = std::sqrt(2) * 50000;
  EXPECT_NEAR(duration("pmc600-path/gcode.toml"),
              move(diagonal, 50000, 500000) + move(diagonal, 30000, 300000), 1e-9);
}

TEST(PathExamples, OfHimcTakeTheirTimes) {
  // v 100, j 25000: the ramp reaches no limit of acceleration and takes 2 sqrt(v / j).
  const double ramp = 2 * std::sqrt(100.0 / 25000);
  const auto with_jerk = [&](double length) { return length / 100 + ramp; };
  EXPECT_NEAR(duration("himc-path/lines.toml"), 2 * with_jerk(std::sqrt(2) * 100), 1e-9);
  EXPECT_NEAR(duration("himc-path/helix.toml"), with_jerk(std::hypot(10 * std::acos(-1) * 50, 100)),
              1e-9);
  const double square = duration("himc-path/square.toml");
  EXPECT_LT(square, 4 * with_jerk(100));
  EXPECT_GT(square, 3 * with_jerk(100) + 0.9);
}

/// Checks all axes of an example; returns the points at which its commands end.
std::vector<Point> ends_of(const std::string& name) {
  const std::vector<Input> all = inputs_of(read_spec(examples + name), name);
  for (const Input& input : all) EXPECT_TRUE(check_all(input).ok()) << name << " " << input.axis;
  const Program& program = std::get<PathSpec>(all.front().spec->subject).program;
  std::vector<Point> ends;
  for (const Program::Command& command : program.commands()) {
    if (command.kind == Program::Kind::arc) {
      ends.push_back(program.arcs()[command.data].to);
      continue;
    }
    Point to{};
    for (std::size_t i = 0; i < program.axes(); ++i) to[i] = program.numbers()[command.data + i];
    ends.push_back(to);
  }
  return ends;
}

void expect_near(const Point& p, double x, double y, double tolerance = 1e-9) {
  EXPECT_NEAR(p[0], x, tolerance);
  EXPECT_NEAR(p[1], y, tolerance);
}

TEST(PathExamples, OfHimcFramesReachThePointsOfTheManual) {
  const double diagonal = 10 * std::sqrt(2);
  const auto frame = ends_of("himc-path/frame.toml");  // 5-1
  ASSERT_EQ(frame.size(), 1U);
  expect_near(frame[0], 400, 200 + diagonal);
  const auto work = ends_of("himc-path/work-frames.toml");  // 5-2 and 5-3
  ASSERT_EQ(work.size(), 6U);
  const double places[][2] = {{500, 450}, {700, 50}, {900, -350}};
  for (std::size_t k = 0; k < 6; ++k) {
    const double offset = k < 3 ? 0 : -100;
    expect_near(work[k], places[k % 3][0], places[k % 3][1] + diagonal + offset);
  }
}

TEST(PathExamples, OfHimcArcsEndAsInTheManual) {
  const auto ends = ends_of("himc-path/arc-forms.toml");
  ASSERT_EQ(ends.size(), 7U);
  expect_near(ends[0], 200, 300);                    // 8.2.11
  expect_near(ends[2], 10, 10 - 10 * std::sqrt(2));  // 8.2.16
  expect_near(ends[4], 200, 0);                      // 8.2.13
  expect_near(ends[6], 200, 0);                      // 8.2.17
  const auto axes = inputs_of(read_spec(examples + "himc-path/arc-forms.toml"), "");
  const Path& path = axes.front().plan->path();
  expect_near(path.point(4, path.pieces()[4].length / 2), 100, 100);
  expect_near(path.point(6, path.pieces()[6].length / 2), 100, -100);
  for (const std::size_t half : {4U, 6U})
    EXPECT_NEAR(path.pieces()[half].length, 100 * std::acos(-1), 1e-9);
}

TEST(PathExamples, OfHimcTheArcHasTheSpeedOfItsAcceleration) {
  const auto axes = inputs_of(read_spec(examples + "himc-path/arc-speed.toml"), "");
  const Plan& plan = *axes.front().plan;
  double fastest = 0;
  for (const LawInterval& s : plan.law().stretches())
    if (plan.path().pieces()[s.piece].kind == PieceKind::arc) fastest = std::max(fastest, s.peak);
  EXPECT_NEAR(fastest, std::sqrt(100.0 * 50), 1e-4);  // 70.71
  EXPECT_TRUE(check_along(plan).ok());
}

TEST(PathExamples, OfPmc600TheVelocityIsContinuousAcrossABlendedCorner) {
  const auto axes = inputs_of(read_spec(examples + "pmc600-path/blended-corner.toml"), "");
  const auto corners = axes.front().plan->corners();
  ASSERT_EQ(corners.size(), 1U);
  EXPECT_FALSE(corners[0].stop);
  EXPECT_LE(corners[0].trim, 10 * (1 + 1e-12));
  for (const Input& axis : axes) {
    EXPECT_TRUE(check_continuity(std::get<Trajectory>(*axis.curve), 1).ok());
    EXPECT_TRUE(check_all(axis).ok()) << axis.axis;
  }
}

TEST(PathExamples, OfTheRefinedSquareTakesLessTime) {
  EXPECT_LE(duration("path-square/refined.toml"), 1.003 * 4.528);
}

TEST(PathTables, KeepTheLimitsThatTheirCurvesKeep) {
  // An arc whose greatest acceleration is the limit, but for 1e-6. A table of few knots exceeds it by 0.01 %.
  const std::string text = R"(
jounce = 1
kind = "path"
units = { position = "mm", time = "s" }
[path]
velocity = 198.8
corner = { deviation = 0.408 }
start = [-84.945, -4.055]
[[axis]]
name = "x"
limits = { velocity = 76.4, acceleration = 391, jerk = 60583 }
table = { tolerance = 0.001 }
[[axis]]
name = "y"
limits = { velocity = 160.7, acceleration = 477, jerk = 9477 }
table = { tolerance = 0.001 }
[[command]]
type = "arc"
center = [-84.945, -34.626]
to = [-84.945, -4.055]
rotation = "counterclockwise"
[[command]]
type = "arc"
center = [-84.945, 10.339]
to = [-70.551, 10.339]
rotation = "clockwise"
[[command]]
type = "line"
to = [-70.562711, 10.405001]
)";
  for (const Input& axis : inputs_of(parse_spec(text, "arc.toml"), "arc.toml")) {
    EXPECT_TRUE(check_all(axis).ok()) << axis.axis;
    EXPECT_LE(axis.error->position, 0.001);
    const auto& curve = std::get<Trajectory>(*axis.curve);
    const Table coarse = sample_within(curve, axis.table.table.rule(), 0.001).table;
    EXPECT_EQ(check(coarse, axis.limits).ok(), axis.axis == "y") << "without limits";
    EXPECT_LE(axis.table.table.size(), coarse.size() + 40);
  }
}

/// A move whose table has the given keys.
Input move_with_table(const std::string& keys) {
  const std::string text = R"(
jounce = 1
kind = "move"
units = { position = "mm", time = "s" }
[move]
profile = "s_curve"
to = 50
velocity = 10
acceleration = 20
jerk = 100
[limits]
velocity = 10
acceleration = 20
[table]
)" + keys;
  return inputs_of(parse_spec(text, "move.toml"), "move.toml").front();
}

TEST(Tables, OfTheFewestKnotsKeepTheLimitsOfTheirCurve) {
  const Input fewest = move_with_table("knots = \"fewest\"\ntolerance = 0.01\n");
  EXPECT_TRUE(check_all(fewest).ok());
  EXPECT_LE(fewest.error->position, 0.01);
}

TEST(Tables, OfEqualIntervalsBeyondALimitAreFindings) {
  const Input coarse = move_with_table("intervals = 7\n");
  const Report report = check_all(coarse);
  ASSERT_FALSE(report.ok());
  EXPECT_TRUE(std::any_of(report.findings.begin(), report.findings.end(), [](const Finding& f) {
    return f.broken && f.axis == "table" && f.rule.family() == RuleFamily::limit &&
           f.advice.find("Increase intervals in [table]") != std::string::npos;
  }));
  const Input stepped = move_with_table("tolerance = 0.01\nposition_resolution = 0.001\n");
  const Report of_steps = check_all(stepped);
  EXPECT_TRUE(std::any_of(of_steps.findings.begin(), of_steps.findings.end(), [](const Finding& f) {
    return f.broken && f.advice.find("remove its resolutions") != std::string::npos;
  }));
}

TEST(PathExamples, OfAnOverlapTakesItsClosedForm) {
  const auto axes = inputs_of(read_spec(examples + "path-square/overlap.toml"), "");
  // tests/oracle/path.json, closed form 5.
  EXPECT_NEAR(axes.front().overlap->duration, 4.349152, 1e-6);
  EXPECT_NEAR(axes.front().table.table.end(), 4.349152, 1e-6);
  EXPECT_EQ(axes.front().overlap->corners.size(), 3U);
  for (const Input& axis : axes) EXPECT_TRUE(check_all(axis).ok());
}

TEST(PathExamples, OfAnOverrideTakesTheTimeOfTheManual) {
  EXPECT_NEAR(duration("pmc600-path/ratio.toml"), 0.75 + 2450.0 / 3000 + 0.3, 1e-9);
}

TEST(PathExamples, OfGcodeWithArcsStopsAtEachCorner) {
  const double pi = std::acos(-1);
  EXPECT_NEAR(duration("pmc600-path/gcode-arcs.toml"),
              move(std::sqrt(2) * 1000, 1000, 2000) + 2 * move(pi * 500, 1000, 2000), 1e-9);
}

const Plan& plan_of(const std::vector<Input>& axes) {
  return *axes.front().plan;
}

/// Velocity along the path where it first is at q.
double velocity_at(const Plan& plan, double q) {
  double low = 0;
  double high = plan.duration();
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (plan.law().at(middle).position < q ? low : high) = middle;
  }
  return plan.law().at(low).velocity;
}

TEST(PathExamples, OfHimcTheStadiumRestsAtThePointThatComesLate) {
  const auto axes = inputs_of(read_spec(examples + "himc-path/stadium.toml"), "");
  const Plan& plan = plan_of(axes);
  const double half = 50 * std::acos(-1);  // 157.08
  EXPECT_NEAR(plan.path().length(), 200 + 2 * half, 1e-9);
  const double p1 = velocity_at(plan, 100);
  EXPECT_GT(p1, 90);
  EXPECT_LE(p1, 100 * (1 + 1e-12));
  EXPECT_NEAR(velocity_at(plan, 100 + half), 50, 1e-6);
  EXPECT_NEAR(velocity_at(plan, 200 + half), 0, 0.01);
  for (const Input& axis : axes) EXPECT_TRUE(check_all(axis).ok());
}

TEST(PathExamples, OfHimcTheSecondLapIsRoundedEverywhere) {
  const auto axes = inputs_of(read_spec(examples + "himc-path/second-lap.toml"), "");
  const std::vector<CornerRecord> corners = plan_of(axes).corners();
  ASSERT_EQ(corners.size(), 8U);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    EXPECT_EQ(corners[k].stop, k < 3) << k;
    EXPECT_LE(corners[k].trim, k < 3 ? 0 : 20 * (1 + 1e-12)) << k;
    if (k >= 3) {
      EXPECT_GT(corners[k].trim, 0) << k;
    }
  }
  EXPECT_LE(corners.back().trim, 10 * (1 + 1e-12));
  for (const Input& axis : axes) EXPECT_TRUE(check_all(axis).ok());
}

TEST(PathExamples, OfHimcCornersBesideAnArcAreRounded) {
  const auto axes = inputs_of(read_spec(examples + "himc-path/arc-corners.toml"), "");
  const std::vector<CornerRecord> corners = plan_of(axes).corners();
  ASSERT_EQ(corners.size(), 2U);
  for (const CornerRecord& corner : corners) {
    EXPECT_FALSE(corner.stop);
    EXPECT_NEAR(corner.angle, std::acos(0), 1e-9) << "that of the joint, not of the blend";
    EXPECT_GT(corner.trim, 0);
    EXPECT_LE(corner.trim, 20 * (1 + 1e-12));
  }
  for (const Input& axis : axes) EXPECT_TRUE(check_all(axis).ok());
}

TEST(PathExamples, AnOverrideAboveOneMultipliesTheFeed) {
  // PMC600 8.2: 3000 pulses/s under the factors 0.5, 1.5 and 1.
  const auto axes = inputs_of(read_spec(examples + "pmc600-path/ratio.toml"), "");
  const Report report = path_report(*axes.front().spec, plan_of(axes));
  EXPECT_TRUE(report.ok());
  EXPECT_FALSE(check_along(plan_of(axes)).ok()) << "4500 pulses/s are above the feed itself";
}

TEST(PathExamples, OfTheSquareAreNeverSlowerThanStopping) {
  EXPECT_NEAR(duration("path-square/stop.toml"), 4.8, 1e-9);
  // spec of the corner: v 56.462162 mm/s in each, tests/oracle/path.json, closed form 3.
  EXPECT_LE(duration("path-square/deviation.toml"), 4.568655 + 1e-6);
  for (const char* mode : {"distance", "curvature", "velocity"})
    EXPECT_LT(duration(std::string("path-square/") + mode + ".toml"), 4.8) << mode;
}

}  // namespace
}  // namespace jounce::path_examples_test
