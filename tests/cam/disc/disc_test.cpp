// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/disc/disc.hpp"

#include <cmath>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/profiles/error.hpp"

#include "cam/disc/disc_cams.hpp"
#include "support/random.hpp"

namespace jounce::disc_test {
namespace {

using test::harmonic;
using test::random_disc;
using test::rise_dwell_return;

constexpr double deg = std::numbers::pi / 180;

/// disc.json: placed by plain trigonometry, differentiated numerically.
const nlohmann::json& disc_oracle() {
  static const nlohmann::json all =
      nlohmann::json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/disc.json"));
  return all;
}

Disc disc_of(const nlohmann::json& c) {
  DiscSpec spec{.base_radius = c["base_radius"], .roller_radius = c["roller_radius"]};
  if (c["follower"] == "oscillating") {
    spec.follower = Follower::oscillating;
    spec.arm_length = c["arm_length"];
    spec.center_distance = c["center_distance"];
  } else {
    spec.offset = c["offset"];
  }
  if (c["rotation"] == "clockwise") spec.rotation = Rotation::clockwise;
  return Disc(rise_dwell_return(*law_named(c["law"].get<std::string>()), 10), spec);
}

TEST(Disc, PointsAgreeWithNumericalDifferentiation) {
  ASSERT_EQ(disc_oracle().size(), 12U);
  for (const auto& c : disc_oracle()) {
    const Disc disc = disc_of(c);
    for (const auto& wanted : c["points"]) {
      SCOPED_TRACE(c["follower"].dump() + c["rotation"].dump() + wanted.dump());
      const DiscPoint p = disc.at(wanted["master"]);
      EXPECT_NEAR(p.center.x, wanted["center"][0].get<double>(), 4e-14 * 40);
      EXPECT_NEAR(p.center.y, wanted["center"][1].get<double>(), 4e-14 * 40);
      EXPECT_NEAR(p.contact.x, wanted["contact"][0].get<double>(), 4e-14 * 40);
      EXPECT_NEAR(p.contact.y, wanted["contact"][1].get<double>(), 4e-14 * 40);
      EXPECT_NEAR(p.pressure_angle, wanted["pressure_angle"].get<double>(), 1e-14);
      EXPECT_NEAR(p.pitch_curvature, wanted["pitch_curvature"].get<double>(), 1e-15);
    }
  }
}

TEST(Disc, ExtremesAgreeWithNumericalDifferentiation) {
  for (const auto& c : disc_oracle()) {
    const DiscExtremes e = extremes(disc_of(c));
    EXPECT_LE(e.error, 1e-12);
    for (const auto& [key, extremum, tolerance] :
         {std::tuple{"pressure_angle_max", e.pressure_angle.max, 1e-12},
          {"pressure_angle_min", e.pressure_angle.min, 1e-12},
          {"pitch_curvature_max", e.pitch_curvature.max, 1e-13},
          {"pitch_curvature_min", e.pitch_curvature.min, 1e-13}}) {
      SCOPED_TRACE(std::string(key) + c["follower"].dump() + c["law"].dump());
      EXPECT_NEAR(extremum.value, c[key]["value"].get<double>(), tolerance);
      EXPECT_NEAR(extremum.where, c[key]["where"].get<double>(), 1e-5);
    }
  }
}

// r = b - a cos t, a limacon: closed forms of everything.
TEST(Disc, HarmonicLiftMakesALimacon) {
  const double a = 5;
  const double b = 33;
  const Disc disc(harmonic(a), {.base_radius = 20, .roller_radius = 8});
  const DiscExtremes e = extremes(disc);
  EXPECT_NEAR(std::tan(e.pressure_angle.max.value), a / std::sqrt(b * b - a * a), 1e-13);
  EXPECT_NEAR(std::tan(e.pressure_angle.min.value), -a / std::sqrt(b * b - a * a), 1e-13);
  EXPECT_NEAR(e.pressure_angle.max.where, std::acos(a / b) / deg, 1e-6);
  EXPECT_NEAR(e.pitch_curvature.min.value, (b - 2 * a) / ((b - a) * (b - a)), 1e-15);
  EXPECT_NEAR(e.pitch_curvature.max.value, 1 / std::sqrt(b * b - a * a), 1e-15);
  EXPECT_NEAR(e.pitch_curvature.max.where, std::acos(a / b) / deg, 1e-5);
  EXPECT_NEAR(disc.at(180).pitch_curvature, (b + 2 * a) / ((b + a) * (b + a)), 1e-15);
}

TEST(Disc, DwellIsACircleAndTheOffsetTiltsIt) {
  const Cam still({line(360, 7, 7)}, 0, Extrapolation::wrap);
  for (const auto rotation : {Rotation::counterclockwise, Rotation::clockwise}) {
    const DiscExtremes e = extremes(
        Disc(still, {.base_radius = 20, .roller_radius = 5, .offset = 7, .rotation = rotation}));
    const double angle = (rotation == Rotation::clockwise ? 1 : -1) * std::atan2(7, 24);
    EXPECT_NEAR(e.pressure_angle.max.value, angle, 1e-15);
    EXPECT_NEAR(e.pressure_angle.min.value, angle, 1e-15);
    EXPECT_NEAR(e.pitch_curvature.max.value, 1.0 / 25, 1e-16);
    EXPECT_NEAR(e.pitch_curvature.min.value, 1.0 / 25, 1e-16);
  }
}

TEST(Disc, LineIsASpiralOfArchimedesWithACornerThatIsReported) {
  const Cam heart({line(180, 0, 18), line(180, 18, 0)}, 0, Extrapolation::wrap);
  const Disc disc(heart, {.base_radius = 20, .roller_radius = 4});
  const double k = 18 / std::numbers::pi;  // per rad
  for (const double x : {1.0, 60.0, 179.0}) {
    const double r = 24 + x / 10;
    const double v = std::hypot(r, k);
    EXPECT_NEAR(disc.at(x).pitch_curvature, (r * r + 2 * k * k) / (v * v * v), 1e-15);
    EXPECT_NEAR(std::tan(disc.at(x).pressure_angle), k / r, 1e-14);
  }
  const DiscExtremes e = extremes(disc);
  EXPECT_NEAR(std::tan(e.pressure_angle.max.value), k / 24, 1e-14);
  EXPECT_EQ(e.pressure_angle.max.where, 0);
  EXPECT_NEAR(e.pressure_angle.min.value, -e.pressure_angle.max.value, 1e-15);
  EXPECT_EQ(e.pressure_angle.min.where, 360);
  EXPECT_EQ(e.pressure_angle.min.side, Side::left);
  const Report report = check(disc, {});
  ASSERT_EQ(report.broken(), 1U);
  EXPECT_EQ(report.findings[0].rule, "disc/corner");
}

TEST(Disc, TheOtherRotationIsTheMirrorImage) {
  const Cam cam = rise_dwell_return(Law::modified_sine, 10);
  const Disc one(cam, {.base_radius = 20, .roller_radius = 8, .offset = 5});
  const Disc two(
      cam, {.base_radius = 20, .roller_radius = 8, .offset = -5, .rotation = Rotation::clockwise});
  for (double x = 0; x < 360; x += 7.3) {
    const DiscPoint a = one.at(x);
    const DiscPoint b = two.at(x);
    EXPECT_NEAR(a.contact.x, -b.contact.x, 1e-13);
    EXPECT_NEAR(a.contact.y, b.contact.y, 1e-13);
    EXPECT_NEAR(a.pressure_angle, b.pressure_angle, 1e-15);
    EXPECT_NEAR(a.pitch_curvature, b.pitch_curvature, 1e-16);
  }
}

// A sliding follower and the roller on an arm of enormous length move alike.
TEST(Disc, LongArmTendsToTheTranslatingFollower) {
  const Cam cam = rise_dwell_return(Law::inclined_sine, 10);
  const double arm = 1e7;
  const Disc slide(cam, {.base_radius = 20, .roller_radius = 8});
  const Disc swing(cam, {.follower = Follower::oscillating,
                         .base_radius = 20,
                         .roller_radius = 8,
                         .arm_length = arm,
                         .center_distance = std::hypot(arm, 28)});
  for (double x = 0; x < 360; x += 17) {
    EXPECT_NEAR(swing.at(x).pressure_angle, slide.at(x).pressure_angle, 3e-5);
    EXPECT_NEAR(swing.at(x).pitch_curvature, slide.at(x).pitch_curvature, 1e-6);
  }
}

TEST(Disc, SlaveMayBeTheAngleOfTheArm) {
  DiscSpec spec{.follower = Follower::oscillating,
                .base_radius = 20,
                .roller_radius = 8,
                .arm_length = 40,
                .center_distance = 50};
  const Cam way = rise_dwell_return(Law::poly345, 10);
  const Disc by_way(way, spec);
  spec.arm_angle = deg;
  const Disc by_angle(scaled(way, 1 / 40.0 / deg), spec);
  EXPECT_NEAR(by_way.at(77).contact.x, by_angle.at(77).contact.x, 1e-13);
  EXPECT_NEAR(by_way.at(77).pressure_angle, by_angle.at(77).pressure_angle, 1e-14);
}

TEST(Disc, PartOfATurnMakesLobes) {
  const Cam third = scaled(rise_dwell_return(Law::poly345, 4), 1.0, 1.0 / 3);
  const Disc disc(third, {.base_radius = 40, .roller_radius = 8});
  EXPECT_NEAR(disc.lift().length(), 360, 1e-12);
  EXPECT_NEAR(std::hypot(disc.at(140).center.x, disc.at(140).center.y),
              disc.at(20).center.y / std::cos(20 * deg), 1e-12);
}

TEST(Disc, BaseCircleBelongsToTheLeastSlavePosition) {
  const DiscSpec spec{.base_radius = 20, .roller_radius = 8};
  const Cam cam = rise_dwell_return(Law::poly345, 10);
  EXPECT_NEAR(Disc(shifted(cam, 0, -123), spec).at(40).contact.y, Disc(cam, spec).at(40).contact.y,
              1e-12);
}

TEST(Disc, RandomCamsKeepWithinTheirExtremesAndReachThem) {
  test::Random random(20240611);
  for (int n = 0; n < 150; ++n) {
    const auto made = random_disc(random);
    SCOPED_TRACE(made.text);
    const DiscExtremes e = extremes(made.disc);
    EXPECT_LE(e.error, 1e-12);
    for (int i = 0; i < 500; ++i) {
      const DiscPoint p = made.disc.at(random.uniform(0, 360));
      EXPECT_LE(p.pressure_angle, e.pressure_angle.max.value + 1e-12);
      EXPECT_GE(p.pressure_angle, e.pressure_angle.min.value - 1e-12);
      const double noise = 1e-12 * std::abs(e.pitch_curvature.peak().value);
      EXPECT_LE(p.pitch_curvature, e.pitch_curvature.max.value + noise);
      EXPECT_GE(p.pitch_curvature, e.pitch_curvature.min.value - noise);
    }
    for (const Extremum& x : {e.pressure_angle.min, e.pressure_angle.max})
      EXPECT_NEAR(made.disc.at(x.where, x.side).pressure_angle, x.value, 1e-10);
    for (const Extremum& x : {e.pitch_curvature.min, e.pitch_curvature.max})
      EXPECT_NEAR(made.disc.at(x.where, x.side).pitch_curvature, x.value,
                  1e-9 * std::abs(e.pitch_curvature.peak().value));
  }
}

// 0.2 deg of master in which the cam sweeps up and back: 1000 samples of the turn miss it.
TEST(Disc, NarrowPeakIsFound) {
  const Cam cam({line(123.4, 0, 0), quintic(0.1, 0, 0, 0, 0.02, 0, 0),
                 quintic(0.1, 0.02, 0, 0, 0, 0, 0), line(236.4, 0, 0)},
                0, Extrapolation::wrap);
  const Disc disc(cam, {.base_radius = 20, .roller_radius = 8});
  double sampled = 0;
  for (int i = 0; i < 1000; ++i) sampled = std::max(sampled, disc.at(0.36 * i).pressure_angle);
  const DiscExtremes e = extremes(disc);
  EXPECT_NEAR(std::tan(e.pressure_angle.max.value), 15.0 / 8 * 0.2 / deg / 28.01, 1e-3);
  EXPECT_GT(e.pressure_angle.max.value, 2 * sampled);
}

TEST(Disc, UnitsDoNotMatter) {
  const Cam cam = rise_dwell_return(Law::modified_trapezoid, 10);
  const DiscExtremes e = extremes(Disc(cam, {.base_radius = 20, .roller_radius = 8, .offset = 3}));
  for (const double unit : {1e-9, 25.4, 1e9}) {
    const DiscExtremes f = extremes(Disc(
        scaled(cam, unit, deg),
        {.base_radius = 20 * unit, .roller_radius = 8 * unit, .offset = 3 * unit, .angle = 1}));
    EXPECT_NEAR(f.pressure_angle.max.value, e.pressure_angle.max.value, 1e-13);
    EXPECT_NEAR(f.pressure_angle.max.where, e.pressure_angle.max.where * deg, 1e-7);
    EXPECT_NEAR(f.pitch_curvature.max.value * unit, e.pitch_curvature.max.value, 1e-14);
  }
}

struct Refused {
  const char* key;
  Cam cam;
  DiscSpec spec;
};

TEST(Disc, RejectsAnInvalidDisc) {
  const Cam good = rise_dwell_return(Law::poly345, 10);
  const DiscSpec swing{.follower = Follower::oscillating,
                       .base_radius = 20,
                       .roller_radius = 8,
                       .arm_length = 40,
                       .center_distance = 50};
  auto arm = [&](double length, double distance) {
    DiscSpec spec = swing;
    spec.arm_length = length;
    spec.center_distance = distance;
    return spec;
  };
  const Cam open({quintic(360, 0, 0, 0, 5, 0, 0)}, 0, Extrapolation::wrap);
  const Cam part({line(100, 0, 0)}, 0, Extrapolation::wrap);
  const Cam step({line(100, 0, 0), line(260, 1, 0)}, 0, Extrapolation::wrap);
  for (const Refused& r : {Refused{"base_radius", good, {}},
                           {"base_radius", good, {.base_radius = NAN}},
                           {"roller_radius", good, {.base_radius = 20, .roller_radius = -1}},
                           {"offset", good, {.base_radius = 20, .offset = 20}},
                           {"base_radius", good, {.base_radius = 1e300}},
                           {"base_radius", good, {.base_radius = 9e-6}},
                           {"roller_radius", good, {.base_radius = 20, .roller_radius = 1.1e12}},
                           {"offset", good, {.base_radius = 20, .offset = -1e13}},
                           {"arm_length", good, arm(1e300, 1e300)},
                           {"center_distance", good, arm(40, 1e13)},
                           {"angle", good, {.base_radius = 20, .angle = 0}},
                           {"cam", open, {.base_radius = 20}},
                           {"cam", part, {.base_radius = 20}},
                           {"cam", step, {.base_radius = 20}},
                           {"arm_length", good, arm(0, 50)},
                           {"center_distance", good, arm(40, 0)},
                           {"arm_length", good, arm(10, 50)},
                           {"arm_length", good, arm(14.5, 14.5)}}) {
    try {
      const Disc disc(r.cam, r.spec);
      ADD_FAILURE() << "accepted; expected to name " << r.key;
    } catch (const InputError& error) {
      EXPECT_EQ(error.key(), r.key) << error.what();
    }
  }
}

}  // namespace
}  // namespace jounce::disc_test
