// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/rotary_knife.hpp"

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/cam/coupling/master_limits.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"
#include "support/invariants.hpp"
#include "support/random.hpp"

namespace jounce::rotary_knife_test {
namespace {

constexpr double pi = std::numbers::pi;

/// Made by tests/oracle/knife.py without any of our code.
const nlohmann::json& oracle(const char* name) {
  static const nlohmann::json all =
      nlohmann::json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/knife.json"));
  return all.at(name);
}

/// cams.md's case Y, in inches and radians.
RotaryKnifeSpec case_y() {
  return {.diameter = 3, .cut_length = 4.71, .sync_angle = 10 * pi / 180};
}

RotaryKnifeSpec horizontal(const nlohmann::json& of) {
  RotaryKnifeSpec spec{.diameter = of["diameter"],
                       .blades = of["blades"],
                       .cut_length = of["length"],
                       .sync_angle = of["degrees"].get<double>() * pi / 180};
  spec.matching = KnifeMatching::horizontal;
  spec.speed_ratio = of["ratio"];
  spec.law = of["jerk"].get<bool>() ? Law::poly4567 : Law::poly345;
  return spec;
}

std::string refusal(const RotaryKnifeSpec& spec) {
  return test::error_of([&] { (void)rotary_knife(spec); });
}

void expect_near(double value, double expected, double relative) {
  EXPECT_NEAR(value, expected, relative * std::abs(expected));
}

const Finding* find(const Report& report, const std::string& rule) {
  for (const Finding& f : report.findings)
    if (f.rule == rule) return &f;
  return nullptr;
}

TEST(RotaryKnife, HasTheFiguresOfCaseY) {
  const RotaryKnifeFigures f = figures(case_y());
  const auto& y = oracle("case_y");
  expect_near(f.synchronous, y["synchronous"], 1e-14);
  expect_near(f.sync_length, y["sync_length"], 1e-14);
  expect_near(f.recovery_length, y["recovery_length"], 1e-14);
  expect_near(f.recovery_angle, y["recovery_angle"], 1e-14);
  expect_near(f.rho, y["rho"], 1e-14);
  expect_near(f.surface_ratio, y["surface_ratio"], 1e-13);
  expect_near(f.longest, y["longest"], 1e-13);
  EXPECT_NEAR(f.longest, 19.896753, 5e-7);  // the printed value
  expect_near(f.speed_error, 1 - std::cos(5 * pi / 180), 1e-12);
}

TEST(RotaryKnife, HasTheSpeedAndAccelerationOfCaseY) {
  const Cam cam = rotary_knife(case_y()).cam;
  test::expect_invariants(cam, 2);
  const auto& y = oracle("case_y");
  const double line = 20;
  const Ranges ranges = extrema(cam);
  const double rpm = 60 / (2 * pi);
  expect_near(cam.jet(0)[1] * line * rpm, y["sync_rpm"], 1e-13);
  expect_near(ranges[1].max.value * line * rpm, y["peak_rpm"], 1e-12);
  expect_near(ranges[2].max.value * line * line, y["acceleration"], 1e-12);
  EXPECT_NEAR(ranges[2].peak().value * line * line, 366.8602, 5e-5);
  EXPECT_EQ(cam.end(), 4.71);
  EXPECT_EQ(cam.advance(), 2 * pi);
}

TEST(RotaryKnife, IsAPlainGearAtTheSynchronousLengthWithEveryLaw) {
  for (const LawInfo& each : all_laws()) {
    RotaryKnifeSpec spec{
        .diameter = 3 / pi, .blades = 3, .cut_length = 1, .sync_angle = 20, .turn = 360};
    spec.law = each.law;
    if (each.law == Law::scca) spec.form.shares = {0.25, 0.5, 0.25};
    if (!refusal(spec).empty()) continue;
    const Cam cam = rotary_knife(spec).cam;
    ASSERT_EQ(cam.segments().size(), 1U) << each.name;
    EXPECT_EQ(cam.jet(0.25)[0], 30) << each.name;  // to the last digit
    EXPECT_EQ(cam.jet(0.5)[1], 120);
    EXPECT_EQ(cam.jet(0.5)[2], 0);
    EXPECT_EQ(cam.jet(1e9 + 0.5)[0], 120e9 + 60);
    // The recovery itself is that line, too, a hair beside the length.
    spec.cut_length = 1 + 1e-9;
    EXPECT_LT(std::abs(extrema(rotary_knife(spec).cam, 2).peak().value), 1e-5) << each.name;
  }
}

TEST(RotaryKnife, TurnsBackBeyondEachLawsOwnLength) {
  int compared = 0;
  for (const auto& [law, factor] : oracle("longest_factor").items()) {
    RotaryKnifeSpec spec = case_y();
    spec.law = *law_named(law);
    const RotaryKnifeFigures f = figures(spec);
    expect_near(f.longest, f.sync_length + 1.5 * f.recovery_angle * factor.get<double>(), 1e-13);
    spec.cut_length = f.longest * 0.999;
    EXPECT_GT(extrema(rotary_knife(spec).cam, 1).min.value, 0) << law;
    EXPECT_TRUE(check(spec).ok()) << law;
    spec.cut_length = f.longest;
    EXPECT_TRUE(check(spec).ok()) << law;
    spec.cut_length = f.longest * 1.001;
    EXPECT_LT(extrema(rotary_knife(spec).cam, 1).min.value, 0) << law;
    EXPECT_FALSE(check(spec).ok()) << law;
    ++compared;
  }
  EXPECT_EQ(compared, 15);
}

TEST(RotaryKnife, HasTheClosedFormsOfEverySymmetricLaw) {
  for (const char* law : {"345", "4567", "parabola", "modified_sine", "simple_sine", "gutman_13"})
    for (const double length : {2.0, 4.71, 14.0}) {
      RotaryKnifeSpec spec = case_y();
      spec.law = *law_named(law);
      spec.cut_length = length;
      const RotaryKnifeFigures f = figures(spec);
      const Cam cam = rotary_knife(spec).cam;
      const Cam rise(normalized(spec.law));
      const double cv = extrema(rise, 1).max.value;
      const double ca = extrema(rise, 2).max.value;
      const double b = f.recovery_length;
      expect_near(f.surface_ratio, (cv - (cv - 1) * f.rho) / f.rho, 1e-12);
      expect_near(std::abs(extrema(cam, 2).peak().value),
                  std::abs(1 - f.rho) * ca * f.recovery_angle / (b * b), 1e-11);
      expect_near(cam.jet(length / 2)[1] * 1.5, f.surface_ratio, 1e-11);
    }
}

TEST(RotaryKnife, StandsWhereTheCutIsTooLong) {
  for (const KnifeMatching matching : {KnifeMatching::surface, KnifeMatching::horizontal})
    for (const char* law : {"345", "4567", "modified_sine", "modified_constant_velocity"}) {
      RotaryKnifeSpec spec = case_y();
      spec.law = *law_named(law);
      spec.matching = matching;
      spec.dwell = true;
      const double length = spec.cut_length = 1.25 * figures(spec).longest;
      const RotaryKnifeFigures f = figures(spec);
      const SyncCam made = rotary_knife(spec);
      EXPECT_TRUE(check_continuity(made.cam, 2).ok());
      expect_near(f.dwell, length - f.longest, 1e-13);
      EXPECT_EQ(f.surface_ratio, 0);
      const double from = (length - f.dwell) / 2;
      EXPECT_EQ(made.cam.jet(length / 2)[0], pi);
      for (const double x : {from + 1e-9, length / 2, length - from - 1e-9})
        for (int k = 1; k < 4; ++k) EXPECT_EQ(made.cam.jet(x)[static_cast<std::size_t>(k)], 0);
      EXPECT_GE(extrema(made.cam, 1).min.value, -1e-14);
      EXPECT_TRUE(check(spec).ok());
      // The motion of the knife does not depend on the length of its stop.
      spec.cut_length = 300;
      expect_near(extrema(rotary_knife(spec).cam, 2).peak().value,
                  extrema(made.cam, 2).peak().value, 1e-11);
    }
}

TEST(RotaryKnife, StopsNearlyAsGentlyAsAnyQuinticCan) {
  RotaryKnifeSpec spec = case_y();
  spec.dwell = true;
  spec.cut_length = 40;
  const double slope = 1 / 1.5;
  const double travel = figures(spec).recovery_angle / 2;
  double least = 1e9;
  for (int i = 0; i <= 400;
       ++i) {  // from rest to the slope, by its ratio to the mean: 5/2 reverses
    const double length = (1.5 + i / 400.) * travel / slope;
    const Cam start({quintic(length, 0, 0, 0, travel, slope, 0)});
    least = std::min(least, std::abs(extrema(start, 2).peak().value));
  }
  EXPECT_NEAR(std::abs(extrema(rotary_knife(spec).cam, 2).peak().value) / least, 1.0107, 1e-4);
}

TEST(RotaryKnife, HorizontalRecoveryTakesOverWhatAsinEndsWith) {
  for (const auto& each : oracle("horizontal")) {
    const RotaryKnifeSpec spec = horizontal(each);
    const RotaryKnifeFigures f = figures(spec);
    const Cam cam = rotary_knife(spec).cam;
    const bool jerk = each["jerk"];
    EXPECT_TRUE(check_continuity(cam, 2).ok());
    EXPECT_EQ(check_continuity(cam, 3, 1e-7).ok(), jerk);
    expect_near(f.sync_length, each["sync_length"], 1e-14);
    expect_near(f.longest, each["longest"], 1e-12);
    EXPECT_LE(f.strays, 1e-12 * f.sync_angle);
    for (const char* part : {"in_step", "angles"})
      for (const auto& at : each[part])
        EXPECT_NEAR(cam.jet(at[0])[0], at[1].get<double>(), 2e-12) << part << " " << at[0];
    const double half = f.sync_length / 2;
    std::size_t first = 0;
    while (cam.breaks()[first] < half * (1 - 1e-12)) ++first;
    std::size_t last = first;
    while (cam.breaks()[last + 1] < (spec.cut_length - half) * (1 - 1e-12)) ++last;
    const Ranges ranges = segment_extrema(cam, first, last);
    const char* names[] = {"", "velocity", "acceleration", "third"};
    for (std::size_t k = 1; k < 4; ++k) {
      const double size = std::abs(ranges[k].peak().value);
      EXPECT_NEAR(ranges[k].min.value, each[names[k]][0].get<double>(), 1e-10 * size);
      EXPECT_NEAR(ranges[k].max.value, each[names[k]][1].get<double>(), 1e-10 * size);
    }
  }
}

TEST(RotaryKnife, AHorizontalKnifeWithoutAnAccelerationReversesAsReported) {
  for (const auto& each : oracle("horizontal")) {
    RotaryKnifeSpec spec = horizontal(each);
    spec.cut_length = each["longest"].get<double>() * 1.0001;
    EXPECT_LT(extrema(rotary_knife(spec).cam, 1).min.value, 0);
    EXPECT_FALSE(check(spec).ok());
    spec.cut_length = each["longest"].get<double>() * 0.9999;
    EXPECT_GT(extrema(rotary_knife(spec).cam, 1).min.value, 0);
  }
}

/// The blade's tip as a point on a circle over a running web: how far it slips in the material
/// while it is below the web's top, the greatest over the cut, in m.
double slip_in_the_web(const RotaryKnifeSpec& spec) {
  const Cam cam = rotary_knife(spec).cam;
  const double radius = spec.diameter / 2;
  double worst = 0;
  for (int i = -4000; i <= 4000; ++i) {
    const double web = spec.cut_length / 2 * i / 4000;
    const double angle = cam.jet(web)[0];
    if (radius * (1 - std::cos(angle)) > spec.thickness || std::abs(angle) > pi / 2) continue;
    worst = std::max(worst, std::abs(radius * std::sin(angle) - spec.speed_ratio * web));
  }
  return worst;
}

TEST(RotaryKnife, TipDoesNotSlipInAThickWebWithHorizontalMatching) {
  RotaryKnifeSpec spec{.diameter = 300, .cut_length = 1200, .thickness = 5};
  spec.matching = KnifeMatching::horizontal;
  const auto& touch = oracle("contact")[0];
  EXPECT_NEAR(figures(spec).contact_angle, touch["angle"].get<double>(), 1e-14);
  EXPECT_NEAR(figures(spec).sync_angle, 2 * touch["angle"].get<double>(), 1e-14);
  EXPECT_LT(slip_in_the_web(spec), 1e-9);
  EXPECT_TRUE(check(spec).ok());
  spec.speed_ratio = 1.005;
  EXPECT_LT(slip_in_the_web(spec), 1e-9);
}

TEST(RotaryKnife, TipSlipsInAThickWebWhereOnlyTheSurfaceMatches) {
  const RotaryKnifeSpec spec{.diameter = 300, .cut_length = 1200, .thickness = 5};
  const double alpha = figures(spec).contact_angle;
  EXPECT_NEAR(slip_in_the_web(spec), 150 * (alpha - std::sin(alpha)), 5e-3);  // 0.4 mm
  const Report report = check(spec);
  ASSERT_NE(find(report, "knife/slip"), nullptr);
  EXPECT_EQ(find(report, "knife/slip")->severity, Severity::warning);
  EXPECT_NEAR(find(report, "knife/slip")->value, 1 - std::cos(alpha), 1e-14);
}

TEST(RotaryKnife, ReportsWhereTheBladeTouchesBeforeItIsInSync) {
  RotaryKnifeSpec spec{
      .diameter = 300, .cut_length = 1200, .sync_angle = 20, .turn = 360, .thickness = 5};
  spec.matching = KnifeMatching::horizontal;
  const double touches = 2 * std::acos(1 - 5. / 150) * 180 / pi;
  const Report report = check(spec);
  EXPECT_FALSE(report.ok());
  const Finding* contact = find(report, "knife/contact");
  ASSERT_NE(contact, nullptr);
  EXPECT_NEAR(contact->limit, touches, 1e-12);
  EXPECT_TRUE(contact->broken);
  EXPECT_GT(slip_in_the_web(spec), 0.02);  // and so it slips
  spec.sync_angle = touches;
  EXPECT_TRUE(check(spec).ok());
}

TEST(RotaryKnife, RunsAheadOfTheWebByItsSpeedRatio) {
  RotaryKnifeSpec spec = case_y();
  spec.speed_ratio = 1.005;
  const RotaryKnifeFigures f = figures(spec);
  const Cam cam = rotary_knife(spec).cam;
  EXPECT_NEAR(cam.jet(0)[1] * 1.5, 1.005, 1e-14);
  EXPECT_NEAR(cam.jet(4.71, Side::left)[1] * 1.5, 1.005, 1e-14);
  expect_near(f.synchronous, 3 * pi / 1.005, 1e-14);
  spec.cut_length = f.synchronous;
  EXPECT_EQ(rotary_knife(spec).cam.segments().size(), 1U);
}

TEST(RotaryKnife, CountsInAnyUnitOfTheSlave) {
  const Cam radians = rotary_knife(case_y()).cam;
  RotaryKnifeSpec spec = case_y();
  spec.turn = 360;
  spec.sync_angle = 10;
  const Cam degrees = rotary_knife(spec).cam;
  spec.sync_angle = std::nullopt;
  spec.sync_length = figures(case_y()).sync_length;
  spec.turn = 3 * pi;  // inches of the circumference
  const Cam inches = rotary_knife(spec).cam;
  for (const double x : {0.0, 0.05, 0.7, 2.1, 4.6}) {
    EXPECT_NEAR(degrees.jet(x)[0], radians.jet(x)[0] * 180 / pi, 1e-12);
    EXPECT_NEAR(inches.jet(x)[0], radians.jet(x)[0] * 1.5, 1e-13);
  }
}

TEST(RotaryKnife, ClosesToTheLastDigitWhateverItsNumbers) {
  test::Random random(51);
  for (int i = 0; i < 400; ++i) {
    RotaryKnifeSpec spec;
    spec.diameter = random.log_uniform(1e-3, 1e4);
    spec.blades = static_cast<std::size_t>(1 + random.below(6));
    spec.turn = random.below(2) == 0 ? 360 : 2 * pi;
    const double pitch = spec.turn / static_cast<double>(spec.blades);
    spec.sync_angle = pitch * random.uniform(0.01, 0.45);
    spec.matching = random.below(2) == 0 ? KnifeMatching::surface : KnifeMatching::horizontal;
    spec.law = random.below(2) == 0 ? Law::poly4567 : Law::modified_sine;
    spec.speed_ratio = random.uniform(0.98, 1.02);
    spec.dwell = random.below(2) == 0;
    const double synchronous = pi * spec.diameter / static_cast<double>(spec.blades);
    spec.cut_length = synchronous * random.log_uniform(0.5, 20);
    const SyncCam made = rotary_knife(spec);
    const auto failing = [&] {
      return ::testing::Message() << "case " << i << ": diameter " << spec.diameter << " blades "
                                  << spec.blades << " turn " << spec.turn << " sync "
                                  << *spec.sync_angle << " length " << spec.cut_length;
    };
    EXPECT_EQ(made.cam.end(), spec.cut_length) << failing();
    EXPECT_EQ(made.cam.advance(), pitch) << failing();
    EXPECT_TRUE(check_continuity(made.cam, 2).ok()) << failing();
    EXPECT_EQ(made.segments.size(), made.cam.segments().size()) << failing();
    EXPECT_EQ(check(spec).ok(), spec.dwell || spec.cut_length <= figures(spec).longest)
        << failing();
    if (!check(spec).ok()) continue;
    // Point symmetry about the middle, for any law.
    for (const double share : {0.03, 0.2, 0.4})
      EXPECT_NEAR(made.cam.jet(share * spec.cut_length)[0],
                  pitch - made.cam.jet((1 - share) * spec.cut_length)[0], 1e-12 * spec.turn)
          << failing();
  }
}

TEST(RotaryKnife, RejectsInputThatCannotBeCut) {
  RotaryKnifeSpec spec = case_y();
  spec.cut_length = 0.26;
  EXPECT_EQ(refusal(spec),
            "cut_length = 0.26: must be longer than the sync zone on the web, 0.2618: raise "
            "cut_length, or shorten the sync zone (sync_angle must be less than 0.173333)");
  spec.cut_length = 4;  // the sync zone of the angle between two blades is 4.712 long
  spec.sync_angle = 7;
  EXPECT_EQ(
      refusal(spec),
      "sync_angle = 7: must be less than 2.66666, the angle of a sync zone as long as "
      "cut_length: give a smaller angle (it must also be less than the angle between two blades)");
  for (const auto matching : {KnifeMatching::surface, KnifeMatching::horizontal}) {
    spec.matching = matching;
    spec.cut_length = 2;
    const double most = matching == KnifeMatching::surface ? 4.0 / 3 : 1.4594553124539327;
    spec.sync_angle = most * (1 - 1e-9);
    EXPECT_EQ(refusal(spec), "");
    spec.sync_angle = most * (1 + 1e-9);
    EXPECT_NE(refusal(spec).find(" (sync_angle must be less than "), std::string::npos);
  }
  spec = case_y();
  spec.sync_angle = 7;
  EXPECT_NE(refusal(spec).find("sync_angle = 7: must be less than "), std::string::npos);
  spec = case_y();
  spec.sync_length = 0.3;
  EXPECT_NE(refusal(spec).find("leave one out"), std::string::npos);
  spec = case_y();
  spec.sync_angle.reset();
  EXPECT_NE(refusal(spec).find("sync_angle"), std::string::npos);
  spec = case_y();
  spec.sync_angle = pi;
  spec.matching = KnifeMatching::horizontal;
  EXPECT_NE(refusal(spec).find("must be less than half a turn"), std::string::npos);
  spec = case_y();
  spec.law = Law::double_harmonic;
  EXPECT_NE(refusal(spec).find("law = double_harmonic"), std::string::npos);
  spec = case_y();
  spec.form.inflection = 0.4;
  EXPECT_NE(refusal(spec).find("inflection"), std::string::npos);
  spec = case_y();
  spec.blades = 0;
  EXPECT_EQ(refusal(spec), "blades = 0: must be at least 1");
  spec = case_y();
  spec.thickness = 1.5;
  EXPECT_NE(refusal(spec).find("thickness"), std::string::npos);
}

TEST(RotaryKnife, FollowsTheWebThroughManyCuts) {
  const SyncCam knife = rotary_knife(case_y());
  const Trajectory web({line(10, 0, 200)}, 0, Extrapolation::hold);  // 20 in/s
  const Followed slave(knife.cam, web);
  for (int cut = 0; cut < 40; ++cut) {
    const double t = cut * 4.71 / 20;
    EXPECT_NEAR(slave.at(t).position, 2 * pi * cut, 1e-11);
    EXPECT_NEAR(slave.at(t + 1e-6).velocity * 1.5, 20, 1e-9);
  }
}

}  // namespace
}  // namespace jounce::rotary_knife_test
