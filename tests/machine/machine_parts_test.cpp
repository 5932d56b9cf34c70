// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/machine_parts.hpp"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "support/errors.hpp"

namespace jounce::machine_parts_test {
namespace {

class MachineParts : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) / ("parts_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// A spec of kind "axis" in mm and min: 1.2 m/min.
  std::string axis(const std::string& name, const std::string& more = "") {
    const std::string path = (folder_ / (name + ".toml")).string();
    std::ofstream(path) << "jounce = 1\nkind = \"axis\"\nname = \"" << name
                        << "\"\nunits = { position = \"mm\", master = \"mm\", time = \"min\" }\n"
                           "[axis]\ncycle = \"2 ms\"\n[limits]\nvelocity = 1200\n"
                           "acceleration = 3600\n"
                        << more;
    return path;
  }

  std::filesystem::path folder_;
};

TEST_F(MachineParts, HaveTheNumbersOfTheirSpecsInSeconds) {
  const auto parts = machine_parts({.files = {axis("feeder")}, .log = "run.csv", .enable = true});
  ASSERT_EQ(parts.axes.size(), 1U);
  const ExecutorOptions& feeder = parts.axes[0];
  EXPECT_EQ(feeder.receiver.executor, "feeder");
  EXPECT_EQ(feeder.axis.period, 2'000'000);
  EXPECT_DOUBLE_EQ(feeder.axis.limits.velocity.value(), 20);
  EXPECT_DOUBLE_EQ(feeder.axis.limits.acceleration.value(), 1);
  EXPECT_EQ(feeder.log, "run.csv");
  EXPECT_TRUE(feeder.enable);
  EXPECT_TRUE(parts.masters.empty());
}

TEST_F(MachineParts, FollowEachOtherByName) {
  const std::string leader = axis("line"), slave = axis("knife", "[follow]\naxis = \"line\"\n");
  const auto parts = machine_parts({.files = {slave, leader}});
  EXPECT_EQ(parts.axes[0].follow.index, 1U);
  EXPECT_EQ(parts.axes[0].follow.what, Follow::What::setpoint);
  EXPECT_THAT(test::error_of([&] { machine_parts({.files = {slave}}); }),
              testing::HasSubstr("follow.axis = line: is not an axis of this machine"));
}

TEST_F(MachineParts, SendTheirNoticesWithTheNameOfTheAxis) {
  std::vector<std::string> notices;
  const auto notify = [&](const std::string& notice) { notices.push_back(notice); };
  const auto parts = machine_parts({.files = {axis("a"), axis("b")}, .notify = notify});
  parts.axes[1].notify("late");
  EXPECT_THAT(notices, testing::ElementsAre("b: late"));
}

TEST(LogOf, NamesTheAxisIfThereAreSeveral) {
  EXPECT_EQ(log_of("run.csv", "feeder", 1), "run.csv");
  EXPECT_EQ(log_of("logs/run.csv", "feeder", 2), "logs/run.feeder.csv");
}

}  // namespace
}  // namespace jounce::machine_parts_test
