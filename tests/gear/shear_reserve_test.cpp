// SPDX-License-Identifier: Apache-2.0
// A shear behind a line that changes its speed, against sampled accelerations: s'' v^2 + s' a.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/gear/cut_plan.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::shear_reserve_test {
namespace {

using ::testing::StartsWith;

constexpr double most_velocity = 2000;
constexpr double most_acceleration = 10000;

/// A shear with the law 3-4-5 in ramps and return, in mm and s, without a return_length.
FlyingShear carriage(double speed, double safety) {
  FlyingShear spec{.cut_length = 3000, .line_speed = speed, .sync_time = 0.15};
  spec.safety = safety;
  spec.limits = {.velocity = most_velocity, .acceleration = most_acceleration};
  return spec;
}

CutJob job_of(const FlyingShear& shear, double line_acceleration,
              std::vector<double> lengths = {2500, 3000}) {
  CutJob job{{shear, {.lengths = std::move(lengths)}}, {.speed = shear.line_speed}};
  job.line.rates.acceleration = line_acceleration;
  job.line.slave = shear.limits;
  return job;
}

/// The greatest velocity and acceleration of a return over `length`, of the whole stroke S, relative to
/// their limits: from the derivatives of 10 u^3 - 15 u^4 + 6 u^5 at many places.
double use_of_limits(double stroke, double length, double v, double a) {
  double most = 0;
  constexpr int places = 20'000;
  for (int i = 0; i <= places; ++i) {
    const double u = static_cast<double>(i) / places;
    const double f1 = 30 * u * u * (1 - u) * (1 - u);
    const double f2 = std::abs(60 * u * (1 - u) * (1 - 2 * u));
    most = std::max(
        {most, stroke / length * f1 * v / most_velocity,
         (stroke / (length * length) * f2 * v * v + stroke / length * f1 * a) / most_acceleration});
  }
  return most;
}

double least_return(double stroke, double v, double a) {
  double low = 1, high = 1e5;
  while (high - low > 1e-9 * high) {
    const double middle = (low + high) / 2;
    (use_of_limits(stroke, middle, v, a) > 1 ? low : high) = middle;
  }
  return high;
}

TEST(ShearReserve, TheWayHomeLeavesWhatTheAccelerationOfTheLineNeeds) {
  for (const double v : {50.0, 450.0, 1000.0})
    for (const double a : {500.0, 1500.0}) {
      const FlyingShear shear = carriage(v, 1.3);
      const CutTask task(job_of(shear, a));
      const double ramp = 1.3 * 1.875 * v * v / most_acceleration;
      const double sync = 0.15 * v;
      const double back = least_return(ramp + sync, v, a);
      EXPECT_NEAR(task.cutter.retreat(), sync + ramp + back, 1e-6 * back) << v << ' ' << a;
      EXPECT_NEAR(task.possible.front().from, sync + 2 * ramp + back, 1e-6 * back);
      EXPECT_GT(back, least_return(ramp + sync, v, 0) * 1.01) << "longer than at constant speed";
    }
}

TEST(ShearReserve, EveryPieceKeepsTheLimitsWhileTheLineChangesItsSpeed) {
  const double v = 1000, a = 1500;
  const FlyingShear shear = carriage(v, 1.3);
  const double shortest = CutTask(job_of(shear, a)).possible.front().from;
  CutPlan plan(std::make_shared<const CutTask>(job_of(shear, a, {shortest, 1500, shortest})), 0);
  double hardest = 0;
  for (double x = 0; x < 9000; x += 0.25) {
    if (x == 8000) plan.finish();
    const Jet s = plan.at(x);
    ASSERT_LE(std::abs(s[1]) * v, most_velocity * (1 + 1e-9)) << x;
    for (const double change : {-a, 0.0, a})
      hardest = std::max(hardest, std::abs(s[2] * v * v + s[1] * change));
  }
  EXPECT_LE(hardest, most_acceleration * (1 + 1e-9));
  EXPECT_GT(hardest, 0.999 * most_acceleration) << "the shortest piece uses the limit";
  EXPECT_EQ(plan.phase(), CutPlan::Phase::home);
}

// `check` judges this cam without a tolerance.
TEST(ShearReserve, TheCamOfAListPermitsTheSpeedOfItsLine) {
  for (const double v : {50.0, 450.0, 1000.0})
    for (const double a : {500.0, 1500.0}) {
      const FlyingShear shear = carriage(v, 1.3);
      const SyncCam run = cut_list(
          {shear, {.lengths = {1500}, .first = 900}, {v, {.acceleration = a}, shear.limits}});
      EXPECT_GE(greatest_master_velocity(run.cam, shear.limits, {.acceleration = a}).value, v);
    }
}

TEST(ShearReserve, WithoutAccelerationOrWithALengthTheWayHomeIsUnchanged) {
  const FlyingShear shear = carriage(1000, 1.3);
  const CutLine constant{.speed = 1000, .rates = {}, .slave = shear.limits};
  EXPECT_EQ(Cutter(shear, constant).retreat(), Cutter(shear).retreat());
  FlyingShear given = shear;
  given.return_length = 900;
  const CutLine changes{.speed = 1000, .rates = {.acceleration = 1500}, .slave = shear.limits};
  EXPECT_EQ(Cutter(given, changes).retreat(), Cutter(given).retreat());
  CutLine slower = changes;  // at half the speed, the way home for 1000 mm/s has enough reserve
  slower.speed = 500;
  EXPECT_EQ(Cutter(shear, slower).retreat(), Cutter(shear).retreat());
}

/// The key and the least value in the error of a job.
struct Advice {
  std::string key;
  double least = 0;
  std::string rule;
};

Advice advice_for(const CutJob& job) {
  try {
    (void)CutTask(job);
  } catch (const InputError& error) {
    const std::string begin = "must be at least ";
    const bool has_number = error.rule().starts_with(begin);
    return {error.key(), has_number ? std::stod(error.rule().substr(begin.size())) : 0,
            error.rule()};
  }
  return {};
}

// Each remedy is tried: its number is accepted, and a number that is a little smaller is not.
TEST(ShearReserve, TheErrorHasTheNumberThatRepairsTheSpec) {
  const auto expect_repair = [](const char* key, const FlyingShear& shear, const auto& set) {
    const Advice advice = advice_for(job_of(shear, 1500));
    ASSERT_EQ(advice.key, key) << advice.rule;
    FlyingShear repaired = shear;
    set(repaired, advice.least);
    EXPECT_EQ(advice_for(job_of(repaired, 1500)).rule, "");
    set(repaired, advice.least * (1 - 2e-5));
    EXPECT_EQ(advice_for(job_of(repaired, 1500)).key, key);
  };
  FlyingShear shear = carriage(1000, 1.05);
  expect_repair("safety", shear, [](FlyingShear& s, double x) { s.safety = x; });
  shear.acceleration_length = 190;
  shear.deceleration_length = 300;
  expect_repair("acceleration_length", shear,
                [](FlyingShear& s, double x) { s.acceleration_length = x; });
  shear.acceleration_length = 300;
  shear.deceleration_length = 190;
  expect_repair("deceleration_length", shear,
                [](FlyingShear& s, double x) { s.deceleration_length = x; });
  shear.deceleration_length = 300;
  shear.return_length = 510;
  expect_repair("return_length", shear, [](FlyingShear& s, double x) { s.return_length = x; });
}

TEST(ShearReserve, NoLengthRepairsALineThatAcceleratesMoreThanTheSlave) {
  const Advice advice = advice_for(job_of(carriage(1000, 1.3), 12000));
  EXPECT_EQ(advice.key, "master.acceleration");
  EXPECT_THAT(advice.rule, StartsWith("must be less than 10000:"));
}

}  // namespace
}  // namespace jounce::shear_reserve_test
