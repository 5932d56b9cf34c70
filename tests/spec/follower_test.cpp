// SPDX-License-Identifier: Apache-2.0
// [follower] of a spec: its keys, and what is refused at which line.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/spec/spec.hpp"

#include "support/errors.hpp"

namespace jounce::follower_test {
namespace {

using test::error_of;
using ::testing::HasSubstr;

const std::string head = R"(jounce = 1
kind = "cam"
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }
segment = [ { law = "quintic", end = { master = 360, slave = 10 } } ]
)";
const std::string master = "master = { velocity = 360, distance = 360 }\n";
const std::string follower = R"([follower]
mass = "200 g"
linkage_stiffness = "5e6 N/m"
linkage_damping = 100
spring_stiffness = "30 N/mm"
preload = 250
settle = "20 ms"
)";

std::string refused(const std::string& text) {
  return error_of([&] { (void)parse_spec(text, "valve.toml"); });
}

TEST(FollowerSpec, IsReadInSIUnits) {
  const Spec spec = parse_spec(
      head + master + follower + "[follower.limits]\nleast_force = 20\nresidual = \"10 um\"\n",
      "valve.toml");
  const SpringFollower& f = spec.follower.value().follower;
  EXPECT_DOUBLE_EQ(f.mass, 0.2);
  EXPECT_DOUBLE_EQ(f.spring_stiffness, 30e3);
  EXPECT_DOUBLE_EQ(f.preload, 250);
  EXPECT_DOUBLE_EQ(f.meters_per_unit, 1e-3);
  EXPECT_DOUBLE_EQ(spec.follower->settle, 0.02);
  EXPECT_DOUBLE_EQ(spec.follower->limits.least_force.value(), 20);
  EXPECT_DOUBLE_EQ(spec.follower->limits.residual.value(), 0.01);
  EXPECT_FALSE(spec.follower->limits.impact_speed);
}

TEST(FollowerSpec, RejectsWhatCannotBe) {
  const auto with = [](const std::string& more) {
    return refused(head + master + follower + more);
  };
  EXPECT_THAT(refused(head + follower), HasSubstr("follower: needs the speed of the master"));
  EXPECT_THAT(with("prelod = 3\n"), HasSubstr("follower.prelod = 3: is not a key"));
  EXPECT_THAT(
      with("[follower.limits]\nleast_force = -20\n"),
      HasSubstr("valve.toml:15:15: follower.limits.least_force = -20 N: must not be negative"));
  EXPECT_THAT(with("[follower.limits]\nimpact_speed = 0\n"),
              HasSubstr("follower.limits.impact_speed = 0 m/s: must be greater than 0"));
  EXPECT_THAT(with("[follower.limits]\nresidual = nan\n"), HasSubstr("must be a finite number"));
  std::string turned = head + master + follower;
  turned.replace(turned.find("\"20 ms\""), 7, "-0.5");
  EXPECT_THAT(refused(turned), HasSubstr("follower.settle = -0.5 s: must not be negative"));
  turned = head + master + follower;
  turned.replace(turned.find("\"mm\""), 4, "\"deg\"");
  EXPECT_THAT(refused(turned),
              HasSubstr("needs a slave with a unit of length, such as mm, not deg"));
}

}  // namespace
}  // namespace jounce::follower_test
