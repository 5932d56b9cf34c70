// SPDX-License-Identifier: Apache-2.0
#include "executor/src/server/last_start.hpp"

#include <gtest/gtest.h>

namespace jounce::last_start_test {
namespace {

using wire::StartOutcome;

constexpr StartRequested request{
    .session = 3, .command = 12, .when = StartAt::master_position, .position = 340};
const Units units{"mm", "deg"};

/// The armed movement 7, with an accepted start of the session 3 and the command 12.
LastStart accepted() {
  LastStart start;
  start.request(request, 7);
  start.answer(3, 12, std::nullopt);
  return start;
}

const Tick armed{.armed = 7};

TEST(LastStart, WaitsFromItsAnswerToItsBegin) {
  LastStart start;
  EXPECT_EQ(start.outcome(), StartOutcome::none);
  start.request(request, 7);
  start.follow({}, {.job = 7});
  EXPECT_EQ(start.outcome(), StartOutcome::none) << "not answered yet";
  start.answer(3, 11, std::nullopt);
  start.answer(4, 12, std::nullopt);
  EXPECT_EQ(start.outcome(), StartOutcome::none) << "the answers to others";
  start.answer(3, 12, std::nullopt);
  EXPECT_EQ(start.outcome(), StartOutcome::waiting);
  start.follow(armed, armed);
  EXPECT_EQ(start.outcome(), StartOutcome::waiting);
  start.follow(armed, {.job = 7});
  EXPECT_EQ(start.outcome(), StartOutcome::begun);
  start.follow({.job = 7}, {.fault = Cause::stalled});
  EXPECT_EQ(start.outcome(), StartOutcome::begun) << "later ticks do not change the outcome";
}

TEST(LastStart, ARejectedOneHasNoOutcome) {
  LastStart start;
  start.request(request, 7);
  start.answer(3, 12, Refusal{.cause = Cause::too_late});
  EXPECT_EQ(start.outcome(), StartOutcome::none);
}

TEST(LastStart, AMovementOfOneTickHasBegunToo) {
  LastStart start = accepted();
  start.follow(armed, {.finished = 1});
  EXPECT_EQ(start.outcome(), StartOutcome::begun);
}

TEST(LastStart, IsDroppedForTheReasonOfTheTick) {
  const auto cause = [](const Tick& tick) {
    LastStart start = accepted();
    start.follow(armed, tick);
    EXPECT_EQ(start.outcome(), StartOutcome::dropped);
    wire::Status status;
    start.report(status, 3, units, armed);
    EXPECT_FALSE(status.start_reason.empty());
    return static_cast<Cause>(status.start_cause);
  };
  EXPECT_EQ(cause({.dropped = Refusal{.cause = Cause::group_stopped}}), Cause::group_stopped);
  EXPECT_EQ(cause({.fault = Cause::drive_fault}), Cause::drive_fault);
  EXPECT_EQ(cause({}), Cause::stopped);
}

TEST(LastStart, ItsOutcomeIsReportedToItsSessionAloneButAllSeeWhatItWaitsFor) {
  LastStart start = accepted();
  wire::Status own, other;
  start.report(own, 3, units, armed);
  start.report(other, 4, units, armed);
  EXPECT_EQ(own.start, StartOutcome::waiting);
  EXPECT_EQ(own.start_command, 12);
  EXPECT_EQ(other.start, StartOutcome::waiting);
  EXPECT_EQ(other.start_command, wire::Status{}.start_command);
  EXPECT_EQ(other.start_reason, "until its master passes 340 " + units.x);
  start.follow(armed, {.dropped = Refusal{.cause = Cause::group_stopped}});
  wire::Status later;
  start.report(later, 4, units, {});
  EXPECT_EQ(later.start, StartOutcome::none);
}

TEST(LastStart, TheMasterComesOrHasPassed) {
  const auto place = [](double at, double velocity) {
    return place_of_master({.live_master = {at, velocity}}, 340, "mm");
  };
  EXPECT_EQ(place(2134, 600), "its master is at 2134 mm, and moves away from 340 mm");
  EXPECT_EQ(place(2134, -600), "its master is at 2134 mm, and moves towards 340 mm");
  EXPECT_EQ(place(100, 600), "its master is at 100 mm, and moves towards 340 mm");
  EXPECT_EQ(place(100, 0), "its master is at 100 mm, and rests");
  EXPECT_EQ(place_of_master({}, 340, "mm"), "its master sends no position");
}

}  // namespace
}  // namespace jounce::last_start_test
