// SPDX-License-Identifier: Apache-2.0
#include "executor/src/server/notices.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/command/detail/causes.hpp"
#include "jounce/command/detail/command_table.hpp"
#include "jounce/command/detail/refusal_text.hpp"
#include "jounce/path/point.hpp"
#include "jounce/stream/message/message.hpp"

namespace jounce::notices_test {
namespace {

using ::testing::HasSubstr;

using Notices = std::vector<std::string>;

TEST(Notices, ReportWhatChangedInATick) {
  const Tick before{.tick = 9, .job = 1, .finished = 4, .stopped = 2};
  EXPECT_EQ(notices_of(before, before, "mm"), Notices{});
  EXPECT_EQ(notices_of(before, {.tick = 10, .job = 2, .finished = 5, .stopped = 2}, "mm"),
            (Notices{"started at tick 10", "finished at tick 10"}));
  EXPECT_EQ(notices_of(before, {.tick = 10, .finished = 4, .stopped = 3}, "mm"),
            Notices{"stopped at tick 10"});
}

TEST(Notices, ReportAFaultOnceWithItsMeaning) {
  const Tick before{.tick = 9};
  const Tick now{.tick = 10, .fault = Cause::drive_fault};
  const Notices notices = notices_of(before, now, "mm");
  ASSERT_EQ(notices.size(), 1U);
  EXPECT_EQ(notices[0], std::string("fault at tick 10 (0 s, position 0 mm): ") +
                            name(Cause::drive_fault) + ": " + meaning(Cause::drive_fault) +
                            " See `jounce explain drive_fault`.");
  EXPECT_EQ(notices_of(now, now, "mm"), Notices{});
  EXPECT_EQ(notices_of(now, before, "mm"), Notices{}) << "a reset";
}

TEST(Notices, ACutterAwayFromHomeIsAnsweredWithItsOrder) {
  ExecutorOptions options;
  options.units = {"mm", "deg"};
  options.receiver.executor = "knife";
  const Refusal away{.cause = Cause::cutter_away, .value = 270, .limit = 90};
  EXPECT_EQ(refusal_text(away, {}, options, CommandKind::start_table),
            "the cutter does not stand at its home position: home is at 270 deg, the axis at 90 "
            "deg: send `jounce order knife move --to 270deg`");
}

TEST(Notices, AnAxisOfAGroupWithJointsHasItsOwnUnit) {
  ExecutorOptions options;
  options.units = {"", "mm"};
  options.group.emplace();
  options.group->names = {"a1", "z"};
  options.group->units = {"deg", "mm"};
  options.group->kinematics.emplace();
  const Refusal away{.cause = Cause::axis_away, .value = 3, .limit = 5, .where = 1};
  EXPECT_THAT(refusal_text(away, {}, options, CommandKind::start),
              HasSubstr("a1 is at 3 deg instead of 5 deg."));
}

TEST(Notices, APlaceHasAllDigitsThatAMoveToItNeeds) {
  ExecutorOptions options;
  options.units = {"", "mm"};
  options.group.emplace();
  options.group->names = {"x", "c"};
  options.group->units = {"mm", "deg"};
  options.group->of.tolerance = 1e-6;
  const Refusal away{
      .cause = Cause::axis_away, .value = 424.557, .limit = 431.78125903267603, .where = 2};
  EXPECT_THAT(refusal_text(away, {}, options, CommandKind::resume),
              HasSubstr("c is at 424.557 deg instead of 431.781259033 deg. The tolerance is "
                        "1e-6 deg."));
}

TEST(Notices, ReportTheNumbersOfAFault) {
  AxisConfig config{.following_error = 0.1, .following_time = 0.002};
  config.limits.position_min = -10;
  Tick now{.tick = 575, .fault = Cause::following_error};
  now.following_error = 0;  // the axis was disabled, and its setpoint follows the drive
  now.fault_value = 0.31;
  const std::string text = fault_text(now, "mm", config);
  EXPECT_THAT(text, HasSubstr("was 0.31 mm"));
  EXPECT_THAT(text, HasSubstr("following_error = 0.1 mm"));
  EXPECT_THAT(text, HasSubstr("following_time = 0.002 s"));
  now.fault = Cause::negative_soft_limit;
  EXPECT_THAT(fault_text(now, "mm", config), HasSubstr("position_min = -10 mm"));
  now.fault = Cause::axis_fault;
  now.failed_axis = Refusal{Cause::axis_not_ready, static_cast<double>(Cause::not_enabled), 0, 2};
  const std::vector<std::string> axes{"x", "y"};
  EXPECT_THAT(fault_text(now, "mm", config, axes), HasSubstr("y was disabled."));
  now.failed_axis->limit = 3;  // the bits of x and y
  EXPECT_THAT(fault_text(now, "mm", config, axes), HasSubstr("; x was not ready either."));
  config.limits.acceleration = 10000;
  now.fault = Cause::overacceleration;
  now.fault_value = 20700;
  EXPECT_THAT(
      fault_text(now, "mm", config),
      HasSubstr("The motion requires 20700 mm/s^2. The limit is acceleration = 10000 mm/s^2."));
  now.fault = Cause::jump;
  EXPECT_THAT(fault_text(now, "mm", config),
              HasSubstr("The limit is stop_acceleration = 20000 mm/s^2."))
      << "by default, twice the acceleration";
  config.stop_acceleration = 15000;
  EXPECT_THAT(fault_text(now, "mm", config), HasSubstr("stop_acceleration = 15000 mm/s^2."));
}

TEST(Notices, AFailedHomingNamesItsLimit) {
  Tick now{.fault = Cause::home_timeout};
  EXPECT_THAT(fault_text(now, "mm", {}), ::testing::EndsWith("longer than its timeout."));
  now.fault_value = 0.5;
  EXPECT_THAT(fault_text(now, "mm", {}), HasSubstr(" The limit is timeout = 0.5 s."));
  for (const Cause cause : {Cause::search_distance, Cause::index_not_found}) {
    now.fault = cause;
    now.fault_value = 30;
    EXPECT_THAT(fault_text(now, "mm", {}), HasSubstr(" The limit is distance = 30 mm."));
  }
}

TEST(Notices, ARejectionNamesThePresentFault) {
  const ExecutorOptions options;
  const Tick now{.fault = Cause::negative_soft_limit};
  for (const Cause cause : {Cause::in_error, Cause::not_enabled}) {
    EXPECT_THAT(refusal_text({cause}, now, options), HasSubstr("negative_soft_limit. "));
    EXPECT_THAT(refusal_text({cause}, {}, options),
                ::testing::StartsWith(std::string(name(cause)) + ": The axis "));
  }
  ExecutorOptions limited;
  limited.units.position = "mm";
  limited.axis.limits.position_max = 300;
  EXPECT_EQ(refusal_text({Cause::in_error}, {.fault = Cause::positive_soft_limit}, limited),
            "in_error: the axis has a fault: positive_soft_limit. The motion would have passed "
            "position_max: the axis stopped before it. The limit is position_max = 300 mm.");
  limited.axis.longest_gap = 100;
  Tick stalled{.fault = Cause::stalled};
  stalled.skipped = 3;
  const std::string late = refusal_text({Cause::in_error}, stalled, limited);
  EXPECT_THAT(late, HasSubstr("longest_gap is 100 cycles"));
  EXPECT_THAT(late, ::testing::Not(HasSubstr("late by 3"))) << "the delay of a later cycle";
}

TEST(Notices, ARejectionNamesWhatTheSpecLacks) {
  ExecutorOptions options;
  EXPECT_THAT(refusal_text({Cause::no_master_input}, {}, options),
              HasSubstr("or [follow] to its own spec"));
  EXPECT_THAT(
      refusal_text({Cause::no_cut_plan}, {}, options),
      HasSubstr("send the command to an axis that has one, or add cutter = \"FILE\" (kind knife or "
                "shear) to [axis]"));
  const Refusal input{Cause::no_trigger_input, 2, 0b110000};
  EXPECT_THAT(refusal_text(input, {}, options), HasSubstr("add [drive] to its spec"));
  options.follow = {.what = Follow::What::master};
  EXPECT_THAT(refusal_text({Cause::no_master_input}, {}, options), HasSubstr("no valid position"));
  options.cutter.emplace();
  EXPECT_THAT(refusal_text({Cause::no_cut_plan}, {}, options), HasSubstr("no_cut_plan: "));
  EXPECT_EQ(text(input, "mm"),
            "no_trigger_input: The drive of the axis does not have this trigger "
            "input: 2; it has home, index.");
  for (const Cause cause : {Cause::no_master_input, Cause::no_cut_plan, Cause::no_trigger_input})
    EXPECT_LT(refusal_text({cause}, {}, ExecutorOptions{}).size(), wire::reason_bytes);
}

TEST(Notices, ARejectedDistanceComesWithThePossibleOnes) {
  ExecutorOptions options;
  options.units.position = "mm";
  options.axis.limits.position_min = -10;
  options.axis.limits.position_max = 300;
  const Refusal beyond{.cause = Cause::position_limit, .value = 400, .limit = 300};
  const auto text_at = [&](double position, State state = State::standstill) {
    Tick now{.state = state};
    now.position = position;
    return refusal_text(beyond, now, options, CommandKind::move_relative);
  };
  EXPECT_EQ(text_at(0),
            "400 mm is outside the position range, -10 mm to 300 mm: give at most 300 mm forward, "
            "or 10 mm back");
  EXPECT_THAT(text_at(300), ::testing::EndsWith("give at most 310 mm back"));
  EXPECT_THAT(text_at(-10), ::testing::EndsWith("give at most 310 mm forward"));
  EXPECT_THAT(text_at(-11), ::testing::StartsWith("position_limit: ")) << "outside the range";
  EXPECT_THAT(text_at(0, State::discrete_motion), ::testing::StartsWith("position_limit: "))
      << "the start of the move is not known";
}

TEST(Notices, AMemberOfAGroupNamesTheOrderToTheGroup) {
  ExecutorOptions options;
  options.groups = {"plotter"};
  EXPECT_THAT(refusal_text({Cause::in_group}, {}, options, CommandKind::hold),
              ::testing::EndsWith("send `jounce order plotter hold`"));
  EXPECT_THAT(refusal_text({Cause::in_group}, {}, options, CommandKind::move_absolute),
              ::testing::EndsWith("send `jounce order plotter disable` first"));
}

/// Each refusal, in each state, with the longest names, units and numbers, for these options.
void expect_all_fit(ExecutorOptions options) {
  constexpr double number = -1.23456e-300;
  options.receiver.executor = std::string(wire::executor_bytes - 1, 'n');
  options.units = {std::string(wire::unit_bytes - 1, 'u'), std::string(wire::unit_bytes - 1, 'u')};
  options.axis.limits = {.position_min = 10 * number,
                         .position_max = 0,
                         .velocity = number,
                         .acceleration = number,
                         .jerk = number};
  options.axis.following_error = options.axis.following_time = -number;
  for (const CauseInfo& info : all_causes())
    for (const Cause fault : {Cause::none, Cause::following_error, Cause::axis_fault, Cause::jump})
      for (const State state : {State::disabled, State::standstill, State::discrete_motion,
                                State::continuous_motion, State::synchronized_motion})
        for (const CommandKind order :
             {CommandKind::arm, CommandKind::start, CommandKind::hold, CommandKind::move_relative,
              CommandKind::move_linear_relative}) {
          if (info.cause == Cause::none) continue;
          constexpr double all_axes = (1U << max_axes) - 1;  // bits of the axes that are not ready
          const bool is_of_axes = info.cause == Cause::axis_not_ready;
          Tick now{.state = state, .fault = fault, .fault_value = number};
          now.position = number;
          const std::string text = refusal_text(
              {info.cause, number, is_of_axes ? all_axes : number, 1}, now, options, order);
          EXPECT_LT(text.size(), wire::reason_bytes) << text;
        }
}

TEST(Notices, ARejectionWithLongNamesFitsIntoItsField) {
  const std::string name(wire::executor_bytes - 1, 'g');
  expect_all_fit({});
  ExecutorOptions member;
  member.groups = {name, name};
  expect_all_fit(member);
  ExecutorOptions cutter;
  cutter.follow.what = Follow::What::master;
  cutter.cutter.emplace();
  expect_all_fit(cutter);
  ExecutorOptions group;
  group.group.emplace();
  group.group->names.assign(max_axes, name);
  expect_all_fit(group);
}

// The field of the reason on the wire cuts a longer text.
TEST(Notices, ARejectionFitsIntoItsField) {
  const ExecutorOptions options;
  for (const CauseInfo& fault : all_causes()) {
    if (fault.cause == Cause::none) continue;
    for (const Cause cause : {Cause::in_error, Cause::not_enabled}) {
      const std::string text = refusal_text({cause}, {.fault = fault.cause}, options);
      EXPECT_LT(text.size(), wire::reason_bytes) << text;
      EXPECT_THAT(text, ::testing::StartsWith(std::string(name(cause)) + ": "));
      EXPECT_THAT(text, HasSubstr(std::string("fault: ") + fault.name));
    }
  }
  ExecutorOptions millimeters;
  millimeters.units.position = "mm";
  const Refusal elsewhere{Cause::start_position, -1234.5678, -8765.4321};
  ExecutorOptions no_cutter;
  EXPECT_LT(refusal_text({Cause::no_cut_plan}, {}, no_cutter).size(), wire::reason_bytes);
  const Tick moving{.state = State::discrete_motion, .job = 1};
  const std::string text = refusal_text(elsewhere, moving, millimeters);
  EXPECT_LT(text.size(), wire::reason_bytes);
  EXPECT_THAT(
      text, HasSubstr("begins at -1234.5678 mm, but the present motion ends at -8765.43 mm: after "
                      "it, send `jounce order "));
}

// The order of the reason must move the axis to the start within the tolerance: six digits were too few.
TEST(Notices, TheOrderToTheStartOfATableHasItsDigits) {
  ExecutorOptions options;
  options.units.position = "mm";
  options.receiver.executor = "p";
  EXPECT_THAT(refusal_text({Cause::start_position, 8.0201172412, 8.02012}, {}, options),
              HasSubstr("begins at 8.0201172412 mm, but the axis is at 8.02012 mm: send `jounce "
                        "order p move --to 8.0201172412mm`"));
}

// Standstill never comes by itself, so "wait for standstill" would be a remedy that fails.
TEST(Notices, ARejectionInAnEndlessMotionNamesTheOrderThatEndsIt) {
  ExecutorOptions options;
  options.receiver.executor = "roller";
  const auto reason = [&](const Tick& now, CommandKind order) {
    return refusal_text({permitted(now.state, order)}, now, options, order);
  };
  Tick now{.state = State::continuous_motion};
  EXPECT_EQ(reason(now, CommandKind::set_position),
            "the axis keeps a constant velocity: end the motion with `jounce order roller halt`");
  EXPECT_EQ(refusal_text({Cause::in_motion}, now, options, CommandKind::arm),
            reason(now, CommandKind::set_position))
      << "a table cannot wait for the end of a jog";
  EXPECT_EQ(reason(now, CommandKind::finish),
            "a motion at constant velocity has no end to finish: end it with `jounce order roller "
            "halt`");
  EXPECT_EQ(reason({.state = State::discrete_motion, .held = true}, CommandKind::home),
            "the axis is held on its path: end the motion with `jounce order roller halt`, or "
            "continue it with `resume`");
  EXPECT_THAT(reason({.state = State::discrete_motion, .override_ = 0}, CommandKind::home),
              HasSubstr("because the override is 0 %: end it with `jounce order roller halt`"));
  now.state = State::synchronized_motion;
  EXPECT_EQ(reason(now, CommandKind::home),
            "the axis follows its master: end the coupling with `jounce order roller halt`");
  options.cutter.emplace();
  EXPECT_EQ(
      reason(now, CommandKind::start_table),
      "the axis follows its master: end the coupling with `jounce order roller park`, or `halt` "
      "without a plan of cuts")
      << "halt would leave a knife in the web";
  options.cutter.reset();
  now.ratio = 2;
  EXPECT_EQ(reason(now, CommandKind::move_repetitive),
            "the axis follows its master by a gear: end the gear with `jounce order roller halt`");
  EXPECT_THAT(refusal_text({Cause::in_motion}, now, options, CommandKind::gear_in),
              ::testing::StartsWith("in_motion: "))
      << "its clutch ends";
  now.state = State::discrete_motion;
  EXPECT_THAT(reason(now, CommandKind::home), ::testing::StartsWith("in_motion: ")) << "it ends";
}

TEST(Notices, ATableOnALiveMasterNamesTheCutterOfTheAxisFirst) {
  ExecutorOptions options;
  options.receiver.executor = "knife";
  options.units.position = "deg";
  options.follow = {.what = Follow::What::master};
  options.cutter.emplace();
  const Refusal away{Cause::start_position, -0.0119, 0};
  EXPECT_EQ(refusal_text(away, {}, options, CommandKind::start, true),
            "the cam is at -0.0119 deg, the axis at 0 deg: send `jounce order knife start` for its "
            "cutter");
  EXPECT_THAT(refusal_text(away, {}, options, CommandKind::arm), HasSubstr("move --to"))
      << "the order for the cutter begins no table over time";
}

// The place of the cam at this instant is no remedy: after a move to it, the master is elsewhere.
TEST(Notices, ACamOnAMovingMasterNamesRemediesThatDoNotDependOnTheInstant) {
  ExecutorOptions options;
  options.receiver.executor = "pusher";
  options.units.position = "mm";
  const Refusal away{Cause::start_position, -1234.5678, -8765.4321};
  const auto live = [&](const Tick& now) {
    const std::string text = refusal_text(away, now, options, CommandKind::start, true);
    EXPECT_LT(text.size(), wire::reason_bytes) << text;
    EXPECT_THAT(text, Not(::testing::StartsWith("start_position")))
        << "--adopt-start has no effect";
    return text;
  };
  const Tick moving{.live_master = {0.25, 0.3}};
  EXPECT_EQ(live(moving),
            "the master moves: use start = \"ramp_in\" in [coupling], or --start-at where the cam "
            "rests at the place of the axis");
  EXPECT_EQ(refusal_text({Cause::start_position, 5, 0}, moving, options, CommandKind::start, true),
            "the cam is at 5 mm now, the axis at 0 mm, and the master moves: use start = "
            "\"ramp_in\" in [coupling], or --start-at where the cam rests at this place");
  Tick endless = moving;
  endless.state = State::synchronized_motion;
  EXPECT_EQ(live(endless),
            "the axis keeps moving: send `jounce order pusher halt`, then use start = \"ramp_in\" "
            "in [coupling]");
  const Tick resting{.live_master = {0.25, 0}};
  EXPECT_EQ(live(resting),
            "the cam is at -1234.5678 mm, the axis at -8765.43 mm: send `jounce order pusher move "
            "--to -1234.5678mm`, or use start = \"ramp_in\" in [coupling]");
  endless.live_master = resting.live_master;
  EXPECT_EQ(
      live(endless),
      "the axis keeps moving: send `jounce order pusher halt`, then `jounce order pusher move "
      "--to -1234.5678mm`, and repeat the command");
  const Refusal over_time{Cause::start_position, 1, 2, 0};
  EXPECT_THAT(refusal_text(over_time, moving, options, CommandKind::arm), HasSubstr("move --to"));
}

// `jounce stream` adds "Or start the executor with --adopt-start." to a text with the name of the cause.
TEST(Notices, ATableOverTimeNamesTheCauseOnlyIfTheExecutorDoesNotAdoptTheStart) {
  ExecutorOptions options;
  options.receiver.executor = "x";
  options.units.position = "mm";
  const Refusal away{Cause::start_position, 10, 3, 0};
  const auto text = [&](State state, bool adopts) {
    options.adopt_start = adopts;
    const Tick now{.state = state, .job = state == State::discrete_motion ? 1U : 0U};
    return refusal_text(away, now, options, CommandKind::arm);
  };
  EXPECT_EQ(
      text(State::continuous_motion, false),
      "start_position: The table begins at 10 mm, but the axis keeps moving: send `jounce order "
      "x halt`, then `jounce order x move --to 10mm`, and repeat the command.");
  EXPECT_EQ(text(State::continuous_motion, true),
            "the table begins at 10 mm, but the axis keeps moving: send `jounce order x halt`, and "
            "repeat the command");
  EXPECT_EQ(text(State::discrete_motion, true),
            "the table begins at 10 mm, but the present motion ends at 3 mm: repeat the command "
            "after it");
}

TEST(Notices, ReportAStartThatDidNotBegin) {
  const Refusal why{.cause = Cause::group_stopped};
  EXPECT_EQ(notices_of({}, {.tick = 10, .dropped = why}, "mm"),
            Notices{"the armed motion did not start at tick 10: " + text(why, "mm")});
}

}  // namespace
}  // namespace jounce::notices_test
