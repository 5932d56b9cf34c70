// SPDX-License-Identifier: Apache-2.0
#include "jounce/validate/follower.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"
#include "validate/references.hpp"

namespace jounce::follower_test {
namespace {

constexpr double h = 0.01;  // m, lift

SpringFollower valve() {
  SpringFollower f;
  f.mass = 0.2;
  f.linkage_stiffness = 2e6;
  f.spring_stiffness = 3e4;
  f.preload = 250;
  return f;
}

/// Simple harmonic: h/2 (1 - cos w t), turning from the start.
Trajectory harmonic(double w, double turns, double lift = h) {
  Segment f;
  f.length = 2 * std::numbers::pi * turns / w;
  f.c[0] = lift / 2;
  f.sines = 1;
  f.sine[0] = {lift / 2, 2 * std::numbers::pi * turns, -std::numbers::pi / 2};
  return Trajectory({f}, 0, Extrapolation::hold);
}

/// The undamped follower on a harmonic cam, and its flight: closed forms, in absolute coordinates.
struct Closed {
  SpringFollower f;
  double w;

  [[nodiscard]] double own() const {
    return std::sqrt((f.linkage_stiffness + f.spring_stiffness) / f.mass);
  }
  [[nodiscard]] double cam(double t) const { return h / 2 * (1 - std::cos(w * t)); }
  [[nodiscard]] double on(double t) const {
    const double o = own();
    const double rest = -f.preload / (f.linkage_stiffness + f.spring_stiffness);
    return rest + f.linkage_stiffness / f.mass * h / 2 *
                      ((1 - std::cos(o * t)) / (o * o) -
                       (std::cos(w * t) - std::cos(o * t)) / (o * o - w * w));
  }
  [[nodiscard]] double on_speed(double t) const {
    const double o = own();
    return f.linkage_stiffness / f.mass * h / 2 *
           (std::sin(o * t) / o - (-w * std::sin(w * t) + o * std::sin(o * t)) / (o * o - w * w));
  }
  [[nodiscard]] double force(double t) const { return f.linkage_stiffness * (cam(t) - on(t)); }

  /// Ballistic on the spring alone from t0.
  [[nodiscard]] double flight(double t0, double t) const {
    const double s = std::sqrt(f.spring_stiffness / f.mass);
    const double middle = -f.preload / f.spring_stiffness;
    return middle + (on(t0) - middle) * std::cos(s * (t - t0)) +
           on_speed(t0) / s * std::sin(s * (t - t0));
  }
};

/// The first zero of f after `from`, stepping by `step` and then halving.
double first_zero(const std::function<double(double)>& f, double from, double step) {
  double a = from;
  while ((f(a) < 0) == (f(a + step) < 0)) a += step;
  double b = a + step;
  const bool below = f(a) < 0;
  for (int i = 0; i < 80; ++i) {
    const double m = (a + b) / 2;
    ((f(m) < 0) == below ? a : b) = m;
  }
  return (a + b) / 2;
}

/// At this speed a rigid follower would just leave the cam at the top of its lift.
double rigid_jump_speed(const SpringFollower& f) {
  return std::sqrt(2 * (f.spring_stiffness * h + f.preload) / (f.mass * h));
}

TEST(Follower, KeepsToTheClosedFormOnTheCam) {
  // The step of acceleration at the start rings as much again as the cam asks for: well below.
  const double w = 0.6 * rigid_jump_speed(valve());
  const Closed closed{valve(), w};
  FollowerOptions options;
  options.samples = 401;
  options.tolerance = 1e-11;
  const FollowerResult run = follow(harmonic(w, 2), valve(), options);
  ASSERT_TRUE(run.integration.ok()) << run.integration.reason;
  EXPECT_TRUE(run.flights.empty());
  EXPECT_TRUE(run.report.ok());
  double least = 1e300, most = 0;
  for (const FollowerSample& s : run.samples) {
    ASSERT_NEAR(s.mass, closed.on(s.time), 1e-9 * h) << s.time;
    ASSERT_NEAR(s.force, closed.force(s.time), 1e-7 * run.greatest_force.value) << s.time;
  }
  for (int i = 0; i <= 200'000; ++i) {
    const double n = closed.force(run.samples.back().time * i / 200'000);
    least = std::min(least, n);
    most = std::max(most, n);
  }
  EXPECT_NEAR(run.least_force.value, least, 1e-5 * most);
  EXPECT_NEAR(run.greatest_force.value, most, 1e-5 * most);
}

TEST(Follower, LeavesAndLandsWhereTheClosedFormsDo) {
  const double w = 1.15 * rigid_jump_speed(valve());
  const Closed closed{valve(), w};
  const FollowerResult run = follow(harmonic(w, 1), valve());
  ASSERT_TRUE(run.integration.ok()) << run.integration.reason;
  ASSERT_FALSE(run.flights.empty());
  const double period = 2 * std::numbers::pi / w;
  const double off = first_zero([&](double t) { return closed.force(t); }, 0, 1e-5 * period);
  EXPECT_NEAR(run.flights[0].from, off, 1e-8 * period);
  const auto gap = [&](double t) { return closed.flight(off, t) - closed.cam(t); };
  const double on = first_zero(gap, off + 1e-5 * period, 1e-5 * period);
  EXPECT_NEAR(run.flights[0].to, on, 1e-8 * period);
  const double d = 1e-7 * period;
  const double speed = (gap(on - d) - gap(on + d)) / (2 * d);
  EXPECT_NEAR(run.flights[0].impact_speed, speed, 1e-5 * speed);
  double height = 0;
  for (int i = 0; i <= 20'000; ++i) height = std::max(height, gap(off + (on - off) * i / 20'000));
  EXPECT_NEAR(run.flights[0].height, height, 1e-5 * height);
  EXPECT_EQ(run.least_force.value, 0);
  EXPECT_FALSE(run.report.ok());
  EXPECT_EQ(run.report.findings[0].rule, "follower/contact");
  EXPECT_EQ(run.report.findings[0].where, run.flights[0].from);
}

TEST(Follower, AStiffLinkageJumpsAtTheRigidSpeed) {
  // A ramp of the speed's square over many turns would do; two runs either side of it do as well.
  // The linkage rings at the start as the cam starts with a step of acceleration: damped away.
  SpringFollower f = valve();
  f.linkage_stiffness = 1e9;
  f.linkage_damping = 2 * 0.7 * std::sqrt(1e9 * f.mass);
  const double w = rigid_jump_speed(f);
  EXPECT_TRUE(follow(harmonic(0.999 * w, 1), f).flights.empty());
  EXPECT_EQ(follow(harmonic(1.001 * w, 1), f).flights.size(), 1u);
}

TEST(Follower, KeepsItsEnergyInTheAir) {
  const double w = 1.3 * rigid_jump_speed(valve());
  const FollowerResult run = follow(harmonic(w, 1), valve(), {.samples = 20'001});
  ASSERT_FALSE(run.flights.empty());
  const Flight& flight = run.flights[0];
  const double step = run.samples[1].time;
  const SpringFollower f = valve();
  double least = 1e300, most = 0;
  for (std::size_t i = 2; i + 2 < run.samples.size(); ++i) {
    const double t = run.samples[i].time;
    if (t - 2 * step < flight.from || t + 2 * step > flight.to) continue;
    const auto x = [&](std::size_t k) { return run.samples[k].mass; };
    const double v = (8 * (x(i + 1) - x(i - 1)) - (x(i + 2) - x(i - 2))) / (12 * step);
    const double energy =
        f.mass * v * v / 2 + f.spring_stiffness * x(i) * x(i) / 2 + f.preload * x(i);
    least = std::min(least, energy);
    most = std::max(most, energy);
  }
  ASSERT_GT(most, 0);
  EXPECT_NEAR(least, most, 1e-6 * most);
}

TEST(Follower, FindsAJumpWithinASegmentOfADwellCam) {
  // Rise and return of a modified sine at a speed that throws the follower off, after a long dwell.
  CamSpec spec{{0, 0, 0, 0}, {}, true};
  spec.segments = {{Law::modified_sine, {200, 0, {}, {}}, ""},
                   {Law::modified_sine, {260, 10, {}, {}}, ""},
                   {Law::modified_sine, {340, 0, {}, {}}, ""},
                   {Law::modified_sine, {360, 0, {}, {}}, ""}};
  SpringFollower f = valve();
  f.linkage_damping = 50;
  f.meters_per_unit = 1e-3;
  const auto at_speed = [&](double degrees_per_second) {
    return follow(Followed(design(spec).cam, Trajectory({line(1080 / degrees_per_second, 0, 1080)},
                                                        0, Extrapolation::hold)),
                  f, {.settle = 0.05});
  };
  EXPECT_TRUE(at_speed(2000).flights.empty());
  const FollowerResult fast = at_speed(20'000);
  ASSERT_TRUE(fast.integration.ok()) << fast.integration.reason;
  EXPECT_GE(fast.flights.size(), 3u);  // every turn
  for (const Flight& j : fast.flights) {
    EXPECT_LT(j.from, j.to);
    EXPECT_GE(j.height, 0);
  }
  EXPECT_GT(std::abs(fast.residual.value), 0);
}

TEST(Follower, UnitsScaleOut) {
  const double w = 1.15 * rigid_jump_speed(valve());
  SpringFollower millimeters = valve();
  millimeters.meters_per_unit = 1e-3;
  const FollowerResult a = follow(harmonic(w, 1), valve());
  const FollowerResult b = follow(harmonic(w, 1, 1000 * h), millimeters);
  ASSERT_EQ(a.flights.size(), b.flights.size());
  EXPECT_NEAR(a.flights[0].from, b.flights[0].from, 1e-9 * a.flights[0].from);
  EXPECT_NEAR(1000 * a.flights[0].height, b.flights[0].height, 1e-6 * b.flights[0].height);
  EXPECT_NEAR(a.greatest_force.value, b.greatest_force.value, 1e-6 * a.greatest_force.value);
}

TEST(Follower, StaysOnACamThatRests) {
  const FollowerResult run = follow(Trajectory({line(1, h, h)}), valve(), {.samples = 3});
  EXPECT_TRUE(run.report.ok());
  // (7): k_l e with e = (k_s y + F_0) / (k_l + k_s)
  const double force = 2e6 * (3e4 * h + 250) / 2.03e6;
  EXPECT_NEAR(run.least_force.value, force, 1e-9 * force);
  EXPECT_NEAR(run.greatest_force.value, force, 1e-9 * force);
}

TEST(Follower, LimitsGivenAreChecked) {
  const double w = 1.15 * rigid_jump_speed(valve());
  FollowerOptions options;
  options.settle = 0.01;
  options.limits = {10, 100, 0.01, 1e-9};
  const FollowerResult run = follow(harmonic(w, 1), valve(), options);
  EXPECT_EQ(run.report.findings.size(), 4u);
  EXPECT_EQ(run.report.broken(), 4u);
  options.limits = {10, 1e5, 100, 1};
  options.limits.least_force = 0;
  options.settle = 0;
  EXPECT_TRUE(follow(harmonic(w / 2, 1), valve(), options).report.ok());
}

template <class Change>
std::string refused(Change change) {
  SpringFollower f = valve();
  FollowerOptions options;
  change(f, options);
  return test::key_of([&] { follow(harmonic(10, 1), f, options); }, "nothing");
}

TEST(Follower, RejectsParametersOutOfRangeByName) {
  EXPECT_EQ(refused([](auto& f, auto&) { f.mass = 0; }), "mass");
  EXPECT_EQ(refused([](auto& f, auto&) { f.mass = std::nan(""); }), "mass");
  EXPECT_EQ(refused([](auto& f, auto&) { f.linkage_stiffness = 0; }), "linkage_stiffness");
  EXPECT_EQ(refused([](auto& f, auto&) { f.linkage_damping = -1; }), "linkage_damping");
  EXPECT_EQ(refused([](auto& f, auto&) { f.spring_stiffness = -1; }), "spring_stiffness");
  EXPECT_EQ(refused([](auto& f, auto&) { f.preload = -1; }), "preload");
  EXPECT_EQ(refused([](auto& f, auto&) { f.preload = 0; }),
            "preload");  // nothing presses at lift 0
  EXPECT_EQ(refused([](auto& f, auto&) { f.meters_per_unit = 0; }), "meters_per_unit");
  EXPECT_EQ(refused([](auto&, auto& o) { o.settle = -1; }), "settle");
  EXPECT_EQ(refused([](auto&, auto& o) { o.tolerance = 1; }), "tolerance");
  EXPECT_EQ(refused([](auto&, auto& o) { o.limits.impact_speed = 0; }), "limits.impact_speed");
  EXPECT_EQ(refused([](auto&, auto&) {}), "nothing");
}

}  // namespace
}  // namespace jounce::follower_test
