// SPDX-License-Identifier: Apache-2.0
// A group with a follower: a welding head, whose rotary axis c (deg) moves along with x and y (mm). The judge
// has the limits of the axes and the requested lines and arcs with the angles at their ends, and nothing of
// the planner.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/executor/detail/group_plan.hpp"

#include "executor/group/judged_plotter.hpp"

namespace jounce::group_followers_test {
namespace {

using namespace test;
using namespace std::chrono_literals;
using ::testing::HasSubstr;

constexpr std::size_t x = 0, y = 1, c = 2, head = 3;

/// The options of the head. `turn`: of c, deg; 0: a linear axis. `window`: of the plans of a long program.
std::vector<ExecutorOptions> welding_head(double turn, const PlanWindow& window) {
  const Limits linear = limits(200, 2000, 1e5);
  const Limits rotary = limits(360, 4000, 2e5);
  std::vector<ExecutorOptions> axes{axis_named("x", linear, {"", "mm"}),
                                    axis_named("y", linear, {"", "mm"}),
                                    axis_named("c", rotary, {"", "deg"})};
  axes[c].axis.modulo = turn;
  const std::vector<AxisConfig> configs{axes[x].axis, axes[y].axis, axes[c].axis};
  ExecutorOptions all = axis_named("head", {}, {"", "mm"});
  all.axis = group_config(configs);
  all.enable = false;
  all.group = ExecutorGroup{.of = {{x, y, c}},
                            .names = {"x", "y", "c"},
                            .configs = configs,
                            .followers = 1,
                            .unit = "mm",
                            .units = {"mm", "mm", "deg"},
                            .window = window};
  axes.push_back(std::move(all));
  return axes;
}

/// A requested line or arc in the plane, with the angle of c at both ends.
struct Stroke {
  double x0, y0, c0, x1, y1, c1;
  double cx = 0, cy = 0, r = 0;  // r > 0: counterclockwise arc
};

/// The distance of a place from the stroke, and the angle that c has there: proportional to the length.
struct Found {
  double away = std::numeric_limits<double>::infinity();
  double angle = 0;
};

Found found(const Stroke& s, double px, double py) {
  if (s.r > 0) {
    const auto angle_at = [&](double ax, double ay) { return std::atan2(ay - s.cy, ax - s.cx); };
    const auto turned = [](double angle) {
      return angle < -1e-9 ? angle + 2 * std::numbers::pi : angle;
    };
    const double begin = angle_at(s.x0, s.y0);
    const double whole = turned(angle_at(s.x1, s.y1) - begin);
    const double share = std::clamp(turned(angle_at(px, py) - begin) / whole, 0.0, 1.0);
    return {std::abs(std::hypot(px - s.cx, py - s.cy) - s.r), s.c0 + share * (s.c1 - s.c0)};
  }
  const double dx = s.x1 - s.x0;
  const double dy = s.y1 - s.y0;
  const double square = dx * dx + dy * dy;
  if (square == 0) return {std::hypot(px - s.x0, py - s.y0), NAN};  // only c moves
  const double share = std::clamp(((px - s.x0) * dx + (py - s.y0) * dy) / square, 0.0, 1.0);
  return {std::hypot(px - s.x0 - share * dx, py - s.y0 - share * dy), s.c0 + share * (s.c1 - s.c0)};
}

/// A head that is judged in every tick.
struct JudgedHead : Site {
  explicit JudgedHead(double turn = 0, const PlanWindow& window = {})
      : Site(welding_head(turn, window), {.masters = {}, .recorded = true, .said = {}}) {
    for (std::size_t i = 0; i < 3; ++i) configs.push_back(resolved(axes[i].axis));
    after = [this] { judge(); };
    advance(10ms);
    EXPECT_TRUE(order("head", command::Enable{}).ok());
  }

  CallOutcome order(const char* name, const ClientCommand& command) {
    Client client(link, name, {}, clock);
    const CallOutcome outcome = client.command(command);
    static_cast<void>(client.release());
    return outcome;
  }
  std::string refused(const ClientCommand& command) {
    const CallOutcome outcome = order("head", command);
    EXPECT_FALSE(outcome.ok());
    return outcome.reason;
  }

  void judge() {
    const Tick& all = last(head);
    const bool full = all.rate == before[head].rate;
    for (std::size_t i = 0; i < 3; ++i) {
      const Tick& axis = last(i);
      if (axis.tick == before[i].tick) continue;
      if (axis.state == State::synchronized_motion && before[i].state == axis.state) {
        ASSERT_TRUE(keeps_limits(configs[i], before[i], axis, full))
            << "axis " << i << " is beyond a limit in tick " << axis.tick;
        fastest[i] = std::max(fastest[i], std::abs(axis.velocity));
      }
      before[i] = axis;
    }
    before[head] = all;
    if (all.job == 0 || strokes.empty()) return;
    ++judged;
    Found best;
    double angle = std::numeric_limits<double>::infinity();
    for (const Stroke& s : strokes) {
      const Found here = found(s, last(x).position, last(y).position);
      best.away = std::min(best.away, here.away);
      if (here.away > tolerance) continue;
      const double low = std::min(s.c0, s.c1);
      const double high = std::max(s.c0, s.c1);
      const double at = last(c).position - offset;
      angle = std::min(angle, std::isnan(here.angle) ? std::abs(at - std::clamp(at, low, high))
                                                     : std::abs(at - here.angle));
    }
    ASSERT_LE(best.away, tolerance) << "off the path in tick " << all.tick;
    ASSERT_LE(angle, angle_tolerance)
        << "c is not proportional in tick " << all.tick << ": " << last(c).position;
  }
  void rests() {
    for (int k = 0; k < 20000 && last(head).job != 0; ++k) advance(10ms);
    ASSERT_EQ(last(head).state, State::standstill);
    advance(20ms);
  }
  void expect_at(double px, double py, double pc) {
    EXPECT_NEAR(last(x).position, px, 1e-9);
    EXPECT_NEAR(last(y).position, py, 1e-9);
    EXPECT_NEAR(last(c).position, pc, 1e-9);
  }

  std::vector<AxisConfig> configs;
  std::vector<Stroke> strokes;
  double tolerance = 1e-9;
  double angle_tolerance = 1e-7;
  double offset = 0;  // whole turns of c
  std::array<Tick, 4> before{};
  std::array<double, 3> fastest{};
  int judged = 0;
};

command::Coordinates to(double px, double py, double pc) {
  command::Coordinates all = command::no_coordinates<command::most_coordinates>();
  all[0] = px;
  all[1] = py;
  all[2] = pc;
  return all;
}

constexpr double none = as_configured;

command::PathDynamics at_velocity(double velocity) {
  return {.along = {.velocity = velocity}};
}

TEST(GroupFollowers, TheFeedCountsThePathAxesOnly) {
  JudgedHead site;
  site.strokes = {{0, 0, 0, 30, 40, 90}};
  ASSERT_TRUE(
      site.order("head", command::MoveLinearAbsolute{to(30, 40, 90), at_velocity(100)}).ok());
  site.advance(250ms);
  EXPECT_NEAR(std::hypot(site.last(x).velocity, site.last(y).velocity), 100, 1e-9);
  EXPECT_NEAR(site.last(c).velocity, 180, 1e-9) << "90 deg in 50 mm at 100 mm/s";
  EXPECT_NEAR(site.last(head).velocity, 100, 1e-9);
  site.rests();
  site.expect_at(30, 40, 90);
  EXPECT_GT(site.judged, 400);
  EXPECT_TRUE(site.replayed().same());
}

TEST(GroupFollowers, TheLimitsOfTheFollowerSlowThePath) {
  JudgedHead site;
  site.strokes = {{0, 0, 0, 30, 40, 360}};
  const CallOutcome outcome =
      site.order("head", command::MoveLinearAbsolute{to(30, 40, 360), at_velocity(100)});
  ASSERT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_EQ(outcome.reason, "the limits lower the velocity from 100 mm/s to 50 mm/s");
  site.rests();
  EXPECT_NEAR(site.fastest[c], 360, 1e-6);
  EXPECT_NEAR(std::hypot(site.fastest[x], site.fastest[y]), 50, 1e-6);
}

TEST(GroupFollowers, ACommandOfTheFollowerAloneCountsInItsUnit) {
  JudgedHead site;
  site.strokes = {{0, 0, 0, 0, 0, 90}};
  CallOutcome outcome =
      site.order("head", command::MoveLinearAbsolute{to(none, none, 90), at_velocity(45)});
  ASSERT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_THAT(outcome.reason, HasSubstr("only followers move, so the velocity is 45 deg/s"));
  site.rests();
  EXPECT_NEAR(site.fastest[c], 45, 1e-9);
  site.expect_at(0, 0, 90);
  site.strokes = {{0, 0, 90, 0, 0, 900}};
  outcome = site.order("head", command::MoveLinearRelative{to(none, none, 810), at_velocity(500)});
  ASSERT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_EQ(outcome.reason, "the limits lower the velocity from 500 deg/s to 360 deg/s");
  site.rests();
  site.expect_at(0, 0, 900);
}

TEST(GroupFollowers, AnArcTurnsTheFollowerInProportionToItsLength) {
  JudgedHead site;
  site.strokes = {{0, 0, 0, 20, 20, 90, 0, 20, 20}};
  command::MoveCircularAbsolute arc{.to = to(20, 20, 90), .path = at_velocity(60)};
  arc.center[0] = 0;
  arc.center[1] = 20;
  const CallOutcome outcome = site.order("head", arc);
  ASSERT_TRUE(outcome.ok()) << outcome.reason;
  site.rests();
  site.expect_at(20, 20, 90);
  command::MoveCircularAbsolute via{.to = to(0, 40, 180)};
  via.via[0] = 20 / std::numbers::sqrt2;
  via.via[1] = 20 + 20 / std::numbers::sqrt2;
  site.strokes = {{20, 20, 90, 0, 40, 180, 0, 20, 20}};
  ASSERT_TRUE(site.order("head", via).ok());
  site.rests();
  site.expect_at(0, 40, 180);
  via.via[2] = 5;
  EXPECT_THAT(site.refused(via), HasSubstr("is the coordinate of a follower"));
}

TEST(GroupFollowers, HoldOverrideAndContinuationStayOnThePath) {
  JudgedHead site;
  site.strokes = {{0, 0, 0, 60, 80, 180}, {60, 80, 180, 120, 80, 0}};
  ASSERT_TRUE(
      site.order("head", command::MoveLinearAbsolute{to(60, 80, 180), at_velocity(100)}).ok());
  command::PathDynamics next = at_velocity(80);
  next.buffer = PathBuffer::look_ahead;
  ASSERT_TRUE(site.order("head", command::MoveLinearAbsolute{to(120, 80, 0), next}).ok());
  site.advance(300ms);
  ASSERT_TRUE(site.order("head", command::Override{0.3}).ok());
  site.advance(200ms);
  ASSERT_TRUE(site.order("head", command::Hold{}).ok());
  site.advance(500ms);
  EXPECT_EQ(site.last(c).velocity, 0);
  EXPECT_GT(site.last(c).position, 10) << "in the middle of its turn";
  EXPECT_LT(site.last(c).position, 170);
  ASSERT_TRUE(site.order("head", command::Resume{}).ok());
  site.advance(200ms);
  ASSERT_TRUE(site.order("head", command::Override{1.5}).ok());
  site.rests();
  site.expect_at(120, 80, 0);
  EXPECT_EQ(site.last(head).finished, 1U) << "one motion without a rest of its own";
  EXPECT_TRUE(site.replayed().same());
}

TEST(GroupFollowers, AFaultOfTheFollowerStopsThePathAndTheMotionContinues) {
  JudgedHead site;
  site.strokes = {{0, 0, 0, 100, 0, 180}};
  ASSERT_TRUE(
      site.order("head", command::MoveLinearAbsolute{to(100, 0, 180), at_velocity(50)}).ok());
  site.advance(600ms);
  site.after = nullptr;  // c leaves the path
  ASSERT_TRUE(site.order("c", command::Disable{}).ok());
  site.advance(500ms);
  EXPECT_EQ(site.last(head).state, State::error_stop);
  EXPECT_EQ(site.last(x).velocity, 0);
  ASSERT_TRUE(site.order("c", command::Reset{}).ok());
  ASSERT_TRUE(site.order("c", command::Enable{}).ok());
  site.advance(20ms);
  const std::string reason = site.refused(command::Reset{});
  EXPECT_THAT(reason, HasSubstr("c is at "));
  EXPECT_THAT(reason, HasSubstr(" deg instead of "));
  const double place = site.last(x).position * 1.8;
  ASSERT_TRUE(site.order("c", command::MoveAbsolute{.position = place}).ok());
  site.advance(1s);
  ASSERT_TRUE(site.order("head", command::Reset{}).ok());
  ASSERT_TRUE(site.order("head", command::Resume{}).ok());
  for (const std::size_t i : {x, y, c, head}) site.before[i] = site.last(i);
  site.after = [&] { site.judge(); };
  site.angle_tolerance = 2e-6;  // the tolerance of the start
  site.advance(10ms);
  site.rests();
  site.expect_at(100, 0, 180);
}

TEST(GroupFollowers, LimitsOfTheFollowerByCommandAreInItsUnit) {
  JudgedHead site;
  site.strokes = {{0, 0, 0, 60, 0, 120}};
  command::GroupSetLimits limit{.dynamics = {.velocity = 100}, .axis = 3, .queued = true};
  ASSERT_TRUE(site.order("head", limit).ok());
  ASSERT_TRUE(
      site.order("head", command::MoveLinearAbsolute{to(60, 0, 120), at_velocity(150)}).ok());
  site.rests();
  EXPECT_NEAR(site.fastest[c], 100, 1e-6);
  EXPECT_NEAR(site.fastest[x], 50, 1e-6);
}

TEST(GroupFollowers, AJogMovesTheFollowerAloneOrAlongWithThePath) {
  JudgedHead site;
  site.strokes = {{0, 0, 0, 0, 0, 1e6}};
  command::GroupJog jog{.along = to(none, none, 1), .dynamics = {.velocity = 90}};
  ASSERT_TRUE(site.order("head", jog).ok());
  site.advance(400ms);
  EXPECT_NEAR(site.last(c).velocity, 90, 1e-9);
  EXPECT_EQ(site.last(x).velocity, 0);
  ASSERT_TRUE(site.order("head", command::Halt{}).ok());
  site.rests();
  site.strokes.clear();
  jog = {.along = to(3, 4, 10), .dynamics = {.velocity = 50}};
  ASSERT_TRUE(site.order("head", jog).ok());
  site.advance(400ms);
  EXPECT_NEAR(std::hypot(site.last(x).velocity, site.last(y).velocity), 50, 1e-9);
  EXPECT_NEAR(site.last(c).velocity, 100, 1e-9) << "10 deg for 5 mm";
  ASSERT_TRUE(site.order("head", command::Halt{}).ok());
  site.rests();
}

TEST(GroupFollowers, AFrameTurnsThePathAndShiftsTheFollower) {
  JudgedHead site;
  command::SetCoordinateTransform frame{.rotation = 30};
  frame.offset[0] = 7.3;
  frame.offset[1] = -2.1;
  frame.offset[2] = 45;
  ASSERT_TRUE(site.order("head", frame).ok());
  ASSERT_TRUE(site.order("head", command::MoveLinearAbsolute{to(20, 11, -45)}).ok());
  site.rests();
  const double cs = std::cos(std::numbers::pi / 6);
  const double sn = std::sin(std::numbers::pi / 6);
  const double px = 7.3 + cs * 20 - sn * 11;
  const double py = -2.1 + sn * 20 + cs * 11;
  site.expect_at(px, py, 0);
  // A command of c alone moves nothing else, also not by the rounding of the frame.
  const double at_x = site.last(x).position;
  const double at_y = site.last(y).position;
  const auto judge = site.after;
  int moved = 0;
  site.after = [&] {
    judge();
    moved += site.last(x).position != at_x || site.last(y).position != at_y;
  };
  ASSERT_TRUE(
      site.order("head", command::MoveLinearAbsolute{to(none, none, 135), at_velocity(90)}).ok());
  site.rests();
  EXPECT_EQ(moved, 0);
  EXPECT_NEAR(site.last(c).position, 180, 1e-12);
  EXPECT_NEAR(site.fastest[c], 90, 1e-6);
  ASSERT_TRUE(site.order("head", command::GroupSetPosition{.to = to(none, none, 0)}).ok());
  ASSERT_TRUE(site.order("head", command::MoveLinearAbsolute{to(none, none, 90)}).ok());
  site.after = judge;
  site.rests();
  EXPECT_NEAR(site.last(c).position, 270, 1e-9);
}

TEST(GroupFollowers, AFastMoveHasTheLengthOfThePathAxes) {
  JudgedHead site;
  command::MoveDirectAbsolute fast{to(3, 4, 180)};
  fast.fast = true;
  ASSERT_TRUE(site.order("head", fast).ok());
  site.advance(10ms);
  double length = 0;
  for (int k = 0; k < 2000 && site.last(head).job != 0; ++k) {
    length = std::max(length, site.last(head).position);
    site.advance(1ms);
  }
  EXPECT_NEAR(length, 5, 0.1);
  site.expect_at(3, 4, 180);
}

// ---- programs that are sent as a whole ---------------------------------------------------------

/// A closed contour, along which c makes a whole turn.
LimitedProgram contour_with_turn(std::size_t path_axes = 2) {
  Program program(3, {}, path_axes);
  program.set({.velocity = 80});
  program.line({40, 0, 0}, 1);
  program.arc(arc_about(program.position(), {40, 10, 0}, {40, 20, 180}, Plane{0, 1},
                        ArcRotation::counterclockwise),
              2);
  program.line({0, 20, 180}, 3);
  program.line({0, 0, 360}, 4);
  const Limits mm = limits(200, 2000, 1e5);
  return {.program = program,
          .limits = {.axes = {mm, mm, limits(360, 4000, 2e5)}},
          .names = {"x", "y", "c"},
          .words = {},
          .units = {"mm", "mm", "deg"}};
}

std::vector<Stroke> strokes_of_turn() {
  return {{0, 0, 0, 40, 0, 0},
          {40, 0, 0, 40, 20, 180, 40, 10, 10},
          {40, 20, 180, 0, 20, 180},
          {0, 20, 180, 0, 0, 360}};
}

StreamPlan to_head(const LimitedProgram& program) {
  StreamPlan plan = stream_of(program);
  plan.executor = "head";
  return plan;
}

TEST(GroupFollowers, AProgramThatIsSentTurnsARotaryAxisAgainAndAgain) {
  JudgedHead site(360);
  site.strokes = strokes_of_turn();
  for (int turn = 0; turn < 3; ++turn) {
    site.offset = 360.0 * turn;
    const StreamOutcome outcome = site.stream(to_head(contour_with_turn()));
    ASSERT_TRUE(outcome.ok()) << outcome.reason;
    site.advance(20ms);
    site.rests();
    site.expect_at(0, 0, 360.0 * (turn + 1));
  }
  EXPECT_GT(site.judged, 3000);
  // A single command also reaches an angle on the shortest way.
  site.strokes = {{0, 0, 0, 10, 0, -10}};
  site.offset = 1080;
  ASSERT_TRUE(site.order("head", command::MoveLinearAbsolute{to(10, 0, 350)}).ok());
  site.rests();
  site.expect_at(10, 0, 1070);
  EXPECT_TRUE(site.replayed().same());
}

TEST(GroupFollowers, ALongProgramIsPlayedInWindowsAsOnePlan) {
  JudgedHead site(0, {.commands = 120, .common = 60});
  Program program(3, {}, 2);
  program.set({.velocity = 100, .corner = Corner::deviation, .value = 0.2});
  for (int k = 1; k <= 400; ++k)
    program.line({40 * std::sin(0.031 * k) + 0.7 * std::sin(1.7 * k), 40 * std::sin(0.023 * k),
                  90 * std::sin(0.05 * k)},
                 k);
  LimitedProgram sent = contour_with_turn();
  sent.program = program;
  const auto whole =
      planned_program(sent.program, sent.limits, *site.axes[head].group);  // one window
  std::int64_t begin = -1;
  std::size_t plans = 0;
  std::uint64_t job = 0;
  double away = 0;
  std::array<Motion, 3> motion;
  const auto judge = site.after;
  site.after = [&] {
    judge();
    const Tick& now = site.last(head);
    if (now.job == 0) return;
    if (begin < 0) begin = now.tick;
    plans += now.job != job;
    job = now.job;
    const double t = static_cast<double>(now.tick - begin) * 1e-3;
    whole->plan->at(std::min(t, whole->plan->duration()), motion);
    for (const std::size_t i : {x, y, c})
      away = std::max(away, std::abs(site.last(i).position - motion[i].position));
  };
  ASSERT_TRUE(site.stream(to_head(sent)).ok());
  site.advance(20ms);
  site.rests();
  EXPECT_GE(plans, 5U);
  EXPECT_LT(away, 1e-8);
  EXPECT_EQ(site.last(head).finished, 1U) << "without a rest";
  site.expect_at(program.position()[0], program.position()[1], program.position()[2]);
}

TEST(GroupFollowers, ALinearFollowerMustStandWhereTheProgramBegins) {
  JudgedHead site;
  site.strokes = strokes_of_turn();
  ASSERT_TRUE(site.stream(to_head(contour_with_turn())).ok());
  site.advance(20ms);
  site.rests();
  EXPECT_THAT(site.stream(to_head(contour_with_turn())).reason,
              HasSubstr("c is at 360 deg instead of 0 deg"));
}

TEST(GroupFollowers, AProgramWithOtherAxesIsRejected) {
  JudgedHead site;
  EXPECT_THAT(site.stream(to_head(contour_with_turn(3))).reason,
              HasSubstr("c: is a follower of the group, but a path axis of the path"));
  LimitedProgram other = contour_with_turn();
  other.units[2] = "rad";
  EXPECT_THAT(site.stream(to_head(other)).reason, HasSubstr("c.unit = rad: must be deg"));
  other.units.clear();  // all axes have the unit of the path
  EXPECT_THAT(site.stream(to_head(other)).reason, HasSubstr("c.unit = mm: must be deg"));
  Program plane(2);
  plane.line({10, 0}, 1);
  LimitedProgram without{.program = plane,
                         .limits = {.axes = std::vector<Limits>(2, limits(200, 2000, 1e5))},
                         .names = {"x", "y"}};
  EXPECT_THAT(site.stream(to_head(without)).reason,
              HasSubstr("c: is a follower of the group, but not an axis of the path"));
  EXPECT_EQ(site.last(head).state, State::standstill);
}

}  // namespace
}  // namespace jounce::group_followers_test
