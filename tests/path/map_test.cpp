// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/path/along.hpp"
#include "jounce/path/axis_map.hpp"
#include "jounce/path/direct.hpp"
#include "jounce/path/hold.hpp"
#include "jounce/path/override.hpp"
#include "jounce/profiles/error.hpp"

#include "tests/path/paths.hpp"

// Joints: derivatives against tests/oracle/paths/maps.py (60 digits, from the forward maps), plans against the forward
// kinematics written here.
namespace jounce::map_test {
namespace {

using path_tests::Random;
using testing::HasSubstr;

constexpr double degree = 180 / std::numbers::pi;

const nlohmann::json& oracle() {
  static const nlohmann::json all =
      nlohmann::json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/path.json")).at("maps");
  return all;
}

/// A third of the way along a line, by its length.
std::vector<Jet> jets_at_third(const AxisMap& map, const nlohmann::json& row) {
  const auto from = row.at("from").get<std::vector<double>>();
  const auto to = row.at("to").get<std::vector<double>>();
  double length = 0;
  for (std::size_t i = 0; i < from.size(); ++i) length = std::hypot(length, to[i] - from[i]);
  std::vector<Jet> point;
  for (std::size_t i = 0; i < from.size(); ++i)
    point.push_back({from[i] + (to[i] - from[i]) / 3, (to[i] - from[i]) / length, 0, 0});
  std::vector<Jet> joints(map.joints());
  EXPECT_EQ(map.jets(point, joints), MapState::ok);
  return joints;
}

void expect_joints(const std::vector<Jet>& joints, const nlohmann::json& wanted, double unit) {
  for (std::size_t j = 0; j < joints.size(); ++j)
    for (std::size_t k = 0; k < wanted[j].size(); ++k) {
      const double digits = unit * wanted[j][k].get<double>();
      EXPECT_NEAR(joints[j][k], digits, 1e-12 * std::abs(digits) + 1e-15) << j << " " << k;
    }
}

TEST(Map, AScaraHasTheJointsAndDerivativesOfTheOracle) {
  const nlohmann::json rows = oracle().at("scara");
  ASSERT_GT(rows.size(), 4u);
  for (const auto& row : rows) {
    const Elbow elbow = row.at("second_joint_sign") == 1 ? Elbow::right : Elbow::left;
    const auto map = scara_map({.arms = row.at("arms"), .elbow = elbow});
    expect_joints(jets_at_third(*map, row), row.at("joints_at_third"), degree);
  }
}

TEST(Map, ALinearDeltaHasTheJointsAndDerivativesOfTheOracle) {
  const nlohmann::json rows = oracle().at("delta");
  ASSERT_GT(rows.size(), 4u);
  for (const auto& row : rows) {
    const auto map = linear_delta_map({.outer_radius = row.at("outer_radius"),
                                       .inner_radius = row.at("inner_radius"),
                                       .arm = row.at("rod"),
                                       .first_rail = 90});
    expect_joints(jets_at_third(*map, row), row.at("joints_at_third"), 1);
  }
}

TEST(Map, CoreXYHasTheMotorsOfTheOracle) {
  for (const auto& row : oracle().at("corexy"))
    expect_joints(jets_at_third(*core_xy_map(2), row), row.at("motors_at_third"), 1);
}

/// Range of a coordinate.
struct Sides {
  double low, high;
};

/// Forward kinematics of a SCARA with two arms.
std::array<double, 2> scara_tool(double a, double b, double first, double second) {
  return {a * std::cos(first / degree) + b * std::cos((first + second) / degree),
          a * std::sin(first / degree) + b * std::sin((first + second) / degree)};
}

GroupLimits none(std::size_t n) {
  return {.axes = std::vector<Limits>(n)};
}

std::vector<Limits> joint_limits(std::size_t n, double v, double a, double j) {
  return std::vector<Limits>(n, {.velocity = v, .acceleration = a, .jerk = j});
}

/// A rectangle with an arc, within reach of two arms of 300.
Program rectangle(const PathSettings& settings) {
  Program p(2, {200, 100});
  p.set(settings);
  p.line({400, 100}, 1);
  p.line({400, 250}, 2);
  p.arc(arc_about(p.position(), {350, 250}, {350, 300}, Plane{0, 1}, ArcRotation::counterclockwise),
        3);
  p.line({200, 300}, 4);
  p.line({200, 100}, 5);
  return p;
}

TEST(Map, TheJointsOfAScaraPutTheToolOnThePathWithinTheirLimits) {
  const std::vector<Limits> limits = joint_limits(2, 200, 1500, 20000);
  const Program program = rectangle({.velocity = 400, .corner = Corner::deviation, .value = 2});
  for (const Elbow elbow : {Elbow::right, Elbow::left}) {
    const Plan motion =
        plan(program, none(2),
             {.joints = JointSpace{scara_map({.arms = {300, 300}, .elbow = elbow}), limits}});
    const PlanAxes axes = to_axes(motion);
    ASSERT_EQ(axes.curves.size(), 4u);
    EXPECT_LE(path_tests::worst_ratio(axes, motion.given().limits), 1 + 1e-12);
    EXPECT_GT(path_tests::worst_ratio(axes, motion.given().limits), 0.9);
    EXPECT_LE(motion.duration(), motion.stop_duration());
    EXPECT_GE(motion.duration(), lower_bound(motion) * (1 - 1e-12));
    ASSERT_TRUE(motion.given().fit);
    const MapFit fit = *motion.given().fit;
    EXPECT_TRUE(fit.proven);
    EXPECT_LE(fit.error, 1e-9 + 2e-12);
    double worst = 0;
    for (int i = 0; i <= 4000; ++i) {
      const double t = motion.duration() * i / 4000;
      const auto tool =
          scara_tool(300, 300, axes.curves[2].at(t).position, axes.curves[3].at(t).position);
      worst = std::max({worst, std::abs(tool[0] - axes.curves[0].at(t).position),
                        std::abs(tool[1] - axes.curves[1].at(t).position)});
    }
    // Both joints are off by the fit and by to_axes, on arms of 600 and 300.
    const double joint = (fit.error + axes.error[2][0] + axes.error[3][0]) / degree;
    EXPECT_LE(worst, 900 * joint + axes.error[0][0] + axes.error[1][0] + 1e-11);
    ASSERT_GE(motion.corners().size(), 2u);
    EXPECT_NEAR(motion.corners()[0].angle, std::numbers::pi / 2, 1e-9);
    EXPECT_LE(motion.corners()[0].deviation, 2 * (1 + 1e-12));
  }
}

TEST(Map, TheProvenBoundOfAFitHoldsAndIsNotFarFromTheError) {
  // One line: the joints at the fit's places are the map's; between them they are off by up to the bound.
  Program p(2, {250, -200});
  p.set({.velocity = 100});
  p.line({250, 300}, 1);
  const auto map = scara_map({.arms = {300, 300}});
  for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
    const Plan motion =
        plan(p, none(2), {.joints = JointSpace{map, joint_limits(2, 500, 5e3, 1e5), tolerance}});
    const MapFit fit = *motion.given().fit;
    ASSERT_TRUE(fit.proven);
    EXPECT_LE(fit.error, tolerance + 2e-12);
    double worst = 0;
    std::array<Jet, 4> jet;
    std::array<Jet, 2> exact;
    for (std::size_t k = 0; k < motion.path().pieces().size(); ++k)
      for (int i = 0; i <= 64; ++i) {
        motion.path().jets(k, motion.path().pieces()[k].length * i / 64, jet);
        ASSERT_EQ(map->jets(std::span(jet).first(2), exact), MapState::ok);
        for (std::size_t j = 0; j < 2; ++j)
          worst = std::max(worst, std::abs(jet[2 + j][0] - exact[j][0]));
      }
    EXPECT_LE(worst, fit.error);
    if (tolerance > 1e-9) {
      EXPECT_GT(worst, 1e-4 * fit.error);
    }
  }
}

TEST(Map, TheCarriagesOfADeltaKeepTheirRodsWithinTheirLimits) {
  const LinearDeltaSpec spec{
      .outer_radius = 200, .inner_radius = 40, .arm = 360, .distance = 500, .rail_angle = 10};
  Program p(3, {-60, 20, 0});
  p.set({.velocity = 300, .corner = Corner::deviation, .value = 1});
  p.line({60, 20, 30}, 1);
  p.line({60, -50, 0}, 2);
  p.arc(arc_through(p.position(), {0, -80, 20}, {-60, -50, 0}, 3), 3);
  p.line({-60, 20, 0}, 4);
  const Plan motion = plan(
      p, none(3), {.joints = JointSpace{linear_delta_map(spec), joint_limits(3, 400, 4000, 1e5)}});
  const PlanAxes axes = to_axes(motion);
  EXPECT_TRUE(motion.given().fit->proven);
  EXPECT_LE(path_tests::worst_ratio(axes, motion.given().limits), 1 + 1e-12);
  EXPECT_GT(path_tests::worst_ratio(axes, motion.given().limits), 0.9);
  const double sn = std::sin(10 / degree);
  const double cs = std::cos(10 / degree);
  for (int i = 0; i <= 1000; ++i) {
    const double t = motion.duration() * i / 1000;
    for (int rail = 0; rail < 3; ++rail) {
      const double turned = 120 * rail / degree;
      const double h = axes.curves[3 + static_cast<std::size_t>(rail)].at(t).position;
      const double out = 200 - h * sn - 40;  // from the platform's joint outwards
      const double x = axes.curves[0].at(t).position - out * std::cos(turned);
      const double y = axes.curves[1].at(t).position - out * std::sin(turned);
      const double z = axes.curves[2].at(t).position - (500 + h * cs);
      EXPECT_LT(z, 0) << "the carriage is above the tool";
      EXPECT_NEAR(std::sqrt(x * x + y * y + z * z), 360, 1e-8);
    }
  }
}

TEST(Map, AThirdArmKeepsItsDirection) {
  Program p(4, {300, 100, 10, 90}, 3);
  p.set({.velocity = 200});
  p.line({100, 350, 0, 30}, 1);
  const auto map = scara_map({.arms = {300, 250, 80},
                              .elbow = Elbow::left,
                              .offsets = {5, 0, -10},
                              .with_z = true,
                              .offset_z = 2});
  ASSERT_EQ(map->joints(), 4u);
  const Plan motion =
      plan(p, none(4), {.joints = JointSpace{map, joint_limits(4, 300, 3000, 1e5)}});
  const PlanAxes axes = to_axes(motion);
  EXPECT_LE(path_tests::worst_ratio(axes, motion.given().limits), 1 + 1e-12);
  for (int i = 0; i <= 200; ++i) {
    const double t = motion.duration() * i / 200;
    const auto at = [&](std::size_t k) { return axes.curves[k].at(t).position; };
    const double first = at(4) - 5;
    const double second = at(5);
    const double direction = first + second + at(6) + 10;
    const auto wrist = scara_tool(300, 250, first, second);
    EXPECT_NEAR(direction, at(3), 1e-8);
    EXPECT_NEAR(wrist[0] + 80 * std::cos(direction / degree), at(0), 1e-8);
    EXPECT_NEAR(wrist[1] + 80 * std::sin(direction / degree), at(1), 1e-8);
    EXPECT_NEAR(at(7), at(2) + 2, 1e-9);
  }
}

TEST(Map, AnArmThatGoesAroundTheBaseCountsOn) {
  Program p(2, {-300, -1});
  p.set({.velocity = 100});
  p.arc(arc_about(p.position(), {0, 0}, p.position(), Plane{0, 1}, ArcRotation::clockwise, 1), 1);
  const Plan motion = plan(
      p, none(2),
      {.joints = JointSpace{scara_map({.arms = {300, 200}}), joint_limits(2, 100, 500, 5000)}});
  const PlanAxes axes = to_axes(motion);
  EXPECT_NEAR(axes.curves[2].at(motion.duration()).position - axes.curves[2].at(0).position, -720,
              1e-8);
  EXPECT_LT(std::abs(largest_jump(axes.curves[2], 0).step), 1e-9);
  // The second joint stays: the radius does.
  const Range second = extrema(axes.curves[3], 0);
  EXPECT_NEAR(second.max.value, second.min.value, 1e-8);
}

/// A SCARA of a user: without enclosures.
class OwnScara final : public AxisMap {
 public:
  OwnScara() : AxisMap(2, 2), of_(scara_map({.arms = {300, 300}})) {}
  MapState jets(std::span<const Jet> point, std::span<Jet> joints) const override {
    return of_->jets(point, joints);
  }
  [[nodiscard]] double turn(std::size_t) const override { return 360; }

 private:
  std::shared_ptr<const AxisMap> of_;
};

TEST(Map, AMapWithoutBoundsIsReportedAsSampled) {
  const std::vector<Limits> limits = joint_limits(2, 200, 1500, 20000);
  const Program program = rectangle({.velocity = 400, .corner = Corner::deviation, .value = 2});
  const Plan motion =
      plan(program, none(2), {.joints = JointSpace{std::make_shared<OwnScara>(), limits}});
  const MapFit fit = *motion.given().fit;
  EXPECT_FALSE(fit.proven);
  EXPECT_GT(fit.sample_step, 0);
  EXPECT_LE(fit.sample_step, 200.0 / 8);
  EXPECT_LE(fit.error, 1e-9 + 2e-12);
  EXPECT_LE(path_tests::worst_ratio(to_axes(motion), motion.given().limits), 1 + 1e-12);
}

/// A map of a user with an error: beyond x = 150, its joints are NaN, or its velocities are halved.
class WrongMap final : public AxisMap {
 public:
  explicit WrongMap(bool nan) : AxisMap(2, 2), nan_(nan) {}
  MapState jets(std::span<const Jet> point, std::span<Jet> joints) const override {
    for (std::size_t j = 0; j < 2; ++j) {
      joints[j] = point[j];
      if (nan_ && point[0][0] > 150) joints[j].fill(std::nan(""));
      if (!nan_) joints[j][1] /= 2;
    }
    return MapState::ok;
  }

 private:
  bool nan_;
};

TEST(Map, AnErrorInAMapOfAUserIsReported) {
  const auto rejected = [](bool nan, const Program& program) {
    const JointSpace joints{std::make_shared<WrongMap>(nan), joint_limits(2, 200, 1500, 20000)};
    try {
      static_cast<void>(plan(program, none(2), {.joints = joints}));
    } catch (const InputError& error) {
      EXPECT_EQ(error.key(), "map");
      return error.rule();
    }
    return std::string();
  };
  const PathSettings rounded{.velocity = 400, .corner = Corner::deviation, .value = 2};
  EXPECT_THAT(rejected(true, rectangle(rounded)), HasSubstr("is not finite"));
  Program p(2);
  p.set(rounded);
  p.line({10, 0}, 1);
  EXPECT_THAT(rejected(false, p),
              HasSubstr("the first derivative 0.5, but its values change by 1"));
}

TEST(Map, AHaltKeepsTheLimitsOfTheJointsAndThePath) {
  const Program program = rectangle({.velocity = 400, .corner = Corner::deviation, .value = 2});
  const Plan motion = plan(
      program, none(2),
      {.joints = JointSpace{scara_map({.arms = {300, 300}}), joint_limits(2, 200, 1500, 20000)}});
  for (const double share : {0.1, 0.35, 0.6, 0.85}) {
    const Plan held = halted(motion, share * motion.duration());
    const PlanAxes axes = to_axes(held);
    EXPECT_LE(path_tests::worst_ratio(axes, motion.given().limits), 1 + 1e-12) << share;
    EXPECT_LE(held.duration(), motion.duration() * (1 + 1e-12));
    const double t = held.duration();
    const auto tool = scara_tool(300, 300, axes.curves[2].at(t, Side::left).position,
                                 axes.curves[3].at(t, Side::left).position);
    EXPECT_NEAR(tool[0], axes.curves[0].at(t, Side::left).position, 1e-7);
    EXPECT_NEAR(tool[1], axes.curves[1].at(t, Side::left).position, 1e-7);
  }
}

/// The joints of a SCARA with arms of 300 put the tool where its axes are.
void expect_tool(const PlanAxes& axes, double t) {
  const auto at = [&](std::size_t i) { return axes.curves[i].at(t, Side::left).position; };
  const auto tool = scara_tool(300, 300, at(2), at(3));
  EXPECT_NEAR(tool[0], at(0), 1e-7) << t;
  EXPECT_NEAR(tool[1], at(1), 1e-7) << t;
}

bool is_within(const Report& report) {
  return std::none_of(report.findings.begin(), report.findings.end(),
                      [](const Finding& f) { return f.broken; });
}

TEST(Map, AnOverrideAndARetreatKeepTheLimitsOfTheJointsAndThePath) {
  const auto scara = scara_map({.arms = {300, 300}});
  for (const PathSettings& settings :
       {PathSettings{.velocity = 400, .corner = Corner::deviation, .value = 2},
        PathSettings{.velocity = 90, .corner = Corner::velocity, .value = 20}}) {
    const Plan motion = plan(rectangle(settings), none(2),
                             {.joints = JointSpace{scara, joint_limits(2, 200, 1500, 20000)}});
    EXPECT_TRUE(is_within(check_along(motion)));
    const double end = motion.duration();
    const FactorRequest steps[] = {{0.1 * end, 1.5}, {0.3 * end, 0}, {0.5 * end, 0.4}};
    const Plan changed = played(motion, steps);
    const Plan held = halted(motion, 0.6 * end);
    const LawInterval& last = held.law().stretches().back();
    const Plan back = retreated(motion, held, motion.path().pieces()[1].start / 2);
    const Plan rest = resumed(motion, held);
    const auto turn = std::ranges::find(motion.drawn().pieces(), PieceKind::turn, &PathPiece::kind);
    const double within = turn->start + 0.4 * turn->length;
    const Plan to_corner = retreated(motion, held, within);
    const Plan from_corner = resumed(motion, within);
    EXPECT_TRUE(is_within(check_along(from_corner)));
    EXPECT_LT(last.start, motion.path().length());
    for (const Plan* each : {&changed, &back, &rest, &to_corner, &from_corner}) {
      const PlanAxes axes = to_axes(*each);
      EXPECT_LE(path_tests::worst_ratio(axes, motion.given().limits), 1 + 1e-12);
      for (int i = 1; i <= 50; ++i) expect_tool(axes, each->duration() * i / 50);
    }
    const FactorRequest slow[] = {{0.1 * end, 0.5}};
    const Plan slower = played(motion, slow);
    EXPECT_GT(slower.duration(), 1.2 * end);
    EXPECT_TRUE(is_within(check_along(slower)));
    // Corners pass at most at their velocity.
    const double most = settings.corner == Corner::velocity ? 20 : settings.velocity;
    for (const CornerRecord& corner : slower.corners())
      EXPECT_LE(corner.velocity, most * (1 + 1e-9));
    EXPECT_THROW((void)aborted(motion, end / 2, {200, 100}), InputError);
  }
}

InputError error_of(const Program& p, const std::shared_ptr<const AxisMap>& map,
                    double tolerance = 1e-9) {
  try {
    plan(p, none(p.axes()),
         {.joints = JointSpace{map, joint_limits(map->joints(), 100, 500, 5000), tolerance}});
  } catch (const InputError& error) {
    return error;
  }
  ADD_FAILURE() << "no error";
  return {"", "", ""};
}

TEST(Map, OutOfReachIsAnErrorWithItsLineAndItsPlace) {
  Program p(2, {200, 0});
  p.set({.velocity = 100});
  p.line({200, 100}, 3);
  p.line({700, 100}, 4);
  const InputError error = error_of(p, scara_map({.arms = {300, 300}}));
  EXPECT_EQ(error.line(), 4);
  EXPECT_EQ(error.key(), "point");
  EXPECT_THAT(error.rule(), HasSubstr("is out of reach of the joints, at "));
  // The border: x^2 + 100^2 = 600^2; the singular rim of the reach is 1e-12 of it wide.
  EXPECT_THAT(error.value(), HasSubstr("(591.608, 100"));
}

TEST(Map, AWayAcrossTheBaseAndAFoldedArmAreSingular) {
  Program across(2, {-100, 0});
  across.set({.velocity = 100});
  across.line({100, 0}, 7);
  const InputError error = error_of(across, scara_map({.arms = {300, 300}}));
  EXPECT_EQ(error.line(), 7);
  EXPECT_THAT(error.rule(), HasSubstr("is a singular position of the joints"));
  EXPECT_THAT(error.rule(), HasSubstr("at 100 along the path"));
  Program delta(3, {0, 0, 0});
  delta.set({.velocity = 100});
  delta.line({260, 0, 0}, 2);
  EXPECT_THAT(
      error_of(delta, linear_delta_map({.outer_radius = 200, .inner_radius = 40, .arm = 320}))
          .rule(),
      HasSubstr("is out of reach"));
}

/// The cube root of x: it is defined everywhere, and its velocity has no bound at x = 0.
class CubeRoot final : public AxisMap {
 public:
  CubeRoot() : AxisMap(2, 1) {}
  MapState jets(std::span<const Jet> point, std::span<Jet> joints) const override {
    const auto [x, first, second, third] = point[0];
    const double root = std::cbrt(x);
    EXPECT_EQ(second, 0) << "a line";
    EXPECT_EQ(third, 0);
    joints[0] = {root, first * root / (3 * x), -2 * first * first * root / (9 * x * x),
                 10 * first * first * first * root / (27 * x * x * x)};
    return MapState::ok;
  }
};

TEST(Map, AToleranceBelowTheRoundingIsNotASingularPosition) {
  Program p(2, {200, 0});
  p.set({.velocity = 100});
  p.line({200, 100}, 3);
  const InputError error = error_of(p, std::make_shared<OwnScara>(), 1e-20);
  EXPECT_EQ(error.key(), "tolerance");
  EXPECT_EQ(error.line(), 3);
  EXPECT_THAT(error.rule(),
              testing::MatchesRegex("is below the error of the fitted joints, which is "
                                    "[1-9][.0-9]*e-1[3-5] in their unit at [.0-9e-]+ "
                                    "along the path: give a greater tolerance"));
  Program across(2, {-100, 0});
  across.set({.velocity = 100});
  across.line({200, 0}, 7);
  EXPECT_THAT(error_of(across, std::make_shared<CubeRoot>()).rule(),
              HasSubstr("is a singular position of the joints, at 100 along the path"));
}

TEST(Map, TheMotorsOfACoreXYKeepTheirLimitsExactly) {
  // Along the diagonal motor a moves 200 and motor b rests: the move of one axis.
  Program p(2);
  p.set({.velocity = 1e3});
  p.line({100, 100}, 1);
  const Plan motion =
      plan(p, none(2), {.joints = JointSpace{core_xy_map(2), joint_limits(2, 100, 1000, 1e4)}});
  EXPECT_NEAR(motion.duration(), 200.0 / 100 + 100.0 / 1000 + 1000.0 / 1e4, 1e-12);
  EXPECT_EQ(motion.given().fit->error, 0);
  const Program round = rectangle({.velocity = 400, .corner = Corner::deviation, .value = 2});
  const Plan all =
      plan(round, none(2), {.joints = JointSpace{core_xy_map(2), joint_limits(2, 300, 2000, 3e4)}});
  const PlanAxes axes = to_axes(all);
  EXPECT_LE(path_tests::worst_ratio(axes, all.given().limits), 1 + 1e-12);
  EXPECT_GT(path_tests::worst_ratio(axes, all.given().limits), 0.99);
  for (int i = 0; i <= 500; ++i) {
    const double t = all.duration() * i / 500;
    const auto at = [&](std::size_t k) { return axes.curves[k].at(t).position; };
    EXPECT_NEAR(at(2), at(0) + at(1), 1e-8);
    EXPECT_NEAR(at(3), at(0) - at(1), 1e-8);
  }
}

TEST(Map, TheIdentityChangesNothing) {
  const Program program = rectangle({.velocity = 400, .corner = Corner::deviation, .value = 2});
  const std::vector<Limits> limits = joint_limits(2, 300, 2000, 3e4);
  const Plan plain = plan(program, {.axes = limits});
  const Plan same = plan(program, none(2), {.joints = JointSpace{identity_map(2), limits}});
  EXPECT_NEAR(same.duration(), plain.duration(), 1e-12);
  const std::size_t beams[] = {0, 1, 0};
  const Plan gantry =
      plan(program, none(2),
           {.joints = JointSpace{gantry_map(2, beams), joint_limits(3, 300, 2000, 3e4)}});
  EXPECT_NEAR(gantry.duration(), plain.duration(), 1e-12);
  EXPECT_EQ(gantry.path().axes(), 5u);
}

TEST(Map, RandomProgramsOfAScaraKeepTheLimitsOfTheirJoints) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const auto place = [&] {
      const double r = random.between(120, 500);
      const double angle = random.between(-1, 2);
      return Point{r * std::cos(angle), r * std::sin(angle)};
    };
    Program p(2, place());
    p.set({.velocity = random.log_between(50, 1000),
           .corner = Corner::deviation,
           .value = random.log_between(0.1, 10)});
    for (int k = 1; k <= 4; ++k) p.line(place(), k);
    const JointSpace joints{
        scara_map({.arms = {300, 250}}),
        joint_limits(2, random.log_between(50, 500), random.log_between(200, 5000),
                     random.log_between(1e3, 1e6))};
    try {
      const Plan motion = plan(p, none(2), {.joints = joints});
      EXPECT_LE(path_tests::excess(to_axes(motion), motion.given().limits), 1e-12) << seed;
      EXPECT_LE(motion.duration(), motion.stop_duration() * (1 + 1e-12)) << seed;
    } catch (const InputError& error) {  // a chord may pass the inner rim of the reach
      EXPECT_THAT(error.rule(), HasSubstr("of the joints")) << seed;
    }
  }
}

/// The tool of the joints of random points is the point again.
void expect_tool(const AxisMap& map, const std::vector<Sides>& box) {
  Random random(42);
  std::array<Jet, max_axes> point{};
  std::array<Jet, max_axes> joints{};
  int there = 0;
  for (int round = 0; round < 300; ++round) {
    for (std::size_t i = 0; i < map.axes(); ++i)
      point[i] = {box[i].low + (box[i].high - box[i].low) * random(), 0, 0, 0};
    if (map.jets(std::span(point).first(map.axes()), std::span(joints).first(map.joints())) !=
        MapState::ok)
      continue;
    std::array<double, max_axes> at{};
    for (std::size_t k = 0; k < map.joints(); ++k) at[k] = joints[k][0];
    const auto tool = map.tool(std::span(at).first(map.joints()));
    ASSERT_TRUE(tool);
    for (std::size_t i = 0; i < map.axes(); ++i) EXPECT_NEAR((*tool)[i], point[i][0], 1e-8);
    ++there;
  }
  EXPECT_GT(there, 100);
}

TEST(Map, TheToolOfTheJointsIsThePoint) {
  expect_tool(*scara_map({.arms = {300, 250}}), {{-540, 540}, {-540, 540}});
  expect_tool(*scara_map({.arms = {300, 250}, .elbow = Elbow::left, .with_z = true, .offset_z = 5}),
              {{-540, 540}, {-540, 540}, {-10, 100}});
  expect_tool(*scara_map({.arms = {300, 250, 80}, .offsets = {10, -20, 5}}),
              {{-500, 500}, {-500, 500}, {-170, 170}});
  for (const double angle : {0.0, 25.0, -30.0})
    expect_tool(*linear_delta_map({.outer_radius = 200,
                                   .inner_radius = 40,
                                   .arm = 320,
                                   .distance = 30,
                                   .rail_angle = angle,
                                   .first_rail = 90}),
                {{-80, 80}, {-80, 80}, {-60, 60}});
  expect_tool(*core_xy_map(3), {{-100, 100}, {-100, 100}, {0, 50}});
  const std::array<std::size_t, 4> beam{0, 1, 1, 2};
  expect_tool(*gantry_map(3, beam), {{-100, 100}, {-100, 100}, {0, 50}});
}

TEST(Map, JointsThatDoNotFitTogetherHaveNoTool) {
  const auto scara = scara_map({.arms = {300, 250}});
  EXPECT_TRUE(scara->tool(std::array<double, 2>{0, 90}));
  EXPECT_FALSE(scara->tool(std::array<double, 2>{0, -90})) << "the other side of the elbow";
  EXPECT_TRUE(scara->tool(std::array<double, 2>{360, 90})) << "a whole turn";
  const std::array<std::size_t, 3> beam{0, 1, 1};
  const auto gantry = gantry_map(2, beam);
  EXPECT_TRUE(gantry->tool(std::array<double, 3>{5, 7, 7}));
  EXPECT_FALSE(gantry->tool(std::array<double, 3>{5, 7, 8})) << "a skewed beam";
  EXPECT_FALSE(identity_map(2)->tool(std::array<double, 2>{std::nan(""), 0}));
}

TEST(Map, ParametersAreChecked) {
  EXPECT_THROW(scara_map({.arms = {300}}), InputError);
  EXPECT_THROW(scara_map({.arms = {300, 0}}), InputError);
  EXPECT_THROW(scara_map({.arms = {300, 100}, .offsets = {1}}), InputError);
  EXPECT_THROW(linear_delta_map({.outer_radius = 100, .inner_radius = 10, .arm = 0}), InputError);
  EXPECT_THROW(
      linear_delta_map({.outer_radius = 100, .inner_radius = 10, .arm = 200, .rail_angle = 90}),
      InputError);
  EXPECT_THROW(core_xy_map(1), InputError);
  EXPECT_THROW(identity_map(5), InputError);
  EXPECT_THROW(plan(rectangle({.velocity = 1}), none(2),
                    {.joints = JointSpace{core_xy_map(2), joint_limits(1, 1, 1, 1)}}),
               InputError);
}

/// Limits of a joint in a command: they hold in this command and on both of its corners, and only there.
TEST(Map, LimitsOfJointsInACommandHoldThere) {
  Program p(2, {200, 100});
  const PathSettings free{.velocity = 400, .corner = Corner::deviation, .value = 2};
  PathSettings slow = free;
  slow.axes = std::vector<AxisRates>(4);
  slow.axes[2] = {.velocity = 15, .acceleration = 150, .jerk = 3000};
  p.set(free);
  p.line({400, 100}, 1);
  p.set(slow);
  p.line({400, 250}, 2);
  p.set(free);
  p.line({200, 300}, 3);
  const Plan motion = plan(
      p, none(2),
      {.joints = JointSpace{scara_map({.arms = {300, 300}}), joint_limits(2, 200, 1500, 20000)}});
  std::array<double, 3> slow_peak{}, free_peak{};
  const PlanAxes axes = to_axes(motion);
  double time = 0;
  for (const Segment& f : axes.curves[2].segments()) {
    const double q = motion.law().at(time + f.length / 2).position;
    const auto drawn = motion.drawn().pieces();
    const auto piece = std::prev(std::upper_bound(
        drawn.begin(), drawn.end(), q, [](double x, const PathPiece& at) { return x < at.start; }));
    const bool limited = piece->line == 2 || (piece->line == 3 && piece->kind == PieceKind::turn);
    for (std::size_t order = 1; order <= 3; ++order)
      for (double s = 0; s <= 1; s += 1.0 / 64) {
        double& peak = (limited ? slow_peak : free_peak)[order - 1];
        peak = std::max(peak, std::abs(evaluate(f, s)[order]));
      }
    time += f.length;
  }
  EXPECT_LE(slow_peak[0], 15 * (1 + 1e-12));
  EXPECT_GT(slow_peak[0], 15 * 0.8);
  EXPECT_LE(slow_peak[1], 150 * (1 + 1e-12));
  EXPECT_LE(slow_peak[2], 3000 * (1 + 1e-12));
  EXPECT_GT(free_peak[0], 30);
  EXPECT_LE(motion.duration(), motion.stop_duration());
}

TEST(Map, ACommandOfTooManyTurnsIsRejected) {
  Program p(3, {400, 100, 0}, 2);
  p.set({.velocity = 500});
  p.line({300, 200, 90}, 1);
  p.line({200, 250, 4.5e7}, 2);
  try {
    plan(p, none(3),
         {.joints =
              JointSpace{scara_map({.arms = {300, 250, 80}}), joint_limits(3, 200, 2e3, 4e4)}});
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.key(), "to[3]");
    EXPECT_EQ(error.line(), 2);
    EXPECT_THAT(error.what(), HasSubstr("a travel of 44999910"));
    EXPECT_THAT(error.what(), HasSubstr("more than 100000 polynomials"));
  }
}

}  // namespace
}  // namespace jounce::map_test
