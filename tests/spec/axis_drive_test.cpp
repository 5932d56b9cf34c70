// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/axis_drive.hpp"

#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/spec/spec.hpp"

#include "support/errors.hpp"
#include "support/temporary_folder.hpp"

namespace jounce::axis_drive_test {
namespace {

using ::testing::HasSubstr;

const std::string head = R"(jounce = 1
kind = "axis"
units = { position = "deg" }
[axis]
[limits]
velocity = 1
acceleration = 1
)";

std::optional<AxisDriveSpec> read(const std::string& drive, const std::string& name = "a.toml") {
  return axis_drive(parse_spec(head + drive, name));
}

std::string complaint(const std::string& drive, const std::string& name = "a.toml") {
  return test::error_of([&] { (void)read(drive, name); });
}

TEST(AxisDriveSpec, ReadsTheDriveBehindTheSetpoints) {
  using Type = AxisDriveSpec::Type;
  EXPECT_FALSE(read(""));
  EXPECT_EQ(read("[drive]\ntype = \"null\"\n")->type, Type::null);
  const auto shared = read(R"([drive]
type = "shared_memory"
name = "feeder"
increments_per_rev = 131072
position_per_rev = "1 rev/rev"
reversed = true
)");
  ASSERT_TRUE(shared && shared->shared);
  EXPECT_EQ(shared->type, Type::shared_memory);
  EXPECT_EQ(shared->shared->name, "feeder");
  EXPECT_EQ(shared->shared->increments_per_rev, 131072);
  EXPECT_EQ(shared->shared->position_per_rev, 360);
  EXPECT_TRUE(shared->shared->reversed);
  EXPECT_EQ(shared->shared->silent_cycles, 50);
  const auto simulated = read(
      "[drive]\nposition_per_rev = 360\nmotor = { inertia = 5e-5, torque_limit = 3 }\n"
      "controller = { position_gain = 40, velocity_gain = 0.05 }\n");
  ASSERT_TRUE(simulated && simulated->model);
  EXPECT_EQ(simulated->type, Type::simulated);
  EXPECT_EQ(simulated->model->motor.inertia, 5e-5);
}

TEST(AxisDriveSpec, TakesAModelFromAFileBesideItsOwn) {
  const test::TemporaryFolder folder;
  const std::string unit = "jounce = 1\nkind = \"drive\"\nunits = { position = ";
  const std::string rest =
      " }\n[drive]\nposition_per_rev = 10\nmotor = { inertia = 7e-5, torque_limit = 3 }\n"
      "controller = { position_gain = 40, velocity_gain = 0.05 }\n";
  std::ofstream(folder / "deg.toml") << unit << "\"deg\"" << rest;
  std::ofstream(folder / "mm.toml") << unit << "\"mm\"" << rest;
  const std::string name = (folder / "a.toml").string();
  std::ofstream(name) << head;
  EXPECT_EQ(read("[drive]\nspec = \"deg.toml\"\n", name)->model->motor.inertia, 7e-5);
  EXPECT_THAT(complaint("[drive]\nspec = \"mm.toml\"\n", name), HasSubstr("has the unit mm"));
  EXPECT_THAT(complaint("[drive]\nspec = \"a.toml\"\n", name), HasSubstr("of kind \"drive\""));
  EXPECT_NE(complaint("[drive]\nspec = \"none.toml\"\n", name), "");
}

TEST(AxisDriveSpec, RejectsWhatItsTypeDoesNotHave) {
  EXPECT_THAT(complaint("[drive]\ntype = \"hydraulic\"\n"), HasSubstr("drive.type"));
  EXPECT_THAT(complaint("[drive]\ntype = \"null\"\nname = \"x\"\n"), HasSubstr("drive.name"));
  EXPECT_THAT(complaint("[drive]\ntype = \"shared_memory\"\n"), HasSubstr("drive.name"));
  EXPECT_THAT(complaint("[drive]\ntype = \"shared_memory\"\nname = \"x\"\n"
                        "increments_per_rev = 1000\nposition_per_rev = 1\nsilent_cycles = 0\n"),
              HasSubstr("drive.silent_cycles"));
  EXPECT_THAT(complaint("[drive]\nspec = \"a.toml\"\nmotor.inertia = 1\n"), HasSubstr("a.toml"));
}

TEST(AxisDriveSpec, ReadsTheSensorsOfItsMachine) {
  const auto drive = read(R"([drive]
type = "null"
[drive.machine]
encoder_offset = "0.1 rev"
home_switch = { position = 20, width = 15, inverted = true, bounce = "3 ms" }
negative_switch = { position = -5, bounce = 0.002 }
positive_switch = { position = 320 }
index = { period = "1 rev", offset = 4 }
)");
  ASSERT_TRUE(drive && drive->machine);
  const MachineSensorsSpec& machine = *drive->machine;
  EXPECT_DOUBLE_EQ(machine.encoder_offset, 36);
  EXPECT_EQ(machine.home->position, 20);
  EXPECT_EQ(machine.home->width, 15);
  EXPECT_TRUE(machine.home->inverted);
  EXPECT_DOUBLE_EQ(machine.home->bounce, 0.003);
  EXPECT_EQ(machine.negative->position, -5);
  EXPECT_TRUE(machine.negative->inverted) << "on below it";
  EXPECT_EQ(machine.negative->bounce, 0.002);
  EXPECT_FALSE(machine.positive->inverted);
  EXPECT_EQ(machine.positive->position, 320);
  EXPECT_DOUBLE_EQ(machine.index->period, 360);
  EXPECT_EQ(machine.index->offset, 4);
  EXPECT_FALSE(read("[drive]\ntype = \"null\"\n")->machine);
  const auto model = read(
      "[drive]\nposition_per_rev = 360\nmotor = { inertia = 5e-5, torque_limit = 3 }\n"
      "controller = { position_gain = 40, velocity_gain = 0.05 }\n"
      "[drive.machine]\nindex = { period = 360 }\n");
  EXPECT_TRUE(model->model && model->machine->index);
}

TEST(AxisDriveSpec, RejectsSensorsThatNoMachineHas) {
  const std::string machine = "[drive]\ntype = \"null\"\n[drive.machine]\n";
  EXPECT_THAT(complaint(machine + "home_switch = { width = 3 }\n"),
              HasSubstr("drive.machine.home_switch.position"));
  EXPECT_THAT(complaint(machine + "home_switch = { position = 0, width = 0 }\n"),
              HasSubstr("width = 0 deg: must be greater than 0"));
  EXPECT_THAT(complaint(machine + "home_switch = { position = 0, bounce = -1 }\n"),
              HasSubstr("bounce = -1 s: must not be negative"));
  EXPECT_THAT(complaint(machine + "index = { period = 0 }\n"),
              HasSubstr("period = 0 deg: must be greater than 0"));
  EXPECT_THAT(complaint(machine + "negative_switch = { position = 5 }\n"
                                  "positive_switch = { position = 5 }\n"),
              HasSubstr("must be above the position of the negative switch, 5"));
  EXPECT_THAT(complaint("[drive]\ntype = \"shared_memory\"\nname = \"x\"\n"
                        "increments_per_rev = 1000\nposition_per_rev = 360\n"
                        "[drive.machine]\nindex = { period = 360 }\n"),
              HasSubstr("machine"));
}

}  // namespace
}  // namespace jounce::axis_drive_test
