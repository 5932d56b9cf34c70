// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "jounce/profiles/error.hpp"
#include "jounce/spec/spec.hpp"

#include "support/errors.hpp"

namespace jounce::axis_test {
namespace {

std::string axis_spec(const std::string& keys) {
  return "jounce = 1\nkind = \"axis\"\nunits = { position = \"mm\" }\n[axis]\n" + keys +
         "[limits]\nvelocity = 1\nacceleration = 1\n";
}

AxisSpec read(const std::string& keys) {
  return std::get<AxisSpec>(parse_spec(axis_spec(keys), "a.toml").subject);
}

TEST(AxisSpec, ReadsHowTheAxisStopsAndWhatItWatches) {
  const AxisSpec axis = read(R"(modulo = "36 cm"
stop_acceleration = "2 m/s^2"
stop_jerk = 3
abort_acceleration = 4
limit_acceleration = 5
following_error = "20 um"
following_time = "10 ms"
in_position = 0.01
in_position_time = 0.005
)");
  EXPECT_DOUBLE_EQ(axis.modulo, 360);
  EXPECT_DOUBLE_EQ(axis.stop_acceleration, 2000);
  EXPECT_DOUBLE_EQ(axis.stop_jerk, 3);
  EXPECT_DOUBLE_EQ(axis.abort_acceleration, 4);
  EXPECT_DOUBLE_EQ(axis.limit_acceleration, 5);
  EXPECT_DOUBLE_EQ(axis.following_error, 0.02);
  EXPECT_DOUBLE_EQ(axis.following_time, 0.01);
  EXPECT_DOUBLE_EQ(axis.in_position, 0.01);
  EXPECT_DOUBLE_EQ(axis.in_position_time, 0.005);
}

TEST(AxisSpec, LeavesOffWhatIsNotAskedFor) {
  const AxisSpec axis = read("");
  EXPECT_EQ(axis.modulo, 0);
  EXPECT_EQ(axis.stop_acceleration, 0);
  EXPECT_EQ(axis.following_error, 0);
}

const std::string homing = "[homing]\n";

TEST(AxisSpec, ReadsItsHoming) {
  const AxisSpec axis = read(R"(require_home = true
[homing]
method = 24
search_velocity = "5 cm/s"
index_velocity = 5
acceleration = "1 m/s^2"
offset = "-1 cm"
timeout = "20 s"
distance = 400
)");
  EXPECT_TRUE(axis.require_home);
  ASSERT_TRUE(axis.homing);
  EXPECT_EQ(axis.homing->method, 24);
  EXPECT_DOUBLE_EQ(axis.homing->search_velocity, 50);
  EXPECT_DOUBLE_EQ(axis.homing->index_velocity, 5);
  EXPECT_DOUBLE_EQ(axis.homing->acceleration, 1000);
  EXPECT_DOUBLE_EQ(axis.homing->offset, -10);
  EXPECT_DOUBLE_EQ(axis.homing->timeout, 20);
  EXPECT_EQ(axis.homing->distance, 400);
  EXPECT_FALSE(read("").homing);
  EXPECT_FALSE(read("").require_home);
  const AxisSpec left_out = read(homing);
  EXPECT_EQ(left_out.homing->method, 37);
  EXPECT_EQ(left_out.homing->search_velocity, 0);
  EXPECT_EQ(left_out.homing->timeout, 60);
  EXPECT_FALSE(left_out.homing->distance);
}

// The check of the whole spec must see the other limits, or it reports them as missing.
TEST(AxisSpec, ARangeInTheWrongOrderLeavesTheOtherLimits) {
  std::optional<double> velocity;
  EXPECT_EQ(test::error_of([&] {
              (void)parse_spec(
                  axis_spec("") + "position_min = 5\nposition_max = 1\n", "a.toml",
                  [&](const Spec& spec) { velocity = spec.parts().front().limits.velocity; });
            }),
            "a.toml:8:16: limits.position_min = 5 mm: must not be above position_max = 1 mm: "
            "exchange the two");
  EXPECT_EQ(velocity, 1);
}

TEST(AxisSpec, RejectsAWindowOfNothingAndAWrongUnitWithTheirPlace) {
  const auto complaint = [](const std::string& keys) -> std::string {
    return test::error_of([&] { (void)read(keys); });
  };
  using testing::AllOf;
  using testing::HasSubstr;
  EXPECT_THAT(
      complaint("following_error = 0\n"),
      AllOf(HasSubstr("a.toml:5"), HasSubstr("following_error = 0 mm: must be greater than 0")));
  EXPECT_THAT(complaint("stop_jerk = \"3 mm\"\n"),
              AllOf(HasSubstr("a.toml:5"), HasSubstr("stop_jerk")));
  EXPECT_THAT(complaint("in_position = nan\n"), HasSubstr("in_position"));
  EXPECT_THAT(complaint(homing + "method = 38\n"),
              AllOf(HasSubstr("a.toml:6"), HasSubstr("method = 38: must be 1 to 14")));
  EXPECT_THAT(complaint(homing + "search_velocity = 0\n"),
              HasSubstr("search_velocity = 0 mm/s: must be greater than 0"));
  EXPECT_THAT(complaint(homing + "timeout = -1\n"), HasSubstr("timeout = -1 s: must be"));
  EXPECT_THAT(complaint(homing + "velocity = 1\n"), HasSubstr("velocity"));
}

}  // namespace
}  // namespace jounce::axis_test
