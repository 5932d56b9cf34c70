// SPDX-License-Identifier: Apache-2.0
// The judge of the random orders is tested with logs that are made here: a right one has no finding, and a log with one
// violation of each kind has the finding of that kind.

#include "executor/record/log_judge.hpp"

#include <cmath>
#include <cstdint>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jounce::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using What = Accepted::What;
using Findings = std::vector<std::string>;

constexpr double dt = 1e-3;

/// One tick as the log has it.
struct Row {
  std::int64_t tick = 0;
  std::string state{};
  double p = 0, v = 0, a = 0;
  bool path = false;
  std::string fault = "none";
  bool homed = false;
};

/// A log that is made tick by tick.
struct Log {
  std::vector<Row> rows;
  Row next{.state = "disabled"};

  Log& be(const std::string& state, int ticks, const std::string& fault = "none") {
    next.state = state;
    next.fault = fault;
    return go(ticks, 0);
  }
  /// Goes on with this acceleration.
  Log& go(int ticks, double acceleration) {
    for (int i = 0; i < ticks; ++i) {
      const double before = next.v;
      next.a = acceleration;
      next.v += acceleration * dt;
      if (std::abs(next.v) < 1e-9) next.v = 0;
      next.p += (before + next.v) / 2 * dt;
      rows.push_back(next);
      ++next.tick;
    }
    return *this;
  }
  /// The same from the next tick on, with another state.
  Log& in(const std::string& state, const std::string& fault = "none") {
    next.state = state;
    next.fault = fault;
    return *this;
  }
  [[nodiscard]] std::int64_t tick() const { return next.tick; }

  [[nodiscard]] std::string csv() const {
    std::ostringstream text;
    text.precision(17);
    text << "tick,time,state,master,master_velocity,position,velocity,acceleration,"
            "job,fault,outputs,edges,held,homed\n";
    for (const Row& row : rows)
      text << row.tick << ',' << static_cast<double>(row.tick) * dt << ',' << row.state << ",0,0,"
           << row.p << ',' << row.v << ',' << row.a << ',' << (row.path ? 1 : 0) << ',' << row.fault
           << ",0,,0," << (row.homed ? 1 : 0) << '\n';
    return text.str();
  }
};

const Bounds bounds{.velocity = 100,
                    .acceleration = 1000,
                    .stop_acceleration = 2000,
                    .limit_acceleration = 1500,
                    .abort_acceleration = 0,
                    .lowest = -10,
                    .highest = 50};

Accepted at(std::int64_t tick, What what) {
  return {.what = what, .sent = tick - 1, .answered = tick, .words = "order"};
}

/// Enabled, and at rest.
Log enabled() {
  Log log;
  log.be("disabled", 3).be("standstill", 3);
  return log;
}

/// A move to 0.6 mm with 20 mm/s, that was ordered in tick 5.
Log moved() {
  return enabled().in("discrete_motion").go(20, 1000).go(10, 0).go(20, -1000).be("standstill", 5);
}
const std::vector<Accepted> ordered{at(5, What::moves)};

Findings of(const Log& log, const std::vector<Accepted>& orders, const Bounds& of_axis = bounds) {
  return judged(log.csv(), of_axis, orders);
}

/// The finding of a right log in which one line was changed.
Findings with(const std::function<void(Log&)>& wrong,
              const std::vector<Accepted>& orders = ordered) {
  Log log = moved();
  wrong(log);
  return of(log, orders);
}

TEST(LogJudge, ARightMoveHasNoFinding) {
  EXPECT_THAT(of(moved(), ordered), IsEmpty());
}

TEST(LogJudge, FindsAMotionThatNoOrderAskedFor) {
  EXPECT_THAT(of(moved(), {}), Contains(HasSubstr("begins to move without an order")));
  EXPECT_THAT(of(moved(), {at(40, What::moves)}),
              Contains(HasSubstr("begins to move without an order")));
}

TEST(LogJudge, FindsAPositionOutOfTheRange) {
  Bounds narrow = bounds;
  narrow.highest = 0.5;
  EXPECT_THAT(of(moved(), ordered, narrow), Contains(HasSubstr("position out of the range")));
  narrow.highest = 50;
  narrow.lowest = 0.1;
  EXPECT_THAT(of(moved(), ordered, narrow), IsEmpty()) << "it comes back from outside";
  Log out = enabled().in("discrete_motion").go(20, -1000).go(20, 1000).be("standstill", 3);
  EXPECT_THAT(of(out, ordered, narrow), Contains(HasSubstr("position out of the range")));
}

TEST(LogJudge, FindsAVelocityAboveTheLimit) {
  Log fast = enabled().in("discrete_motion").go(101, 1000).go(101, -1000).be("standstill", 3);
  EXPECT_THAT(of(fast, ordered), Contains(HasSubstr("velocity 101")));
}

TEST(LogJudge, FindsAnAccelerationAboveTheLimit) {
  Log hard = enabled().in("discrete_motion").go(10, 1010).go(10, -1010).be("standstill", 3);
  EXPECT_THAT(of(hard, ordered), Contains(HasSubstr("acceleration 1010")));
}

TEST(LogJudge, FindsAJerkAboveThatOfAStop) {
  Bounds soft = bounds;
  soft.jerk = 1e5;
  soft.stop_jerk = 2e5;  // 200 u/s^2 from tick to tick
  Log right = enabled().in("discrete_motion").go(1, 200).go(9, 400).go(1, 200).go(1, 0);
  right.go(1, -200).go(9, -400).go(1, -200);
  right.be("standstill", 3);
  EXPECT_THAT(of(right, ordered, soft), IsEmpty());
  Log steep = enabled().in("discrete_motion").go(10, 210).go(1, 0).go(10, -210).be("standstill", 3);
  EXPECT_THAT(of(steep, ordered, soft), Contains(HasSubstr("jerk 210")));
}

TEST(LogJudge, FindsStepsThatDoNotBelongTogether) {
  EXPECT_THAT(with([](Log& log) { log.rows[20].p += 0.01; }),
              Contains(HasSubstr("step of the position")));
  EXPECT_THAT(with([](Log& log) { log.rows[20].v += 5; }),
              Contains(HasSubstr("step of the velocity")));
}

TEST(LogJudge, AnotherNameIsNoStep) {
  const auto renamed = [](Log& log) {
    for (Row& row : log.rows)
      if (row.tick >= 58) row.p += 30;
  };
  EXPECT_THAT(with(renamed), Contains(HasSubstr("step of the position")));
  EXPECT_THAT(with(renamed, {at(5, What::moves), at(57, What::places)}), IsEmpty());
}

TEST(LogJudge, FindsMotionWhileDisabled) {
  EXPECT_THAT(with([](Log& log) {
                for (Row& row : log.rows)
                  if (row.tick == 20) row.state = "disabled";
              }),
              Contains(HasSubstr("moves while disabled")));
}

/// In motion with 20 mm/s from tick 26 on.
Log cruising() {
  return enabled().in("continuous_motion").go(20, 1000).go(4, 0);
}

TEST(LogJudge, FindsAStopThatTakesTooLong) {
  const std::vector<Accepted> stopped{at(5, What::moves), at(29, What::stops)};
  Log right = cruising().in("stopping").go(10, -2000).be("standstill", 40);
  EXPECT_THAT(of(right, stopped), IsEmpty());
  Log slow = cruising().in("stopping").go(40, -500).be("standstill", 40);
  EXPECT_THAT(of(slow, stopped), Contains(HasSubstr("not at rest in the time of its stop")));
  Log again = cruising().in("stopping").go(10, -2000).be("standstill", 10);
  again.in("discrete_motion").go(5, 1000).go(5, -1000);
  EXPECT_THAT(of(again, stopped), Contains(HasSubstr("begins to move without an order")));
}

TEST(LogJudge, FindsAHaltThatTakesLongerThanItAskedFor) {
  Accepted halt = at(29, What::rests);
  halt.acceleration = 500;
  Log log = cruising().go(40, -500).be("standstill", 5);
  EXPECT_THAT(of(log, {at(5, What::moves), halt}), IsEmpty());
  halt.acceleration = 1000;
  EXPECT_THAT(of(log, {at(5, What::moves), halt}),
              Contains(HasSubstr("not at rest in the time of its stop")));
}

TEST(LogJudge, FindsMotionAfterAFault) {
  const std::string fault = "positive_soft_limit";
  Log right = cruising().in("error_stop", fault).go(10, -2000).be("error_stop", 40, fault);
  EXPECT_THAT(of(right, ordered), IsEmpty());
  Log on = cruising().in("error_stop", fault).go(40, 0);
  EXPECT_THAT(of(on, ordered), Contains(HasSubstr("not at rest in the time of its stop")));
  Log again = cruising().in("error_stop", fault).go(10, -2000).go(2, 0).go(1, 1000).go(1, -1000);
  EXPECT_THAT(of(again, ordered), Contains(HasSubstr("moves again in its fault")));
}

TEST(LogJudge, FindsASetpointThatMovesWhereItIsFrozen) {
  Log right = cruising();
  right.next.v = 0;
  right.be("error_stop", 5, "aborted");
  EXPECT_THAT(of(right, ordered), IsEmpty());
  Log moves = cruising();
  moves.next.v = 0;
  moves.next.p += 0.02;
  moves.be("error_stop", 5, "aborted");
  EXPECT_THAT(of(moves, ordered), Contains(HasSubstr("a frozen setpoint moves")));
}

// ---- homing ------------------------------------------------------------------------------------

/// Limit switches at -5 and 5, the home switch from 0.1 to 3, an index at 0.05 and every 0.2 from there.
Bounds with_switches() {
  Bounds b = bounds;
  b.lowest = -0.01;  // does not hold while it searches
  b.machine = MachineBounds{.start = 0,
                            .negative = -5,
                            .positive = 5,
                            .home_low = 0.1,
                            .home_high = 3,
                            .index_period = 0.2,
                            .index_offset = 0.05};
  return b;
}

Accepted home(int method, double position = 7) {
  Accepted order = at(5, What::homes);
  order.method = method;
  order.fastest = 10;
  order.acceleration = 500;
  order.home = position;
  order.timeout = 0.2;
  return order;
}

/// A search upwards that rests at `rests` and then calls `found`, of the machine, 7.
Log homed(double found = 0.1) {
  Log log = enabled().in("homing").go(20, 500).go(20, 0).go(20, -500).go(2, 0);
  log.next.p += 7 - found;
  log.next.homed = true;
  return log.be("standstill", 3);
}

TEST(LogJudge, ARightHomingHasNoFinding) {
  EXPECT_THAT(of(homed(), {home(20)}, with_switches()), IsEmpty());
  EXPECT_THAT(of(homed(0.25), {home(4)}, with_switches()), IsEmpty())
      << "the first index above the edge";
  Log down = enabled().in("homing").go(20, -500).go(20, 0).go(20, 500).go(2, 0);
  down.next.p += 7 - 0.1;
  down.next.homed = true;
  EXPECT_THAT(of(homed(0.05), {home(34)}, with_switches()), IsEmpty()) << "the first index upwards";
  Bounds on_index = with_switches();
  on_index.machine->index_offset = 0;
  for (const double found : {0.0, 0.2})
    EXPECT_THAT(of(homed(found), {home(34)}, on_index), IsEmpty()) << "it begins on an index";
  EXPECT_THAT(of(homed(0.4), {home(34)}, on_index),
              Contains(HasSubstr("a home position that is not")));
  EXPECT_THAT(of(down.be("standstill", 3), {home(19)}, with_switches()), IsEmpty())
      << "below the range";
}

TEST(LogJudge, FindsAHomeThatIsElsewhere) {
  const char* const elsewhere = "a home position that is not that of its method";
  EXPECT_THAT(of(homed(0.101), {home(20)}, with_switches()), Contains(HasSubstr(elsewhere)));
  EXPECT_THAT(of(homed(0.45), {home(4)}, with_switches()), Contains(HasSubstr(elsewhere)))
      << "the next index";
  EXPECT_THAT(of(homed(0.25), {home(34)}, with_switches()), Contains(HasSubstr(elsewhere)))
      << "the second index";
  EXPECT_THAT(of(homed(), {home(20, 7.5)}, with_switches()), Contains(HasSubstr(elsewhere)))
      << "another number";
  EXPECT_THAT(of(homed(), {home(22)}, with_switches()), Contains(HasSubstr(elsewhere)))
      << "the other edge";
}

TEST(LogJudge, FindsAHomingThatBreaksItsOwnLimits) {
  Accepted order = home(20);
  order.fastest = 9;
  EXPECT_THAT(of(homed(), {order}, with_switches()), Contains(HasSubstr("velocity of a homing")));
  order = home(20);
  order.acceleration = 400;
  EXPECT_THAT(of(homed(), {order}, with_switches()),
              Contains(HasSubstr("acceleration of a homing")));
  order = home(20);
  order.timeout = 0.05;
  EXPECT_THAT(of(homed(), {order}, with_switches()),
              Contains(HasSubstr("a homing after its timeout")));
}

TEST(LogJudge, FindsAHomingWithoutAnOrder) {
  EXPECT_THAT(of(homed(), ordered, with_switches()),
              Contains(HasSubstr("a homing without an order")));
  Log log = enabled();
  log.next.homed = true;
  EXPECT_THAT(of(log.be("standstill", 3), {}), Contains(HasSubstr("homed without a homing")));
  Log early = homed();
  early.rows[30].homed = true;
  EXPECT_THAT(of(early, {home(20)}, with_switches()), Contains(HasSubstr("homed during a search")));
}

TEST(LogJudge, FindsMotionBeyondALimitSwitch) {
  Bounds narrow = with_switches();
  narrow.machine->positive = 0.15;
  Log at_once = enabled().in("homing").go(20, 500).go(6, 0).go(20, -500).go(2, 0);
  EXPECT_THAT(of(at_once, {home(20)}, narrow), IsEmpty());
  Log on = enabled().in("homing").go(20, 500).go(120, 0).go(20, -500).go(2, 0);
  EXPECT_THAT(of(on, {home(20)}, narrow),
              Contains(HasSubstr("moves outwards beyond a limit switch")));
  Log jog = enabled().in("continuous_motion").go(20, 1000).go(100, 0);
  EXPECT_THAT(of(jog, ordered, narrow),
              Contains(HasSubstr("moves outwards beyond a limit switch")));
}

TEST(LogJudge, FindsAHomingThatDoesNotEndWithItsStop) {
  const std::vector<Accepted> stopped{home(20), at(29, What::stops)};
  Log right =
      enabled().in("homing").go(20, 500).go(4, 0).in("stopping").go(5, -2000).be("standstill", 20);
  EXPECT_THAT(of(right, stopped, with_switches()), IsEmpty());
  Log slow =
      enabled().in("homing").go(20, 500).go(4, 0).in("stopping").go(20, -500).be("standstill", 20);
  EXPECT_THAT(of(slow, stopped, with_switches()),
              Contains(HasSubstr("not at rest in the time of its stop")));
}

}  // namespace
}  // namespace jounce::test
