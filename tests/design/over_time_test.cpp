// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/over_time.hpp"

#include <gtest/gtest.h>

#include "jounce/design/sync_zones.hpp"

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

TEST(OverTime, AMotionOverTimeIsRefused) {
  const Input move = read_inputs(JOUNCE_SOURCE_DIR "/examples/generators/03-move.toml").front();
  EXPECT_EQ(test::key_of([&] { over_time(move); }), "input");
  EXPECT_TRUE(sync_zones(move).empty());
}

}  // namespace
}  // namespace jounce::over_time_test
