// SPDX-License-Identifier: Apache-2.0
// [drive] of a spec: every number of the model by its key, and what is refused with which words.
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/spec/spec.hpp"

#include "support/errors.hpp"

namespace jounce::drive_test {
namespace {

using testing::HasSubstr;

std::string spec_with(const std::string& drive, const std::string& unit = "mm") {
  return "jounce = 1\nkind = \"move\"\nunits = { position = \"" + unit +
         "\" }\n[move]\nprofile = \"trapezoid\"\nto = 10\nvelocity = 10\nacceleration = "
         "100\n[drive]\n" +
         drive;
}

DriveSpec drive_of(const std::string& drive) {
  return parse_spec(spec_with(drive), "a.toml").drive.value();
}

std::string refused(const std::string& drive, const std::string& unit = "mm") {
  return test::error_of([&] { (void)parse_spec(spec_with(drive, unit), "a.toml"); });
}

/// Enough for a drive that is valid.
const std::string model = "model = \"servo_400w\"\nposition_per_rev = 10\n";

TEST(DriveSpec, ReadsEveryNumberByItsKey) {
  // Each number in turn, written under its key, is the number read.
  Drive pattern = servo_400w();
  pattern.pendulum = Pendulum{3, 0, 0.5};
  for (const DriveNumber& number : numbers(pattern)) {
    std::string table = number.key.substr(0, number.key.find('.'));
    std::string key = number.key.substr(number.key.find('.') + 1);
    if (number.key == "position_per_rev") continue;
    const std::string value = number.rule == NumberRule::share ? "0.4" : "0.0625";
    std::string text = model;
    if (table == "motor" && key != "rated_torque") text += "[drive.motor]\nrated_torque = 1\n";
    if (table == "motor" && key == "resistance") text += "torque_constant = 1\n";
    if (table == "motor" && key == "rated_torque") text += "[drive.motor]\n";
    if (table == "mass[1]") text += "[[drive.mass]]\n";
    if (table == "controller") text += "[drive.controller]\n";
    if (table == "controller" && key == "encoder_counts") text += "cycle = 1e-3\n";
    if (table == "pendulum") {
      text += "[drive.pendulum]\n";
      if (key != "frequency") text += "frequency = 3\n";
      if (key != "share") text += "share = 0.5\n";
    }
    if (key == "friction.coulomb") text += "friction.breakaway = 1\n";
    text += key + " = " + value + "\n";
    Drive read = drive_of(text).drive;
    bool found = false;
    for (const DriveNumber& got : numbers(read))
      if (got.key == number.key) {
        EXPECT_EQ(*got.value, std::stod(value)) << text;
        found = true;
      }
    EXPECT_TRUE(found) << number.key;
  }
}

TEST(DriveSpec, TakesUnits) {
  const DriveSpec spec = drive_of(
      "model = \"wittenstein_premo_2d\"\nposition_per_rev = \"2 cm/rev\"\n"
      "[drive.motor]\nmax_velocity = \"6000 rpm\"\ninertia = \"0.5 kg cm^2\"\n"
      "torque_constant = \"0.5 N m/A\"\nresistance = \"3 V/A\"\nthermal_time = \"10 min\"\n"
      "[drive.limits]\ncurrent = \"5 A\"\nsettling_band = \"10 um\"\nsettling_time = \"20 ms\"\n"
      "[[drive.sync]]\nfrom = \"10 ms\"\nto = 0.5\n");
  EXPECT_EQ(spec.drive.position_per_rev, 20);
  EXPECT_NEAR(spec.drive.motor.max_velocity, 200 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(spec.drive.motor.inertia, 5e-5, 1e-18);
  EXPECT_EQ(spec.drive.motor.thermal_time, 600);
  EXPECT_NEAR(*spec.limits.settling_band, 0.01, 1e-15);
  ASSERT_EQ(spec.sync.size(), 1u);
  EXPECT_EQ(spec.sync[0].from, 0.01);
}

TEST(DriveSpec, LooksAtLinearLoadsFromTheShaft) {
  const Drive drive = drive_of(model +
                               "[[drive.mass]]\nmass = \"2 kg\"\nload_force = \"10 N\"\n"
                               "belt_stiffness = \"1e5 N/m\"\npulley_radius = \"20 mm\"\n"
                               "[[drive.mass]]\ninertia = 1e-4\n")
                          .drive;
  const double lever = 0.01 / (2 * std::numbers::pi);  // m/rad
  ASSERT_EQ(drive.train.size(), 2u);
  EXPECT_NEAR(drive.train[0].inertia, 2 * lever * lever, 1e-15);
  EXPECT_NEAR(drive.train[0].load_torque, 10 * lever, 1e-15);
  EXPECT_NEAR(drive.train[0].stiffness, 1e5 * 4e-4, 1e-12);
  EXPECT_EQ(drive.train[1].stiffness, 0);
}

TEST(DriveSpec, NamesTheTablesOfFormerKeys) {
  EXPECT_THAT(refused(model + "motor_inertia = 1e-4\n"),
              HasSubstr("drive.motor_inertia = 1e-04: is now inertia in [drive.motor]"));
  EXPECT_THAT(refused(model + "shaft_stiffness = 1\n"), HasSubstr("stiffness in [[drive.mass]]"));
}

TEST(DriveSpec, ReportsAMissingNumberAsMissing) {
  const std::string top =
      "jounce = 1\nkind = \"drive\"\nunits = { position = \"mm\" }\n[drive]\nposition_per_rev = "
      "3\n";
  const auto error = [](const std::string& text) {
    return test::error_of([&] { (void)parse_spec(text, "d.toml"); });
  };
  EXPECT_EQ(error(top),
            "d.toml:4:1: drive.motor.inertia: is missing: add inertia = NUMBER, in kg m^2");
  EXPECT_EQ(error(top + "[drive.motor]\ntorque_limit = 1\n"),
            "d.toml:6:1: drive.motor.inertia: is missing: add inertia = NUMBER, in kg m^2");
  EXPECT_EQ(error(top + "[drive.motor]\ninertia = 0\n"),
            "d.toml:7:11: drive.motor.inertia = 0 kg m^2: must be greater than 0");
}

TEST(DriveSpec, RejectsWithPlaceAndRule) {
  EXPECT_THAT(refused("position_per_rev = 10\n"), HasSubstr("drive.motor.inertia: is missing"));
  EXPECT_THAT(refused(model + "[drive.motor]\ninertia = -1\n"),
              HasSubstr("a.toml:13:11: drive.motor.inertia = -1 kg m^2: must be greater than 0"));
  EXPECT_THAT(refused(model + "[[drive.mass]]\n[[drive.mass]]\ninertia = 1\nbacklash = 1\n"),
              HasSubstr("drive.mass[2].backlash = 1 rad: needs stiffness"));
  EXPECT_THAT(refused(model + "[drive.motor]\ninertia = \"1 N m\"\n"), HasSubstr("kg m^2"));
  EXPECT_THAT(refused(model + "[drive.motor]\ninertai = 1\n"), HasSubstr("did you mean inertia?"));
  EXPECT_THAT(refused(model + "[drive.limits]\ncurrent = 1\n"),
              HasSubstr("drive.limits.current = 1 A: needs motor.torque_constant"));
  EXPECT_THAT(refused(model + "[drive.limits]\nsettling_time = 1\n"), HasSubstr("settling_band"));
  EXPECT_THAT(refused(model + "[[drive.sync]]\nfrom = 2\nto = 1\n"), HasSubstr("sync"));
  EXPECT_THAT(refused(model + "[[drive.mass]]\nmass = 1\ninertia = 1\n"),
              HasSubstr("cannot be combined with inertia"));
  EXPECT_THAT(refused(model + "[[drive.mass]]\nbelt_stiffness = 1\n"), HasSubstr("pulley_radius"));
  EXPECT_THAT(
      refused("model = \"servo_400w\"\nposition_per_rev = 10\n[[drive.mass]]\nmass = 1\n", "deg"),
      HasSubstr("applies to a position in a unit of length"));
  EXPECT_THAT(refused("model = \"servo_9\"\nposition_per_rev = 1\n"), HasSubstr("servo_400w"));
  EXPECT_THAT(refused("model = \"servo_400w\"\nposition_per_rev = 0\n[[drive.mass]]\nmass = 1\n"),
              HasSubstr("drive.position_per_rev = 0 mm/rev: must not be 0"));
}

TEST(DriveSpec, ReadsTolerancesAsSharesOrInTheirUnits) {
  const std::string number = "[[drive.tolerances.number]]\nkey = \"motor.inertia\"\n";
  const auto first = [&](const std::string& more) {
    return drive_of(model + number + more).tolerances.value().numbers.at(0);
  };
  EXPECT_DOUBLE_EQ(first("share = \"20 %\"\n").share, 0.2);
  EXPECT_DOUBLE_EQ(first("share = 0.2\n").share, 0.2);
  EXPECT_DOUBLE_EQ(first("absolute = \"1 kg cm^2\"\n").absolute, 1e-4);
  EXPECT_TRUE(first("share = 0.1\ndistribution = \"normal\"\n").normal);
  const auto said = [&](const std::string& more) { return refused(model + number + more); };
  EXPECT_THAT(said("share = \"20 kg\"\n"), HasSubstr("must be a share such as \"5 %\" or 0.05"));
  EXPECT_THAT(said("share = \"nan %\"\n"), HasSubstr("must be a share such as"));
  EXPECT_THAT(said(""), HasSubstr("share: is missing"));
  EXPECT_THAT(said("share = 0.1\nshares = 1\n"), HasSubstr("did you mean share?"));
  EXPECT_THAT(refused(model + "[drive.tolerances]\nmethod = \"corners\"\n"),
              HasSubstr("needs at least one [[drive.tolerances.number]]"));
  EXPECT_THAT(
      refused(model + "[[drive.tolerances.number]]\nkey = \"motor.inertai\"\nshare = 0.1\n"),
      HasSubstr("did you mean motor.inertia?"));
}

}  // namespace
}  // namespace jounce::drive_test
