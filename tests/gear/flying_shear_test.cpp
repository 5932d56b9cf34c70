// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/flying_shear.hpp"

#include <cmath>
#include <fstream>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/cam/coupling/master_limits.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"
#include "support/invariants.hpp"
#include "support/random.hpp"

namespace jounce::flying_shear_test {
namespace {

using nlohmann::json;

const json& oracle() {
  static const json all = json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/shear.json"));
  return all;
}

const LawForm quarters{.straight = 0.5, .shares = {{0, 1, 0}}};  // 1/4-1/2-1/4

FlyingShear shear_of(const json& spec) {
  FlyingShear shear{.cut_length = spec.at("cut_length"), .line_speed = spec.at("line_speed")};
  const auto take = [&](const char* key, std::optional<double>& to) {
    if (spec.contains(key)) to = spec.at(key).get<double>();
  };
  take("sync_time", shear.sync_time);
  take("sync_length", shear.sync_length);
  take("stroke", shear.stroke);
  take("acceleration_length", shear.acceleration_length);
  take("return_length", shear.return_length);
  take("velocity", shear.limits.velocity);
  take("acceleration", shear.limits.acceleration);
  take("jerk", shear.limits.jerk);
  shear.safety = spec.value("safety", 1.0);
  shear.angle = spec.value("angle", 0.0);
  shear.ramp = *law_named(spec.at("ramp").get<std::string>());
  const std::string back = spec.at("return_law");
  shear.return_law = back == "trapezoid" ? Law::scca : *law_named(back);
  if (back == "trapezoid") shear.return_form = quarters;
  return shear;
}

FlyingShear case_2() {
  return shear_of(oracle().at("case_2").at("spec"));
}

/// The exact peak of a derivative over one stretch of the cam, by its name.
double peak(const SyncCam& made, const std::string& name, int order) {
  double most = 0;
  for (std::size_t i = 0; i < made.segments.size(); ++i)
    if (made.segments[i] == name)
      most = std::max(most, std::abs(segment_range(made.cam, i, order).peak().value));
  return most;
}

void expect_closes(const SyncCam& made, const FlyingShear& shear) {
  const ShearPlan plan = shear_plan(shear);
  EXPECT_EQ(plan.accelerate + plan.sync + plan.decelerate + plan.back + plan.wait,
            shear.cut_length);
  EXPECT_EQ(made.cam.start(), 0);
  EXPECT_EQ(made.cam.end(), shear.cut_length);
  EXPECT_EQ(made.cam.outside(), Extrapolation::wrap);
  EXPECT_EQ(made.cam.segments().size(), made.segments.size());
  // Polynomials begin and end at home exactly; a sine has the rounding of its argument.
  const auto rounding = [&](const Segment& f) { return f.sines > 0 ? 1e-15 * plan.stroke : 0; };
  const Segment& first = made.cam.segments().front();
  const Segment& last = made.cam.segments().back();
  EXPECT_NEAR(value(first, 0), 0, rounding(first));
  EXPECT_NEAR(value(last, 1), 0, rounding(last));
}

TEST(FlyingShear, IsTheOraclesAtEveryPoint) {
  int points = 0;
  for (const auto& [name, expected] : oracle().items()) {
    if (!expected.contains("points")) continue;
    SCOPED_TRACE(name + ": " + expected.at("spec").dump());
    const FlyingShear shear = shear_of(expected.at("spec"));
    const SyncCam made = flying_shear(shear);
    expect_closes(made, shear);
    const double stroke = expected.at("stroke");
    const ShearPlan plan = shear_plan(shear);
    EXPECT_NEAR(plan.stroke, stroke, 1e-13 * stroke);
    EXPECT_NEAR(extrema(made.cam, 0).max.value, stroke, 1e-13 * stroke);
    EXPECT_NEAR(plan.accelerate, expected.at("accelerate"), 1e-13 * shear.cut_length);
    EXPECT_NEAR(plan.back, expected.at("back"), 1e-13 * shear.cut_length);
    const double v = shear.line_speed;
    EXPECT_NEAR(peak(made, "return", 1) * v / expected.at("return_velocity").get<double>(), 1,
                1e-11);
    EXPECT_NEAR(peak(made, "return", 2) * v * v / expected.at("return_acceleration").get<double>(),
                1, 1e-10);
    for (const json& point : expected.at("points")) {
      const Jet at = made.cam.jet(point.at(0));
      EXPECT_NEAR(at[0], point.at(1), 1e-12 * stroke) << point;
      EXPECT_NEAR(at[1], point.at(2), 1e-9 * plan.ratio) << point;
      ++points;
    }
  }
  EXPECT_GT(points, 500);
}

TEST(FlyingShear, BoundsAreTheOracles) {
  int lengths = 0;
  int speeds = 0;
  for (const auto& [name, expected] : oracle().items()) {
    SCOPED_TRACE(name + ": " + expected.at("spec").dump());
    const FlyingShear shear = shear_of(expected.at("spec"));
    if (expected.contains("least_cut_length")) {
      const double least = expected.at("least_cut_length");
      EXPECT_NEAR(least_cut_length(shear).value / least, 1, 1e-12);
      ++lengths;
    }
    if (expected.contains("greatest_line_speed")) {
      const double most = expected.at("greatest_line_speed");
      EXPECT_NEAR(greatest_line_speed(shear).value / most, 1, 1e-12);
      ++speeds;
    }
    if (shear.return_length) continue;
    if (expected.at("feasible").get<bool>()) {
      EXPECT_NO_THROW(flying_shear(shear));
    } else {
      EXPECT_THROW(flying_shear(shear), InputError);
    }
  }
  EXPECT_GT(lengths, 50);
  EXPECT_GT(speeds, 50);
}

TEST(FlyingShear, IsThePrintedCaseOfLuBieML) {
  const FlyingShear shear = shear_of(oracle().at("lubieml").at("spec"));
  const ShearPlan plan = shear_plan(shear);
  EXPECT_NEAR(plan.accelerate / 2, 2.25, 1e-12);  // distance of the carriage
  EXPECT_NEAR(plan.stroke, 7.5, 1e-12);
  EXPECT_NEAR(plan.back, 24, 1e-12);
  const SyncCam made = flying_shear(shear);
  EXPECT_NEAR(peak(made, "return", 1) * 30, 12.5, 1e-9);
  EXPECT_NEAR(peak(made, "return", 2) * 900, 62.5, 1e-9);
  EXPECT_NEAR(peak(made, "accelerate", 2) * 900, 300 / 1.5, 1e-9);
}

TEST(FlyingShear, IsTriosPrintedMoves) {
  // MOVELINK: accelerate 0.3 over 0.6; 0.7 over 1.0, of which 0.6 brake; back 1.0 over 8.4; wait 150.
  FlyingShear shear{.cut_length = 160, .line_speed = 1};
  shear.sync_length = 0.4;
  shear.acceleration_length = 0.6;
  shear.return_length = 8.4;
  shear.ramp = Law::line;
  const SyncCam made = flying_shear(shear);
  expect_closes(made, shear);
  EXPECT_NEAR(made.cam.jet(0.6)[0], 0.3, 1e-12);
  EXPECT_NEAR(made.cam.jet(1.6)[0], 0.3 + 0.7, 1e-12);
  EXPECT_EQ(made.cam.jet(11)[0], 0);
  EXPECT_NEAR(shear_plan(shear).wait, 150, 1e-12);
  EXPECT_EQ(made.segments,
            (std::vector<std::string>{"accelerate", "sync", "decelerate", "return", "wait"}));
}

TEST(FlyingShear, RejectsThePower7CaseWithAWorkingRemedy) {
  FlyingShear shear = shear_of(oracle().at("case_2_power7").at("spec"));
  const ShearBound least = least_cut_length(shear);
  EXPECT_EQ(least.quantity, "return acceleration");
  EXPECT_NEAR(least.value, 1.1138, 1e-4);
  const ShearBound fastest = greatest_line_speed(shear);
  EXPECT_EQ(fastest.quantity, "return acceleration");
  try {
    flying_shear(shear);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.key(), "cut_length");
    EXPECT_EQ(error.rule(), "must be at least " + six_digits_up(least.value) +
                                " at line_speed = " + six_digits(shear.line_speed) +
                                ", or line_speed at most " + six_digits_down(fastest.value) +
                                " with this cut_length: a shorter return would exceed "
                                "limits.acceleration");
  }
  shear.cut_length = least.value;  // the returned length works, a shorter one does not
  EXPECT_NO_THROW(flying_shear(shear));
  shear.cut_length = least.value * (1 - 1e-9);
  EXPECT_THROW(flying_shear(shear), InputError);
  shear.cut_length = 1;
  shear.line_speed = fastest.value;
  const SyncCam made = flying_shear(shear);
  EXPECT_NEAR(peak(made, "return", 2) * fastest.value * fastest.value, 10, 1e-9);
}

TEST(FlyingShear, RampsAreTheNotesFactors) {
  const auto factor = [](Law ramp) {
    FlyingShear shear{.cut_length = 10, .line_speed = 2, .sync_length = 0.5};
    shear.acceleration_length = 0.8;
    shear.deceleration_length = 0.6;
    shear.ramp = ramp;
    const SyncCam made = flying_shear(shear);
    EXPECT_NEAR(peak(made, "decelerate", 2) * 0.6, peak(made, "accelerate", 2) * 0.8, 1e-12);
    EXPECT_NEAR(made.cam.jet(0.8)[0], 0.4, 1e-14) << name(ramp);
    return peak(made, "accelerate", 2) * 0.8;
  };
  EXPECT_NEAR(factor(Law::line), 1, 1e-12);
  EXPECT_NEAR(factor(Law::simple_sine), std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(factor(Law::poly345), 15.0 / 8, 1e-12);
  EXPECT_NEAR(factor(Law::poly4567), 35.0 / 16, 1e-12);
  EXPECT_NEAR(factor(Law::poly56789), 315.0 / 128, 1e-12);
}

TEST(FlyingShear, TakesEveryLawFromRestToRest) {
  int laws = 0;
  for (const LawInfo& each : all_laws()) {
    FlyingShear shear{.cut_length = 3, .line_speed = 1, .sync_time = 0.2};
    shear.acceleration_length = 0.3;
    shear.return_law = each.law;
    if (each.law == Law::scca)
      shear.return_form = quarters;  // it has no shape without one
    else
      shear.ramp = each.law;
    if (each.ends == Ends::straight || each.ends == Ends::standing || reverses(each.ends) ||
        !has_own_shape(each.law)) {
      EXPECT_THROW(flying_shear(shear), InputError) << each.name;
      continue;
    }
    SCOPED_TRACE(each.name);
    const SyncCam made = flying_shear(shear);
    expect_closes(made, shear);
    test::expect_invariants(made.cam, 1);
    EXPECT_NEAR(made.cam.jet(0.4)[0], 0.25, 1e-13);
    EXPECT_NEAR(extrema(made.cam, 0).max.value, 0.5, 1e-13);
    ++laws;
  }
  EXPECT_GT(laws, 10);
}

TEST(FlyingShear, TheDiagonalSawKeepsUpWithTheLine) {
  FlyingShear shear = case_2();
  shear.cut_length = 3;
  shear.angle = std::numbers::pi / 3;
  const SyncCam made = flying_shear(shear);
  const SyncZone zone = made.zones.at(0);
  const double along_guide = made.cam.jet((zone.from + zone.to) / 2)[1];
  EXPECT_NEAR(along_guide * std::cos(shear.angle), 1, 1e-15);  // along the line: the line's speed
  EXPECT_NEAR(peak(made, "accelerate", 2), 10, 1e-10);         // the carriage, still at its limit
  shear.angle = -shear.angle;
  EXPECT_EQ(flying_shear(shear).cam.jet(zone.from)[1], made.cam.jet(zone.from)[1]);
}

TEST(FlyingShear, InSyncTheSlopeIsTheRatioToTheLastDigit) {
  const SyncCam made = flying_shear(case_2());
  const SyncZone zone = made.zones.at(0);
  for (double x = zone.from; x < zone.to; x += 0.01) EXPECT_EQ(made.cam.jet(x)[1], 1) << x;
}

TEST(FlyingShear, LeftToTheStrokeTheSyncIsTheLongest) {
  FlyingShear shear{.cut_length = 4, .line_speed = 1};
  shear.limits = {.velocity = 2, .acceleration = 10};
  shear.stroke = 0.8;
  EXPECT_NEAR(shear_plan(shear).stroke, 0.8, 1e-14);  // the stroke binds
  shear.cut_length = 1;
  const ShearPlan tight = shear_plan(shear);  // the return binds
  EXPECT_LT(tight.stroke, 0.8);
  EXPECT_GT(tight.sync, 0);
  EXPECT_NEAR(peak(flying_shear(shear), "return", 2), 10, 1e-9);
  shear.cut_length = least_cut_length(shear).value;  // nothing is left of it
  EXPECT_THROW(flying_shear(shear), InputError);
  shear.cut_length *= 1 + 1e-9;
  EXPECT_NO_THROW(flying_shear(shear));
}

std::string refusal(const FlyingShear& shear) {
  return test::error_of([&] { (void)flying_shear(shear); });
}

TEST(FlyingShear, NamesWhatBinds) {
  using ::testing::HasSubstr;
  using ::testing::StartsWith;
  FlyingShear shear = case_2();
  shear.limits.velocity = 0.5;
  EXPECT_THAT(refusal(shear), StartsWith("line_speed = 1: must be at most 0.5: at a higher "
                                         "speed, the carriage in the sync zone exceeds"));
  shear = case_2();
  shear.stroke = 0.3;
  EXPECT_THAT(
      refusal(shear),
      StartsWith("stroke = 0.3: must be at least 0.3375 at line_speed = 1, or sync_time at most "));
  shear = case_2();
  shear.acceleration_length = 0.1;
  EXPECT_THAT(refusal(shear), StartsWith("acceleration_length = 0.1: must be at least 0.1875"));
  EXPECT_THAT(refusal(shear), HasSubstr("limits.acceleration"));
  shear = case_2();
  shear.return_length = 0.4;
  EXPECT_THAT(refusal(shear), StartsWith("return_length = 0.4: must be at least 0.44"));
  shear = case_2();
  shear.return_length = 0.5;
  EXPECT_THAT(refusal(shear), StartsWith("cut_length = 1: must be greater than 1.025"));
  shear = case_2();
  shear.limits.jerk = 100;
  shear.return_law = Law::simple_sine;  // its acceleration steps
  EXPECT_THAT(refusal(shear), StartsWith("return_law = simple_sine: exceeds limits.jerk at any"));
  shear.ramp = Law::line;
  EXPECT_THAT(refusal(shear), StartsWith("ramp = line: exceeds limits.jerk at any speed"));
  shear = case_2();
  shear.sync_time.reset();
  EXPECT_THAT(refusal(shear), StartsWith("sync_time"));
  shear = case_2();
  shear.limits.acceleration.reset();
  EXPECT_THAT(refusal(shear), StartsWith("acceleration_length"));
  shear = case_2();
  shear.angle = 2;
  EXPECT_THAT(refusal(shear), StartsWith("angle = 2"));
  shear = case_2();
  shear.line_speed = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(shear), StartsWith("line_speed"));
}

TEST(FlyingShear, BoundsAreZeroOrInfiniteAtTheExtremes) {
  FlyingShear shear = case_2();
  shear.limits.velocity = 0.5;
  EXPECT_EQ(least_cut_length(shear).value, std::numeric_limits<double>::infinity());
  EXPECT_EQ(least_cut_length(shear).quantity, "sync velocity");
  EXPECT_LT(greatest_line_speed(shear).value, 0.5 * (1 + 1e-12));
  shear = case_2();
  shear.limits.jerk = 1000;
  shear.ramp = Law::line;
  EXPECT_EQ(greatest_line_speed(shear).value, 0);
  EXPECT_EQ(greatest_line_speed(shear).quantity, "ramp jerk");
  FlyingShear free{.cut_length = 1, .line_speed = 1, .sync_length = 0.1};
  free.acceleration_length = 0.1;
  EXPECT_EQ(greatest_line_speed(free).value, std::numeric_limits<double>::infinity());
  EXPECT_EQ(greatest_line_speed(free).quantity, "");
  EXPECT_NEAR(least_cut_length(free).value, 0.3, 1e-15);
  EXPECT_EQ(least_cut_length(free).quantity, "cut length");
  free.cut_length = 0.3;  // nothing is left for the return
  EXPECT_THAT(refusal(free), ::testing::StartsWith("cut_length = 0.3: must be greater than 0.3"));
}

TEST(FlyingShear, TheFastestLineIsMetAndNotPassed) {
  test::Random random(17);
  int found = 0;
  for (int i = 0; i < 100; ++i) {
    FlyingShear shear{.cut_length = random.uniform(0.5, 3), .line_speed = random.uniform(0.3, 2)};
    shear.limits = {.velocity = random.uniform(1, 4), .acceleration = random.uniform(5, 30)};
    shear.stroke = random.uniform(0.2, 1);  // the sync is left to it
    SCOPED_TRACE(::testing::Message() << "case " << i);
    const ShearBound fastest = greatest_line_speed(shear);
    ASSERT_GT(fastest.value, 0);
    shear.line_speed = fastest.value * (1 - 1e-9);
    EXPECT_EQ(refusal(shear), "");
    const SyncCam made = flying_shear(shear);
    EXPECT_GE(greatest_master_velocity(made.cam, shear.limits).value,
              shear.line_speed * (1 - 1e-9));
    EXPECT_LE(shear_plan(shear).stroke, *shear.stroke * (1 + 1e-12));
    shear.line_speed = fastest.value * (1 + 1e-9);
    EXPECT_NE(refusal(shear), "");
    ++found;
  }
  EXPECT_EQ(found, 100);
}

TEST(FlyingShear, OfAnotherLengthRunsAsFastAsItCan) {
  FlyingShear shear = case_2();
  shear.limits.velocity = 2;
  double before = 0;
  for (const double length : {0.2, 0.4, 0.6, 0.8, 0.95}) {
    const auto made = fastest_shear(shear, length);
    ASSERT_TRUE(made) << length;
    EXPECT_EQ(made->cam.end(), length);
    shear.cut_length = length;
    const double speed = greatest_master_velocity(made->cam, shear.limits).value;
    EXPECT_NEAR(speed / greatest_line_speed(shear).value, 1, 1e-9) << length;
    EXPECT_GT(speed, before);  // longer is faster
    before = speed;
  }
  const auto slow = fastest_shear(shear, 2);  // the line is no faster than it is
  EXPECT_NEAR(peak(*slow, "accelerate", 2), 10, 1e-9);
  shear.stroke = 0.1;
  EXPECT_NEAR(extrema(fastest_shear(shear, 1)->cam, 0).max.value, 0.1, 1e-12);
  shear.acceleration_length = 0.6;
  EXPECT_FALSE(fastest_shear(shear, 1));
  shear.sync_time.reset();
  EXPECT_THROW(fastest_shear(shear, 1), InputError);
}

TEST(FlyingShear, ScalesWithItsUnits) {
  // m and s against mm and ms: the same cycle to rounding.
  FlyingShear shear = case_2();
  shear.limits.velocity = 2;
  shear.limits.jerk = 1000;
  shear.cut_length = 2;
  FlyingShear small = shear;
  small.cut_length *= 1e3;
  *small.sync_time *= 1e3;
  *small.limits.acceleration *= 1e3 / 1e6;
  *small.limits.jerk *= 1e3 / 1e9;
  EXPECT_NEAR(shear_plan(small).stroke, 1e3 * shear_plan(shear).stroke, 1e-10);
  EXPECT_NEAR(least_cut_length(small).value, 1e3 * least_cut_length(shear).value, 1e-9);
}

TEST(FlyingShear, AnAcceleratingLineIsFollowedAndItsSharesAdd) {
  // a = s'' w^2 + s' alpha: in step the carriage accelerates as the line does.
  const SyncCam made = flying_shear(case_2());
  const double alpha = 0.5;
  Segment line_travel;  // from standstill: x = alpha t^2 / 2
  line_travel.length = 2;
  line_travel.degree = 2;
  line_travel.c[2] = alpha * 2;
  const Followed carriage(made.cam, Trajectory({line_travel}));
  const SyncZone zone = made.zones.at(0);
  for (const double x : {zone.from + 0.01, zone.to - 0.01}) {
    const Motion at = carriage.at(std::sqrt(2 * x / alpha));
    EXPECT_NEAR(at.velocity, std::sqrt(2 * alpha * x), 1e-12);
    EXPECT_NEAR(at.acceleration, alpha, 1e-10);
  }
  // Made for 1 m/s within 10 m/s^2; while the line accelerates it must be slower, exactly so much.
  const Limits limits{.acceleration = 10};
  EXPECT_NEAR(greatest_master_velocity(made.cam, limits).value, 1, 1e-12);
  const MasterLimit live = greatest_master_velocity(made.cam, limits, {.acceleration = alpha});
  EXPECT_LT(live.value, 1);
  double worst = 0;
  for (int i = 0; i <= 100000; ++i) {
    const Jet s = made.cam.jet(made.cam.end() * i / 100000);
    worst = std::max(worst, std::abs(s[2]) * live.value * live.value + std::abs(s[1]) * alpha);
  }
  EXPECT_LE(worst, 10 * (1 + 1e-9));
  EXPECT_NEAR(worst, 10, 1e-4);
}

TEST(FlyingShear, RandomSpecsCloseToTheBitAndKeepTheirLimits) {
  test::Random random(5);
  int made_of_them = 0;
  for (int i = 0; i < 300; ++i) {
    const double unit = random.log_uniform(1e-6, 1e6);
    FlyingShear shear{.cut_length = unit * random.uniform(0.5, 5),
                      .line_speed = unit * random.uniform(0.2, 2)};
    shear.limits.acceleration = unit * random.uniform(5, 30);
    shear.limits.velocity = shear.line_speed * random.uniform(1, 3);
    if (random.below(2) == 0) shear.limits.jerk = unit * random.uniform(100, 3000);
    if (random.below(3) == 0)
      shear.stroke = unit * random.uniform(0.3, 1);
    else
      shear.sync_time = random.uniform(0.02, 0.2);
    shear.safety = random.below(2) == 0 ? 1 : random.uniform(1, 2);
    SCOPED_TRACE(::testing::Message()
                 << "case " << i << " cut_length " << number(shear.cut_length));
    if (!refusal(shear).empty()) {
      const double most = greatest_line_speed(shear).value;
      EXPECT_LT(most, shear.line_speed * (1 + 1e-12)) << refusal(shear);
      continue;
    }
    const SyncCam made = flying_shear(shear);
    expect_closes(made, shear);
    test::expect_invariants(made.cam, 2);
    const MasterLimit fastest = greatest_master_velocity(made.cam, shear.limits);
    EXPECT_GE(fastest.value, shear.line_speed * (1 - 1e-9));
    ++made_of_them;
  }
  EXPECT_GT(made_of_them, 100);
}

}  // namespace
}  // namespace jounce::flying_shear_test
