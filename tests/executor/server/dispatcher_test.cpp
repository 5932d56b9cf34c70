// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/detail/dispatcher.hpp"

#include <charconv>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/stream/detail/sender.hpp"
#include "jounce/stream/sender/client.hpp"

#include "axis/tables.hpp"
#include "executor/site.hpp"
#include "stream/src/transport/lossy_transport.hpp"

namespace jounce::dispatcher_test {
namespace {

using namespace test;
using namespace std::chrono_literals;
using ::testing::HasSubstr;

const Units over_time{.x = "s", .position = "mm"};
const Units over_master{.x = "deg", .position = "mm"};
const Units of_master{.x = "s", .position = "deg"};

ExecutorOptions feeder() {
  return axis_named("feeder", limits(1000, 1e5), over_master);
}

TEST(Dispatcher, StreamsArmsStartsAndPlaysATable) {
  Site site({feeder()});
  const StreamOutcome outcome = site.play(*trapezoid_table(50, 100, 1000, 1000));
  EXPECT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_TRUE(outcome.started);
  EXPECT_TRUE(site.dispatcher.moving());
  site.advance(1s);
  EXPECT_FALSE(site.dispatcher.moving());
  EXPECT_EQ(site.last().position, 50);
  EXPECT_EQ(site.last().finished, 1U);
  EXPECT_FALSE(site.dispatcher.owned());
}

/// A log as columns of numbers: local tick, master, master velocity, position, velocity.
struct Line {
  double time, master, position, velocity;
  std::string state;
};

std::vector<Line> moving_lines(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string text;
  std::getline(file, text);
  std::vector<Line> lines;
  while (std::getline(file, text)) {
    std::vector<std::string> cells;
    for (std::size_t at = 0, comma = 0; comma != std::string::npos; at = comma + 1) {
      comma = text.find(',', at);
      cells.push_back(text.substr(at, comma - at));
    }
    const auto number = [&](std::size_t i) {
      double value = NAN;
      std::from_chars(cells[i].data(), cells[i].data() + cells[i].size(), value);
      return value;
    };
    if (cells.at(8) != "0") lines.push_back({number(1), number(3), number(5), number(6), cells[2]});
  }
  return lines;
}

// An axis that does not stand at the cam's first point, by a coupling that came over the wire.
TEST(Dispatcher, CouplesACamToAnAxisThatStandsElsewhere) {
  ExecutorOptions options = feeder();
  options.axis.position = -12;
  options.axis.limits = limits(800, 20000);
  Site site({options});
  StreamPlan plan{
      .executor = {},
      .tables = {{*pmc600_cam(), over_master}, {*constant_master(1080, 200), of_master}},
      .mode = wire::ArmMode::follow_table};
  const StreamOutcome absolute = site.stream(plan);
  EXPECT_EQ(absolute.cause, static_cast<int>(Cause::start_position)) << "it would jump";
  plan.coupling = {
      .slave_offset = 7, .start = StartMode::ramp_in, .velocity_diff = 50, .acceleration = 1000};
  const StreamOutcome ramped = site.stream(plan);
  ASSERT_TRUE(ramped.ok()) << ramped.reason;
  double last = -12;
  for (int ms = 0; ms < 6000; ++ms) {
    site.advance(1ms);
    EXPECT_LE(std::abs(site.last().position - last), 0.8 + 1e-9) << ms;
    last = site.last().position;
  }
  EXPECT_EQ(site.last().finished, 1U);
  EXPECT_NEAR(last, 7, 1e-9);

  plan.coupling.start = StartMode::ramp_in_neg;
  plan.coupling.slave_offset = 20;
  EXPECT_EQ(site.stream(plan).cause, static_cast<int>(Cause::would_reverse));
}

// PMC600 manual 6.2, example 4.3, from the streamer's tables to the file that the executor leaves.
TEST(Dispatcher, Example43ReachesTheLogBitForBit) {
  ExecutorOptions options = feeder();
  options.axis.limits = limits(700, 7000);
  options.log = std::filesystem::temp_directory_path() /
                ("jounce_dispatcher_" + std::to_string(getpid()) + ".csv");
  const TablePtr cam = pmc600_cam();
  const TablePtr master = constant_master(1080, 200);
  {
    Site site({options});
    const StreamOutcome outcome =
        site.stream({.executor = {},
                     .tables = {{*cam, over_master}, {*master, of_master}},
                     .mode = wire::ArmMode::follow_table});
    ASSERT_TRUE(outcome.ok()) << outcome.reason;
    site.advance(6s);
    EXPECT_EQ(site.last().finished, 1U);
    site.dispatcher.close();
  }
  const auto lines = moving_lines(*options.log);
  std::filesystem::remove(*options.log);
  ASSERT_EQ(lines.size(), 5400U);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const double t = static_cast<double>(k * 1'000'000) / 1e9;
    const Jet m = master->jet(t);
    ASSERT_EQ(lines[k].master, m[0]);
    ASSERT_EQ(lines[k].position, cam->jet(m[0])[0]);
    ASSERT_EQ(lines[k].velocity, cam->jet(m[0])[1] * m[1]);
    ASSERT_EQ(lines[k].state, "synchronized_motion");
  }
}

TEST(Dispatcher, ATableThatBreaksALimitIsRejectedWithItsNumbers) {
  Site site({feeder()});
  const StreamOutcome outcome = site.play(*trapezoid_table(5000, 1500, 5000, 5000));
  EXPECT_EQ(outcome.error, StreamError::refused);
  EXPECT_EQ(outcome.refusal, wire::Refusal::axis);
  EXPECT_EQ(outcome.cause, static_cast<int>(Cause::velocity_limit));
  EXPECT_THAT(outcome.reason, HasSubstr("1500"));
  EXPECT_THAT(outcome.reason, HasSubstr("1000"));
  site.advance(1s);
  EXPECT_EQ(site.last().position, 0);
  EXPECT_EQ(site.last().state, State::standstill);
}

TEST(Dispatcher, AMasterThatIsSentMayHaveAnotherUnitThanTheLiveOne) {
  Site site({feeder()});
  const StreamOutcome outcome = site.stream(
      {.executor = {},
       .tables = {{*pmc600_cam(), {.x = "rad", .position = "mm"}},
                  {*trapezoid_table(50, 100, 1000, 1000), {.x = "s", .position = "rad"}}},
       .mode = wire::ArmMode::follow_table});
  EXPECT_TRUE(outcome.ok()) << outcome.reason;
  site.advance(1s);
  EXPECT_GT(std::abs(site.last().position), 1);
}

TEST(Dispatcher, OtherUnitsAndAMasterInputAreRejected) {
  Site site({feeder()});
  const TablePtr move = trapezoid_table(50, 100, 1000, 1000);
  StreamOutcome outcome =
      site.stream({.executor = {}, .tables = {{*move, {.x = "s", .position = "pulse"}}}});
  EXPECT_EQ(outcome.cause, static_cast<int>(Cause::wrong_unit));
  outcome = site.stream({.executor = {},
                         .tables = {{*pmc600_cam(), over_master}},
                         .mode = wire::ArmMode::follow_input});
  EXPECT_EQ(outcome.cause, static_cast<int>(Cause::no_master_input));
}

TEST(Dispatcher, AnOperatorsStopEndsTheMotionOnItsPath) {
  Site site({feeder()});
  ASSERT_TRUE(site.play(*trapezoid_table(500, 100, 1000, 1000)).ok());
  site.advance(500ms);
  EXPECT_TRUE(operator_stop(site.link, "feeder", wire::StopMode::stop, 2s, {}, site.clock));
  site.advance(1s);
  EXPECT_EQ(site.last().state, State::standstill);
  EXPECT_EQ(site.last().stopped, 1U);
  EXPECT_EQ(site.last().fault, Cause::none);
}

TEST(Dispatcher, AnAbortIsAFaultThatTheNextSessionResets) {
  ExecutorOptions options = feeder();
  std::vector<std::string> notices;
  options.notify = [&](const std::string& notice) { notices.push_back(notice); };
  Site site({options});
  ASSERT_TRUE(site.play(*trapezoid_table(500, 100, 1000, 1000)).ok());
  site.advance(500ms);
  EXPECT_TRUE(operator_stop(site.link, "feeder", wire::StopMode::abort, 2s, {}, site.clock));
  EXPECT_EQ(site.last().fault, Cause::aborted);
  EXPECT_THAT(notices, ::testing::Contains(HasSubstr("fault at tick ")));
  EXPECT_THAT(notices, ::testing::Contains(HasSubstr(": aborted: ")));
  const double where = site.last().position;
  EXPECT_GT(where, 10);
  // The same table begins elsewhere; one that begins here is played.
  EXPECT_EQ(site.play(*trapezoid_table(500, 100, 1000, 1000)).cause,
            static_cast<int>(Cause::start_position));
  EXPECT_TRUE(site.play(*there_and_back(where, 5, 1, Extrapolation::hold)).ok());
  site.advance(2s);
  EXPECT_EQ(site.last().fault, Cause::none);
  EXPECT_EQ(site.last().finished, 1U);
}

/// A streamer by hand: it can fall silent.
void exchange(Site& site, Sender& sender) {
  for (const auto& message : sender.poll(site.clock())) send_message(site.link, message);
  Rejects rejects;
  while (const auto message = next_message(site.link, 0ns, rejects))
    sender.receive(*message, site.clock());
  site.advance(1ms);
}

Sender holding(Site& site, const Table& table, std::int64_t session) {
  site.link.subscribe(wire::channel("feeder", wire::Lane::reply), 64);
  Sender sender({.executor = "feeder", .tables = {{table, over_time}}}, session);
  for (int i = 0; i < 500 && !sender.at_goal(); ++i) exchange(site, sender);
  EXPECT_TRUE(sender.at_goal());
  return sender;
}

TEST(Dispatcher, AFaultIsNotResetByTheSessionItCameIn) {
  Site site({feeder()});
  Sender sender = holding(site, *trapezoid_table(500, 100, 1000, 1000), 1);
  sender.stop(wire::StopMode::abort);
  for (int i = 0; i < 100; ++i) exchange(site, sender);
  EXPECT_EQ(site.last().fault, Cause::aborted);
  const wire::Arm again{.command = 1000,
                        .slave = content_hash(*trapezoid_table(500, 100, 1000, 1000), over_time)};
  ASSERT_TRUE(site.dispatcher.owned());
  send_message(site.link, {"feeder", 1, again, sender.challenge()});
  site.advance(20ms);
  EXPECT_EQ(site.last().fault, Cause::aborted);
  EXPECT_EQ(site.last().state, State::error_stop);
}

TEST(Dispatcher, AnOwnerThatFallsSilentInMotionStopsTheAxis) {
  for (const bool stop : {true, false}) {
    ExecutorOptions options = feeder();
    options.stop_when_silent = stop;
    Site site({options});
    const TablePtr cycle = there_and_back(0, 10, 1, Extrapolation::wrap);
    const Sender sender = holding(site, *cycle, 1);
    site.advance(900ms);
    EXPECT_EQ(site.last().state, State::discrete_motion);
    site.advance(2s);  // one of them is the session's time-out
    EXPECT_FALSE(site.dispatcher.owned());
    EXPECT_EQ(site.last().state, stop ? State::standstill : State::discrete_motion);
  }
}

TEST(Dispatcher, AnArmedTableIsDisarmedWithItsSession) {
  Site site({feeder()});
  const StreamOutcome outcome =
      site.stream({.executor = {},
                   .tables = {{*trapezoid_table(50, 100, 1000, 1000), over_time}},
                   .goal = StreamGoal::arm});
  ASSERT_TRUE(outcome.ok()) << outcome.reason;
  site.advance(100ms);
  EXPECT_EQ(site.last().armed, 0U);
}

TEST(Dispatcher, AnAxisThatAdoptsTheStartTakesAnyTableAtStandstill) {
  ExecutorOptions options = feeder();
  options.adopt_start = true;
  Site site({options});
  EXPECT_TRUE(site.play(*there_and_back(40, 5, 1, Extrapolation::hold)).ok());
  site.advance(1500ms);
  EXPECT_EQ(site.last().position, 40);
}

TEST(Dispatcher, RetiringStopsTheMotionAndArmsNothingMore) {
  Site site({feeder()});
  ASSERT_TRUE(site.play(*there_and_back(0, 10, 1, Extrapolation::wrap)).ok());
  site.advance(300ms);
  EXPECT_FALSE(site.dispatcher.settled());
  site.dispatcher.retire();
  EXPECT_FALSE(site.dispatcher.settled());
  site.advance(1s);
  EXPECT_TRUE(site.dispatcher.settled());
  EXPECT_EQ(site.last().stopped, 1U);
  const double here = site.last().position;
  const StreamOutcome outcome = site.play(*there_and_back(here, 10, 1, Extrapolation::hold));
  EXPECT_EQ(outcome.cause, static_cast<int>(Cause::leaving));
}

// A move has no table; braking it takes half a second here.
TEST(Dispatcher, RetiringWaitsForAMoveToEnd) {
  ExecutorOptions options = feeder();
  options.axis.limits = limits(1000, 100);
  Site site({options});
  Client client(site.link, "feeder", {}, site.clock);
  ASSERT_TRUE(client.command(command::MoveVelocity{.velocity = 100}).ok());
  ASSERT_TRUE(client.release().ok());
  site.advance(1500ms);
  EXPECT_EQ(site.last().velocity, 100);
  EXPECT_TRUE(site.dispatcher.moving());
  site.dispatcher.retire();
  site.advance(100ms);
  EXPECT_NE(site.last().velocity, 0);
  EXPECT_FALSE(site.dispatcher.settled());
  site.advance(1s);
  EXPECT_TRUE(site.dispatcher.settled());
  EXPECT_EQ(site.last().state, State::standstill);
}

/// Orders to an axis whose cycle stands still; why the last one was refused, if it was.
std::string flood(Site& site, const Sender& owner, std::int32_t from, std::int32_t to) {
  std::string reason;
  Rejects rejects;
  for (std::int32_t i = from; i <= to; ++i) {
    if (i < to)
      send_message(
          site.link,
          {"feeder", 1, wire::Command{.command = i, .kind = CommandKind::override_, .value = {0.5}},
           owner.challenge()});
    site.dispatcher.turn(0ns);
    while (const auto message = next_message(site.link, 0ns, rejects))
      if (const auto* reply = std::get_if<wire::Reply>(&message->body)) reason = reply->reason;
  }
  return reason;
}

TEST(Dispatcher, AnAbortIsNotUndoneByTheStopBehindIt) {
  Site site({feeder()});
  const Sender owner = holding(site, *there_and_back(0, 10, 1, Extrapolation::wrap), 1);
  flood(site, owner, 100, 120);  // more than the commands in transit
  for (const auto mode : {wire::StopMode::abort, wire::StopMode::stop}) {
    send_message(site.link,
                 {"feeder", 1,
                  wire::Stop{.command = mode == wire::StopMode::abort ? 200 : 201, .mode = mode},
                  owner.challenge()});
    site.dispatcher.turn(0ns);
  }
  site.advance(30ms);
  EXPECT_EQ(site.last().fault, Cause::aborted);
}

TEST(Dispatcher, AFloodOfOrdersIsRejectedNotHoarded) {
  Site site({feeder()});
  const Sender owner = holding(site, *there_and_back(0, 10, 1, Extrapolation::wrap), 1);
  EXPECT_EQ(flood(site, owner, 100, 150), "");
  EXPECT_THAT(flood(site, owner, 150, 600), HasSubstr("too many commands are waiting"));
  site.advance(100ms);  // one a tick is obeyed
  EXPECT_EQ(site.last().fault, Cause::none);
  EXPECT_EQ(flood(site, owner, 2000, 2001), "");
}

TEST(Dispatcher, AStartAtATickBeginsThere) {
  Site site({feeder()});
  StreamPlan plan{.executor = {},
                  .tables = {{*trapezoid_table(50, 100, 1000, 1000), over_time}},
                  .start_tick = 300};
  ASSERT_TRUE(site.stream(plan).ok());
  while (site.last().tick < 299) site.advance(1ms);
  EXPECT_EQ(site.last().job, 0U);
  site.advance(1ms);
  EXPECT_NE(site.last().job, 0U);
  EXPECT_EQ(site.last().position, 0);
}

TEST(Dispatcher, PublishesWhatTheAxisDoes) {
  Site site({feeder()});
  site.link.subscribe(wire::channel("feeder", wire::Lane::status), 64);
  const TablePtr move = trapezoid_table(50, 100, 1000, 1000);
  ASSERT_TRUE(site.play(*move).ok());
  site.pacer.delay = 5'000'000;
  site.advance(250ms);
  std::vector<wire::Status> published;
  Rejects rejects;
  while (const auto message = next_message(site.link, 0ns, rejects)) {
    if (const auto* status = std::get_if<wire::Status>(&message->body))
      published.push_back(*status);
  }
  ASSERT_GE(published.size(), 5U);
  const wire::Status& now = published.back();
  EXPECT_EQ(now.state, State::discrete_motion);
  EXPECT_EQ(now.cycle_ns, 1'000'000);
  EXPECT_TRUE(std::isnan(now.master_position));
  EXPECT_EQ(now.slave_velocity, 100);
  EXPECT_EQ(now.late_ticks, 1);
  EXPECT_EQ(now.last_error, 0);
  const Sha256 hash = content_hash(*move, over_time);
  EXPECT_TRUE(std::equal(now.table.begin(), now.table.end(), hash.begin()));
}

TEST(Dispatcher, ALossyLinkChangesNothingButTheTimeItTakes) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Site site({feeder()});
    LossyTransport lossy(
        site.link, {.seed = seed, .lost = 0.1, .doubled = 0.1, .corrupted = 0.05, .delayed = 0.1},
        site.clock);
    const StreamOutcome outcome = stream_tables(
        lossy,
        {.executor = "feeder", .tables = {{*trapezoid_table(50, 100, 1000, 1000), over_time}}}, {},
        site.clock, 1);
    ASSERT_TRUE(outcome.ok()) << seed << ": " << outcome.reason;
    site.advance(1s);
    EXPECT_EQ(site.last().finished, 1U) << seed;
    EXPECT_EQ(site.last().position, 50) << seed;
  }
}

}  // namespace
}  // namespace jounce::dispatcher_test
