// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gtest/gtest.h>

#include "jounce/spec/spec.hpp"

#include "support/errors.hpp"

namespace jounce::coupling_test {
namespace {

std::string cam(const std::string& coupling) {
  return R"(jounce = 1
kind = "cam"
units = { master = "deg", position = "mm", time = "ms" }
start = { master = 0, slave = 0 }
[[segment]]
law = "quintic"
end = { master = 360, slave = 50 }
)" + coupling;
}

std::string complaint(const std::string& text) {
  return test::error_of([&] { (void)parse_spec(text, "a.toml"); });
}

TEST(SpecCoupling, ReadsEveryKeyInSeconds) {
  const Spec spec = parse_spec(cam(R"(
[coupling]
master_scaling = 2
master_offset = "0.25 rev"
slave_scaling = 0.5
slave_offset = 3
master_absolute = false
slave_absolute = false
start = "ramp_in_pos"
velocity_diff = 0.2
acceleration = "4000 mm/s^2"
deceleration = 0.003
jerk = 1e-4
distance = 90
slave_period = "5 cm"
)"),
                               "a.toml");
  ASSERT_TRUE(spec.coupling);
  const CouplingSpec& c = *spec.coupling;
  EXPECT_EQ(c.master_scaling, 2);
  EXPECT_DOUBLE_EQ(c.master_offset, 90);
  EXPECT_EQ(c.slave_scaling, 0.5);
  EXPECT_EQ(c.slave_offset, 3);
  EXPECT_FALSE(c.master_absolute);
  EXPECT_FALSE(c.slave_absolute);
  EXPECT_EQ(c.start, StartMode::ramp_in_pos);
  EXPECT_DOUBLE_EQ(*c.velocity_diff, 200) << "0.2 mm/ms";
  EXPECT_DOUBLE_EQ(*c.acceleration, 4000);
  EXPECT_DOUBLE_EQ(*c.deceleration, 3000);
  EXPECT_DOUBLE_EQ(*c.jerk, 1e5);
  EXPECT_EQ(*c.distance, 90);
  EXPECT_DOUBLE_EQ(*c.slave_period, 50);
}

TEST(SpecCoupling, IsAbsoluteByDefaultAndMayBeLeftOut) {
  EXPECT_FALSE(parse_spec(cam(""), "a.toml").coupling);
  const auto c = parse_spec(cam("[coupling]\n"), "a.toml").coupling;
  ASSERT_TRUE(c);
  EXPECT_EQ(c->start, StartMode::absolute);
  EXPECT_TRUE(c->master_absolute && c->slave_absolute);
  EXPECT_EQ(c->master_scaling, 1);
}

TEST(SpecCoupling, RejectsWithPlaceKeyValueAndRule) {
  EXPECT_EQ(complaint(cam("[coupling]\nslave_scaling = -1\n")),
            "a.toml:9:17: coupling.slave_scaling = -1: must be greater than 0");
  const std::string missing = complaint(cam("[coupling]\nstart = \"ramp_in\"\nacceleration = 1\n"));
  EXPECT_NE(missing.find("coupling.velocity_diff: is missing: add velocity_diff = NUMBER, in "),
            std::string::npos)
      << missing;
  EXPECT_NE(missing.find(": start = \"ramp_in\" needs it"), std::string::npos) << missing;
  EXPECT_NE(complaint(cam("[coupling]\nstart = \"ramp\"\n")).find("coupling.start = \"ramp\""),
            std::string::npos)
      << "HMPL 0x1390";
  EXPECT_NE(complaint("periodic = 2\n" + cam("")).find("periodic = 2"), std::string::npos)
      << "HMPL 0x1391";
  EXPECT_NE(complaint(cam("[coupling]\nvelocity = 1\n")).find("coupling.velocity"),
            std::string::npos)
      << "unknown keys";
}

}  // namespace
}  // namespace jounce::coupling_test
