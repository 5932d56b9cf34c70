// SPDX-License-Identifier: Apache-2.0
// Every profile, queue, set of axes and operator of a spec is the library's own, key by key.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/base/file.hpp"
#include "jounce/design/make.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/sequences/retime.hpp"
#include "jounce/profiles/sequences/splice.hpp"
#include "jounce/profiles/sequences/via.hpp"
#include "jounce/profiles/vibration/moving_average.hpp"

#include "support/errors.hpp"

namespace jounce::motion_spec_test {
namespace {

using ::testing::HasSubstr;

std::string complaint(const std::string& text) {
  return test::error_of([&] { (void)make_axes(parse_spec(text, "a.toml")); });
}

/// A spec of kind "move" with these lines under [move], and more tables after them.
std::string move_spec(const std::string& lines, const std::string& more = "",
                      const std::string& units = "position = \"mm\"") {
  return "jounce = 1\nkind = \"move\"\nunits = { " + units + " }\n[move]\n" + lines + "\n" + more;
}

Made made(const std::string& text) {
  return make(parse_spec(text, "a.toml"));
}

Trajectory curve(const std::string& text) {
  return std::get<Trajectory>(*made(text).curve);
}

/// The very same motion, to the last bit.
void expect_same(const Trajectory& f, const Trajectory& g) {
  ASSERT_EQ(f.breaks().size(), g.breaks().size());
  for (std::size_t i = 0; i < f.breaks().size(); ++i) EXPECT_EQ(f.breaks()[i], g.breaks()[i]);
  for (int i = 0; i <= 64; ++i) {
    const double t = f.start() + f.length() * i / 64;
    EXPECT_EQ(f.jet(t), g.jet(t)) << "at " << t;
  }
}

const std::string pulse_ms = "position = \"pulse\", time = \"ms\"";

TEST(MoveSpec, PointToPointIsMoveTo) {
  const Bounds bounds{.velocity_min = -15,
                      .velocity_max = 20,
                      .acceleration_min = -90,
                      .acceleration_max = 100,
                      .jerk_min = -800,
                      .jerk_max = 900,
                      .position_min = -5,
                      .position_max = 60};
  const std::string lines = R"(profile = "point_to_point"
from = 1
from_velocity = -3
from_acceleration = 10
to = "5 cm"
to_velocity = 4
to_acceleration = -5
velocity = 20
velocity_down = 15
acceleration = 100
acceleration_down = 90
jerk = 900
jerk_down = 800
position_min = -5
position_max = 60
)";
  expect_same(curve(move_spec(lines)), move_to({1, -3, 10}, {50, 4, -5}, bounds).profile.curve());
  expect_same(curve(move_spec(lines + "duration = \"9000 ms\"")),
              move_to({1, -3, 10}, {50, 4, -5}, bounds, 9).profile.curve());
}

TEST(MoveSpec, OneNumberBoundsBothDirections) {
  expect_same(curve(move_spec("profile = \"point_to_point\"\nto = -50\nvelocity = 20\n"
                              "acceleration = 100\njerk = 900")),
              move_to({}, {.position = -50}, within(20, 100, 900)).profile.curve());
}

TEST(MoveSpec, AMotionThatEndsMovingDoesNotStandAfterwards) {
  const Trajectory moving =
      curve(move_spec("profile = \"velocity\"\nto_velocity = 20\nacceleration = 100"));
  EXPECT_EQ(moving.outside(), Extrapolation::refuse);
  expect_same(moving, move_velocity({}, 20, within(Bounds::none, 100)).profile.curve());
  EXPECT_EQ(curve(move_spec("profile = \"point_to_point\"\nto = 1\nvelocity = 1")).outside(),
            Extrapolation::hold);
}

TEST(MoveSpec, AModuloAxisMovesInItsDirection) {
  const std::string lines =
      "profile = \"point_to_point\"\nperiod = 360\nfrom = 350\nto = 10\nvelocity = 720\n"
      "acceleration = 7200\n";
  const auto end = [&](const std::string& direction) {
    const Trajectory f = curve(move_spec(lines + direction, "", "position = \"deg\""));
    return f.at(f.end()).position;
  };
  EXPECT_EQ(end(""), 370) << "the shortest";
  EXPECT_EQ(end("direction = \"shortest\""), 370);
  EXPECT_EQ(end("direction = \"negative\""), 10);
  EXPECT_EQ(end("direction = \"fastest\""), 370);
}

// The same motion as with the target that the way leads to, to the last bit.
TEST(MoveSpec, EveryProfileWithATargetTurnsInItsDirection) {
  const std::string deg = "position = \"deg\"";
  const std::string ramps = "velocity = 720\nacceleration = 7200\n";
  const std::vector<std::string> profiles{
      "profile = \"trapezoid\"\n" + ramps, "profile = \"s_curve\"\njerk = 90000\n" + ramps,
      "profile = \"fourth_order\"\njerk = 90000\njounce = 1e7\n" + ramps,
      "profile = \"himc\"\nsmoothing_time = 50\n" + ramps,
      "profile = \"pmc600\"\nmode = \"trapezoid\"\n" + ramps};
  for (const std::string& profile : profiles)
    for (const auto& [direction, from, to, target] : {std::tuple{"shortest", "350", "10", "370"},
                                                      {"negative", "350", "10", "10"},
                                                      {"positive", "350", "340", "700"},
                                                      {"shortest", "10", "350", "-10"},
                                                      {"positive", "10", "350", "350"},
                                                      {"current", "725", "10", "730"},
                                                      {"shortest", "0", "180", "180"}}) {
      const std::string start = profile + "from = " + from + "\n";
      SCOPED_TRACE(start + direction);
      const std::string turned =
          start + "to = " + to + "\nperiod = 360\ndirection = \"" + direction + "\"";
      expect_same(curve(move_spec(turned, "", deg)),
                  curve(move_spec(start + "to = " + target, "", deg)));
    }
}

TEST(MoveSpec, APeriodNeedsATarget) {
  EXPECT_THAT(complaint(move_spec("profile = \"himc_velocity\"\nvelocity = 10\nacceleration = 20\n"
                                  "period = 360")),
              HasSubstr("move.period = 360 mm: applies to a move to one target position only"));
  EXPECT_THAT(complaint(move_spec("profile = \"trapezoid\"\nto = 5\nvelocity = 10\n"
                                  "acceleration = 20\ndirection = \"positive\"")),
              HasSubstr("direction"));
  EXPECT_THAT(complaint(move_spec("profile = \"trapezoid\"\nto = 5\nvelocity = 10\n"
                                  "acceleration = 20\nperiod = 0")),
              HasSubstr("period = 0"));
}

TEST(QueueSpec, OnAModuloAxisEachMoveTurnsFromTheTargetBeforeIt) {
  const auto queue = [](const std::string& period, const std::vector<std::string>& moves) {
    std::string text = "jounce = 1\nkind = \"queue\"\nunits = { position = \"deg\" }\n" + period +
                       "start = { position = 350 }\n[dynamics]\nvelocity = 360\n"
                       "acceleration = 3600\njerk = 72000\n";
    for (const std::string& move : moves) text += "[[command]]\n" + move + "\n";
    return text;
  };
  const std::string go = "type = \"absolute\"\nposition = ";
  expect_same(
      curve(queue("period = 360\n",
                  {go + "10", go + "90\nmode = \"blending_low\"",
                   go + "80\ndirection = \"positive\"\nmode = \"blending_high\"",
                   "type = \"relative\"\ndistance = 300", "type = \"dwell\"\ntime = 0.1",
                   go + "10\ndirection = \"negative\""})),
      curve(queue("", {go + "370", go + "450\nmode = \"blending_low\"",
                       go + "800\nmode = \"blending_high\"", "type = \"relative\"\ndistance = 300",
                       "type = \"dwell\"\ntime = 0.1", go + "1090"})));
  EXPECT_THAT(complaint(queue("period = 360\n", {go + "10", go + "90\nmode = \"aborting\""})),
              HasSubstr("needs a place where the command before it ends"));
  EXPECT_THAT(complaint(queue("period = 360\n", {"type = \"velocity\"", go + "90"})),
              HasSubstr("needs a place where the command before it ends"));
  EXPECT_THAT(complaint(queue("", {go + "10\ndirection = \"positive\""})),
              HasSubstr("needs period"));
}

TEST(MoveSpec, FourthOrderIsTheLibrarys) {
  expect_same(
      curve(move_spec("profile = \"fourth_order\"\nfrom = 1\nto = 1.1\nvelocity = 0.25\n"
                      "acceleration = 2\njerk = 40\njounce = \"2000 m/s^4\"",
                      "", "position = \"m\"")),
      fourth_order(
          {.from = 1, .to = 1.1, .velocity = 0.25, .acceleration = 2, .jerk = 40, .jounce = 2000}));
}

TEST(MoveSpec, SpeaksHimc) {
  const himc::AxisProfile axis{.velocity = 100,
                               .acceleration_time = 200,
                               .deceleration = 400,
                               .smoothing_time = 50,
                               .velocity_scale = 80};
  const std::string lines =
      "velocity = 100\nacceleration_time = \"0.2 s\"\ndeceleration = 400\nsmoothing_time = 50\n"
      "velocity_scale = 80\n";
  expect_same(curve(move_spec("profile = \"himc\"\nfrom = 5\nto = 905\n" + lines)),
              himc::move_abs(5, 905, axis).curve());
  expect_same(curve(move_spec("profile = \"himc_velocity\"\ndirection = -1\n" + lines)),
              himc::move_vel({}, -1, axis).curve());
}

TEST(MoveSpec, SpeaksGoogol) {
  const auto of = [](const std::string& lines) { return curve(move_spec(lines, "", pulse_ms)); };
  const std::string common = "from = 100\npos = 50000\nvel = 50\nacc = 0.25\ndec = 0.125\n";
  expect_same(of("profile = \"googol_trap\"\nvel_start = 5\nsmooth_time = 25\n" + common),
              googol::trap({100, 50000, 50, 0.25, 0.125, 5, 25}).curve());
  expect_same(of("profile = \"googol_move_absolute\"\npercent = 40\n" + common),
              googol::move_absolute({100, 50000, 50, 0.25, 0.125, 40}).curve());
  expect_same(of("profile = \"googol_move_absolute_ex\"\npercent = 40\nvel_start = 5\nvel_end = 6\n"
                 "acc_start_percent = 10\ndec_end_percent = 20\n" +
                 common),
              googol::move_absolute_ex({100, 50000, 50, 0.25, 0.125, 40, 5, 6, 10, 20}).curve());
  expect_same(
      of("profile = \"googol_move_velocity\"\nfrom = 7\nfrom_velocity = 3\nvel = 50\nacc = 0.25\n"
         "dec = 0.2\njerk_begin = 0.01\njerk_end = 0.02\ndirection = \"negative\"\n"),
      googol::move_velocity({7, 3, 0}, {50, 0.25, 0.2, 0.01, 0.02, googol::Direction::negative})
          .curve());
  const std::vector<googol::JogVelocity> velocities{{0, 50}, {1000, -20}};
  expect_same(of("profile = \"googol_jog\"\nfrom = 7\nacc = 0.25\ndec = 0.2\nsmooth = 0.5\n"
                 "velocities = [{ time = 0, vel = 50 }, { time = \"1 s\", vel = -20 }]"),
              googol::jog(7, velocities, {0.25, 0.2, 0.5}));
}

TEST(MoveSpec, SpeaksAgito) {
  const agito::Settings settings{100000, 90000, 1000, 6};
  const std::string lines = "accel = 100000\ndecel = 90000\nspeed = 1000\njerk = 6\n";
  const auto of = [](const std::string& text) { return curve(move_spec(text)); };
  expect_same(of("profile = \"agito\"\nfrom = 10\nabs_trgt = 2000\n" + lines),
              agito::begin(10, {.abs_trgt = 2000}, settings).curve());
  expect_same(
      of("profile = \"agito\"\nfrom = 10\nrel_trgt = 200\nstrokes = 3\nrpt_wait = 40\n" + lines),
      agito::repetitive(10, {.rel_trgt = 200}, settings, 3, 40));
  expect_same(of("profile = \"agito_quasi_sine\"\namplitude = 200\nfrequency = \"5 Hz\"\n"
                 "strokes = 4\nrpt_wait = \"0.01 s\"\n"),
              agito::repetitive(0, {.rel_trgt = 400}, agito::quasi_sine(200, 5), 4, 10));
  expect_same(of("profile = \"agito_jog\"\nfrom_velocity = 50\n" + lines),
              agito::jog({0, 50, 0}, settings).curve());
}

TEST(MoveSpec, SpeaksPmc600) {
  const auto of = [](const std::string& text) { return curve(move_spec(text)); };
  const std::string lines = "from = 5\nvelocity = 2000\nacceleration = 4000\ndeceleration = 3000\n";
  for (const auto& [name, mode] : {std::pair{"trapezoid", pmc600::VelocityMode::trapezoid},
                                   {"sigmoid", pmc600::VelocityMode::sigmoid},
                                   {"sigmoid_limit", pmc600::VelocityMode::sigmoid_limit},
                                   {"quadratic", pmc600::VelocityMode::quadratic}})
    expect_same(of("profile = \"pmc600\"\nto = 4000\njerk = 40000\nmode = \"" + std::string(name) +
                   "\"\n" + lines),
                pmc600::move_absolute(5, 4000, {2000, 4000, 3000, 40000}, mode));
  expect_same(of("profile = \"pmc600_ls\"\nto = 4000\nstart_velocity = 100\n"
                 "end_second_velocity = 50\n" +
                 lines),
              pmc600::ls_move({5, 4000, 2000, 4000, 3000, 100, 50}).curve());
  expect_same(of("profile = \"pmc600_ls_velocity\"\nfrom = 5\nvelocity = -300\nacceleration = 400\n"
                 "start_velocity = 30"),
              pmc600::ls_move_velocity(5, -300, 400, 30).curve());
  expect_same(of("profile = \"pmc600_position_to_velocity\"\nfrom = 5\nrelative = true\n"
                 "end_pos = [3000, 2000]\nvelocity = [2000, 1000]\nacceleration = [4000, 4000]\n"
                 "deceleration = [3000, 4000]\njerk = [40000, 50000]\nmode = \"quadratic\""),
              pmc600::position_to_velocity({5,
                                            true,
                                            {3000, 2000},
                                            {2000, 1000},
                                            {4000, 4000},
                                            {3000, 4000},
                                            {40000, 50000},
                                            pmc600::VelocityMode::quadratic}));
  const Dynamics dynamics{2000, 4000, 3000, 40000, 0};
  expect_same(
      of("profile = \"pmc600_inch\"\ndistance = 300\njerk = 40000\nreleased = 0.1\n" + lines),
      pmc600::inch(5, 300, dynamics, 0.1));
  const std::vector<pmc600::JogInput> inputs{{0, true, false}, {1, false, false}};
  expect_same(of("profile = \"pmc600_jog\"\njerk = 40000\nmax_velocity = 1500\n"
                 "inputs = [{ time = 0, forward = true }, { time = 1 }]\n" +
                 lines),
              pmc600::jog(5, inputs, dynamics, 1500));
}

constexpr const char* queue_spec = R"(jounce = 1
kind = "queue"
units = { position = "mm" }
[start]
position = 2
[dynamics]
velocity = 100
acceleration = 400
jerk = 4000
[[command]]
type = "absolute"
position = 50
[[command]]
type = "relative"
distance = 60
velocity = 60
deceleration = 300
mode = "blending_next"
[[command]]
type = "dwell"
time = "200 ms"
[[command]]
type = "velocity"
direction = -1
[[command]]
type = "halt"
mode = "aborting"
issued = 3
)";

TEST(QueueSpec, IsTheLibrarysQueue) {
  const Dynamics common{.velocity = 100, .acceleration = 400, .jerk = 4000};
  const Dynamics second{.velocity = 60, .acceleration = 400, .deceleration = 300, .jerk = 4000};
  const QueuedMotion expected =
      queue({.start = {.position = 2},
             .commands = {{MoveAbsolute{50}, common},
                          {MoveRelative{60}, second, BufferMode::blending_next},
                          {Dwell{0.2}},
                          {MoveVelocity{-1}, common},
                          {Halt{}, common, BufferMode::aborting, 3.0}}});
  const Made queue = made(queue_spec);
  expect_same(std::get<Trajectory>(*queue.curve), expected.trajectory);
  EXPECT_EQ(queue.segments.front(), "1 absolute");
  EXPECT_EQ(queue.segments.back(), "5 halt");
}

constexpr const char* axes_spec = R"(jounce = 1
kind = "axes"
units = { position = "mm" }
sync = "phase"
[[axis]]
name = "x"
to = 300
velocity = 1000
acceleration = 5000
jerk = 100000
limits = { velocity = 1000 }
table = { rule = "cubic_hermite" }
[[axis]]
name = "c"
unit = "deg"
from = "0.5 rev"
to = 90
velocity = 800
acceleration = 4000
jerk = 100000
[axis.limits]
velocity = 801
)";

TEST(AxesSpec, EveryWordOfSyncMeansTheLibrarys) {
  const std::string text = axes_spec;
  const std::size_t at = text.find("\"phase\"");
  const auto synchronized_by = [&](const std::string& word) {
    const Spec spec = parse_spec(std::string(text).replace(at, 7, '"' + word + '"'), "a.toml");
    return std::get<AxesSpec>(spec.subject).sync;
  };
  EXPECT_EQ(synchronized_by("none"), Sync::none);
  EXPECT_EQ(synchronized_by("time"), Sync::time);
  EXPECT_EQ(synchronized_by("time_if_moving"), Sync::time_if_moving);
  EXPECT_EQ(synchronized_by("phase"), Sync::phase);
  EXPECT_EQ(synchronized_by("phase_or_time"), Sync::phase_or_time);
}

TEST(AxesSpec, AreTheLibrarysSynchronizedAxes) {
  const std::vector<AxisMove> moves{{{}, {.position = 300}, within(1000, 5000, 100000)},
                                    {{.position = 180}, {.position = 90}, within(800, 4000, 1e5)}};
  std::vector<Profile> profiles(2);
  ASSERT_EQ(synchronize(moves, Sync::phase, profiles).status, MoveStatus::ok);
  const std::vector<Made> all = make_axes(parse_spec(axes_spec, "a.toml"));
  ASSERT_EQ(all.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i)
    expect_same(std::get<Trajectory>(*all[i].curve), profiles[i].curve());
  EXPECT_EQ(all[0].part.name, "x");
  EXPECT_EQ(all[0].sampled.table.rule(), Interpolation::cubic_hermite);
  EXPECT_EQ(all[0].part.limits.velocity, 1000);
  EXPECT_EQ(all[1].part.units.position, "deg");
  EXPECT_EQ(all[1].part.limits.velocity, 801);
}

TEST(AxesSpec, WithoutSyncTheEarlierOneWaits) {
  std::string text = axes_spec;
  text.replace(text.find("\"phase\""), 7, "\"none\"");
  const std::vector<Made> all = make_axes(parse_spec(text, "a.toml"));
  const auto& x = std::get<Trajectory>(*all[0].curve);
  const auto& c = std::get<Trajectory>(*all[1].curve);
  EXPECT_EQ(x.end(), c.end());
  EXPECT_EQ(c.jet(x.end() - 0.05)[1], 0) << "90 deg take less time than 300 mm";
}

TEST(AxesSpec, GoThroughPoints) {
  const std::string text = R"(jounce = 1
kind = "axes"
units = { position = "mm" }
axis = [{ name = "x", velocity = 1000, acceleration = 2000, jerk = 20000 },
        { name = "y", velocity = 1000, acceleration = 2000, jerk = 20000 }]
point = [{ position = [0, 0] }, { position = ["1 m", 1000] }, { position = [3000, 0] }]
)";
  const Bounds axis = within(1000, 2000, 20000);
  const ViaMotion motion = via({.axes = {axis, axis}, .points = {{0, 0}, {1000, 1000}, {3000, 0}}});
  const std::vector<Made> all = make_axes(parse_spec(text, "a.toml"));
  ASSERT_EQ(all.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i)
    expect_same(std::get<Trajectory>(*all[i].curve), motion.axes[i]);
}

// ---- operators -------------------------------------------------------------------------------

const std::string s_curve_lines =
    "profile = \"s_curve\"\nto = 50\nvelocity = 10\nacceleration = 20\njerk = 100\n";
const std::string s_curve_limits = "[limits]\nvelocity = 10\nacceleration = 20\njerk = 100\n";

Trajectory the_s_curve() {
  return s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve();
}

Trajectory after(const std::string& then) {
  return curve(move_spec(s_curve_lines, then));
}

TEST(Then, OperatorsAreTheLibrarys) {
  const Trajectory f = the_s_curve();
  expect_same(after("[[then]]\noperator = \"moving_average\"\nwindow = \"50 ms\""),
              moving_average(f, 0.05));
  expect_same(after("[[then]]\noperator = \"shaper\"\nkind = \"ei\"\nfrequency = 5.5\n"
                    "damping = 0.03\ntolerance = 0.06"),
              shaped(f, shaper({ShaperKind::ei, {5.5, 0.03}, 0.06})));
  expect_same(after("[[then]]\noperator = \"notch\"\nfrequency = 5.5\ndamping = 0.9\n"
                    "mode_damping = 0.03\nsettled = 1e-5"),
              notched(f, {5.5, 0.9, 0.03, 1e-5}).motion);
  expect_same(after("[[then]]\noperator = \"retime\"\n[limits]\nvelocity = 5\njerk = 90"),
              retimed(f, {.velocity = 5, .jerk = 90}));
  const std::vector axes{f};
  const std::vector<Limits> limits{{.velocity = 10, .acceleration = 20, .jerk = 100}};
  expect_same(after("[[then]]\noperator = \"override\"\nmaximum = 1.2\n"
                    "request = [{ time = 2, factor = 0 }, { time = 4, factor = 1.1 }]\n" +
                    s_curve_limits),
              overridden(axes, limits, {.requests = {{2, 0}, {4, 1.1}}, .maximum = 1.2}).axes[0]);
}

TEST(Then, ChangesInFlightAreTheLibrarys) {
  const Trajectory f = the_s_curve();
  const Dynamics d{.velocity = 15, .acceleration = 20, .deceleration = 10, .jerk = 200};
  const std::string dynamics =
      "time = 2\nvelocity = 15\nacceleration = 20\ndeceleration = 10\njerk = 200\n";
  expect_same(after("[[then]]\noperator = \"new_target\"\nto = 80\n" + dynamics),
              with_target(f, 2, 80, d));
  expect_same(after("[[then]]\noperator = \"new_velocity\"\n" + dynamics),
              with_velocity(f, 2, 15, d));
  expect_same(after("[[then]]\noperator = \"move_additive\"\ndistance = 7\n" + dynamics),
              pmc600::move_additive(f, 2, 7, d));
  expect_same(
      after("[[then]]\noperator = \"move_superimposed\"\ndistance = 7\nabort = 2.2\n" + dynamics),
      pmc600::move_superimposed(f, 2, 7, d, 2.2));
}

TEST(Then, AChangeBeginsWhereTheMotionPassesAPosition) {
  const Dynamics d{.velocity = 15, .acceleration = 20, .deceleration = 10, .jerk = 200};
  const std::string dynamics = "velocity = 15\nacceleration = 20\ndeceleration = 10\njerk = 200\n";
  const std::string target = "[[then]]\noperator = \"new_target\"\nto = 80\n" + dynamics;
  const double at_2 = the_s_curve().at(2).position;
  const Trajectory past = after(target + "past = " + number(at_2));
  const Trajectory timed = with_target(the_s_curve(), 2, 80, d);
  for (double t = 0; t <= timed.end(); t += 0.01)
    EXPECT_NEAR(past.at(t).position, timed.at(t).position, 1e-9) << t;
  const auto wrong = [&](const std::string& keys) {
    return test::error_of([&] { (void)after(target + keys); });
  };
  EXPECT_THAT(wrong("past = 51"),
              HasSubstr("past = 51 mm: must be a position that the motion passes"));
  EXPECT_THAT(wrong("time = 1\npast = 5"),
              HasSubstr("past = 5 mm: replaces time: leave out one of the two"));
}

// Googol manual, example 7-2: 80000 pulses at 1600 ms, the change at 1800 ms, 160000 pulses at 2600 ms.
TEST(Then, AChangeAtAPositionPlaysExample72) {
  const Trajectory jog = curve(read_file(JOUNCE_SOURCE_DIR "/examples/googol-move/7-2.toml"));
  EXPECT_NEAR(jog.end(), 2600, 1e-9);
  for (const auto& [t, p, v] : {std::array{1600.0, 80000.0, 100.0},
                                {1800.0, 100000.0, 100.0},
                                {2200.0, 135000.0, 75.0},
                                {2600.0, 160000.0, 50.0}}) {
    EXPECT_NEAR(jog.jet(t, Side::left)[0], p, 1e-6) << t;
    EXPECT_NEAR(jog.jet(t, Side::left)[1], v, 1e-9) << t;
  }
}

TEST(Then, OneAfterAnother) {
  expect_same(after("[[then]]\noperator = \"moving_average\"\nwindow = 0.1\n"
                    "[[then]]\noperator = \"moving_average\"\nwindow = 0.2"),
              moving_average(moving_average(the_s_curve(), 0.1), 0.2));
}

TEST(Then, FrequenciesAreInHertzWhateverTheUnitOfTime) {
  const auto residual = [](const std::string& units, const std::string& rates) {
    const Made shaped = made(move_spec("profile = \"s_curve\"\nto = 50\n" + rates,
                                       "[[then]]\noperator = \"shaper\"\nkind = \"zv\"\n"
                                       "frequency = \"5.5 Hz\"\ndamping = 0.03",
                                       units));
    EXPECT_EQ(shaped.residuals.size(), 1U);
    return shaped.residuals.at(0);
  };
  const Residual s =
      residual("position = \"mm\"", "velocity = 400\nacceleration = 4000\njerk = 80000");
  const Residual ms = residual("position = \"mm\", time = \"ms\"",
                               "velocity = 0.4\nacceleration = 0.004\njerk = 0.00008");
  EXPECT_EQ(ms.mode.frequency, 5.5);
  EXPECT_GT(s.before, 1);
  EXPECT_NEAR(ms.before, s.before, 1e-9);
  EXPECT_LT(s.after, 1e-12);
  EXPECT_LT(ms.after, 1e-12);
}

TEST(Then, SeveralAxesKeepTogether) {
  const std::vector<Made> all =
      make_axes(parse_spec(std::string(axes_spec) + "[[then]]\noperator = \"retime\"\n", "a.toml"));
  const auto& x = std::get<Trajectory>(*all[0].curve);
  const auto& c = std::get<Trajectory>(*all[1].curve);
  EXPECT_EQ(x.end(), c.end());
  EXPECT_NEAR(extrema(x, 1).max.value, 1000, 1e-9) << "x decides; c follows";
  EXPECT_NEAR(extrema(c, 1).min.value, -300, 1e-9);
}

TEST(Then, MakesAPvtSpecAnotherTable) {
  const std::string text = R"(jounce = 1
kind = "pvt"
units = { position = "mm" }
[[knot]]
time = 0
position = 0
velocity = 0
[[knot]]
time = 2
position = 10
velocity = 0
[[then]]
operator = "retime"
[limits]
velocity = 15
[table]
intervals = 4
)";
  const Made retimed = made(text);
  EXPECT_EQ(std::get<Trajectory>(*retimed.curve).end(), 1);
  EXPECT_EQ(retimed.sampled.table.size(), 5U);
}

TEST(TableRule, IsCubicWhereTheAccelerationSteps) {
  const std::string lines = "to = 50\nvelocity = 10\nacceleration = 20\n";
  EXPECT_EQ(made(move_spec("profile = \"trapezoid\"\n" + lines)).sampled.table.rule(),
            Interpolation::cubic_hermite);
  EXPECT_EQ(made(move_spec(s_curve_lines)).sampled.table.rule(), Interpolation::quintic_hermite);
}

// ---- what is refused -------------------------------------------------------------------------

struct BadMotion {
  std::string text;
  const char* message;
};

void PrintTo(const BadMotion& bad, std::ostream* out) {
  *out << bad.message;
}

class BadMotionSpec : public ::testing::TestWithParam<BadMotion> {};

TEST_P(BadMotionSpec, GetsOneMessageWithPlaceKeyValueAndRule) {
  EXPECT_EQ(complaint(GetParam().text), GetParam().message) << GetParam().text;
}

std::string with(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

const std::string point =
    "profile = \"point_to_point\"\nto = 50\nvelocity = 10\nacceleration = 20\n";
const std::string trap = "profile = \"googol_trap\"\npos = 50000\nvel = 50\nacc = 0.25\n";
const std::string agito_lines = "profile = \"agito\"\nabs_trgt = 2000\naccel = 1000\nspeed = 100\n";
const std::string himc_lines = "profile = \"himc\"\nto = 10\nvelocity = 10\nacceleration = 20\n";

INSTANTIATE_TEST_SUITE_P(
    All, BadMotionSpec,
    ::testing::Values(
        BadMotion{move_spec("profile = \"point_to_pint\"\nto = 1"),
                  "a.toml:5:11: move.profile = \"point_to_pint\": is unknown: did you mean "
                  "\"point_to_point\"?"},
        BadMotion{move_spec(point + "jrek = 3"),
                  "a.toml:9:1: move.jrek = 3: is not a key here: did you mean jerk?"},
        BadMotion{move_spec(point + "jerk = -3"),
                  "a.toml:9:8: move.jerk = -3 mm/s^3: must be greater than 0"},
        BadMotion{move_spec(point + "velocity_down = 0"),
                  "a.toml:9:17: move.velocity_down = 0 mm/s: must be greater than 0"},
        BadMotion{move_spec(point + "duration = 0"),
                  "a.toml:9:12: move.duration = 0 s: must be greater than 0"},
        BadMotion{move_spec(point + "duration = 5"),
                  "a.toml:9:12: move.duration = 5 s: must be at least 5.5 s: the move takes longer "
                  "than the given duration"},
        BadMotion{move_spec(point + "direction = \"shortest\""),
                  "a.toml:9:13: move.direction = \"shortest\": needs period, because only a modulo "
                  "axis has a choice of direction: add period, or leave direction out"},
        BadMotion{move_spec(point + "period = -360"),
                  "a.toml:9:10: move.period = -360 mm: must be greater than 0"},
        BadMotion{move_spec(point + "to_velocity = 11"),
                  "a.toml:9:15: move.to_velocity = 11 mm/s: must be at most 10 mm/s, the greatest "
                  "velocity"},
        BadMotion{move_spec(point + "position_max = 40"),
                  "a.toml:6:6: move.to = 50 mm: must be at most position_max = 40 mm"},
        BadMotion{move_spec(point + "position_min = 60\nposition_max = 40"),
                  "a.toml:9:16: move.position_min = 60 mm: must be below position_max = 40 mm"},
        BadMotion{move_spec(point + "from = 50"),
                  "a.toml:6:6: move.to: is the start position: there is no move"},
        BadMotion{move_spec("profile = \"velocity\"\nto_velocity = 0\nacceleration = 1"),
                  "a.toml:6:15: move.to_velocity: is the start position: there is no move"},
        BadMotion{move_spec("profile = \"velocity\"\nacceleration = 1"),
                  "a.toml:4:1: move.to_velocity: is missing: add to_velocity = NUMBER, in mm/s"},
        BadMotion{move_spec("profile = \"fourth_order\"\nto = 1\nvelocity = 1\nacceleration = 1\n"
                            "jerk = 1\njounce = \"1 mm/s^3\""),
                  "a.toml:10:10: move.jounce = \"1 mm/s^3\": mm/s^3 is not a unit of this "
                  "quantity: give the value in mm/s^4"},
        BadMotion{move_spec(trap),
                  "a.toml:3:22: units.position = \"mm\": must be pulse for the profiles of Googol: "
                  "give position = \"pulse\" in units"},
        BadMotion{move_spec(trap, "", "position = \"pulse\""),
                  "a.toml:3:9: units.time = \"s\": must be ms for the profiles of Googol: give "
                  "time = \"ms\" in units"},
        BadMotion{move_spec(trap + "smooth_time = 51", "", pulse_ms),
                  "a.toml:9:15: move.smooth_time = 51 ms: must be between 0 and 50 ms"},
        BadMotion{move_spec(trap + "smooth_time = 2.5", "", pulse_ms),
                  "a.toml:9:15: move.smooth_time = 2.5: must be a whole number"},
        BadMotion{move_spec(with(trap, "50000", "5000000000"), "", pulse_ms),
                  "a.toml:6:7: move.pos = 5000000000: must be between -1 073 741 823 and "
                  "1 073 741 823"},
        BadMotion{move_spec("profile = \"googol_jog\"\nacc = 1", "", pulse_ms),
                  "a.toml:4:1: move.velocities: is missing: a jog needs at least one velocity"},
        BadMotion{move_spec(agito_lines, "", "position = \"um\", time = \"ms\""),
                  "a.toml:3:35: units.time = \"ms\": must be s for the profiles of Agito: give "
                  "time = \"s\" in units"},
        BadMotion{move_spec(agito_lines + "jerk = 10"),
                  "a.toml:9:8: move.jerk = 10: must be between 0 and 9"},
        BadMotion{
            move_spec(agito_lines + "rpt_wait = 10"),
            "a.toml:9:12: move.rpt_wait = 10 ms: needs strokes, the number of repetitions: add "
            "it, or leave rpt_wait out"},
        BadMotion{
            move_spec(with(agito_lines, "2000", "3000000000")),
            "a.toml:6:12: move.abs_trgt = 3000000000: must be from -2147483648 to 2147483647"},
        BadMotion{move_spec("profile = \"agito_quasi_sine\"\namplitude = 0.3\nfrequency = 5"),
                  "a.toml:6:13: move.amplitude = 0.3 mm: must be half of RelTrgt"},
        BadMotion{move_spec(himc_lines + "acceleration_time = 5"),
                  "a.toml:8:16: move.acceleration = 20 mm/s^2: cannot be combined with "
                  "acceleration_time: "
                  "give one of the two"},
        BadMotion{move_spec("profile = \"pmc600\"\nto = 1\nvelocity = 1\nacceleration = 1\n"
                            "mode = \"sigmod\""),
                  "a.toml:9:8: move.mode = \"sigmod\": must be one of trapezoid, sigmoid, "
                  "sigmoid_limit, quadratic: did you mean \"sigmoid\"?"},
        BadMotion{move_spec("profile = \"pmc600_position_to_velocity\"\nend_pos = [1, 2, 3]"),
                  "a.toml:6:11: move.end_pos = [1, 2, 3]: must be a list of 2 numbers"},
        // Queues.
        BadMotion{with(queue_spec, "\"relative\"", "\"relativ\""),
                  "a.toml:14:8: command[2].type = \"relativ\": must be one of absolute, relative, "
                  "velocity, halt, dwell: did you mean \"relative\"?"},
        BadMotion{with(queue_spec, "velocity = 100\n", ""),
                  "a.toml:9:1: command[1].velocity: is missing: add velocity = NUMBER, in mm/s, "
                  "here or for "
                  "all commands in [dynamics]"},
        BadMotion{with(queue_spec, "velocity = 100\n", "velocity = 0\n"),
                  "a.toml:7:12: dynamics.velocity = 0 mm/s: must be greater than 0"},
        BadMotion{with(queue_spec, "jerk = 4000\n", "jerk = -1\n"),
                  "a.toml:9:8: dynamics.jerk = -1 mm/s^3: must not be negative"},
        BadMotion{
            with(queue_spec, "time = \"200 ms\"", "time = \"200 ms\"\nmode = \"blending_high\""),
            "a.toml:22:8: command[3].mode = \"blending_high\": does not apply to a dwell, which "
            "begins and ends at rest: use buffered"},
        BadMotion{with(queue_spec, "issued = 3\n", ""),
                  "a.toml:25:1: command[5].issued: is missing: add issued = NUMBER, in s: an "
                  "aborting command needs the time "
                  "at which it is issued"},
        BadMotion{with(queue_spec, "direction = -1", "direction = 2"),
                  "a.toml:24:13: command[4].direction = 2: must be 1 or -1"},
        BadMotion{with(queue_spec, "time = \"200 ms\"", "time = \"200 ms\"\nvelocity = 3"),
                  "a.toml:22:1: command[3].velocity = 3: is not a key of type = \"dwell\"; "
                  "possible keys: "
                  "issued, mode, time, type"},
        BadMotion{"jounce = 1\nkind = \"queue\"\nunits = { position = \"mm\" }\n",
                  "a.toml: command: is missing: add [[command]]"},
        // Axes.
        BadMotion{with(axes_spec, "\"phase\"", "\"fase\""),
                  "a.toml:4:8: sync = \"fase\": must be one of none, "
                  "time, phase, time_if_moving, phase_or_time: did you mean \"phase\"?"},
        BadMotion{with(axes_spec, "\"c\"", "\"x\""),
                  "a.toml:14:8: axis[2].name = \"x\": is the name of two axes: rename one"},
        BadMotion{with(axes_spec, "\"c\"", "\"a/b\""),
                  "a.toml:14:8: axis[2].name = \"a/b\": must consist of letters, digits, - and _"},
        BadMotion{
            with(axes_spec, "to = 90\n", ""),
            "a.toml:13:1: axis[2].to: is missing: add to = NUMBER, in deg: each axis needs its "
            "target position"},
        BadMotion{
            with(axes_spec, "jerk = 100000\nlimits", "jerk = 100000\nto_velocity = 9\nlimits"),
            "a.toml:14:1: axis[2]: the velocities and accelerations of start and target are not "
            "along the line between them, or an axis would exceed its velocity limit on this line"},
        BadMotion{"jounce = 1\nkind = \"axes\"\nunits = { position = \"mm\" }\n",
                  "a.toml: axis: is missing: add [[axis]] for each axis"},
        BadMotion{
            "jounce = 1\nkind = \"axes\"\nunits = { position = \"mm\" }\n[limits]\n"
            "velocity = 1\n[[axis]]\nname = \"x\"\nto = 1\nvelocity = 1\nacceleration = 1\n",
            "a.toml:4:2: [limits]: is not a section of kind = \"axes\"; possible keys and "
            "sections: "
            "axis, compare, duration, jounce, kind, name, optimize, point, sync, then, units"},
        BadMotion{"jounce = 1\nkind = \"axes\"\nunits = { position = \"mm\" }\n"
                  "axis = [{ name = \"x\", to = 1, velocity = 1, acceleration = 1 }]\n"
                  "[norm]\nvelocity = 1\n",
                  "a.toml:5:1: [norm]: applies only to a motion through [[point]]: leave out norm, "
                  "or add [[point]]"},
        BadMotion{
            with(axes_spec, "jounce = 1\n", "jounce = 1\ntimes = \"shortest\"\n"),
            "a.toml:2:9: times = \"shortest\": applies only to a motion through [[point]]: leave "
            "out times, or add [[point]]"},
        BadMotion{"jounce = 1\nkind = \"axes\"\nunits = { position = \"mm\" }\n"
                  "axis = [{ name = \"x\", velocity = 1, acceleration = 1 }]\n"
                  "point = [{ position = [1] }, { position = [1, 2] }]\n",
                  "a.toml:5:43: point[2].position = [1, 2]: must be a list of 1 number, one for "
                  "each axis"},
        BadMotion{"jounce = 1\nkind = \"axes\"\nunits = { position = \"mm\" }\n"
                  "axis = [{ name = \"x\", velocity = 1, acceleration = 1 }]\n"
                  "point = [{ position = [1] }, { position = [1] }]\n",
                  "a.toml:5:30: point[2]: must differ from the previous point"},
        // Operators.
        BadMotion{
            move_spec(s_curve_lines, "[[then]]\noperator = \"shape\""),
            "a.toml:12:12: then[1].operator = \"shape\": is unknown: did you mean \"shaper\"?"},
        BadMotion{move_spec(s_curve_lines, "[[then]]\noperator = \"moving_average\"\nwindow = 0"),
                  "a.toml:13:10: then[1].window = 0 s: must be greater than 0"},
        BadMotion{move_spec(s_curve_lines,
                            "[[then]]\noperator = \"shaper\"\nkind = \"zv\"\n"
                            "frequency = 5\ntolerance = 0.1"),
                  "a.toml:15:1: then[1].tolerance = 0.1: is not a key of operator = \"shaper\"; "
                  "possible keys: "
                  "controller, damping, frequency, kind, operator"},
        BadMotion{move_spec(s_curve_lines,
                            "[[then]]\noperator = \"notch\"\nfrequency = 5\nmode_damping = 2"),
                  "a.toml:14:16: then[1].mode_damping = 2: must be less than damping"},
        BadMotion{move_spec(s_curve_lines, "[[then]]\noperator = \"retime\""),
                  "a.toml: limits: do not limit the motion: add velocity, acceleration or jerk"},
        BadMotion{
            move_spec(s_curve_lines, "[[then]]\noperator = \"override\"\n[limits]\njerk = 100"),
            "a.toml:13:1: limits: need a velocity, an acceleration and a jerk: add what is "
            "missing"},
        BadMotion{move_spec(s_curve_lines,
                            "[[then]]\noperator = \"override\"\n"
                            "request = [{ time = 2, factor = 2 }]\n" +
                                s_curve_limits),
                  "a.toml:13:33: then[1].request[1].factor = 2: must not be greater than maximum = "
                  "1"},
        BadMotion{move_spec(s_curve_lines,
                            "[[then]]\noperator = \"new_target\"\ntime = -1\nto = 3\n"
                            "velocity = 1\nacceleration = 1"),
                  "a.toml:13:8: then[1].time = -1 s: must not be before the motion begins, at 0"},
        BadMotion{move_spec("profile = \"velocity\"\nto_velocity = 20\nacceleration = 100",
                            "[[then]]\noperator = \"moving_average\"\nwindow = 1"),
                  "a.toml:9:12: then[1].operator: needs a motion from rest to rest; this one has "
                  "the velocity 20 mm/s at its end"},
        BadMotion{std::string(axes_spec) +
                      "[[then]]\noperator = \"new_target\"\ntime = 0\nto = 3\nvelocity = 1\n"
                      "acceleration = 1",
                  "a.toml:24:12: then[1].operator: works with a single axis only"},
        BadMotion{std::string(axes_spec) + "[[then]]\noperator = \"override\"",
                  "a.toml:11:10: axis[1].limits: need a velocity, an acceleration and a jerk: add "
                  "what is missing"}));

std::vector<std::filesystem::path> generator_examples() {
  std::vector<std::filesystem::path> all;
  for (const auto& entry :
       std::filesystem::directory_iterator(JOUNCE_SOURCE_DIR "/examples/generators"))
    all.push_back(entry.path());
  std::sort(all.begin(), all.end());
  return all;
}

TEST(BadMotionSpecs, AnExampleCutOffAtAnyLineIsRejectedOrStillASpec) {
  for (const auto& path : generator_examples()) {
    const std::string text = read_file(path);
    for (std::size_t end = text.find('\n'); end != std::string::npos;
         end = text.find('\n', end + 1)) {
      const std::string message = complaint(text.substr(0, end));  // nothing but InputError
      EXPECT_TRUE(message.empty() || message.starts_with("a.toml")) << path << "\n" << message;
    }
    EXPECT_EQ(complaint(text), "") << path;
  }
}

TEST(BadMotionSpecs, AnExampleWithAnyNumberReplacedIsRejectedOrStillASpec) {
  const std::regex assignment(R"(^[a-z_]+ = (-?[0-9.]+)\b)", std::regex::multiline);
  for (const auto& path : generator_examples()) {
    const std::string text = read_file(path);
    for (std::sregex_iterator at(text.begin(), text.end(), assignment), none; at != none; ++at) {
      for (const char* number : {"0", "-1", "3", "nan", "inf", "1e-300", "1e-9", "1e9", "1e300"}) {
        std::string changed = text;
        changed.replace(static_cast<std::size_t>(at->position(1)),
                        static_cast<std::size_t>(at->length(1)), number);
        SCOPED_TRACE(path.string() + ": " + at->str() + " -> " + number);
        std::string message;
        EXPECT_NO_THROW(message = complaint(changed));
        EXPECT_TRUE(message.empty() || message.starts_with("a.toml")) << message;
      }
    }
  }
}

TEST(BadMotionSpecs, OneAxisIsNotSeveral) {
  EXPECT_THROW((void)make(parse_spec(axes_spec, "a.toml")), InputError);
}

TEST(Then, FiltersKeepToWhatHimcTakes) {
  const auto filter = [](const std::string& lines) {
    return complaint(move_spec("profile = \"trapezoid\"\nto = 50\nvelocity = 10\nacceleration = 20",
                               "[[then]]\n" + lines));
  };
  const std::string zv = "operator = \"shaper\"\nkind = \"zv\"\n";
  EXPECT_EQ(filter(zv + "frequency = 2\ncontroller = \"himc\"\n"), "");
  EXPECT_EQ(filter(zv + "frequency = 2\ncontroller = \"himc_group\"\n"),
            "a.toml:12:13: then[1].frequency = 2 Hz: must be from 3 Hz to 300 Hz for a group's "
            "InShape (HIMC "
            "error 0x82gg0118)");
  EXPECT_EQ(
      filter(zv + "frequency = 5\ndamping = 0.31\ncontroller = \"himc\"\n"),
      "a.toml:13:11: then[1].damping = 0.31: must be from 0 to 0.3 for an axis's InShape (HIMC "
      "error 0x83aa0474)");
  const std::string notch = "operator = \"notch\"\nfrequency = 5\n";
  EXPECT_EQ(filter(notch + "damping = 0.5\n"), "");
  EXPECT_EQ(filter(notch + "damping = 0.5\ncontroller = \"himc\"\n"),
            "a.toml:12:11: then[1].damping = 0.5: must be from 0.7 to 1.5 for VSF (HIMC error "
            "0x83aa0474)");
}

TEST(Then, InShapeAndTheVsfOfHimcExcludeEachOther) {
  const std::string zv = "[[then]]\noperator = \"shaper\"\nkind = \"zv\"\nfrequency = 5\n";
  const std::string vsf = "[[then]]\noperator = \"notch\"\nfrequency = 5\ndamping = 1\n";
  const std::string himc = "controller = \"himc\"\n";
  const auto both = [](const std::string& more) {
    return complaint(
        move_spec("profile = \"himc\"\nto = 50\nvelocity = 10\nacceleration = 20\n"
                  "smoothing_time = 50",
                  more));
  };
  EXPECT_EQ(both(zv + himc), "") << "with smoothing";
  EXPECT_EQ(both(vsf + himc), "");
  EXPECT_EQ(both(zv + vsf), "") << "filters of no controller";
  EXPECT_THAT(
      both(zv + himc + vsf + himc),
      HasSubstr("then[2].controller = \"himc\": is a second filter of HIMC: InShape is active, and "
                "excludes the VSF (error 0x83aa00c8): keep one of the two"));
  EXPECT_THAT(both(vsf + himc + zv + himc), HasSubstr("the VSF is active, and excludes InShape"));
  EXPECT_THAT(both(zv + himc + zv + himc), HasSubstr("excludes a second one"));
}

/// A cam with an acceleration of its own at both ends, which are open.
std::string open_cam(const std::string& table) {
  return "jounce = 1\nkind = \"cam\"\nunits = { master = \"deg\", position = \"mm\" }\n"
         "start = { master = 0, slave = 0, geo_acceleration = 0.002 }\n"
         "[[segment]]\nlaw = \"quintic\"\nend = { master = 60, slave = 20 }\n"
         "[[segment]]\nlaw = \"quintic\"\nend = { master = 120, slave = 30, geo_velocity = 0.2 }\n"
         "[[segment]]\nlaw = \"quintic\"\n"
         "end = { master = 180, slave = 40, geo_velocity = 0, geo_acceleration = -0.002 }\n" +
         table;
}

TEST(TableRule, IsQuinticWhereTheAccelerationStepsAtOpenEndsAlone) {
  const Made cam = made(open_cam(""));
  EXPECT_EQ(cam.sampled.table.rule(), Interpolation::quintic_hermite);
  EXPECT_EQ(cam.sampled.table.size(), 4U);
}

TEST(TableTolerance, IsRejectedBelowWhatDoublesCanCertify) {
  EXPECT_EQ(complaint(open_cam("[table]\ntolerance = 1e-9\n")), "");
  const std::string refused = complaint(open_cam("[table]\ntolerance = 1e-30\n"));
  EXPECT_NE(refused.find("table.tolerance = 1e-30 mm: must be at least "), std::string::npos)
      << refused;
}

TEST(Table, PiecesAsShortAsTheRoundingOfTheirPlaceAreTakenAlong) {
  const Made queue = made(
      "jounce = 1\nkind = \"queue\"\nunits = { position = \"mm\" }\n"
      "[dynamics]\nvelocity = 926\nacceleration = 6000\njerk = 12000\n"
      "[[command]]\ntype = \"absolute\"\nposition = 2000\n"
      "[[command]]\ntype = \"absolute\"\nposition = 2000\nvelocity = 385\nmode = \"aborting\"\n"
      "issued = 2.15\n");
  EXPECT_NEAR(std::get<Trajectory>(*queue.curve).at(queue.sampled.table.end()).position, 2000,
              1e-9);
  EXPECT_LE(queue.sampled.error.position, 2e-6);
  const Made far = made(
      "jounce = 1\nkind = \"pt\"\nunits = { position = \"mm\", time = \"s\" }\n"
      "point = [{ time = 1e12, position = 1 }, { time = 1000000000001, position = 2 }]\n[pt]\n");
  EXPECT_EQ(far.sampled.table.end(), 1000000000001);
  const Made sudden = made(
      "jounce = 1\nkind = \"move\"\nunits = { position = \"mm\" }\n[move]\nprofile = \"s_curve\"\n"
      "to = 100\nvelocity = 500\nacceleration = 5000\njerk = 9e15\n");  // ramps of 0.56 ps
  EXPECT_LE(sudden.sampled.error.position, 1e-7);
  const Made near = made(
      "jounce = 1\nkind = \"pvt\"\nunits = { position = \"mm\" }\nknot = [{ time = 0, position = "
      "0, velocity = 0 }, "
      "{ time = 1, position = 1, velocity = 0 }, { time = 1.0000000000001, position = 1, velocity "
      "= 0 }, "
      "{ time = 2, position = 3, velocity = 0 }]\n");
  EXPECT_EQ(near.sampled.table.size(), 4U);
}

/// Pick and place of two axes, with these lines between.
std::string via_spec(const std::string& points, const std::string& more = "") {
  const auto axis = [](const char* name) {
    return std::string("[[axis]]\nname = \"") + name +
           "\"\nvelocity = 1000\nacceleration = 8000\njerk = 100000\n";
  };
  return "jounce = 1\nkind = \"axes\"\nunits = { position = \"mm\" }\n" + axis("x") + axis("z") +
         more + points;
}
std::string via_point(const std::string& position, const std::string& more = "") {
  return "[[point]]\nposition = " + position + "\n" + more;
}

TEST(AxesSpec, TheTableOfPickAndPlaceHasNoNeedlesOfJerk) {
  const std::string text =
      via_spec(via_point("[0, 0]") + via_point("[0, 60]") + via_point("[40, 100]") +
               via_point("[260, 100]") + via_point("[300, 60]") + via_point("[300, 0]"));
  for (const Made& axis : make_axes(parse_spec(text, "a.toml"))) {
    const auto& curve = std::get<Trajectory>(*axis.curve);
    const double most = std::abs(extrema(curve, 3).peak().value);
    EXPECT_LE(most, 100000 * (1 + 1e-9));
    EXPECT_LE(std::abs(extrema(axis.sampled.table.curve<OverTime>())[3].peak().value),
              most * (1 + 1e-3))
        << "61 and 117 times with knots 0.65 us apart";
    EXPECT_LE(axis.sampled.error.position, 1e-9 * 300);
  }
}

TEST(AxesSpec, PointsMayHaveRatesAtTheEndsLimitsOfAStretchAndANorm) {
  const std::string slow = "limits = { velocity = [100, 100] }\n";
  const auto text = [&](const std::string& start) {
    return via_spec(
        via_point("[0, 0]", start) + via_point("[200, 0]", slow) + via_point("[400, 300]"),
        "[norm]\nvelocity = 400\n");
  };
  const auto axes = make_axes(parse_spec(text("velocity = [50, 0]\n"), "a.toml"));
  ASSERT_EQ(axes.size(), 2U);
  const auto& x = std::get<Trajectory>(*axes[0].curve);
  const auto& z = std::get<Trajectory>(*axes[1].curve);
  EXPECT_NEAR(x.at(0).velocity, 50, 1e-12);
  EXPECT_NEAR(x.at(1).velocity, 100, 1e-9) << "on the way to 200";
  EXPECT_LE(extrema(x, 1).max.value, 400 * 200 / std::hypot(200, 300) * (1 + 1e-9));
  EXPECT_NEAR(extrema(z, 1).max.value, 400 * 300 / std::hypot(200, 300), 1e-9);
  EXPECT_EQ(
      complaint(text("velocity = [150, 0]\n")),
      "a.toml:16:1: point: no motion was found that keeps the bounds without a reversal: begin and "
      "end slower, within the limits of the stretch, or move the adjacent points apart");
  EXPECT_NE(complaint(text("limits = { velocity = [1, 1] }\n")).find("so the first point has none"),
            std::string::npos);
}

}  // namespace
}  // namespace jounce::motion_spec_test
