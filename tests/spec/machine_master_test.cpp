// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/spec/machine_spec.hpp"

#include "support/errors.hpp"

namespace jounce::machine_master_test {
namespace {

using ::testing::HasSubstr;

MachineSpec machine(const std::string& masters) {
  const auto parsed = parse_machine(
      "jounce = 1\nkind = \"machine\"\n[[axis]]\nspec = \"knife.toml\"\n" + masters, "m.toml");
  return parsed.value();
}

std::string complaint(const std::string& masters) {
  return test::error_of([&] { (void)machine(masters); });
}

const std::string line =
    "[master.line]\nkind = \"external\"\nunit = \"mm\"\nvelocity = 1500\nacceleration = \"20 "
    "m/s^2\"\n";

TEST(MachineMaster, AnExternalOneHasTheFiltersKeysInItsUnit) {
  const MachineSpec m = machine(line + "latency = \"2 ms\"\njump = \"1 cm\"\norder = 2\n");
  ASSERT_EQ(m.masters.size(), 1U);
  EXPECT_EQ(m.masters[0].name, "line");
  EXPECT_EQ(m.masters[0].unit, "mm");
  EXPECT_EQ(m.masters[0].key, "master.line");
  const TrackingSpec& t = std::get<MachineMasterSpec::External>(m.masters[0].what).tracking;
  EXPECT_EQ(t.velocity, 1500);
  EXPECT_EQ(t.acceleration, 20000);
  EXPECT_EQ(t.latency, 0.002);
  EXPECT_EQ(t.jump, 10);
  EXPECT_EQ(t.order, 2);
  EXPECT_EQ(t.time_constant, 0.01) << "as docs/executor/masters.md has it";
  EXPECT_EQ(t.longest_age, 0.1);
}

TEST(MachineMaster, AnEncoderIsReadFromAnAxisOrADriveOfItsOwn) {
  const MachineSpec m = machine(
      "[master.a]\nkind = \"encoder\"\nunit = \"mm\"\nvelocity = 1\nacceleration = 2\naxis = "
      "\"knife\"\n"
      "resolution = \"50 um\"\nnoise = 0.01\nseed = 7\n"
      "[master.b]\nkind = \"encoder\"\nunit = \"deg\"\nvelocity = 1\nacceleration = 2\n"
      "drive = { name = \"web\", increments_per_rev = 4096, position_per_rev = 360 }\n");
  ASSERT_EQ(m.masters.size(), 2U);
  const auto& a = std::get<MachineMasterSpec::Encoder>(m.masters[0].what);
  EXPECT_EQ(a.axis, "knife");
  EXPECT_NEAR(a.resolution, 0.05, 1e-15);
  EXPECT_EQ(a.noise, 0.01);
  EXPECT_EQ(a.seed, 7U);
  const auto& b = std::get<MachineMasterSpec::Encoder>(m.masters[1].what);
  ASSERT_TRUE(b.drive.has_value());
  EXPECT_EQ(b.drive->name, "web");
  EXPECT_EQ(b.drive->position_per_rev, 360);
}

TEST(MachineMaster, ATableLiesBesideTheMachinesSpec) {
  const auto parsed = parse_machine(
      "jounce = 1\nkind = \"machine\"\n[[axis]]\nspec = \"a.toml\"\n[master.v]\nkind = \"table\"\n"
      "unit = \"mm\"\nfile = \"line.csv\"\nvelocity = 10\nacceleration = 20\njerk = 30\n",
      "plant/m.toml");
  const auto& v = std::get<MachineMasterSpec::FromTable>(parsed->masters.at(0).what);
  EXPECT_EQ(v.file, "plant/line.csv");
  EXPECT_EQ(v.limits.jerk, 30);
}

TEST(MachineMaster, ReportsErrorsWithTheirPlace) {
  EXPECT_THAT(complaint(line + "order = 4\n"), HasSubstr("m.toml:10"));
  EXPECT_THAT(complaint(line + "order = 4\n"), HasSubstr("master.line.order = 4: must be 2 or 3"));
  EXPECT_THAT(complaint(line + "latency = -1\n"), HasSubstr("master.line.latency"));
  EXPECT_THAT(complaint(line + "settle = 0\n"), HasSubstr("must be greater than 0"));
  EXPECT_THAT(complaint(line + "velocty = 0\n"), HasSubstr("velocty"));
  EXPECT_THAT(complaint(line + "setle = 1\n"), HasSubstr("did you mean settle?"));
  for (const char* key : {"longest_age", "latency", "settle", "time_constant"}) {
    EXPECT_THAT(complaint(line + key + " = 1e300\n"),
                HasSubstr("master.line." + std::string(key) + " = 1e300 s: must be at most 60 s"));
  }
  EXPECT_THAT(complaint(line + "latency = \"-1 ms\"\n"), HasSubstr("must not be negative"));
  EXPECT_EQ(complaint(line + "longest_age = \"1 min\"\n"), "");
  EXPECT_THAT(complaint("[master.line]\nkind = \"extern\"\n"), HasSubstr("external"));
  EXPECT_THAT(complaint("[master.line]\nkind = \"external\"\nunit = \"mmm\"\n"),
              HasSubstr("master.line.unit"));
  EXPECT_THAT(complaint("[master.line]\nkind = \"external\"\nunit = \"mm\"\nacceleration = 2\n"),
              HasSubstr("velocity"));
  EXPECT_THAT(complaint("[master.\"the line\"]\nkind = \"external\"\n"),
              HasSubstr("must have 1 to 23 characters, each a letter"));
  EXPECT_THAT(complaint("[master.a]\nkind = \"encoder\"\nunit = \"mm\"\nvelocity = 1\n"
                        "acceleration = 2\n"),
              HasSubstr("axis: is missing: add axis = \"NAME\", or [drive] of the master"));
  EXPECT_THAT(complaint("[master]\nline = 3\n"),
              HasSubstr("is not a master: begin a section [master.NAME]"));
}

}  // namespace
}  // namespace jounce::machine_master_test
