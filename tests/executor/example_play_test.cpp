// SPDX-License-Identifier: Apache-2.0
// The manuals' examples from the streamer to the axis: sessions, queues and orders over a link, the
// executor's threads in turn on a virtual clock, and every tick compared with the exact curves.

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/gear/follow.hpp"
#include "jounce/pvt/pt.hpp"
#include "jounce/pvt/segment_row.hpp"
#include "jounce/stream/sender/client.hpp"

#include "axis/tables.hpp"
#include "executor/site.hpp"
#include "gear/follow_tables.hpp"

namespace jounce::example_play_test {
namespace {

using namespace test;
using namespace std::chrono_literals;

const Units over_time{.x = "s", .position = "pulse"};
const Units over_master{.x = "pulse", .position = "pulse"};

std::vector<ExecutorOptions> feeder_and_knife(const Limits& limits) {
  std::vector<ExecutorOptions> axes{axis_named("feeder", limits), axis_named("knife", limits)};
  axes[1].follow = {.what = Follow::What::setpoint, .index = 0};
  return axes;
}

/// A feeder, and a knife that follows its setpoint.
struct Follower : Site {
  explicit Follower(const Limits& limits = test::limits(1e6, 1e9))
      : Site(feeder_and_knife(limits)) {
    link.subscribe(wire::channel("knife", wire::Lane::reply), 64);
    after = [this] {
      if (each_tick) each_tick(feeder(), knife());
    };
  }
  const Tick& feeder() const { return last(0); }
  const Tick& knife() const { return last(1); }

  /// The feeder plays this from now on.
  void feed(const TablePtr& table) {
    const StreamOutcome outcome = stream({.executor = "feeder", .tables = {{*table, over_time}}});
    ASSERT_TRUE(outcome.ok()) << outcome.reason;
  }
  StreamOutcome couple(const TablePtr& cam, CamEnd end = CamEnd::brake) {
    return stream({.executor = "knife",
                   .tables = {{*cam, over_master}},
                   .mode = wire::ArmMode::follow_input,
                   .end = end});
  }

  std::function<void(const Tick& feeder, const Tick& knife)> each_tick;
};

RowSource source_of(const std::vector<SegmentRow>& rows) {
  return [rows, next = std::size_t{0}](std::size_t most) mutable {
    std::vector<wire::Row> some;
    while (next < rows.size() && some.size() < most) some.push_back(on_wire(rows[next++]));
    return some;
  };
}

std::vector<SegmentRow> ending(std::vector<SegmentRow> rows) {
  rows.back().last = true;
  return rows;
}

/// Time since the motion's first tick, from the two ticks after it.
double since_start(const Follower& site, std::int64_t first) {
  return static_cast<double>(site.feeder().tick - first) * 1e-3;
}

// Googol manual 7.4, examples 7-3 and 7-4, as rolling streams to the feeder.

void play_points(const std::vector<PtPoint>& points, const wire::Queue& queue, double near) {
  Follower site;
  const Trajectory whole = pt<OverTime>(points);
  std::int64_t first = -1;
  std::int64_t ticks = 0;
  site.each_tick = [&](const Tick& tick, const Tick&) {
    if (tick.job == 0) return;
    if (first < 0) first = tick.tick;
    ++ticks;
    ASSERT_NEAR(tick.position, whole.jet(since_start(site, first))[0], near) << ticks;
  };
  const RowOutcome outcome = stream_rows(
      site.link, {.executor = "feeder", .queue = queue, .rows = source_of(ending(rows_of(points)))},
      {}, site.clock, 1);
  EXPECT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_TRUE(outcome.progress.finished);
  EXPECT_EQ(outcome.progress.played, points.size());
  EXPECT_EQ(outcome.progress.underruns, 0);
  EXPECT_EQ(static_cast<double>(ticks), std::round(whole.end() * 1000));
  EXPECT_NEAR(site.feeder().position, points.back().position, near);
  EXPECT_EQ(site.feeder().finished, 1U);
  EXPECT_EQ(site.feeder().fault, Cause::none);
}

// From 400 pulse/s at 0.5 s, a PT row over 800 pulse in 0.5 s ends at 2 * 1600 - 400 = 2800 pulse/s.
TEST(ExamplePlay, ARejectedRowHasItsNumberAndTheLimit) {
  Follower site(limits(1000, 1e5));
  const RowOutcome outcome = stream_rows(
      site.link,
      {.executor = "feeder",
       .queue = {.units = over_time, .capacity = 32, .prefill = 2},
       .rows = source_of(ending(rows_of(std::vector<PtPoint>{{0.5, 100}, {1, 900}, {2, 1000}})))},
      {}, site.clock, 1);
  EXPECT_FALSE(outcome.ok());
  EXPECT_NE(outcome.reason.find("velocity: The row exceeds the velocity limit of the axis. It has "
                                "2800 pulse/s; the limit is 1000 pulse/s."),
            std::string::npos)
      << outcome.reason;
}

TEST(ExamplePlay, Googol73) {
  play_points({{1.024, 1024}, {2.048, 3072}, {3.072, 4096}},
              {.units = over_time, .capacity = 32, .prefill = 3}, 1e-11);
}

// v = 50 sin(2 pi t) in 16 ms steps, two loops of 63 segments, with the manual's pi.
TEST(ExamplePlay, Googol74Of126SegmentsThroughTwoFifosOf32) {
  const double pi = 3.1415926;
  std::vector<PtPoint> points;
  for (int loop = 0; loop < 2; ++loop) {
    double position = 0;
    double before = 0;
    for (int k = 1; k * 16 < 1000; ++k) {
      const double v = 50 * std::sin(2 * pi * k * 0.016);
      position += (before + v) * 8;
      before = v;
      points.push_back({loop + 0.016 * k, position});
    }
    points.push_back({loop + 1.0, 0, PtType::stop});
  }
  ASSERT_EQ(points.size(), 126U);
  play_points(points, {.units = over_time, .capacity = 32, .prefill = 64}, 1e-9);
}

/// A streamer of static queues, by hand: two FIFOs over the feeder's position.
class Hand {
 public:
  explicit Hand(Follower& site) : site_(site), session_(++site.sessions) {}

  void open(const wire::Queue& queue) {
    queue_ = queue;
    say(queue);  // learns the executor's challenge
    say(queue);
    EXPECT_EQ(ack_.refusal, wire::Refusal::none) << ack_.reason;
  }

  void fill(int bank, const std::vector<PtPoint>& points) {
    const auto b = static_cast<std::size_t>(bank);
    std::vector<wire::Row> rows;
    bool first = true;
    for (const PtPoint& p : points) rows.push_back(on_wire(row_of(p, std::exchange(first, false))));
    for (std::size_t at = 0; at < rows.size(); at += wire::rows_each) {
      const std::size_t end = std::min(at + wire::rows_each, rows.size());
      say(wire::Rows{.queue = queue_.queue,
                     .bank = static_cast<std::uint8_t>(bank),
                     .seq = seq_[b]++,
                     .first_row = rows_[b],
                     .rows = {rows.begin() + static_cast<std::ptrdiff_t>(at),
                              rows.begin() + static_cast<std::ptrdiff_t>(end)}});
      rows_[b] += end - at;
    }
    EXPECT_EQ(ack_.refusal, wire::Refusal::none) << ack_.reason;
  }

  void arm_and_start() {
    order(wire::Arm{.mode = wire::ArmMode::queue, .queue = queue_.queue});
    order(wire::Start{});
  }
  void queue_switch() {
    order(wire::Command{.kind = CommandKind::queue_switch,
                        .value = {static_cast<double>(queue_.queue)}});
  }

  /// Clears a bank. After a switch has taken rows from it, messages count again from the next one
  /// on.
  void clear(int bank) {
    order(wire::Command{.kind = CommandKind::queue_clear,
                        .value = {static_cast<double>(queue_.queue), static_cast<double>(bank),
                                  static_cast<double>(seq_[static_cast<std::size_t>(bank)])}});
  }

  template <class Body>
  wire::Reply order(Body command) {
    command.command = ++number_;
    reply_ = {};
    for (int i = 0; i < 100 && reply_.outcome == wire::Outcome::pending; ++i) say(command);
    EXPECT_EQ(reply_.outcome, wire::Outcome::accepted) << reply_.reason;
    return reply_;
  }

  /// Lets time pass, and stays alive.
  void wait(Nanos time) {
    for (const Nanos end = site_.clock() + time; site_.clock() < end;) {
      site_.advance(std::min<Nanos>(end - site_.clock(), 200ms));
      order(wire::Heartbeat{});
    }
  }
  const wire::QueueAck& ack() {
    say(queue_);
    return ack_;
  }

 private:
  void say(wire::Body body) {
    send_message(site_.link, {"knife", session_, std::move(body), challenge_});
    site_.advance(3ms);
    Rejects rejects;
    while (const auto message = next_message(site_.link, 0ns, rejects)) {
      if (message->executor != "knife" || message->session != session_) continue;
      challenge_ = message->challenge;
      if (const auto* ack = std::get_if<wire::QueueAck>(&message->body)) ack_ = *ack;
      if (const auto* reply = std::get_if<wire::Reply>(&message->body);
          reply != nullptr && reply->command == number_)
        reply_ = *reply;
    }
  }

  Follower& site_;
  std::int64_t session_;
  std::int64_t challenge_ = 0;
  std::int32_t number_ = 0;
  wire::Queue queue_;
  wire::QueueAck ack_;
  wire::Reply reply_;
  std::array<std::uint32_t, 2> seq_{};
  std::array<std::uint64_t, 2> rows_{};
};

wire::Queue fifos(std::int32_t loops, std::uint32_t capacity = 16) {
  return {.axis = Domain::master,
          .units = over_master,
          .mode = wire::QueueMode::static_,
          .capacity = capacity,
          .loops = loops};
}

/// The pass that the last table of a cam repeats without end: its master and slave.
struct Pass {
  double master = 0;
  double slave = 0;
};

/// From now on the knife is where the cam puts it, the master counted from `from`.
void expect_follows(Follower& site, const Cam& cam, double from, const Pass& pass, double near) {
  site.each_tick = [&site, cam, from, pass, near](const Tick& feeder, const Tick& knife) {
    const double gone = feeder.position - from;
    const double again = std::max(0.0, std::ceil((gone - cam.end()) / pass.master));
    const double exact = gone > 0 ? cam.jet(gone - again * pass.master)[0] + again * pass.slave : 0;
    ASSERT_NEAR(knife.position, exact, near) << "at " << gone;
    ASSERT_EQ(knife.fault, Cause::none);
    ASSERT_EQ(site.knife().state, State::synchronized_motion);
  };
}

// Example 7-6: a catch-up of (5000, 2500) to ratio 1, then the shear's cycle without end.
TEST(ExamplePlay, Googol76) {
  Follower site;
  Hand hand(site);
  hand.open(fifos(0));
  hand.fill(0, {{5000, 2500}});
  hand.fill(1, test::shear_cycle().segments);
  hand.arm_and_start();
  hand.queue_switch();
  const FollowSpec both{{{{{5000, 2500}}}, test::shear_cycle()}};
  expect_follows(site, follow(both).cam, 0, {10000, 8000}, 1e-6);
  site.feed(constant_master(1e6, 10000));
  hand.wait(8s);
  EXPECT_GT(site.feeder().position, 75000) << "seven cycles";
  EXPECT_EQ(hand.ack().progress, wire::Progress::running);
}

// Example 7-7: PASS at 50000 of a master that speeds up by 1 pulse/ms^2 to 50 pulse/ms.
TEST(ExamplePlay, Googol77) {
  Follower site;
  Hand hand(site);
  wire::Queue queue = fifos(0);
  queue.event = wire::QueueEvent::pass;
  queue.event_position = 50000;
  queue.event_direction = 1;
  hand.open(queue);
  hand.fill(0, test::example_7_7().segments);
  hand.arm_and_start();
  EXPECT_EQ(hand.ack().progress, wire::Progress::waiting);
  double peak = 0;
  expect_follows(site, follow(FollowSpec{{test::example_7_7()}}).cam, 50000, {60000, 40000}, 1e-6);
  site.each_tick = [&, check = site.each_tick](const Tick& feeder, const Tick& knife) {
    check(feeder, knife);
    peak = std::max(peak, knife.velocity);
  };
  site.feed(trapezoid_table(1e6, 50e3, 1e6, 1e6));
  hand.wait(7s);
  EXPECT_GT(site.feeder().position, 300000);
  EXPECT_NEAR(peak, 50e3, 1e-6) << "notes: peak 50 pulse/ms";
}

// Example 7-8: 802 segments.
TEST(ExamplePlay, Googol78) {
  Follower site;
  Hand hand(site);
  hand.open(fifos(1, 1000));
  hand.fill(0, test::example_7_8().segments);
  hand.arm_and_start();
  const Cam exact = follow({{test::example_7_8()}}).cam;
  site.each_tick = [&](const Tick& feeder, const Tick& knife) {
    ASSERT_NEAR(knife.position, exact.jet(std::min(feeder.position, exact.end()))[0], 1e-8);
  };
  site.feed(constant_master(200e3, 50e3));
  hand.wait(3s);
  EXPECT_EQ(site.knife().state, State::standstill);
  EXPECT_NEAR(site.knife().position, 100000, 1e-8) << "stated";
  EXPECT_EQ(site.knife().finished, 1U);
  EXPECT_EQ(hand.ack().progress, wire::Progress::done);
}

// Example 7-9: the old table without end; bridge; the new table, from 0.6 to 0.6.
TEST(ExamplePlay, Googol79) {
  Follower site;
  Hand hand(site);
  hand.open(fifos(0));
  hand.fill(0, test::old_7_9().segments);
  hand.arm_and_start();
  FollowTable old = test::old_7_9();
  old.loops = 2;
  FollowTable endless = test::new_7_9();
  endless.loops = 0;
  expect_follows(site, follow(FollowSpec{{old, test::bridge_7_9(), endless}}).cam, 0,
                 {60000, 52000}, 1e-6);
  site.feed(constant_master(1e6, 50e3));
  hand.wait(1400ms);  // a pass takes 1200
  hand.fill(1, test::bridge_7_9().segments);
  hand.queue_switch();
  hand.wait(1200ms);  // the bridge plays
  hand.clear(0);
  hand.fill(0, test::new_7_9().segments);
  hand.queue_switch();
  hand.wait(1300ms);
  double least = 1e9;
  double most = 0;
  site.each_tick = [&, check = site.each_tick](const Tick& feeder, const Tick& knife) {
    check(feeder, knife);
    least = std::min(least, knife.velocity);
    most = std::max(most, knife.velocity);
  };
  hand.wait(3600ms);
  EXPECT_NEAR(least, 30e3, 150) << "notes: oscillates between 30 and 50 pulse/ms";
  EXPECT_NEAR(most, 50e3, 150);
}

// PMC600 manual 6.2, example 4.4: (0,0) (5000,5000) (10000,7000) at 10000; the coupling ends at speed.
TEST(ExamplePlay, Pmc600Example44) {
  Follower site;
  const StreamOutcome outcome =
      site.couple(table(Domain::master, Interpolation::linear, Extrapolation::refuse,
                        {{0, 5000, 10000}, {0, 5000, 7000}, {}, {}}),
                  CamEnd::keep_velocity);
  ASSERT_TRUE(outcome.ok()) << outcome.reason;
  double last = 0;
  site.each_tick = [&](const Tick& feeder, const Tick& knife) {
    const double m = feeder.position;
    const double cam = m < 5000 ? m : 5000 + 0.4 * (m - 5000);
    ASSERT_NEAR(knife.position, cam, 1e-9) << m;
    ASSERT_EQ(knife.fault, Cause::none);
    last = knife.velocity;
  };
  site.feed(constant_master(12000, 10000));
  site.advance(1100ms);
  EXPECT_EQ(site.knife().state, State::continuous_motion) << "the velocity stays, as after CamOut";
  EXPECT_NEAR(last, 4000, 1e-9);
}

// PMC600 manual 6.1, example 6.1: master +-20000 at 10000, 10000; gears of -2 and 0.5.
TEST(ExamplePlay, Pmc600Example61) {
  for (const auto& [numerator, denominator] : {std::pair{-2, 1}, {1, 2}}) {
    const double k = static_cast<double>(numerator) / denominator;
    Follower site;
    Client knife(site.link, "knife", {}, site.clock);
    ASSERT_TRUE(
        knife.command(command::GearIn{.numerator = numerator, .denominator = denominator}).ok());
    ASSERT_TRUE(knife.release().ok());
    site.each_tick = [&](const Tick& feeder, const Tick& slave) {
      ASSERT_NEAR(slave.position, k * feeder.position, 1e-7);
      ASSERT_NEAR(slave.velocity, k * feeder.velocity, 1e-7);
    };
    Client feeder(site.link, "feeder", {}, site.clock);
    for (const double to : {20000.0, 0.0, 20000.0}) {
      ASSERT_TRUE(
          feeder.command(command::MoveAbsolute{.position = to, .dynamics = {10000, 10000, 10000}})
              .ok());
      ASSERT_TRUE(feeder.release().ok());
      site.advance(3100ms);
      EXPECT_NEAR(site.feeder().position, to, 1e-9);
      EXPECT_NEAR(site.knife().position, k * to, 1e-7) << "notes: -40000, 10000 a stroke";
    }
    EXPECT_EQ(site.knife().state, State::synchronized_motion);
  }
}

// PMC600 manual 6.1, example 6.2: synchronized at (5000, 2000) from 4000 before, through reversals.
TEST(ExamplePlay, Pmc600Example62Looped) {
  Follower site;
  Client knife(site.link, "knife", {}, site.clock);
  ASSERT_TRUE(knife
                  .command(command::GearInPos{.numerator = 1,
                                              .denominator = 2,
                                              .master_sync_position = 5000,
                                              .slave_sync_position = 2000,
                                              .master_start_distance = 4000})
                  .ok());
  ASSERT_TRUE(knife.release().ok());
  bool in_sync = false;
  double furthest = 0;
  site.each_tick = [&](const Tick& feeder, const Tick& slave) {
    if (feeder.position < 1000 && !in_sync) {
      ASSERT_EQ(slave.position, 0) << "notes: starts at master 1000";
    }
    in_sync = in_sync || feeder.position >= 5000;
    if (in_sync) {
      ASSERT_NEAR(slave.position, 2000 + (feeder.position - 5000) / 2, 1e-9);
    }
    furthest = std::max(furthest, slave.position);
  };
  Client feeder(site.link, "feeder", {}, site.clock);
  for (const double to : {10000.0, 0.0, 10000.0, 0.0}) {
    ASSERT_TRUE(
        feeder.command(command::MoveAbsolute{.position = to, .dynamics = {10000, 100000, 100000}})
            .ok());
    ASSERT_TRUE(feeder.release().ok());
    site.advance(1200ms);
  }
  EXPECT_NEAR(furthest, 4500, 1e-9) << "notes: at master 10000 the slave is at 4500";
}

// PMC600 manual 6.3, example 6.7: LS_LineFollowAbs to (4000, 2000) at 2000, 4000, 4000.
TEST(ExamplePlay, Pmc600Example67OfLineFollow) {
  Follower site;
  ASSERT_TRUE(site.couple(table(Domain::master, Interpolation::linear, Extrapolation::hold,
                                {{0, 4000}, {0, 2000}, {}, {}}))
                  .ok());
  std::int64_t ticks = 0;
  double peak = 0;
  site.each_tick = [&](const Tick& feeder, const Tick& knife) {
    ASSERT_NEAR(knife.position, feeder.position / 2, 1e-9) << "on the line";
    ASSERT_NEAR(knife.velocity, feeder.velocity / 2, 1e-9) << "both stop together";
    ticks += feeder.velocity != 0;
    peak = std::max(peak, knife.velocity);
  };
  Client feeder(site.link, "feeder", {}, site.clock);
  ASSERT_TRUE(
      feeder.command(command::MoveAbsolute{.position = 4000, .dynamics = {2000, 4000, 4000}}).ok());
  ASSERT_TRUE(feeder.release().ok());
  site.advance(2600ms);
  EXPECT_NEAR(peak, 1000, 1e-6) << "notes: slave peak 1000";
  EXPECT_NEAR(static_cast<double>(ticks), 2500, 1) << "notes: 2.5 s";
  EXPECT_NEAR(site.knife().position, 2000, 1e-9);
  EXPECT_EQ(site.knife().velocity, 0);
}

// ---- an underrun, from the source to the axis and back ---------------------------------------------

/// 3 s to 300 by the 3-4-5 polynomial, in rows of 10 ms.
std::vector<SegmentRow> long_way() {
  const TablePtr way = table(Domain::time, Interpolation::quintic_hermite, Extrapolation::hold,
                             {{0, 3}, {0, 300}, {0, 0}, {0, 0}});
  std::vector<SegmentRow> rows;
  for (int i = 1; i <= 300; ++i) {
    const Jet a = way->jet(0.01 * (i - 1));
    const Jet b = i < 300 ? way->jet(0.01 * i) : Jet{300, 0, 0, 0};
    rows.push_back({0.01 * i, b[0], a[1], b[1], a[2], b[2], 5, i == 300});
  }
  return rows;
}

/// The first `some` rows, and the rest from `when` on.
RowSource halting(Follower& site, std::size_t some, Nanos when) {
  return [&site, some, when, rows = long_way(), next = std::size_t{0}](std::size_t most) mutable {
    std::vector<wire::Row> given;
    const std::size_t end = site.clock() < when ? some : rows.size();
    while (next < end && given.size() < most) given.push_back(on_wire(rows[next++]));
    return given;
  };
}

/// Conditions that hold for every source.
void expect_within(Follower& site, double known, Nanos more) {
  site.each_tick = [&site, known, more, v = 0.0, p = 0.0](const Tick& tick, const Tick&) mutable {
    ASSERT_GE(tick.position, p) << "never back";
    ASSERT_LE(std::abs(tick.velocity - v), 200 * (1 + 1e-9)) << "stop_acceleration in a tick";
    ASSERT_TRUE(tick.fault == Cause::none || tick.fault == Cause::underrun) << name(tick.fault);
    if (site.clock() < more) {
      ASSERT_LE(tick.position, known) << "never beyond what is known";
    }
    v = tick.velocity;
    p = tick.position;
  };
}

const wire::Queue rolling{.units = over_time, .capacity = 100, .prefill = 50};

TEST(Underrun, StopsOnThePathIsReportedAndContinuesWithMoreRows) {
  Follower site(limits(1000, 1e5));
  const Nanos more = site.clock() + 3s;
  expect_within(site, long_way()[99].p_end, more);
  const RowOutcome outcome = stream_rows(
      site.link,
      {.executor = "feeder", .queue = rolling, .rows = halting(site, 100, more), .resume = true},
      {}, site.clock, 1);
  EXPECT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_EQ(outcome.progress.underruns, 1);
  EXPECT_TRUE(outcome.progress.finished);
  EXPECT_EQ(site.feeder().position, 300);
  EXPECT_EQ(site.feeder().fault, Cause::none);
}

TEST(Underrun, EndsAStreamThatMayNotResumeAndTheNextOwnerBeginsAfresh) {
  Follower site(limits(1000, 1e5));
  expect_within(site, long_way()[99].p_end, Nanos::max());
  const RowOutcome outcome = stream_rows(
      site.link, {.executor = "feeder", .queue = rolling, .rows = halting(site, 100, Nanos::max())},
      {}, site.clock, 1);
  EXPECT_EQ(outcome.error, StreamError::underrun);
  site.advance(1500ms);
  EXPECT_EQ(site.feeder().fault, Cause::underrun);
  EXPECT_EQ(site.feeder().velocity, 0);
  site.each_tick = nullptr;
  const double here = site.feeder().position;
  site.sessions = 1;
  site.feed(there_and_back(here, 5, 0.2, Extrapolation::hold));
  site.advance(300ms);
  EXPECT_EQ(site.feeder().fault, Cause::none);
  EXPECT_EQ(site.feeder().finished, 1U);
  EXPECT_NEAR(site.feeder().position, here, 1e-12);
}

// An axis at rest after an underrun has no motion for which the executor would wait.
TEST(Underrun, DoesNotKeepAnExecutorFromLeaving) {
  Follower site(limits(1000, 1e5));
  (void)stream_rows(
      site.link, {.executor = "feeder", .queue = rolling, .rows = halting(site, 100, Nanos::max())},
      {}, site.clock, 1);
  site.advance(200ms);
  site.dispatcher.retire();
  site.advance(50ms);
  EXPECT_TRUE(site.dispatcher.settled());
}

TEST(Queue, StoppedInMidPlayIsClearedAndFilledAgain) {
  Follower site;
  Hand hand(site);
  hand.open(fifos(0));
  hand.fill(0, test::shear_cycle().segments);
  hand.arm_and_start();
  hand.wait(50ms);
  hand.order(wire::Stop{});
  hand.wait(50ms);
  EXPECT_EQ(hand.ack().progress, wire::Progress::broken);
  hand.order(wire::Arm{.mode = wire::ArmMode::queue, .queue = wire::first_queue});
  hand.order(wire::Start{});
  EXPECT_EQ(site.knife().state, State::synchronized_motion);
}

// The sender learns late that what it has sent was all.
TEST(Queue, DeclaredCompleteItEndsWithoutAnUnderrun) {
  for (const bool declared : {true, false}) {
    Follower site;
    Hand hand(site);
    hand.open({.units = over_time, .capacity = 32, .prefill = 2});
    hand.fill(0, {{0.5, 100}, {1.0, 0, PtType::stop}});
    hand.arm_and_start();
    if (declared)
      hand.order(wire::Command{.kind = CommandKind::queue_end,
                               .value = {static_cast<double>(wire::first_queue)}});
    hand.wait(1500ms);
    EXPECT_EQ(site.knife().fault, declared ? Cause::none : Cause::underrun);
    EXPECT_EQ(site.knife().finished, declared ? 1U : 0U);
    EXPECT_EQ(hand.ack().progress, declared ? wire::Progress::done : wire::Progress::starving);
  }
}

}  // namespace
}  // namespace jounce::example_play_test
