// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/cut_map.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/design/detail/sync_check.hpp"

#include "support/errors.hpp"

namespace jounce::cut_map_test {
namespace {

const Spec knife = read_spec(JOUNCE_SOURCE_DIR "/examples/rotary-knife/knife.toml");

TEST(CutMap, HasTheFastestLineOfEachLength) {
  const CutLengths cuts = cut_lengths(knife);
  const CutLimits limits = cut_limits(knife, std::nullopt);
  EXPECT_EQ(limits.line_speed, 20) << "of [master]";
  const CutMap map = cut_map(knife, cuts, limits, 2, 8, 13);
  ASSERT_EQ(map.speeds.size(), 13U);
  for (std::size_t i = 0; i < map.speeds.size(); ++i) {
    EXPECT_NEAR(map.speeds[i].length, 2 + 0.5 * static_cast<double>(i), 1e-12);
    EXPECT_EQ(map.speeds[i].speed, cuts.fastest(map.speeds[i].length, limits).speed);
    EXPECT_LE(map.speeds[i].speed, limits.line_speed);
  }
  EXPECT_EQ(map.speed_unit(), "in/s");
  EXPECT_THAT(to_csv(map),
              ::testing::HasSubstr("cut_length [in],line_speed [in/s],cuts [1/min],limit\n"));
}

// The map and the figures of cuts are for a line at constant speed; check includes its acceleration.
TEST(CutMap, StatesThatTheLineHasConstantSpeed) {
  Spec ramped = knife;
  const auto csv = [](const Spec& spec) {
    return to_csv(cut_map(spec, cut_lengths(spec), cut_limits(spec, std::nullopt), 2, 8, 3));
  };
  const std::string statement =
      "# for a line at constant speed: `jounce check` also includes the acceleration of [master], "
      "50 in/s^2, ";
  ramped.master->acceleration.reset();
  EXPECT_THAT(csv(ramped), ::testing::Not(::testing::HasSubstr("constant speed")));
  ramped.master->acceleration = 50;
  EXPECT_THAT(csv(ramped), ::testing::HasSubstr(statement));
  EXPECT_THAT(sync_figures(ramped).back().meaning, ::testing::HasSubstr("at constant 20 in/s, "));
}

TEST(CutMap, WithoutALimitThereIsNoMap) {
  Spec free = knife;
  free.slave = {};
  free.master.reset();
  EXPECT_EQ(test::key_of([&] { cut_limits(free, std::nullopt); }), "limits.slave");
  EXPECT_EQ(cut_limits(free, 3.0).line_speed, 3);
}

}  // namespace
}  // namespace jounce::cut_map_test
