// SPDX-License-Identifier: Apache-2.0
// A drive written as a spec is the drive that is read back.
#include "jounce/spec/detail/drive_file.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/spec/spec.hpp"

namespace jounce::drive_file_test {
namespace {

using ::testing::HasSubstr;

void expect_the_same(DriveSpec wanted, const Units& units) {
  const std::string text = drive_text(wanted, units, "a drive", {});
  DriveSpec found = parse_spec(text, "drive.toml").drive.value();
  const auto a = numbers(wanted.drive);
  const auto b = numbers(found.drive);
  ASSERT_EQ(a.size(), b.size()) << text;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].key, b[i].key);
    EXPECT_EQ(*a[i].value, *b[i].value) << a[i].key << "\n" << text;  // to the last bit
  }
  EXPECT_EQ(wanted.settle, found.settle);
  EXPECT_EQ(wanted.limits.torque, found.limits.torque);
  EXPECT_EQ(wanted.limits.settling_band, found.limits.settling_band);
  EXPECT_EQ(wanted.limits.settling_time, found.limits.settling_time);
  EXPECT_EQ(wanted.sync.size(), found.sync.size());
}

TEST(DriveFile, IsReadBackToTheLastBit) {
  DriveSpec spec{.drive = servo_400w(), .limits = {}, .settle = 0.123};
  const Units units{.x = "s", .position = "mm"};
  expect_the_same(spec, units);
  spec.drive.train[0].stiffness = 100.0 / 3;
  spec.drive.train[0].backlash = 1e-3;
  spec.drive.pendulum = Pendulum{3, 0.01, 0.5};
  spec.limits = {.torque = 1.5, .settling_band = 0.02, .settling_time = 0.1};
  spec.sync = {{0.01, 0.02}};
  expect_the_same(spec, units);
  spec.drive = wittenstein_premo_2d();
  expect_the_same(spec, units);
}

TEST(DriveFile, ReadsTheUncertaintyOfItsNumbers) {
  const DriveSpec spec{.drive = servo_400w(), .limits = {}};
  EXPECT_THAT(
      drive_text(spec, {.x = "s", .position = "mm"}, "head", {{"motor.inertia", "95 %: 1 to 2"}}),
      HasSubstr("; 95 %: 1 to 2\n"));
}

}  // namespace
}  // namespace jounce::drive_file_test
