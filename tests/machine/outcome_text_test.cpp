// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/detail/outcome_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/command/cause.hpp"
#include "jounce/machine/detail/message_catalog.hpp"
#include "jounce/machine/detail/status_text.hpp"

namespace jounce::outcome_text_test {
namespace {

using Json = nlohmann::json;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

CallOutcome rejected() {
  return {StreamError::refused, wire::Refusal::axis, static_cast<std::int32_t>(Cause::not_enabled),
          "axis: not_enabled: the axis is disabled"};
}

TEST(OutcomeText, AddsTheRemedyOfTheAxis) {
  const std::string text = reason_text(rejected(), "feeder");
  EXPECT_THAT(text, StartsWith("not_enabled: the axis is disabled "));
  EXPECT_THAT(text, HasSubstr("jounce order feeder enable"));
  CallOutcome busy = rejected();
  busy.refusal = wire::Refusal::busy;
  EXPECT_EQ(reason_text(busy, "feeder"), busy.reason) << "only an axis has causes";
  busy.reason = "busy: the axis belongs to another session";
  EXPECT_THAT(reason_text(busy, "feeder"), EndsWith("`jounce stop feeder`."));
}

// The library names no options: a program in C++ has none.
TEST(OutcomeText, AddsTheOptionOfATimeLimit) {
  const CallOutcome late{StreamError::out_of_time, {}, 0, "not at its goal within 5000 ms"};
  EXPECT_EQ(error_text(late, "feeder"),
            "out_of_time: not at its goal within 5000 ms. Permit more time (--patience)");
}

TEST(OutcomeText, ARejectedShiftOfThePhaseHasARemedy) {
  CallOutcome fast = rejected();
  fast.cause = static_cast<std::int32_t>(Cause::velocity_limit);
  fast.reason =
      "velocity_limit: The motion exceeds the velocity limit of the axis: 560, limit 500.";
  for (const CommandKind kind : {CommandKind::phasing_absolute, CommandKind::phasing_relative})
    EXPECT_THAT(reason_text(fast, "feeder", kind), HasSubstr("the limit applies to the sum"));
}

TEST(OutcomeText, ARemedyFitsTheReason) {
  CallOutcome faulty = rejected();
  faulty.reason =
      "not_enabled: the axis is disabled because of a fault: following_error. It was too great.";
  EXPECT_THAT(reason_text(faulty, "feeder", {}, static_cast<int>(Cause::following_error)),
              HasSubstr("feeder reset` and `jounce order feeder enable`"));
  faulty.cause = static_cast<std::int32_t>(Cause::in_error);
  faulty.reason = "in_error: the axis has a fault: positive_switch. It reached the switch.";
  const auto of_fault = [&](Cause fault) {
    return reason_text(faulty, "feeder", {}, static_cast<int>(fault));
  };
  EXPECT_THAT(of_fault(Cause::positive_switch),
              EndsWith("Send `jounce order feeder reset`, then move the axis off the switch in the "
                       "negative direction."));
  EXPECT_THAT(of_fault(Cause::overspeed), EndsWith(" Then send `jounce order feeder reset`."));
  CallOutcome aborted = rejected();
  aborted.cause = static_cast<std::int32_t>(Cause::in_error);
  aborted.reason = "in_error: the axis has a fault: aborted.";
  const auto remedy = [&](CommandKind order) {
    return reason_text(aborted, "feeder", order, static_cast<int>(Cause::aborted));
  };
  EXPECT_THAT(remedy(CommandKind::change_velocity),
              EndsWith("Send `jounce order feeder reset`, then the motion again."));
  EXPECT_THAT(remedy(CommandKind::move_velocity), EndsWith("Send `jounce order feeder reset`."));
  CallOutcome alone = rejected();
  alone.cause = static_cast<std::int32_t>(Cause::no_master_input);
  alone.reason = "the axis has no live master: add [follow] to its spec";
  EXPECT_EQ(reason_text(alone, "feeder"), alone.reason) << "the executor wrote the remedy";
  CallOutcome homing = rejected();
  homing.cause = static_cast<std::int32_t>(Cause::home_not_found);
  homing.reason = "not homed: home_not_found: The search ended.";
  EXPECT_THAT(reason_text(homing, "feeder"), EndsWith("or choose another method."));
}

TEST(OutcomeText, ARemedyNamesTheOptionThatGaveTheNumber) {
  wire::Status before;
  before.units = {"s", "mm"};
  const auto text = [&](Cause cause, const std::string& number, const CommandWords& words) {
    CallOutcome no = rejected();
    no.cause = static_cast<std::int32_t>(cause);
    no.reason = std::string("axis: ") + name(cause) + ": " + number + ".";
    return reason_text(no, words, before, "feeder");
  };
  EXPECT_THAT(
      text(Cause::no_reserve, "No reserve: deceleration 20 mm/s^2, limit 20 mm/s^2",
           {.what = "move", .options = {{"on-top", "3"}}}),
      EndsWith("Begin the present motion with a lower --deceleration, or wait for its end."));
  EXPECT_THAT(text(Cause::no_reserve, "acceleration or deceleration 20 mm/s^2, limit 20 mm/s^2",
                   {.what = "move", .options = {{"on-top", "3"}}}),
              HasSubstr("--velocity, --acceleration, --deceleration and --jerk"));
  EXPECT_THAT(text(Cause::velocity_limit, "9000 mm/s, limit 500 mm/s",
                   {.what = "home", .options = {{"search-velocity", "9m/s"}}}),
              EndsWith("Give a lower --search-velocity."));
  EXPECT_THAT(
      text(Cause::velocity_limit, "900 mm/s, limit 500 mm/s",
           {.what = "home", .options = {{"search-velocity", "20"}, {"index-velocity", "900"}}}),
      EndsWith("Give a lower --index-velocity."));
  EXPECT_THAT(text(Cause::velocity_limit, "900 mm/s, limit 500 mm/s", {.what = "home"}),
              HasSubstr("search_velocity and index_velocity in [homing]"));
  EXPECT_THAT(text(Cause::acceleration_limit, "1e9 mm/s^2, limit 10000 mm/s^2",
                   {.what = "move",
                    .options = {{"to", "5"}, {"acceleration", "10"}, {"deceleration", "1e9"}}}),
              EndsWith("Give a lower --deceleration."));
  EXPECT_THAT(text(Cause::acceleration_limit, "1e9 mm/s^2, limit 10000 mm/s^2",
                   {.what = "gear-in", .value = "1:1", .options = {{"clutch", "1e9"}}}),
              HasSubstr("--clutch"))
      << "a distance is no acceleration";
  EXPECT_THAT(
      text(Cause::velocity_limit, "900 mm/s, limit 500 mm/s", {.what = "jog", .value = "900"}),
      EndsWith("Give a lower velocity."));
}

TEST(OutcomeText, ARejectedPathHasTheNameOfItsFile) {
  for (const std::string sender : {"", "axis: "})
    EXPECT_EQ(with_file(sender + "line 23: x.position = 399 mm: exceeds", "part.toml"),
              "part.toml:23: x.position = 399 mm: exceeds");
  for (const char* other : {"in_motion: The axis is moving.", "line: x", "line 12", ""})
    EXPECT_EQ(with_file(other, "part.toml"), other);
}

TEST(OutcomeText, AGearInPositionNamesTheBeginOfItsEngagement) {
  wire::Status status;
  status.units = {"mm", "deg"};
  EXPECT_EQ(accepted_text({.what = "gear-in-pos",
                           .options = {{"master-sync", "1cm"}, {"start-distance", "200"}}},
                          status, "knife"),
            "gear-in-pos accepted: the slave waits until the master passes -190 mm; no jerk limit "
            "applies behind the master: the jerk is that of the master times the ratio");
  EXPECT_THAT(accepted_text({.what = "combine", .value = "1:1"}, status, "knife"),
              HasSubstr("no jerk limit applies behind the master"));
  status.gear = wire::GearState::engaging;
  status.progress = wire::Progress::waiting;
  status.ratio = 2;
  EXPECT_EQ(gear_text(status), "waiting for its master, ratio 2");
  status.progress = wire::Progress::engaging;
  EXPECT_EQ(gear_text(status), "engaging, ratio 2");
}

TEST(OutcomeText, AnAcceptedOrderNamesItsEffect) {
  wire::Status status;
  EXPECT_EQ(accepted_text({.what = "override"}, status, "knife"), "override accepted");
  EXPECT_EQ(accepted_text({.what = "disable"}, status, "knife"), "disable accepted");
  status.state = State::continuous_motion;
  EXPECT_THAT(accepted_text({.what = "disable"}, status, "knife"),
              HasSubstr("send `jounce order knife reset` and `jounce order knife enable`"));
  EXPECT_EQ(accepted_text({.what = "disable"}, status, "plotter", "the motion is dropped"),
            "disable accepted; the motion is dropped");
  status.state = State::disabled;
  EXPECT_EQ(accepted_text({.what = "set-coordinate-transform", .options = {{"zyz", ""}}}, status,
                          "plotter"),
            "set-coordinate-transform accepted: without values, it removes the frame");
  EXPECT_EQ(accepted_text({.what = "set-coordinate-transform", .options = {{"offset", "1"}}},
                          status, "plotter"),
            "set-coordinate-transform accepted");
  EXPECT_EQ(accepted_text({.what = "cut", .options = {{"length", "300"}}}, status, "knife"),
            "cut accepted");
  EXPECT_EQ(accepted_text({.what = "cut", .options = {{"position", "900"}}}, status, "knife"),
            "cut accepted; it replaces a cut on demand that still waits");
  status.gear = wire::GearState::in_cam;
  EXPECT_EQ(accepted_text({.what = "override"}, status, "knife"),
            "override accepted; no effect while the axis follows its master");
  status.homed = true;
  status.units.position = "mm";
  status.slave_position = 277;
  EXPECT_THAT(accepted_text({.what = "set-position"}, status, "slide"),
              HasSubstr("was 277 mm before"));
}

TEST(OutcomeText, IsWholeAsJson) {
  const Json command = Json::parse(command_json(rejected()));
  EXPECT_EQ(command["ok"], false);
  EXPECT_EQ(command["error"], "refused");
  EXPECT_EQ(command["cause"], static_cast<int>(Cause::not_enabled));
  EXPECT_FALSE(Json::parse(outcome_json(rejected())).contains("cause"));
}

TEST(OutcomeText, NamesTheLastStateOfAStream) {
  StreamOutcome outcome;
  outcome.downloaded = true;
  outcome.progress.chunks = 6;
  EXPECT_EQ(stream_text(outcome, "feeder", false),
            "6 chunks arrived at feeder, 0 sent again; downloaded");
  outcome.progress.chunks = 1;
  EXPECT_EQ(stream_text(outcome, "feeder", false),
            "1 chunk arrived at feeder, 0 sent again; downloaded");
  outcome.armed = true;
  EXPECT_THAT(stream_text(outcome, "feeder", false), EndsWith("; armed"));
  outcome.remark = "look here";
  EXPECT_THAT(stream_text(outcome, "feeder", false), EndsWith("; armed\nnote: look here"));
  outcome.remark = "";
  outcome.started = true;
  EXPECT_THAT(stream_text(outcome, "feeder", false), EndsWith("; started"));
  EXPECT_THAT(stream_text(outcome, "feeder", true), EndsWith("; accepted, waits for its start"));
  outcome.swaps = 2;
  EXPECT_THAT(stream_text(outcome, "feeder", true), EndsWith("; started, 2 swaps"));
  EXPECT_EQ(Json::parse(stream_json(outcome))["swaps"], 2);
}

TEST(OutcomeText, NamesTheEndOfRows) {
  RowOutcome outcome;
  outcome.progress.sent = 10;
  outcome.progress.played = 7;
  EXPECT_EQ(rows_text(outcome, "feeder"),
            "7 of 10 rows played at feeder, 0 underruns, 0 messages sent again; stopped");
  EXPECT_EQ(Json::parse(rows_json(outcome))["played"], 7);
}

TEST(OutcomeText, ListsEachAxisOfAGroup) {
  StreamOutcome y;
  y.error = StreamError::stopped;
  y.stopped = true;
  const Json all = Json::parse(group_json({"x", "y"}, {StreamOutcome{}, y}));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0]["axis"], "x");
  EXPECT_EQ(all[0]["ok"], true);
  EXPECT_EQ(all[1]["error"], "stopped");
  EXPECT_EQ(all[1]["stopped"], true);
}

TEST(MessageCatalog, HasEachCauseOnceAndNoEmptyMeaning) {
  const auto all = all_messages();
  EXPECT_EQ(messages_named(all, "not_enabled").size(), 1U);
  for (const Message& one : all) {
    EXPECT_FALSE(one.group.empty());
    EXPECT_FALSE(one.meaning.empty()) << one.name << one.code;
  }
}

TEST(OutcomeText, NamesTheEndOfAnAxisOfAGroup) {
  StreamOutcome x;
  EXPECT_EQ(group_text(x, true), "finished");
  EXPECT_EQ(group_text(x, false), "started");
  x.stopped = true;
  EXPECT_EQ(group_text(x, false), "stopped");
}

}  // namespace
}  // namespace jounce::outcome_text_test
