// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/cut_plan.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"

namespace jounce::cut_plan_test {
namespace {

using Status = CutAnswer::Status;

constexpr double pi = std::numbers::pi;

/// A drum of 300 mm around, 20 deg in step, in mm and rad.
RotaryKnifeSpec drum(bool dwell = true) {
  RotaryKnifeSpec spec{.diameter = 300 / pi, .cut_length = 300, .sync_angle = pi / 9};
  spec.dwell = dwell;
  return spec;
}

/// The shear of examples/flying-shear.
FlyingShear carriage() {
  FlyingShear spec{.cut_length = 1000, .line_speed = 1000, .sync_time = 0.15};
  spec.limits = {.velocity = 2000, .acceleration = 10000};
  return spec;
}

CutJob job_of(const CutMachine& machine, std::vector<double> lengths) {
  const bool shear = std::holds_alternative<FlyingShear>(machine);
  CutJob job{{machine, {.lengths = std::move(lengths)}}, {.speed = 1000}};
  job.line.slave = shear ? carriage().limits : Limits{.velocity = 80, .acceleration = 2000};
  return job;
}

std::shared_ptr<const CutTask> task_of(const CutMachine& machine, std::vector<double> lengths) {
  return std::make_shared<const CutTask>(job_of(machine, std::move(lengths)));
}

void expect_near(const Jet& a, const Jet& b, double scale) {
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(a[k], b[k], 1e-9 * scale * std::pow(10, -2.0 * static_cast<double>(k)));
}

// ---- the cutter against the cams of single pieces, which oracles have judged -----------------------

TEST(Cutter, LinkOfAKnifeIsItsCam) {
  for (const auto matching : {KnifeMatching::surface, KnifeMatching::horizontal})
    for (const double length : {120.0, 250.0, 300.0, 420.0, 600.0, 900.0}) {
      RotaryKnifeSpec spec = drum();
      spec.matching = matching;
      const Cutter cutter(spec);
      spec.cut_length = length;
      const Cam cam = rotary_knife(spec).cam;
      for (int i = 0; i <= 200 && cutter.links(length); ++i) {
        const double x = length * i / 200;
        expect_near(cutter.link(length, x), cam.jet(x, i == 200 ? Side::left : Side::right), 1);
      }
      EXPECT_EQ(cutter.links(length), length < figures(spec).longest);
    }
}

TEST(Cutter, LongPiecesOfAKnifeRestAtHome) {
  RotaryKnifeSpec spec = drum();
  spec.cut_length = 900;
  const Cutter cutter(spec);
  const Cam cam = rotary_knife(spec).cam;
  EXPECT_NEAR(cutter.approach() + cutter.retreat(), figures(spec).longest, 1e-9);
  for (double x = 0; x < 450; x += 7) {
    expect_near(cutter.retreat(x), cam.jet(x), 1);
    Jet back = cutter.approach(-x);
    back[0] += cutter.turn();
    expect_near(back, cam.jet(900 - x, Side::left), 1);
  }
}

TEST(Cutter, LinkOfAShearIsItsCam) {
  FlyingShear spec = carriage();
  const Cutter cutter(spec);
  for (const double length : {970.0, 1000.0, 1400.0}) {
    spec.cut_length = length;
    const Cam cam = flying_shear(spec).cam;
    for (double x = 0; x < length; x += 9.7)
      expect_near(cutter.link(length, x), cam.jet(cutter.approach() + x), 1000);
  }
  EXPECT_DOUBLE_EQ(cutter.approach(), 187.5);
  EXPECT_NEAR(cutter.shortest(), least_cut_length(spec).value, 1e-9);
}

// ---- the list as one cam ----------------------------------------------------------------------------

TEST(CutList, PassOfAKnifeAdvancesByOneTurnForEachPiece) {
  const SyncCam pass = cut_list({drum(), {.lengths = {120, 900, 250}, .waste = 80}});
  EXPECT_EQ(pass.cam.end(), 1350);
  EXPECT_EQ(pass.cam.advance(), 4 * drum().turn);
  double cut = 0;
  for (const double length : {120.0, 900.0, 250.0, 80.0}) {
    cut += length;
    EXPECT_NEAR(std::remainder(pass.cam.jet(cut, Side::left)[0], drum().turn), 0, 1e-12);
    EXPECT_NEAR(pass.cam.jet(cut, Side::left)[1], 2 * pi / 300, 1e-12);
  }
}

TEST(CutList, FirstCutBeginsAndEndsAtHome) {
  for (const CutMachine& machine : {CutMachine(drum()), CutMachine(carriage())}) {
    const SyncCam run = cut_list({machine, {.lengths = {1200, 1000}, .first = 600}});
    const Cutter cutter(machine);
    EXPECT_EQ(run.cam.jet(0)[1], 0);
    EXPECT_NEAR(run.cam.jet(0)[0], cutter.home() - cutter.turn(), 1e-12);
    EXPECT_NEAR(run.cam.jet(run.cam.end(), Side::left)[1], 0, 1e-9);
    EXPECT_NEAR(run.cam.end(), 600 + 2200 + cutter.retreat(), 1e-9);
    const double slope = cutter.turn() > 0 ? 2 * pi / 300 : 1;
    for (const double cut : {600.0, 1800.0, 2800.0})
      EXPECT_NEAR(run.cam.jet(cut + 1)[1], slope, 1e-12 * (1 + slope));
  }
}

TEST(CutList, RejectsPiecesThatNoCutterMakes) {
  EXPECT_EQ(test::error_of([] {
              (void)cut_list({drum(false), {.lengths = {300, 900}}});
            }).substr(0, 34),
            "lengths[2] = 900: must be at most ");
  EXPECT_EQ(test::error_of([] {
              (void)cut_list({carriage(), {.lengths = {1000, 500}}});
            }).substr(0, 35),
            "lengths[2] = 500: must be at least ");
  EXPECT_EQ(test::error_of([] {
              (void)cut_list({carriage(), {.lengths = {1000}, .first = 100}});
            }).substr(0, 40),
            "first = 100: must be at least 187.5, the");
}

// ---- possible lengths against closed forms ------------------------------------------------------------

/// Bounds of a knife with surface matching and the law 3-4-5, from equation (6) of
/// docs/gear/rotary-knife.md, for a line at constant speed v: the limits of the velocity and of the
/// acceleration, each solved for the recovery length b.
TEST(PossibleLengths, OfAKnifeAreRootsOfItsEquations) {
  const double g = 2 * pi / 300, sync = 300.0 / 18, h = 2 * pi - pi / 9, cv = 15.0 / 8;
  const double ca = 10 / std::sqrt(3);
  const Cutter cutter(drum());
  const std::vector<std::pair<double, double>> cases{{600, 80},  {1000, 80},  {1400, 80},
                                                     {600, 1e6}, {1400, 1e6}, {4335, 1e6}};
  for (const auto& [v, velocity] : cases) {
    const Limits most{.velocity = velocity, .acceleration = 2000};
    const auto ranges = possible_lengths(cutter, {.speed = v, .rates = {}, .slave = most});
    // Velocity: v (g + (h / b - g) cv) = most; acceleration: (h - g b) ca v^2 / b^2 = most.
    const double by_velocity = h * cv / (velocity / v + g * (cv - 1));
    const double k = *most.acceleration / (ca * v * v);
    const double by_acceleration = (-g + std::sqrt(g * g + 4 * k * h)) / (2 * k);
    ASSERT_FALSE(ranges.empty());
    EXPECT_NEAR(ranges.front().from, sync + std::max(by_velocity, by_acceleration), 1e-6) << v;
    EXPECT_TRUE(std::isinf(ranges.back().to));
    // Longer pieces: (g b - h) ca v^2 / b^2 exceeds the limit between two roots, if there are any.
    const double root = g * g - 4 * k * h;
    ASSERT_EQ(ranges.size(), v == 4335 ? 2U : 1U);
    EXPECT_EQ(root > 0, v == 4335);
    if (ranges.size() == 1) continue;
    EXPECT_NEAR(ranges[0].to, sync + (g - std::sqrt(root)) / (2 * k), 1e-4);
    EXPECT_NEAR(ranges[1].from, sync + (g + std::sqrt(root)) / (2 * k), 1e-4);
  }
}

TEST(PossibleLengths, RejectALineThatIsTooFastForTheWayFromHome) {
  const std::string error = test::error_of([] {
    (void)possible_lengths(Cutter(drum()), {.speed = 9000, .rates = {}, .slave = {.velocity = 80}});
  });
  EXPECT_EQ(error.substr(0, 38), "line_speed = 9000: must be at most 381") << error;
}

// ---- the plan, judged by its cuts ----------------------------------------------------------

/// Compares the slave with the web around each cut: there it moves at the speed of the web. `slope`: u
/// per m in step. Between cuts, checks the limits at the speed of the line.
struct Judge {
  double slope;
  double turn;
  double before;
  double after;
  double speed = 1000;
  Limits limits;
  std::vector<double> cuts = {};

  void see(double web, const Jet& y) const {
    EXPECT_LE(std::abs(y[1]) * speed, *limits.velocity * (1 + 1e-8)) << web;
    EXPECT_LE(std::abs(y[2]) * speed * speed, *limits.acceleration * (1 + 1e-8)) << web;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      if (web < cuts[i] - before || web > cuts[i] + after) continue;
      const double place = turn * static_cast<double>(i) + (turn > 0 ? 0 : 93.75);
      EXPECT_NEAR(y[0], place + slope * (web - cuts[i]), 1e-9 * std::max(1.0, slope * 1000)) << web;
      EXPECT_NEAR(y[1], slope, 1e-9) << web;
    }
  }
};

Judge judge_of(const CutMachine& machine) {
  const bool shear = std::holds_alternative<FlyingShear>(machine);
  return shear
             ? Judge{.slope = 1, .turn = 0, .before = 0, .after = 150, .limits = carriage().limits}
             : Judge{.slope = 2 * pi / 300,
                     .turn = 2 * pi,
                     .before = 300.0 / 36,
                     .after = 300.0 / 36,
                     .limits = {.velocity = 80, .acceleration = 2000}};
}

TEST(CutPlan, CutsTheListAndEveryChange) {
  for (const CutMachine& machine : {CutMachine(drum()), CutMachine(carriage())}) {
    const auto task = task_of(machine, {1000, 1200});
    CutPlan plan(task, 500);
    Judge judge = judge_of(machine);
    const double first = 500 + task->cutter.approach();
    // 1000, 1200, then 1500 from the third cut on; waste of 1100; a cut on demand 1010 after a cut.
    judge.cuts = {first, first + 1000, first + 2200};
    judge.cuts.push_back(judge.cuts.back() + 1500);
    judge.cuts.push_back(judge.cuts.back() + 1100);
    judge.cuts.push_back(judge.cuts.back() + 1010);
    judge.cuts.push_back(judge.cuts.back() + 1500);
    bool changed = false, wasted = false, demanded = false;
    Jet last = plan.at(500);
    for (double web = 500; web < judge.cuts.back() + 300; web += 0.7) {
      const Jet now = plan.at(web);
      EXPECT_NEAR(now[0], last[0] + 0.35 * (now[1] + last[1]), 1e-4 * (judge.turn > 0 ? 1 : 300));
      judge.see(web, now);
      last = now;
      if (!changed && plan.cuts() == 2) changed = bool(plan.set_length(1500));
      if (!wasted && plan.cuts() == 3) wasted = bool(plan.add_waste(1100));
      if (!demanded && plan.cuts() == 5) demanded = bool(plan.cut_at(judge.cuts[5]));
    }
    EXPECT_TRUE(changed && wasted && demanded);
    EXPECT_EQ(plan.cuts(), 7);
  }
}

TEST(CutPlan, NextPossibleCutIsTheBound) {
  // Every phase: at the bound, a cut is possible; a little earlier, it is rejected with the bound.
  for (const CutMachine& machine : {CutMachine(drum()), CutMachine(carriage())}) {
    const auto task = task_of(machine, {1600});
    for (double web = 0; web < 3000; web += 37) {
      CutPlan plan(task, 0);
      for (double x = 0; x < web; x += 1) (void)plan.at(x);
      (void)plan.at(web);
      const double bound = plan.next_possible();
      const bool is_knife = task->cutter.turn() > 0;
      const double from_home = is_knife ? figures(drum()).longest / 2 : 187.5;
      const double to_home = is_knife ? from_home : 966.42464345 - 187.5;
      if (plan.phase() == CutPlan::Phase::home) {
        EXPECT_NEAR(bound, web + from_home, 1e-6);
      }
      if (plan.phase() == CutPlan::Phase::retreat) {
        EXPECT_NEAR(bound, plan.last_cut() + to_home + from_home, 1e-6);
      }
      const double least = is_knife ? task->possible.front().from : 966.42464345;
      if (plan.phase() == CutPlan::Phase::cut) {
        EXPECT_NEAR(bound, plan.last_cut() + least, 1e-6);
      }
      CutPlan early = plan;
      const CutAnswer no = early.cut_at(bound - 1e-3);
      EXPECT_EQ(no.status, Status::position) << web;
      EXPECT_EQ(no.limit, bound);
      EXPECT_TRUE(plan.cut_at(bound)) << web;
      Judge judge = judge_of(machine);
      std::vector<double>& cuts = judge.cuts;
      if (plan.cuts() > 0) cuts.push_back(task->cutter.approach());
      for (int i = 1; i < plan.cuts(); ++i) cuts.push_back(cuts.back() + 1600);
      const bool fixed =
          plan.phase() == CutPlan::Phase::approach || plan.phase() == CutPlan::Phase::link;
      if (fixed) cuts.push_back(plan.next_cut());
      cuts.push_back(bound);
      for (double x = web; x < bound + 10; x += 1) judge.see(x, plan.at(x));
      EXPECT_EQ(plan.last_cut(), bound) << web;
    }
  }
}

TEST(CutPlan, DemandSeveralPiecesAhead) {
  const auto task = task_of(carriage(), {1000});
  CutPlan plan(task, 0);
  (void)plan.at(0);
  EXPECT_EQ(plan.cut_at(187.5 + 3000 + 500).status, Status::position) << "too short a piece";
  EXPECT_NEAR(plan.cut_at(187.5 + 3000 + 500).limit, 187.5 + 3000 + 966.425, 1e-3);
  EXPECT_TRUE(plan.cut_at(187.5 + 3000 + 980));
  EXPECT_EQ(plan.set_length(1200).status, Status::pending) << "a piece of 380 would end there";
  EXPECT_EQ(plan.add_waste(1200).status, Status::pending);
  for (double x = 0; x < 4300; x += 1) (void)plan.at(x);
  EXPECT_EQ(plan.last_cut(), 187.5 + 3980);
  EXPECT_EQ(plan.next_cut(), 187.5 + 4980) << "the length of the piece that the demand cut short";
}

TEST(CutPlan, PlaysTheCamOfItsList) {
  const std::vector<std::pair<CutMachine, std::vector<double>>> cases{{drum(), {200, 400, 900}},
                                                                      {carriage(), {1000, 1300}}};
  for (const auto& [machine, lengths] : cases) {
    CutListSpec spec{machine, {.lengths = lengths, .first = 700}};
    CutJob job = job_of(machine, lengths);
    job.spec = spec;
    CutPlan plan(std::make_shared<const CutTask>(job), 0);
    const Cam cam = cut_list(spec).cam;
    double end = 700;
    for (const double length : lengths) end += length;
    for (double x = 0; x < end; x += 0.9) {
      const Jet now = plan.at(x);
      expect_near(now, cam.jet(x), judge_of(machine).turn > 0 ? 1 : 1000);
    }
  }
}

TEST(CutPlan, DemandRepeatsTheLengthThatItInterrupts) {
  for (const double demand : {187.5 + 970.0, 187.5 + 1000 + 975.0}) {
    CutPlan plan(task_of(carriage(), {1000, 1200, 1400}), 0);
    for (double x = 0; x < 250; x += 1) (void)plan.at(x);  // after the first cut
    EXPECT_TRUE(plan.cut_at(demand));
    std::vector<double> cuts;
    for (double x = 250; cuts.size() < 6; x += 1) {
      const auto made = plan.cuts();
      (void)plan.at(x);
      if (plan.cuts() > made) cuts.push_back(plan.last_cut());
    }
    std::vector<double> expected{187.5};
    for (const double length : {1000.0, 1200.0, 1400.0, 1000.0, 1200.0, 1400.0}) {
      if (demand > expected.back() && demand < expected.back() + length) expected.push_back(demand);
      expected.push_back(expected.back() + length);
    }
    for (std::size_t i = 0; i < cuts.size(); ++i) EXPECT_NEAR(cuts[i], expected[i + 1], 1e-9) << i;
  }
}

TEST(CutPlan, RejectsWithTheBound) {
  CutPlan plan(task_of(carriage(), {1000}), 0);
  const CutAnswer no = plan.set_length(500);
  EXPECT_EQ(no.status, Status::length);
  EXPECT_NEAR(no.limit, 966.42464345, 1e-6);
  EXPECT_EQ(plan.cut_at(-200).status, Status::position) << "in the past";
  EXPECT_EQ(plan.set_length(-1).status, Status::length);
}

TEST(CutPlan, CutNowUnlessAPlannedCutComesFirst) {
  CutPlan plan(task_of(carriage(), {5000}), 0);
  for (double x = 0; x < 200; x += 1) (void)plan.at(x);
  ASSERT_EQ(plan.phase(), CutPlan::Phase::cut);
  EXPECT_TRUE(plan.cut_now());
  EXPECT_NEAR(plan.next_cut(), 187.5 + 966.42464345, 1e-6);
  EXPECT_TRUE(plan.cut_now()) << "the planned cut is the next one";
  for (double x = 200; x < 1400; x += 1) (void)plan.at(x);
  EXPECT_EQ(plan.cuts(), 2);
}

TEST(CutPlan, ACutOnDemandReplacesTheOneThatWaits) {
  // The demand is 1 above the next possible cut of its piece. It is the planned cut from 1187.5 on.
  const double earliest = 1187.5 + 966.42464345;
  for (const double asked : {1100.0, 1200.0}) {  // before and after it becomes the planned cut
    CutPlan plan(task_of(carriage(), {1000}), 0);
    for (double x = 0; x < asked; x += 1) (void)plan.at(x);
    EXPECT_TRUE(plan.cut_at(earliest + 1));
    for (double x = asked; x < 1210; x += 1) (void)plan.at(x);
    ASSERT_EQ(plan.phase(), CutPlan::Phase::cut);
    EXPECT_TRUE(plan.cut_at(earliest + 0.5));
    EXPECT_EQ(plan.next_cut(), earliest + 0.5);
    EXPECT_TRUE(plan.cut_now());
    EXPECT_NEAR(plan.next_cut(), earliest, 1e-6);
    for (double x = 1210; x < 2200; x += 1) (void)plan.at(x);
    EXPECT_NEAR(plan.last_cut(), earliest, 1e-6);
    EXPECT_NEAR(plan.next_cut(), earliest + 1000, 1e-6) << "no other cut on demand is left";
  }
}

TEST(CutPlan, ADemandThatWaitsIsMovedOrCancelled) {
  CutPlan plan(task_of(carriage(), {1000}), 0);
  for (double x = 0; x < 200; x += 1) (void)plan.at(x);
  EXPECT_TRUE(plan.cut_at(187.5 + 5980));
  EXPECT_TRUE(plan.cut_at(187.5 + 3980)) << "a later command moves it";
  EXPECT_TRUE(plan.set_length(1990)) << "this length leaves a piece of 1990 there";
  EXPECT_TRUE(plan.set_length(1000));
  EXPECT_TRUE(plan.cut_at(187.5 + 4000)) << "a planned cut: nothing waits any more";
  for (double x = 200; x < 6300; x += 1) {
    const auto made = plan.cuts();
    (void)plan.at(x);
    if (plan.cuts() > made) {
      EXPECT_NEAR(std::remainder(plan.last_cut() - 187.5, 1000), 0, 1e-9) << x;
    }
  }
}

TEST(CutPlan, ADemandIsAtMostAThousandPiecesAhead) {
  CutPlan plan(task_of(carriage(), {1000}), 0);
  for (double x = 0; x < 200; x += 1) (void)plan.at(x);
  const double last = 1187.5 + 1000.0 * CutPlan::most_planned;
  EXPECT_TRUE(plan.cut_at(last - 20));
  const CutAnswer far = plan.cut_at(1e9);
  EXPECT_EQ(far.status, Status::far);
  EXPECT_EQ(far.limit, last);
  EXPECT_TRUE(plan.cut_at(last));
  EXPECT_TRUE(plan.cut_now()) << "nothing blocks the next cuts";
  EXPECT_TRUE(plan.set_length(1200));
}

TEST(CutPlan, WebThatMovesBackPassesNoCutTwice) {
  for (const CutMachine& machine : {CutMachine(drum()), CutMachine(carriage())}) {
    CutPlan plan(task_of(machine, {1000}), 0);
    std::vector<Jet> out;
    for (int x = 0; x <= 1500; ++x) out.push_back(plan.at(x));
    const auto cuts = plan.cuts();
    for (int x = 1500; x > 900; --x)
      EXPECT_NEAR(plan.at(x)[0], out[static_cast<std::size_t>(x)][0], 1e-9) << x;
    for (int x = 900; x <= 1500; ++x) (void)plan.at(x);
    EXPECT_EQ(plan.cuts(), cuts);
    EXPECT_FALSE(plan.lost());
  }
  CutPlan plan(task_of(drum(), {200}), 0);  // links
  for (int x = 0; x <= 1500; ++x) (void)plan.at(x);
  for (int x = 1500; x > 1000; --x) (void)plan.at(x);
  EXPECT_TRUE(plan.lost());
}

TEST(CutNumbers, AreTheWholeJob) {
  CutJob job = job_of(drum(), {300, 400});
  job.spec.list.first = 700;
  job.line.rates.acceleration = 12;
  const std::vector<double> numbers = numbers_of(job);
  EXPECT_EQ(numbers_of(cut_job_of(numbers)), numbers);
  job = job_of(carriage(), {1000});
  auto& shear = std::get<FlyingShear>(job.spec.machine);
  shear.return_law = Law::triple_harmonic;
  shear.return_form.harmonics = {7.5, -0.25};
  const CutJob again = cut_job_of(numbers_of(job));
  EXPECT_EQ(numbers_of(again), numbers_of(job));
  const auto& read = std::get<FlyingShear>(again.spec.machine);
  EXPECT_EQ(read.return_law, Law::triple_harmonic);
  EXPECT_EQ(read.return_form.harmonics, shear.return_form.harmonics);
  EXPECT_EQ(again.spec.list.lengths, job.spec.list.lengths);
  EXPECT_THROW((void)cut_job_of(std::vector<double>{0, 1}), InputError);
  // A damaged record, each number in turn: the answer is a task or an InputError.
  for (const CutMachine& machine : {CutMachine(drum()), CutMachine(carriage())}) {
    const std::vector<double> good = numbers_of(job_of(machine, {1000}));
    for (std::size_t i = 0; i < good.size(); ++i)
      for (const double bad : {-1e300, 1e300, 0.5, -1.0}) {
        std::vector<double> damaged = good;
        damaged[i] = bad;
        try {
          (void)CutTask(cut_job_of(damaged));
        } catch (const InputError&) {  // the expected answer to most of them
        }
      }
  }
}

}  // namespace
}  // namespace jounce::cut_plan_test
