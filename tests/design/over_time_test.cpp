// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/over_time.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/design/detail/cam_check.hpp"
#include "jounce/design/detail/sync_zones.hpp"

#include "support/errors.hpp"

namespace jounce::over_time_test {
namespace {

// 20 in/s over 14.13 in: three cuts of 4.71 in, a turn each, in step once a cut.
TEST(OverTime, ACamIsTheMotionOfItsSlave) {
  const Input cam = read_inputs(JOUNCE_SOURCE_DIR "/examples/rotary-knife/knife.toml").front();
  const Input slave = over_time(cam);
  const auto& motion = std::get<Trajectory>(*slave.curve);
  EXPECT_NEAR(motion.length(), 14.13 / 20, 1e-9);
  EXPECT_NEAR(motion.jet(motion.end(), Side::left)[0] - motion.jet(motion.start())[0], 3 * 360,
              1e-6);
  EXPECT_EQ(slave.limits.velocity, cam.spec->slave.velocity);
  // The cam begins in the middle of a zone. Two halves that meet between two cuts are one zone: half, 2 wholes, half.
  EXPECT_EQ(sync_zones(cam).size(), 2U);
  EXPECT_EQ(slave.zones.size(), 4U);
  for (const SyncZone& zone : slave.zones) EXPECT_LT(zone.from, zone.to);
}

// The press pusher: 40 mm by the modified sine in a quarter of a turn, at 120 turns a minute, without a limit. The
// modified sine has Cv = 4 pi / (4 + pi), Ca = 4 pi^2 / (4 + pi), Cj = 16 pi^3 / (4 + pi).
TEST(OverTime, ThePeaksOfTheSlaveAreThoseOfItsLaw) {
  const std::string file = JOUNCE_SOURCE_DIR "/examples/press-pusher/pusher.toml";
  Spec spec = read_spec(file);
  spec.slave = {};
  spec.master->acceleration.reset();
  const Input slave = over_time(inputs_of(spec, file).front());
  const Ranges peaks = extrema(std::get<Trajectory>(*slave.curve));
  const double t = 0.125;
  const double pi = std::numbers::pi;
  EXPECT_NEAR(peaks[0].max.value, 40, 1e-12);
  EXPECT_NEAR(peaks[1].max.value, 4 * pi / (4 + pi) * 40 / t, 1e-10);
  EXPECT_NEAR(peaks[2].max.value, 4 * pi * pi / (4 + pi) * 40 / (t * t), 1e-8);
  EXPECT_NEAR(peaks[3].max.value, 16 * pi * pi * pi / (4 + pi) * 40 / (t * t * t), 1e-4);
  EXPECT_FALSE(slave.limits.velocity);
  Report report = checked(slave);
  add_not_limited(report, slave);
  EXPECT_THAT(not_limited_text(report, slave.labels),
              testing::HasSubstr("velocity (up to 563.073 mm/s)"));
}

// The table over time against the cam behind its accelerating master, by the chain rule.
TEST(OverTime, TheTableKeepsItsCertifiedErrorAgainstTheChainRule) {
  const std::string file = JOUNCE_SOURCE_DIR "/examples/press-pusher/pusher.toml";
  Spec spec = read_spec(file);
  spec.master->acceleration = 2000;
  spec.table.tolerance = 1e-4;
  const Input cam = inputs_of(spec, file).front();
  const Input slave = over_time(cam);
  const Trajectory master = make_master(spec);
  const auto& f = std::get<Cam>(*cam.curve);
  const Trajectory played = slave.table.table.curve<OverTime>();
  EXPECT_EQ(slave.table.units.x, "s");
  EXPECT_NEAR(played.end(), master.end(), 1e-12);
  double worst = 0;
  for (int i = 0; i <= 5000; ++i) {
    const double t = master.end() * i / 5000;
    worst = std::max(
        worst, std::abs(played.jet(t, Side::left)[0] - f.jet(master.jet(t, Side::left)[0])[0]));
  }
  EXPECT_GT(worst, 1e-6) << "a coarse table";
  EXPECT_LE(worst, slave.error->position);
  EXPECT_LE(slave.error->position, 1.0001e-4);
}

TEST(OverTime, PositionLimitsHoldOverTimeToo) {
  Spec spec = read_spec(JOUNCE_SOURCE_DIR "/examples/press-pusher/pusher.toml");
  spec.limits.position_max = 39;
  const Report report = checked(over_time(inputs_of(spec, "pusher.toml").front()));
  EXPECT_FALSE(report.ok());
  EXPECT_EQ(report.findings.front().rule, "limit/position_max");
}

TEST(OverTime, TheWordOfAnOptionFitsTheFile) {
  const Input cam = read_inputs(JOUNCE_SOURCE_DIR "/examples/rotary-knife/knife.toml").front();
  const Input move = read_inputs(JOUNCE_SOURCE_DIR "/examples/generators/03-move.toml").front();
  EXPECT_TRUE(over("", cam).labels.over_master);
  EXPECT_TRUE(over("master", cam).labels.over_master);
  EXPECT_FALSE(over("time", cam).labels.over_master);
  EXPECT_EQ(test::key_of([&] { (void)over("master", move); }), "over");
  EXPECT_EQ(test::key_of([&] { (void)over("time", move); }), "over");
  EXPECT_EQ(test::key_of([&] { (void)over("time", input_of(cam.table, "knife.csv")); }), "over");
}

TEST(OverTime, AMotionOverTimeIsRejected) {
  const Input move = read_inputs(JOUNCE_SOURCE_DIR "/examples/generators/03-move.toml").front();
  EXPECT_EQ(test::key_of([&] { over_time(move); }), "FILE");
  EXPECT_TRUE(sync_zones(move).empty());
}

}  // namespace
}  // namespace jounce::over_time_test
