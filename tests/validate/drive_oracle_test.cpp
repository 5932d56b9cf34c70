// SPDX-License-Identifier: Apache-2.0
// Backlash and dry friction against tests/oracle/drive.py, which shares nothing with us.

#include <fstream>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/validate/drive.hpp"

#include "validate/references.hpp"

namespace jounce::drive_oracle_test {
namespace {

void expect_oracle(const std::string& name, const Drive& drive) {
  const nlohmann::json oracle =
      nlohmann::json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/drive.json")).at(name);
  const DriveResult run =
      drive_through(test::law_345(360, 0.2), drive, {.settle = 0.2, .samples = 41});
  ASSERT_TRUE(run.integration.ok()) << run.integration.reason;
  const double radians = std::numbers::pi / 180;
  for (std::size_t i = 0; i < 41; ++i) {
    EXPECT_NEAR(run.samples[i].motor * radians, oracle["motor"][i].get<double>(), 2e-8) << i;
    EXPECT_NEAR(run.samples[i].load * radians, oracle["load"][i].get<double>(), 2e-8) << i;
  }
  // The start, the standstill and every switch: the same switches as the oracle's.
  EXPECT_NEAR(static_cast<double>(run.integration.restarts), oracle["switches"].get<double>(), 3);
}

TEST(DriveOracle, Backlash) {
  Drive drive = servo_400w();
  drive.train[0].backlash = 2e-3;
  expect_oracle("backlash", drive);
}

TEST(DriveOracle, StribeckFriction) {
  Drive drive = servo_400w();
  drive.motor.friction = {1e-4, 0.02, 0.03, 2};
  drive.train[0].friction = {1e-4, 0.05, 0.08, 2};
  expect_oracle("stribeck", drive);
}

TEST(DriveOracle, BacklashAndFriction) {
  Drive drive = servo_400w();
  drive.train[0].backlash = 4e-3;
  drive.train[0].friction = {1e-4, 0.05, 0.08, 2};
  expect_oracle("both", drive);
}

}  // namespace
}  // namespace jounce::drive_oracle_test
