// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/drive/machine_sensors.hpp"
#include "jounce/drive/simulated_drive.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/bench.hpp"
#include "support/errors.hpp"

// Every homing method of CiA 402 on a machine whose switches and index are known: where its home must lie is
// read off the standard's figures by hand.

namespace jounce::homing_test {
namespace {

using namespace test;

constexpr double tick = 1e-3;  // s
constexpr double offset = 37.2;
constexpr double fast = 50, slow = 5, acceleration = 800, jerk = 2e4;

/// Limit switches at -100 and 100, indices at ..., -7, 3, 13, 23, 33, ...; home is the caller's.
MachineSensorsSpec machine(const MachineSwitch& home) {
  return {.encoder_offset = offset,
          .home = home,
          .negative = negative_switch(-100),
          .positive = positive_switch(100),
          .index = MachineIndex{.period = 10, .offset = 3}};
}
const MachineSwitch cam{.position = 10, .width = 22};         // on from 10 to 32
const MachineSwitch from_10{.position = 10};                  // and on to the end
const MachineSwitch to_10{.position = 10, .inverted = true};  // from the beginning

AxisConfig config_of() {
  AxisConfig config{.limits = limits(200, 1000, jerk)};
  config.limits.position_min =
      -20;  // range of positions that count from home; not in force during the search
  config.limits.position_max = 20;
  config.homing = {
      .search_velocity = fast, .index_velocity = slow, .acceleration = acceleration, .offset = 2.5};
  return config;
}

/// An axis in front of a machine, at rest and enabled; it keeps the tick that was last.
struct Stage {
  explicit Stage(const MachineSensorsSpec& spec, double at, AxisConfig config = config_of(),
                 std::shared_ptr<AxisDrive> behind = nullptr)
      : bench(config),
        drive(behind ? behind : std::make_shared<NullDrive>(at - spec.encoder_offset), spec, tick) {
    step({command::Enable{}});
    step();
  }

  const Tick& step(const Command& command = {}) {
    Inputs inputs;
    inputs.feedback = drive.feedback();
    Sensors& sensors = inputs.feedback.sensors;
    if (!latches) sensors.home.edge = sensors.negative.edge = sensors.positive.edge = std::nan("");
    before = now;
    now = bench.step(command, inputs);
    drive.command(drive_setpoint(now, command));
    if (watch) watch();
    return now;
  }
  const Tick& home(int method, command::Home more = {}) {
    more.method = method;
    return step({more});
  }
  /// To the end of the homing, or of what came in its place.
  void finish(int most = 200'000) {
    for (int i = 0; i < most && (now.state == State::homing || in_motion(now)); ++i) step();
  }
  /// Position of the machine that the axis commands.
  [[nodiscard]] double at() const { return now.position - now.offset + offset; }

  Bench bench;
  DriveOnMachine drive;
  Tick now, before;
  std::function<void()> watch;
  bool latches = true;  // the drive
};

/// |velocity|, |acceleration| and jerk of a tick; position, velocity and acceleration belong together.
void expect_within_limits(const Stage& stage) {
  const Tick& now = stage.now;
  const Tick& before = stage.before;
  EXPECT_LE(std::abs(now.velocity), fast * (1 + 1e-9));
  EXPECT_LE(std::abs(now.acceleration), acceleration * (1 + 1e-9));
  EXPECT_LE(std::abs(now.acceleration - before.acceleration), jerk * tick * (1 + 1e-6));
  const double way = (now.position - now.offset) - (before.position - before.offset);
  EXPECT_NEAR(way, tick * (now.velocity + before.velocity) / 2, jerk * tick * tick * tick / 6);
}

struct Case {
  MachineSwitch home;
  double expected;  // u, of the machine
};

// CiA 402, figures of the homing methods.
const std::map<int, Case> cases{
    {1, {cam, -97}},     {2, {cam, 93}},      {3, {from_10, 3}}, {4, {from_10, 13}},
    {5, {to_10, 13}},    {6, {to_10, 3}},     {7, {cam, 3}},     {8, {cam, 13}},
    {9, {cam, 23}},      {10, {cam, 33}},     {11, {cam, 33}},   {12, {cam, 23}},
    {13, {cam, 13}},     {14, {cam, 3}},      {17, {cam, -100}}, {18, {cam, 100}},
    {19, {from_10, 10}}, {20, {from_10, 10}}, {21, {to_10, 10}}, {22, {to_10, 10}},
    {23, {cam, 10}},     {24, {cam, 10}},     {25, {cam, 32}},   {26, {cam, 32}},
    {27, {cam, 32}},     {28, {cam, 32}},     {29, {cam, 10}},   {30, {cam, 10}}};

// On and just beside every switch, between them, and in the middle of nowhere.
const std::vector<double> starts{-101.3, -100, -99.95, -50, -7, 9.98,  10,  10.02,
                                 20,     31.9, 32,     33,  60, 99.98, 100, 104};

TEST(Homing, EveryMethodFindsItsHomeFromEverywhere) {
  for (const auto& [method, wanted] : cases)
    for (const double start : starts) {
      SCOPED_TRACE("method " + std::to_string(method) + " from " + std::to_string(start));
      Stage stage(machine(wanted.home), start);
      double last_passed = 0;  // u/s, as the home was passed last
      stage.watch = [&, at = stage.at(), home = wanted.expected]() mutable {
        expect_within_limits(stage);
        if ((at < home) != (stage.at() < home)) last_passed = stage.now.velocity;
        at = stage.at();
      };
      EXPECT_EQ(refusal(stage.home(method)), Cause::none);
      EXPECT_FALSE(stage.now.homed);
      stage.finish();
      ASSERT_EQ(stage.now.state, State::standstill) << name(stage.now.fault);
      ASSERT_TRUE(stage.now.homed);
      EXPECT_EQ(stage.now.reason, Cause::none);
      EXPECT_EQ(stage.now.finished, 1U);
      // The home position has the offset's name: so far does the count agree with the machine.
      EXPECT_NEAR(stage.now.position - 2.5, stage.at() - wanted.expected, 1e-9);
      EXPECT_LE(std::abs(last_passed), slow * (1 + 1e-9));
      if (HasFailure()) return;
    }
}

TEST(Homing, TheIndexAloneIsTheNextOneInTheDirection) {
  for (const double start : {-50.0, 4.0, 12.99, 60.0}) {
    const double below = std::floor((start - 3) / 10) * 10 + 3;
    for (const auto& [method, expected] : {std::pair{33, below}, {34, below + 10}}) {
      SCOPED_TRACE(method);
      Stage stage(machine(cam), start);
      stage.watch = [&] { expect_within_limits(stage); };
      stage.home(method);
      stage.finish();
      ASSERT_TRUE(stage.now.homed);
      EXPECT_NEAR(stage.now.position - 2.5, stage.at() - expected, 1e-9);
    }
  }
}

TEST(Homing, WhereItStandsNothingMoves) {
  for (const int method : {35, 37}) {
    Stage stage(machine(cam), 60);
    EXPECT_EQ(stage.home(method).state, State::homing);
    EXPECT_EQ(stage.now.position, 2.5);
    EXPECT_TRUE(stage.now.homed);
    EXPECT_EQ(stage.step().state, State::standstill);
    EXPECT_EQ(stage.at(), 60);
  }
}

// A servo that lags behind its setpoint: the latch is of the encoder, so the home is no worse for it.
TEST(Homing, ADriveThatLagsFindsTheSameHome) {
  for (const int method : {1, 7, 10, 18, 24, 28, 33}) {
    SCOPED_TRACE(method);
    const double start = 60;
    auto servo = std::make_shared<SimulatedDrive>(servo_400w(), tick, start - offset);
    Stage stage(machine(cam), start, config_of(), servo);
    stage.home(method);
    stage.finish();
    ASSERT_TRUE(stage.now.homed) << name(stage.now.fault);
    const double expected = method == 33 ? 53 : cases.at(method).expected;
    const double machine_now = servo->feedback().position + offset;
    EXPECT_NEAR(servo->feedback().position + stage.now.offset - 2.5, machine_now - expected, 1e-9);
  }
}

/// Follows its setpoint with a first-order lag of gain Kv [1/s], as a position loop does.
class Lagging final : public AxisDrive {
 public:
  Lagging(double position, double gain) : position_(position), gain_(gain) {}

  void command(const DriveSetpoint& setpoint) noexcept override {
    const double step = (setpoint.position - position_) * (1 - std::exp(-gain_ * tick));
    velocity_ = step / tick;
    position_ += step;
  }
  [[nodiscard]] Feedback feedback() noexcept override {
    Feedback seen;
    seen.position = position_;
    seen.velocity = velocity_;
    return seen;
  }

 private:
  double position_, velocity_ = 0, gain_;
};

// The setpoint rests while the machine still moves on, on some of these switches over their other edge.
TEST(Homing, AMachineThatStillMovesDoesNotPassAnotherEdgeForHome) {
  for (const double gain : {20.0, 30.0, 50.0})
    for (double width = 1; width <= 12; width += 0.125)
      for (const int method : {23, 24, 27, 30}) {
        const MachineSwitch narrow{.position = 10, .width = width};
        Stage stage(machine(narrow), -50, config_of(),
                    std::make_shared<Lagging>(-50 - offset, gain));
        stage.home(method);
        stage.finish();
        if (!stage.now.homed) continue;  // a switch that the search overruns may end in a fault
        const double edge = method == 27 ? 10 + width : 10;
        EXPECT_NEAR(stage.at() - (stage.now.position - 2.5), edge, 1e-9)
            << method << ", width " << width << ", Kv " << gain;
      }
}

TEST(Homing, AContactThatBouncesIsLatchedAtItsFirstEdge) {
  MachineSwitch bouncing = cam;
  bouncing.bounce = 0.008;
  for (const int method : {23, 24, 25, 26, 27, 28, 29, 30})
    for (const double start : {-50.0, 9.98, 20.0, 32.0, 60.0}) {
      SCOPED_TRACE("method " + std::to_string(method) + " from " + std::to_string(start));
      Stage stage(machine(bouncing), start);
      stage.watch = [&] { expect_within_limits(stage); };
      stage.home(method);
      stage.finish();
      ASSERT_TRUE(stage.now.homed) << name(stage.now.fault);
      EXPECT_NEAR(stage.now.position - 2.5, stage.at() - cases.at(method).expected, 1e-9);
    }
}

// 0.2 u: passed by the search in four ticks, and before it stands.
TEST(Homing, ASwitchThatTheSearchOverrunsIsFoundOnTheWayBack) {
  const MachineSwitch narrow{.position = 10, .width = 0.2};
  for (const auto& [method, expected] : {std::pair{23, 10.0},
                                         {24, 10.0},
                                         {25, 10.2},
                                         {26, 10.2},
                                         {27, 10.2},
                                         {28, 10.2},
                                         {29, 10.0},
                                         {30, 10.0}})
    for (const double start : {-50.0, 60.0}) {
      SCOPED_TRACE("method " + std::to_string(method) + " from " + std::to_string(start));
      Stage stage(machine(narrow), start);
      stage.home(method);
      stage.finish();
      ASSERT_TRUE(stage.now.homed) << name(stage.now.fault);
      EXPECT_NEAR(stage.now.position - 2.5, stage.at() - expected, 1e-9);
    }
}

TEST(Homing, WithoutALatchTheHomeIsAsNearAsTheWayOfACycle) {
  for (int method = 17; method <= 30; ++method) {
    SCOPED_TRACE(method);
    const Case& wanted = cases.at(method);
    Stage stage(machine(wanted.home), 60);
    stage.latches = false;
    stage.home(method);
    stage.finish();
    ASSERT_TRUE(stage.now.homed) << name(stage.now.fault);
    EXPECT_NEAR(stage.now.position - 2.5, stage.at() - wanted.expected, slow * tick + 1e-9);
  }
}

TEST(Homing, LateCyclesDoNotMoveTheHome) {
  for (const auto& [method, wanted] : cases) {
    SCOPED_TRACE(method);
    Stage stage(machine(wanted.home), 60);
    stage.home(method);
    for (int i = 0; i < 200'000 && stage.now.state == State::homing; ++i) {
      if (i % 7 == 0) stage.bench.tick += i % 5;
      stage.step();
    }
    ASSERT_TRUE(stage.now.homed) << name(stage.now.fault);
    EXPECT_NEAR(stage.now.position - 2.5, stage.at() - wanted.expected, 1e-9);
  }
}

TEST(Homing, TheOrderChangesWhatIsConfigured) {
  Stage stage(machine(cam), -50);
  double fastest = 0;
  stage.watch = [&] { fastest = std::max(fastest, std::abs(stage.now.velocity)); };
  stage.step({command::Home{.offset = 15,
                            .method = 24,
                            .search_velocity = 20,
                            .index_velocity = 1,
                            .acceleration = 100}});
  stage.finish();
  ASSERT_TRUE(stage.now.homed);
  EXPECT_NEAR(stage.now.position - 15, stage.at() - 10, 1e-9);
  EXPECT_NEAR(fastest, 20, 1e-9);
}

// ---- what ends it otherwise --------------------------------------------------------------------------

/// `limit`: the timeout, s, or the distance that the search exceeded; NaN: none.
void expect_failed(Stage& stage, Cause cause, double limit = NAN) {
  stage.finish();
  EXPECT_THAT(stage.now.fault_value, testing::NanSensitiveDoubleEq(limit));
  EXPECT_EQ(stage.now.state, State::error_stop);
  EXPECT_EQ(stage.now.fault, cause) << name(stage.now.fault);
  EXPECT_FALSE(stage.now.homed);
  EXPECT_EQ(stage.now.velocity, 0);
  stage.step({command::Reset{}});
  EXPECT_EQ(stage.step().state, State::standstill);
}

TEST(Homing, FailsWhereTheSwitchIsNotBetweenTheLimitSwitches) {
  for (const int method : {23, 27}) {
    Stage stage(machine({.position = 300, .width = 5}), -50);
    stage.home(method);
    expect_failed(stage, Cause::home_not_found);
  }
}

TEST(Homing, FailsAtItsDistanceAndItsTimeout) {
  Stage far(machine(cam), -50);
  far.home(23, {.distance = 30});
  expect_failed(far, Cause::search_distance, 30);
  EXPECT_NEAR(far.at(), -20, 4);

  Stage no_index(machine(cam), 4);
  no_index.home(34, {.distance = 5});
  expect_failed(no_index, Cause::index_not_found, 5);

  Stage late(machine(cam), -50);
  late.home(23, {.timeout = 0.5});
  const double begun = late.now.time;
  while (late.now.state == State::homing) late.step();
  EXPECT_NEAR(late.now.time - begun, 0.5, 0.002);
  expect_failed(late, Cause::home_timeout, 0.5);
}

TEST(Homing, FailsOnALimitSwitchThatItDoesNotSearchFor) {
  MachineSensorsSpec rare = machine(cam);
  rare.index->period = 1000;
  Stage up(rare, 60);
  up.home(34);
  expect_failed(up, Cause::positive_switch);
  Stage below(rare, -60);
  below.home(33);
  expect_failed(below, Cause::negative_switch);
}

TEST(Homing, FailsWhereBothLimitSwitchesAreOn) {
  MachineSensorsSpec crossed = machine(cam);
  crossed.negative = negative_switch(200);
  crossed.positive = positive_switch(-200);
  Stage stage(crossed, 0);
  stage.home(23);
  expect_failed(stage, Cause::both_switches);
}

TEST(Homing, RejectsWhatItCannotDo) {
  const auto refused = [](Stage& stage, const Command& command) {
    const Cause cause = refusal(stage.step(command));
    EXPECT_EQ(stage.now.state, State::standstill);
    return cause;
  };
  Stage stage(machine(cam), 0);
  const auto with = [](int method, const MoveDynamics& dynamics = {},
                       double index = as_configured) {
    return Command{command::Home{.method = method,
                                 .search_velocity = dynamics.velocity,
                                 .index_velocity = index,
                                 .acceleration = dynamics.acceleration}};
  };
  for (const int method : {15, 16, 31, 32, 36, 38, -1, 1000})
    EXPECT_EQ(refused(stage, with(method)), Cause::no_such_method) << method;
  EXPECT_EQ(refused(stage, with(23, {.velocity = 0})), Cause::not_positive);
  EXPECT_EQ(refused(stage, with(23, {.velocity = 201})), Cause::velocity_limit);
  EXPECT_EQ(refused(stage, with(23, {.acceleration = 1001})), Cause::acceleration_limit);
  EXPECT_EQ(refused(stage, with(23, {}, 201)), Cause::velocity_limit);
  Stage bare({.encoder_offset = offset}, 0);
  for (const int method : {1, 2, 17, 18, 7, 23, 33})
    EXPECT_EQ(refused(bare, with(method)), Cause::no_sensor) << method;
  EXPECT_EQ(refusal(bare.step(with(35))), Cause::none);
}

TEST(Homing, AConfigurationThatCannotBeIsRejectedWithItsKey) {
  const auto complaint = [](const HomingSpec& spec) {
    AxisConfig config = config_of();
    config.homing = spec;
    return test::key_of([&] { (void)resolved(config); });
  };
  EXPECT_EQ(complaint({.method = 15}), "homing.method");
  EXPECT_EQ(complaint({.search_velocity = 201}), "homing.search_velocity");
  EXPECT_EQ(complaint({.index_velocity = -1}), "homing.index_velocity");
  EXPECT_EQ(complaint({.acceleration = 1001}), "homing.acceleration");
  EXPECT_EQ(complaint({.offset = NAN}), "homing.offset");
  EXPECT_EQ(complaint({.timeout = 0}), "homing.timeout");
  EXPECT_EQ(complaint({.distance = -1}), "homing.distance");
  EXPECT_EQ(complaint({.distance = 0}), "homing.distance");
  const HomingSpec left_out = resolved(AxisConfig{.limits = limits(200, 1000)}).homing;
  EXPECT_EQ(left_out.method, 37);
  EXPECT_EQ(left_out.search_velocity, 20);
  EXPECT_EQ(left_out.index_velocity, 5);
  EXPECT_EQ(left_out.acceleration, 1000);
}

// ---- the state -------------------------------------------------------------------------------------

TEST(Homing, AHomePositionOutsideTheRangeIsRejectedExceptOnTheSwitchOfThatSide) {
  Limits range{.velocity = 10, .acceleration = 100};
  range.position_min = -10;
  range.position_max = 100;
  const auto limit = [&](int method, double home) {
    const auto no = misplaced_home({.method = method, .offset = home}, range);
    return no ? no->limit : NAN;
  };
  EXPECT_TRUE(std::isnan(limit(37, 100)));
  EXPECT_EQ(limit(37, 101), 100);
  EXPECT_EQ(limit(24, -11), -10);
  for (const int negative : {1, 17}) {
    EXPECT_TRUE(std::isnan(limit(negative, -11)));
    EXPECT_EQ(limit(negative, 101), 100);
  }
  for (const int positive : {2, 18}) {
    EXPECT_TRUE(std::isnan(limit(positive, 101)));
    EXPECT_EQ(limit(positive, -11), -10);
  }
}

TEST(Homing, NothingElseMovesTheAxisMeanwhile) {
  Stage stage(machine(cam), -50);
  stage.home(23);
  for (int i = 0; i < 300; ++i) stage.step();
  for (const Kind kind : {Kind::home, Kind::set_position, Kind::move_absolute, Kind::move_relative,
                          Kind::move_velocity, Kind::move_additive, Kind::move_superimposed,
                          Kind::hold, Kind::resume, Kind::finish, Kind::start}) {
    EXPECT_EQ(refusal(stage.step(any({.kind = kind, .position = 1}))), Cause::in_motion)
        << name(kind);
    EXPECT_EQ(stage.now.state, State::homing);
  }
  stage.finish();
  EXPECT_TRUE(stage.now.homed);
}

TEST(Homing, StopAndHaltEndItAtRestWithinTheLimits) {
  for (const auto& [kind, reason] :
       {std::pair{Kind::stop, Cause::stopped}, {Kind::halt, Cause::halted}})
    for (const int after : {0, 1, 300, 1230, 1300, 1500}) {
      SCOPED_TRACE(std::string(name(kind)) + " after " + std::to_string(after));
      Stage stage(machine(cam), -50);  // outside the range of its positions, which do not count yet
      stage.home(23);
      for (int i = 0; i < after; ++i) stage.step();
      ASSERT_EQ(stage.now.state, State::homing);
      stage.step(any({.kind = kind}));
      const Cause no = refusal(stage.step({command::MoveRelative{.distance = 1}}));
      if (stage.before.state == State::standstill)
        EXPECT_EQ(no, Cause::position_limit) << "the axis is outside its range";
      else
        EXPECT_EQ(no, Cause::stopping);
      stage.finish();
      EXPECT_EQ(stage.now.fault, Cause::none);
      EXPECT_EQ(stage.now.state, State::standstill);
      EXPECT_FALSE(stage.now.homed);
    }
}

TEST(Homing, AStopOrHaltWithALowDecelerationEndsItAsTheAxisStops) {
  for (const auto kind : {Kind::stop, Kind::halt}) {
    Stage stage(machine(cam), -50);
    stage.home(18);
    for (int i = 0; i < 500; ++i) stage.step();
    const double at = stage.at();
    stage.step(any({.kind = kind, .dynamics = {.deceleration = 0.1}}));
    stage.finish();
    EXPECT_EQ(stage.now.fault, Cause::none);
    EXPECT_LT(stage.at() - at, fast * fast / (2 * acceleration) + fast * acceleration / jerk);
  }
}

TEST(Homing, AnOverrideAboveOneDoesNotSpeedItUp) {
  Stage stage(machine(cam), -50);
  stage.step({command::Override{.factor = 2}});
  stage.watch = [&] { expect_within_limits(stage); };
  stage.home(23);
  stage.finish();
  EXPECT_TRUE(stage.now.homed);
}

TEST(Homing, ADriveFaultEndsTheHomeAlsoWhereThePowerIsOff) {
  Stage stage(machine(cam), -50);
  stage.home(23);
  stage.finish();
  ASSERT_TRUE(stage.now.homed);
  stage.step({command::Disable{}});
  Inputs inputs;
  inputs.feedback = stage.drive.feedback();
  inputs.feedback.fault = true;
  EXPECT_FALSE(stage.bench.step({}, inputs).homed);
}

TEST(Homing, AStopNearALimitSwitchIsNoFault) {
  Stage stage(machine(cam), 60);
  stage.home(23);
  while (stage.now.state == State::homing && stage.at() < 100.05) stage.step();
  stage.step({command::Stop{}});
  stage.finish();
  EXPECT_EQ(stage.now.fault, Cause::none) << name(stage.now.fault);
  EXPECT_EQ(stage.now.reason, Cause::stopped);
}

TEST(Homing, AnAbortAndADisableEndIt) {
  Stage aborted(machine(cam), -50);
  aborted.home(23);
  for (int i = 0; i < 300; ++i) aborted.step();
  aborted.step({command::Abort{}});
  expect_failed(aborted, Cause::aborted);
  Stage disabled(machine(cam), -50);
  disabled.home(23);
  for (int i = 0; i < 300; ++i) disabled.step();
  disabled.step({command::Disable{}});
  EXPECT_EQ(disabled.now.state, State::disabled);
  EXPECT_FALSE(disabled.now.homed);
}

TEST(Homing, OverrideSlowsItDownAndHoldsItAtZero) {
  Stage stage(machine(cam), -50);
  stage.home(23);
  stage.step({command::Override{.factor = 0}});
  for (int i = 0; i < 500; ++i) stage.step();
  EXPECT_EQ(stage.now.velocity, 0);
  EXPECT_EQ(stage.now.state, State::homing);
  stage.step({command::Override{.factor = 0.5}});
  for (int i = 0; i < 300; ++i) stage.step();
  EXPECT_NEAR(stage.now.velocity, fast / 2, 1e-9);
  stage.finish();
  ASSERT_TRUE(stage.now.homed);
  EXPECT_NEAR(stage.now.position - 2.5, stage.at() - 10, 1e-9);
}

TEST(Homing, AnOverrideOfZeroKeepsItsAcceleration) {
  Stage stage(machine(cam), -50);
  stage.home(23);
  for (int i = 0; i < 300; ++i) stage.step();
  ASSERT_NE(stage.now.velocity, 0);
  stage.watch = [&] { expect_within_limits(stage); };
  stage.step({command::Override{.factor = 0}});
  for (int i = 0; i < 500; ++i) stage.step();
  EXPECT_EQ(stage.now.velocity, 0);
  stage.step({command::Override{.factor = 1}});
  stage.finish();
  EXPECT_TRUE(stage.now.homed);
}

TEST(Homing, AfterwardsThePositionRangeHolds) {
  Stage stage(machine(cam), -50);
  stage.home(23);
  stage.finish();
  ASSERT_TRUE(stage.now.homed);
  EXPECT_EQ(refusal(stage.step({command::MoveAbsolute{.position = 21}})), Cause::position_limit);
  stage.step({command::MoveVelocity{.velocity = -100}});
  stage.finish();
  EXPECT_EQ(stage.now.fault, Cause::negative_soft_limit);
  EXPECT_NEAR(stage.now.position, -20, 1e-6);
}

TEST(Homing, WhatRequiresAHomeIsRejectedBefore) {
  AxisConfig config = config_of();
  config.require_home = true;
  Stage stage(machine(cam), 40, config);
  const Command absolute{command::MoveAbsolute{.position = 5}};
  EXPECT_EQ(refusal(stage.step(absolute)), Cause::not_homed);
  EXPECT_EQ(refusal(stage.step({command::MoveRelative{.distance = 1}})), Cause::none);
  stage.finish();
  stage.home(24);
  stage.finish();
  ASSERT_TRUE(stage.now.homed);
  EXPECT_EQ(refusal(stage.step(absolute)), Cause::none);
  stage.finish();
  EXPECT_NEAR(stage.at(), 12.5, 1e-9) << "2.5 beyond the edge, which is at 2.5";
}

}  // namespace
}  // namespace jounce::homing_test
