// SPDX-License-Identifier: Apache-2.0
// A plan of cuts on an axis: its log, judged by the positions of the cuts on the web, the speed of the
// web in the sync zones, and the limits of the axis.
#include "jounce/axis/detail/live_cuts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "axis/bench.hpp"

namespace jounce::live_cuts_test {
namespace {

using test::Bench;
using test::refusal;

constexpr double pi = std::numbers::pi;
constexpr double dt = 1e-3;

/// A line that accelerates from rest with `a` to `v`.
Jet line_at(double t, double v, double a) {
  const double ramp = v / a;
  if (t < ramp) return {a * t * t / 2, a * t, a, 0};
  return {v * ramp / 2 + v * (t - ramp), v, 0, 0};
}

struct Machine {
  CutMachine cutter;
  AxisConfig config;
  double slope;  // slope of the slave in step, u/m
  double after;  // web in step after a cut, m
  double turn;   // turn of a knife from cut to cut, u; 0: a shear
};

/// A shear with a margin for the acceleration of its line, 1 m/s^2.
Machine shear() {
  FlyingShear spec{.cut_length = 1000, .line_speed = 1000, .sync_time = 0.15};
  spec.return_length = 520;
  spec.safety = 1.4;
  spec.limits = {.velocity = 2000, .acceleration = 10000};
  return {spec, {.limits = test::limits(2000, 10000)}, 1, 150, 0};
}

/// A drum of 300 mm around, in rad.
Machine knife() {
  RotaryKnifeSpec spec{.diameter = 300 / pi, .cut_length = 300, .sync_angle = pi / 9};
  spec.dwell = true;
  return {
      spec, {.limits = test::limits(80, 2500), .position = -pi}, 2 * pi / 300, 300.0 / 36, 2 * pi};
}

std::shared_ptr<const CutTask> task_of(const Machine& machine, CutList list) {
  CutJob job{{machine.cutter, std::move(list)}, {.speed = 1000}};
  job.line.rates.acceleration = 1000;
  job.line.slave = machine.config.limits;
  return std::make_shared<const CutTask>(job);
}

struct Row {
  double web, web_velocity;
  Tick tick;
};

/// An axis behind a line, from its first tick on.
struct Site {
  explicit Site(const Machine& machine, CutList list)
      : machine(machine),
        task(task_of(machine, std::move(list))),
        cuts(1, task, machine.config),
        bench(machine.config) {}

  Tick step(const Command& command = {}) {
    const Jet web = line(static_cast<double>(bench.tick + 1) * dt);
    Inputs inputs{.master = web};
    Triggers& triggers = inputs.feedback.triggers;
    for (const double mark : marks)
      if (!log.empty() && log.back().web < mark && mark <= web[0])
        triggers.change[triggers.count++] = {.input = 1, .rising = true};
    const Tick tick = bench.step(command, inputs);
    log.push_back({web[0], web[1], tick});
    return tick;
  }
  void start() {
    step({command::Enable{}});
    EXPECT_EQ(refusal(step({command::Couple{&cuts}})), Cause::none);
  }
  Tick run(int ticks) {
    Tick last;
    for (int i = 0; i < ticks; ++i) last = step();
    return last;
  }
  Tick until(const std::function<bool()>& done) {
    Tick last;
    for (int i = 0; i < 20'000 && !done(); ++i) last = step();
    EXPECT_TRUE(done());
    return last;
  }

  Machine machine;
  std::shared_ptr<const CutTask> task;
  LiveCuts cuts;
  Bench bench;
  std::function<Jet(double)> line = [](double t) { return line_at(t, 1000, 1000); };
  std::vector<double> marks;  // positions of print marks on the web, which a sensor reports
  std::vector<Row> log;
};

/// Judges a log: in step around each cut, within the limits everywhere, without a step.
void judge(const Site& site, const std::vector<double>& cuts) {
  const Limits& most = site.machine.config.limits;
  std::size_t seen = 0;
  std::optional<double> shear_place;
  for (std::size_t i = 1; i < site.log.size(); ++i) {
    const auto& [web, speed, now] = site.log[i];
    const Tick& last = site.log[i - 1].tick;
    ASSERT_EQ(now.fault, Cause::none) << web;
    EXPECT_LE(std::abs(now.velocity), *most.velocity * (1 + 1e-9)) << web;
    EXPECT_LE(std::abs(now.acceleration), *most.acceleration * (1 + 1e-9)) << web;
    EXPECT_NEAR(now.position - last.position, dt / 2 * (now.velocity + last.velocity),
                *most.acceleration * dt * dt)
        << web;
    EXPECT_LE(std::abs(now.velocity - last.velocity), *most.acceleration * dt * (1 + 1e-9)) << web;
    for (const double cut : cuts) {
      if (web < cut || web > cut + site.machine.after) continue;
      ++seen;
      EXPECT_NEAR(now.velocity, site.machine.slope * speed, 1e-8 * *most.velocity) << web;
      // A blade points down at the cut; a shear is in the same place at every cut.
      const double place = now.position - site.machine.slope * (web - cut);
      if (site.machine.turn == 0 && !shear_place) shear_place = place;
      const double away =
          shear_place ? place - *shear_place : std::remainder(place, site.machine.turn);
      EXPECT_NEAR(away, 0, 1e-8) << web;
    }
  }
  if (!cuts.empty()) {
    EXPECT_GT(seen, 5 * cuts.size()) << "the log passes the cuts";
  }
}

TEST(LiveCuts, LengthsChangeWhileTheLineAccelerates) {
  for (const Machine& machine : {shear(), knife()}) {
    Site site(machine, {.lengths = {1200, 1300}});
    const LiveCuts& cuts = site.cuts;
    site.start();
    const double first = cuts.plan().next_cut();
    site.until([&] { return cuts.plan().cuts() == 1; });
    ASSERT_LT(site.log.back().web_velocity, 1000) << "the line accelerates";
    EXPECT_EQ(refusal(site.step({command::Cut{.length = 1500}})), Cause::none);
    site.until([&] { return cuts.plan().cuts() == 3; });
    EXPECT_EQ(refusal(site.step({command::Cut{.waste = 1250}})), Cause::none);
    site.until([&] { return cuts.plan().cuts() == 5; });
    const double fifth = cuts.plan().last_cut();
    EXPECT_EQ(refusal(site.step({command::Cut{.position = fifth + 1210}})), Cause::none);
    site.until([&] { return cuts.plan().cuts() == 7; });
    judge(site, {first, first + 1200, first + 2700, first + 4200, first + 5450, fifth + 1210,
                 fifth + 2710});
    EXPECT_NEAR(fifth, first + 5450, 1e-9);
    EXPECT_NEAR(cuts.plan().last_cut(), fifth + 2710, 1e-9);
  }
}

TEST(LiveCuts, ParkLeavesTheWebAfterTheSyncZoneAndEndsAtHome) {
  for (const Machine& machine : {shear(), knife()})
    for (int wait = 0; wait < 1400; wait += 35) {
      Site site(machine, {.lengths = {1300}});
      site.start();
      site.run(600 + wait);
      const double next = site.cuts.plan().next_cut();
      const double last_cut = site.cuts.plan().last_cut();
      const std::int64_t made = site.cuts.plan().cuts();
      EXPECT_EQ(refusal(site.step({command::Park{}})), Cause::none);
      site.until([&] { return site.bench.axis.state() == State::standstill; });
      const Tick& end = site.log.back().tick;
      const double turn = site.task->cutter.turn();
      const double home = turn > 0 ? std::remainder(end.position - turn / 2, turn) : end.position;
      EXPECT_NEAR(home, 0, 1e-9) << wait;
      EXPECT_EQ(end.reason, Cause::none);
      std::vector<double> cuts;
      for (double cut = last_cut; made > 0 && cut > 0; cut -= 1300) cuts.push_back(cut);
      if (site.cuts.plan().cuts() > made) cuts.push_back(next);
      ASSERT_LE(site.cuts.plan().cuts(), made + 1);
      judge(site, cuts);
    }
}

TEST(LiveCuts, ParkIsFasterThanTheWayBehindTheWeb) {
  Site site(shear(), {.lengths = {1300}});
  site.start();
  site.until([&] { return site.cuts.plan().cuts() == 2; });
  site.step({command::Park{}});
  site.line = [t0 = static_cast<double>(site.bench.tick) * dt](double t) {
    return line_at(std::min(t, t0 + 0.2), 1000, 1000);  // the web stops later than its sync zone
  };
  site.run(2000);
  EXPECT_EQ(site.bench.axis.state(), State::standstill);
  EXPECT_EQ(site.log.back().tick.position, 0);
}

TEST(LiveCuts, RejectionsHaveTheirNumbers) {
  Site site(shear(), {.lengths = {1300}});
  EXPECT_EQ(refusal(site.step({command::Cut{}})), Cause::not_enabled);
  site.step({command::Enable{}});
  EXPECT_EQ(refusal(site.step({command::Cut{.length = 1300}})), Cause::no_cut_plan);
  EXPECT_EQ(refusal(site.step({command::Park{}})), Cause::no_cut_plan);
  EXPECT_EQ(refusal(site.step({command::Couple{&site.cuts}})), Cause::none);
  site.until([&] { return site.cuts.plan().cuts() == 1; });
  const double cut = site.cuts.plan().last_cut();
  const double least = site.task->possible.front().from;

  Tick tick = site.step({command::Cut{.length = 900}});
  ASSERT_EQ(refusal(tick), Cause::cut_length);
  EXPECT_EQ(tick.refused->value, 900);
  EXPECT_EQ(tick.refused->limit, least);
  tick = site.step({command::Cut{.position = cut - 400}});  // in the past
  ASSERT_EQ(refusal(tick), Cause::cut_position);
  EXPECT_EQ(tick.refused->limit, cut + least);
  tick = site.step({command::Cut{.position = cut + 20}});  // while a cut runs
  ASSERT_EQ(refusal(tick), Cause::cut_position);
  EXPECT_EQ(tick.refused->value, cut + 20);
  EXPECT_EQ(tick.refused->limit, cut + least);
  EXPECT_EQ(refusal(site.step({command::Cut{.length = 1300, .waste = 1300}})), Cause::no_value);
  EXPECT_EQ(refusal(site.step({command::Cut{.position = cut + 3 * 1300}})), Cause::none);
  EXPECT_EQ(refusal(site.step({command::Cut{.position = cut + 3 * 1300 + 1200}})), Cause::none);
  tick = site.step({command::Cut{.length = 1500}});  // a piece of 800 would end at that cut
  ASSERT_EQ(refusal(tick), Cause::cut_pending);
  EXPECT_EQ(tick.refused->limit, cut + 3 * 1300 + 1200);
  tick = site.step({command::Cut{.position = 1e9}});
  ASSERT_EQ(refusal(tick), Cause::cut_too_far);
  EXPECT_EQ(tick.refused->value, 1e9);
  EXPECT_NEAR(tick.refused->limit, cut + 1300 * 1002, 1300);
  EXPECT_EQ(refusal(site.step({command::Cut{.position = cut + 9000}})), Cause::none)
      << "it replaces the cut that waits";
  EXPECT_EQ(refusal(site.step({command::Cut{.length = 1600}})), Cause::none)
      << "a piece of 1300 ends at that cut";
  EXPECT_EQ(refusal(site.step({command::Park{}})), Cause::none);
  EXPECT_EQ(refusal(site.step({command::Cut{.length = 1300}})), Cause::no_cut_plan);
}

TEST(LiveCuts, NoShiftMovesTheCutterAgainstTheWeb) {
  for (const Machine& machine : {shear(), knife()}) {
    Site site(machine, {.lengths = {1300}});
    site.start();
    site.until([&] { return site.cuts.plan().cuts() == 1; });
    const double first = site.cuts.plan().last_cut();
    for (int i = 0; i < 40; ++i) {
      const double by = i % 2 == 0 ? 0.5 : -40;
      EXPECT_EQ(refusal(site.step({command::PhasingRelative{by, {}}})), Cause::in_cut_plan);
      EXPECT_EQ(refusal(site.step({command::PhasingAbsolute{by, {.velocity = 1}}})),
                Cause::in_cut_plan);
      EXPECT_EQ(refusal(site.step({command::MoveSuperimposed{by, {}}})), Cause::in_cut_plan);
      site.run(30);
    }
    // The remedy: one piece is 10 mm longer, and all later cuts move by 10 mm.
    const double next = site.cuts.plan().next_cut();
    EXPECT_EQ(refusal(site.step({command::Cut{.waste = 1310}})), Cause::none);
    site.until([&] { return site.cuts.plan().last_cut() > next + 3900; });
    std::vector<double> cuts{next + 1310, next + 2610, next + 3910};
    for (double cut = next; cut > first - 1; cut -= 1300) cuts.push_back(cut);
    judge(site, cuts);
  }
}

// Marks that drift by 3 mm, and a window of the correction in the sync zone. The machine file rejects this
// pair (registration_play_test.cpp).
TEST(LiveCuts, RegistrationDoesNotMoveTheCutterAgainstTheWeb) {
  for (Machine machine : {shear(), knife()})
    for (const CorrectionOf side : {CorrectionOf::master, CorrectionOf::slave}) {
      const double first = Cutter(machine.cutter).approach();
      const double unit = side == CorrectionOf::slave ? machine.slope : 1;
      LiveRegistrationSpec spec{.period = 1300, .mark = first - 100, .window = 5, .search = 60};
      spec.correction = {.window_from = first - 50, .window_length = 100, .most = 2 * unit};
      spec.add_to = side;
      spec.ratio = unit;
      spec.on_loss = MarkLoss::hold;
      machine.config.registration = spec;
      Site site(machine, {.lengths = {1300}});
      std::vector<double> cuts;
      for (int k = 0; k < 6; ++k) site.marks.push_back(first - 100 + 1300 * k + 3 * (k + 1));
      site.start();
      for (int k = 0; k < 6; ++k) cuts.push_back(site.cuts.plan().next_cut() + 1300 * k);
      site.until([&] { return site.cuts.plan().cuts() == 6; });
      judge(site, cuts);
      EXPECT_EQ(site.log.back().tick.registration.correction, 0);
    }
}

TEST(LiveCuts, LineAtRestOrBackwards) {
  Site site(shear(), {.lengths = {1300}, .first = 2000});
  site.line = [](double) { return Jet{500, 0, 0, 0}; };
  site.start();
  site.run(10);
  EXPECT_EQ(refusal(site.step({command::Cut{}})), Cause::web_stands);
  EXPECT_EQ(refusal(site.step({command::Cut{.position = 1500}})), Cause::none) << "a position";
  site.line = [](double t) { return Jet{500 - 100 * t, -100, 0, 0}; };
  site.run(10);
  EXPECT_EQ(refusal(site.step({command::Cut{}})), Cause::web_stands);
  EXPECT_EQ(site.run(1000).fault, Cause::none) << "at home, the web may move back";
}

TEST(LiveCuts, WebThatMovesBackTooFarIsAFault) {
  Site site(knife(), {.lengths = {200}});
  site.line = [](double t) { return line_at(t, 300, 1000); };
  site.start();
  site.until([&] { return site.cuts.plan().cuts() == 4; });
  const double turned = site.log.back().web;
  const double t0 = static_cast<double>(site.bench.tick) * dt;
  site.line = [=](double t) {
    const double s = t - t0;  // brakes to rest, and moves back
    const double v = std::max(300 - 1000 * s, -300.0);
    const double brake = std::min(s, 0.6);
    return Jet{turned + 300 * brake - 500 * brake * brake - 300 * std::max(s - 0.6, 0.0), v,
               v > -300 ? -1000.0 : 0.0, 0};
  };
  EXPECT_EQ(site.run(3000).fault, Cause::master_reversed);
}

TEST(LiveCuts, BeginsAtHomeOnly) {
  Machine machine = knife();
  machine.config.position = 0.5;
  Site site(machine, {.lengths = {300}});
  site.step({command::Enable{}});
  const Tick tick = site.step({command::Couple{&site.cuts}});
  const auto& no = tick.refused ? tick.refused : tick.dropped;
  ASSERT_TRUE(no.has_value());
  EXPECT_EQ(no->cause, Cause::cutter_away);
  EXPECT_NEAR(no->value, pi, 1e-12) << "the nearest home position";
  EXPECT_EQ(no->limit, 0.5);
}

TEST(LiveCuts, RenamedMasterShiftsItsPositions) {
  Site site(shear(), {.lengths = {1300}});
  site.start();
  site.until([&] { return site.cuts.plan().cuts() == 1; });
  const double cut = site.cuts.plan().last_cut();
  const Jet web = site.line(static_cast<double>(site.bench.tick + 1) * dt);
  const Tick tick =
      site.bench.step({command::Cut{.position = cut + 10'000 + 100}},
                      {.master = {web[0] + 10'000, web[1], web[2], 0}, .master_offset = 10'000});
  ASSERT_EQ(refusal(tick), Cause::cut_position);
  EXPECT_NEAR(tick.refused->limit, cut + 10'000 + site.task->possible.front().from, 1e-9);
}

}  // namespace
}  // namespace jounce::live_cuts_test
