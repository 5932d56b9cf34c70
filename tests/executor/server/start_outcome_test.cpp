// SPDX-License-Identifier: Apache-2.0
// What becomes of a start that is accepted for later, and of several axes that start as one: from the
// streamer through an executor to the axis, on a virtual clock.

#include <cstdlib>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/client.hpp"
#include "jounce/stream/sender/stream_group.hpp"

#include "axis/tables.hpp"
#include "executor/site.hpp"

namespace jounce::start_outcome_test {
namespace {

using namespace test;
using namespace std::chrono_literals;
using ::testing::AllOf;
using ::testing::HasSubstr;

const Units in_mm{.x = "s", .position = "mm"};

std::vector<ExecutorOptions> line_and_slave(double modulo = 0) {
  std::vector<ExecutorOptions> axes{axis_named("line", limits(1e4, 1e6)),
                                    axis_named("slave", limits(1e4, 1e6))};
  axes[1].follow = {.what = Follow::What::setpoint, .index = 0};
  axes[1].axis.modulo = modulo;
  return axes;
}

/// A slave that is to follow this cam, from 460 on; the line jogs meanwhile.
StreamPlan at_460(const TablePtr& cam, const CouplingSpec& coupling = {}) {
  return {.executor = "slave",
          .tables = {{*cam, {"mm", "mm"}}},
          .mode = wire::ArmMode::follow_input,
          .coupling = coupling,
          .when = StartAt::master_position,
          .position = 460,
          .await = true};
}

StreamPlan jog() {
  return {.executor = "line", .tables = {{*constant_master(2000, 200), {"s", "mm"}}}};
}

TEST(StartOutcome, AStartAtAMasterPositionIsAwaitedAndJudgedThere) {
  auto axes = line_and_slave();
  axes[1].axis.position = pmc600_cam()->jet(100)[0];
  Site site(axes);
  ASSERT_TRUE(site.stream(jog()).ok());
  const StreamOutcome outcome = site.stream(at_460(pmc600_cam()));
  EXPECT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_TRUE(outcome.started);
  EXPECT_GE(site.last(0).position, 460) << "not before";
  EXPECT_LT(site.last(0).position, 480) << "and not long after";
  site.advance(100ms);
  EXPECT_NEAR(site.last(1).position, pmc600_cam()->jet(site.last(0).position)[0], 1e-9);
}

TEST(StartOutcome, ADroppedStartIsReportedWithItsNumbers) {
  const CouplingSpec negative{
      .start = StartMode::ramp_in_neg, .velocity_diff = 150, .acceleration = 5000};
  for (const CouplingSpec& coupling : {CouplingSpec{}, negative}) {
    Site site(line_and_slave());
    ASSERT_TRUE(site.stream(jog()).ok());
    const StreamOutcome outcome = site.stream(at_460(pmc600_cam(), coupling));
    EXPECT_EQ(outcome.error, StreamError::dropped);
    EXPECT_FALSE(outcome.started);
    if (coupling.start == StartMode::absolute) {
      EXPECT_EQ(outcome.cause, static_cast<int>(Cause::start_position));
      EXPECT_THAT(outcome.reason,
                  AllOf(HasSubstr("begins at 125"), HasSubstr("the axis would start it at 0")));
    } else {
      EXPECT_EQ(outcome.cause, static_cast<int>(Cause::would_reverse));
      EXPECT_THAT(outcome.reason, HasSubstr("would_reverse"));
    }
    EXPECT_EQ(site.last(1).state, State::standstill);
  }
}

/// A slave that is to follow this cam from now on.
StreamPlan at_once(const TablePtr& cam, const CouplingSpec& coupling = {}) {
  StreamPlan plan = at_460(cam, coupling);
  plan.when = StartAt::tick;
  plan.position = 0;
  return plan;
}

/// A cam that rises by 10 and falls again in each `period` of its master.
TablePtr cam_from(double start, double period) {
  return table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap,
               {{0, period / 2, period}, {start, start + 10, start}, {0, 0, 0}, {0, 0, 0}});
}

CallOutcome order(Site& site, const std::string& axis, const ClientCommand& what) {
  Client client(site.link, axis, {}, site.clock);
  const CallOutcome outcome = client.command(what);
  EXPECT_TRUE(client.release().ok());
  return outcome;
}

// The two tests follow the remedies of the rejection word for word.
TEST(StartOutcome, ACamElsewhereThanTheAxisBeginsAfterTheMoveOfItsRejection) {
  Site site(line_and_slave());
  const TablePtr cam = cam_from(3, 1000);
  const StreamOutcome rejected = site.stream(at_once(cam));
  ASSERT_EQ(rejected.cause, static_cast<int>(Cause::start_position)) << rejected.reason;
  EXPECT_THAT(rejected.reason, HasSubstr("send `jounce order slave move --to 3`"));
  ASSERT_TRUE(order(site, "slave", command::MoveAbsolute{.position = 3}).ok());
  site.advance(2s);
  const StreamOutcome begun = site.stream(at_once(cam));
  EXPECT_TRUE(begun.ok()) << begun.reason;
}

TEST(StartOutcome, ACamOnAMovingMasterBeginsWithTheRampOrTheStartOfItsRejection) {
  const CouplingSpec ramp{.start = StartMode::ramp_in, .velocity_diff = 150, .acceleration = 5000};
  const TablePtr cam = cam_from(0, 400);
  StreamPlan ahead = at_460(cam);
  ahead.position = 800;
  for (const StreamPlan& remedy : {at_once(cam, ramp), ahead}) {
    Site site(line_and_slave());
    ASSERT_TRUE(site.stream(jog()).ok());
    site.advance(520ms);
    const StreamOutcome rejected = site.stream(at_once(cam));
    ASSERT_EQ(rejected.cause, static_cast<int>(Cause::start_position)) << rejected.reason;
    EXPECT_THAT(rejected.reason,
                HasSubstr("the master moves: use start = \"ramp_in\" in "
                          "[coupling], or --start-at where the cam rests at this"));
    EXPECT_NE(site.last(0).velocity, 0);
    const StreamOutcome begun = site.stream(remedy);
    EXPECT_TRUE(begun.ok()) << begun.reason;
    EXPECT_TRUE(begun.started);
  }
}

TEST(StartOutcome, AStopWhileItWaitsIsNoBeginning) {
  Site site(line_and_slave());
  StreamOptions options;
  options.total = 20s;
  const Nanos stops = site.clock() + 500ms;
  options.cancelled = [&] { return site.clock() > stops; };
  const StreamOutcome outcome =
      stream_tables(site.link, at_460(pmc600_cam()), options, site.clock, ++site.sessions);
  EXPECT_FALSE(outcome.started);
  EXPECT_TRUE(outcome.stopped);
  EXPECT_FALSE(site.last(1).waiting);
}

/// A function of the caller that throws must not leave the start waiting, nor the axis moving.
TEST(StartOutcome, AnExceptionOfTheCallerStopsTheAxisFirst) {
  for (const bool in_progress : {false, true}) {
    Site site(line_and_slave());
    StreamOptions options;
    options.total = 20s;
    const Nanos throws = site.clock() + 500ms;
    int thrown = 0;
    const auto maybe = [&] {
      if (site.clock() <= throws) return false;
      ++thrown;
      throw std::runtime_error("of the caller");
    };
    if (in_progress)
      options.progress = [&](const StreamProgress& /*now*/) { (void)maybe(); };
    else
      options.cancelled = maybe;
    EXPECT_THROW(static_cast<void>(stream_tables(site.link, at_460(pmc600_cam()), options,
                                                 site.clock, ++site.sessions)),
                 std::runtime_error);
    EXPECT_EQ(thrown, 1) << "no function is called again";
    EXPECT_FALSE(site.last(1).waiting);
  }
}

TEST(StartOutcome, AStopByAnotherOperatorEndsTheStreamAndTheStart) {
  Site site(line_and_slave());
  MemoryTransport other(site.network);
  StreamOptions options;
  options.total = 20s;
  const Nanos stops = site.clock() + 500ms;
  bool stopped = false;
  options.cancelled = [&] {
    if (!stopped && site.clock() > stops)
      stopped = operator_stop(other, "slave", wire::StopMode::stop, 1s, {}, site.clock);
    return false;
  };
  const StreamOutcome outcome =
      stream_tables(site.link, at_460(pmc600_cam()), options, site.clock, ++site.sessions);
  EXPECT_TRUE(stopped);
  EXPECT_EQ(outcome.error, StreamError::stopped);
  EXPECT_EQ(outcome.reason, "another operator stopped the axis");
  EXPECT_FALSE(site.last(1).waiting) << "nothing begins later";
}

TEST(StartOutcome, TheAnswerAndTheStatusNameTheMasterAndThePositionThatItMustPass) {
  Site site(line_and_slave());
  ASSERT_TRUE(site.stream(jog()).ok());
  while (site.last(0).position < 500) site.advance(100ms);
  StreamPlan plan = at_460(pmc600_cam());
  plan.await = false;
  const StreamOutcome outcome = site.stream(plan);
  ASSERT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_THAT(outcome.progress.note,
              AllOf(HasSubstr("its master is at "), HasSubstr("and moves away from 460")));
  const wire::Status status = site.dispatcher.server(1).status();
  EXPECT_EQ(status.start, wire::StartOutcome::waiting);
  EXPECT_THAT(status.start_reason, HasSubstr("until its master passes 460"));
  EXPECT_EQ(status.master_position, site.last(0).position);
  site.advance(100ms);
  EXPECT_EQ(site.dispatcher.server(1).status().master_position, site.last(0).position)
      << "the live master";
}

TEST(StartOutcome, AMotionBesideACommandForALaterTickIsAnsweredWithThisTick) {
  Site site({axis_named("feeder", limits(1000, 1e4, 1e6), {"", "mm"})});
  Client client(site.link, "feeder", {}, site.clock);
  const std::int64_t tick = site.last().tick + 5000;
  const CallOutcome later = client.command(command::MoveAbsolute{.position = 100}, tick);
  EXPECT_TRUE(later.ok() && later.reason.empty()) << later.reason;
  site.advance(100ms);
  const CallOutcome now = client.command(command::MoveAbsolute{.position = 20});
  EXPECT_TRUE(now.ok());
  EXPECT_THAT(now.reason,
              HasSubstr("does not wait for the command of tick " + std::to_string(tick)));
  while (site.last().tick <= tick) {
    ASSERT_TRUE(client.beat().ok());
    site.advance(100ms);
  }
  EXPECT_EQ(client.command(command::MoveAbsolute{.position = 30}).reason, "");
}

TEST(StartOutcome, AnExpiredPatienceIsReportedAndLeavesTheStartWaiting) {
  Site site(line_and_slave());
  StreamOptions options;
  options.total = 1s;
  const StreamOutcome outcome =
      stream_tables(site.link, at_460(pmc600_cam()), options, site.clock, ++site.sessions);
  EXPECT_EQ(outcome.error, StreamError::out_of_time);
  EXPECT_THAT(
      outcome.reason,
      HasSubstr("within 1000 ms; the accepted start still waits in the axis: a stop cancels it"));
  site.advance(100ms);
  EXPECT_TRUE(site.last(1).waiting);
}

// On a modulo axis two turns on is the same place.
TEST(StartOutcome, AnAbsoluteCamIsComparedModulo) {
  for (const double turn : {0.0, 500.0}) {
    auto axes = line_and_slave(turn);
    axes[1].axis.position = 1000;
    Site site(axes);
    StreamPlan plan = at_460(pmc600_cam());
    plan.when = StartAt::tick;
    plan.position = 0;
    plan.position = 0;
    const StreamOutcome outcome = site.stream(plan);
    EXPECT_EQ(outcome.started, turn != 0) << outcome.reason;
  }
}

// ---- several axes --------------------------------------------------------------------------------

std::vector<ExecutorOptions> x_and_y() {
  return {axis_named("x", limits(1000, 1e5), {"", "mm"}),
          axis_named("y", limits(1000, 1e5), {"", "mm"})};
}

std::vector<StreamPlan> both(const TablePtr& x, const TablePtr& y) {
  return {{.executor = "x", .tables = {{*x, in_mm}}}, {.executor = "y", .tables = {{*y, in_mm}}}};
}

TEST(Group, StartsInOneTickAndEndsWithTheLast) {
  Site site(x_and_y());
  std::int64_t began[2] = {-1, -1};
  site.after = [&] {
    for (const std::size_t i : {0u, 1u})
      if (began[i] < 0 && site.last(i).job != 0) began[i] = site.last(i).tick;
  };
  const auto outcomes = stream_group(
      site.link, both(trapezoid_table(50, 100, 1000, 1000), trapezoid_table(80, 100, 1000, 1000)),
      {}, {}, site.clock);
  for (const StreamOutcome& outcome : outcomes) EXPECT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_GT(began[0], 0);
  EXPECT_EQ(began[0], began[1]);
  EXPECT_EQ(site.last(0).position, 50);
  EXPECT_EQ(site.last(1).position, 80);
  EXPECT_FALSE(site.dispatcher.owned());
}

TEST(Group, WhereOneRejectsNoneStartsAndAllReasonsAreThere) {
  Site site(x_and_y());
  const TablePtr good = trapezoid_table(50, 100, 1000, 1000);
  const TablePtr fast = trapezoid_table(50, 2000, 1e5, 1e5);
  const TablePtr elsewhere = there_and_back(10, 5, 1, Extrapolation::hold);
  auto outcomes = stream_group(site.link, both(good, fast), {}, {}, site.clock);
  EXPECT_EQ(outcomes[0].error, StreamError::stopped);
  EXPECT_THAT(outcomes[0].reason, HasSubstr("y rejected"));
  EXPECT_EQ(outcomes[1].error, StreamError::refused);
  EXPECT_THAT(outcomes[1].reason, HasSubstr("velocity_limit"));
  outcomes = stream_group(site.link, both(elsewhere, fast), {}, {}, site.clock);
  EXPECT_THAT(outcomes[0].reason, HasSubstr("start_position"));
  EXPECT_THAT(outcomes[1].reason, HasSubstr("velocity_limit"));
  site.advance(1s);
  for (const std::size_t i : {0u, 1u}) {
    EXPECT_EQ(site.last(i).position, 0);
    EXPECT_EQ(site.last(i).finished, 0U);
    EXPECT_EQ(site.last(i).armed, 0U);
  }
}

TEST(Group, AStopOfOneStopsTheOther) {
  Site site(x_and_y());
  MemoryTransport operators_link{site.network};
  bool stopped = false;
  site.after = [&] {
    if (stopped || site.last(0).position < 20) return;
    stopped = true;
    wire::Stop stop;
    stop.command = 77;
    send_message(operators_link, {"x", 0, stop});
  };
  const TablePtr slow = trapezoid_table(200, 50, 1000, 1000);
  const auto outcomes = stream_group(site.link, both(slow, slow), {}, {}, site.clock);
  EXPECT_TRUE(stopped);
  EXPECT_EQ(outcomes[0].error, StreamError::stopped) << outcomes[0].reason;
  EXPECT_EQ(outcomes[1].error, StreamError::stopped) << outcomes[1].reason;
  site.advance(500ms);
  for (const std::size_t i : {0u, 1u}) {
    EXPECT_EQ(site.last(i).state, State::standstill);
    EXPECT_LT(site.last(i).position, 60) << "of 200";
  }
}

// Nothing watches any more: it is the executor that stops the other one.
TEST(Group, TheExecutorStopsTheOthersItself) {
  for (const char* const first : {"x", "y"})
    for (const auto mode : {wire::StopMode::stop, wire::StopMode::abort}) {
      Site site(x_and_y());
      const TablePtr slow = trapezoid_table(200, 50, 1000, 1000);
      for (const auto& outcome :
           stream_group(site.link, both(slow, slow), {.watch = false}, {}, site.clock))
        ASSERT_TRUE(outcome.ok()) << outcome.reason;
      std::int64_t ended[2] = {0, 0};
      site.after = [&] {
        for (const std::size_t i : {0u, 1u})
          if (ended[i] == 0 && site.last(i).state != State::discrete_motion)
            ended[i] = site.last(i).tick;
      };
      ASSERT_TRUE(operator_stop(site.link, first, mode, 2s, {}, site.clock));
      site.advance(500ms);
      EXPECT_GT(ended[0], 0);
      EXPECT_LE(std::abs(ended[0] - ended[1]), 1);
      const std::size_t other = first[0] == 'x' ? 1 : 0;
      EXPECT_EQ(site.last(other).state, State::standstill);
      EXPECT_EQ(site.last(other).reason, Cause::group_stopped);
      EXPECT_EQ(site.last(other).stopped, 1U);
    }
}

TEST(Group, ATickThatIsOverStartsNone) {
  Site site(x_and_y());
  site.advance(1s);
  const TablePtr table = trapezoid_table(50, 100, 1000, 1000);
  const auto outcomes = stream_group(site.link, both(table, table), {.tick = 5}, {}, site.clock);
  EXPECT_FALSE(outcomes[0].ok());
  EXPECT_FALSE(outcomes[1].ok());
  site.advance(1s);
  EXPECT_EQ(site.last(0).position, 0);
  EXPECT_EQ(site.last(1).position, 0);
}

TEST(Group, RejectsAnInvalidGroup) {
  MemoryNetwork network;
  MemoryTransport link(network);
  const TablePtr table = trapezoid_table(50, 100, 1000, 1000);
  auto plans = both(table, table);
  plans[1].executor = "x";
  EXPECT_THROW(stream_group(link, plans, {}), InputError);
  plans.pop_back();
  EXPECT_THROW(stream_group(link, plans, {}), InputError);
}

}  // namespace
}  // namespace jounce::start_outcome_test
