// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/units.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"

namespace jounce::units_test {
namespace {

TEST(Units, ConvertWhatMeasuresTheSame) {
  EXPECT_DOUBLE_EQ(conversion("mm", "m"), 1e-3);
  EXPECT_DOUBLE_EQ(conversion("nm", "um"), 1e-3);
  EXPECT_DOUBLE_EQ(conversion("rev", "deg"), 360);
  EXPECT_DOUBLE_EQ(conversion("pulse/ms", "pulse/s"), 1000);
  EXPECT_DOUBLE_EQ(conversion("rpm", "rad/s"), 2 * std::numbers::pi / 60);
  EXPECT_DOUBLE_EQ(conversion("kg cm^2", "kg m^2"), 1e-4);
  EXPECT_DOUBLE_EQ(conversion("N m s/rad", "kg m^2/s/rad"), 1);
  EXPECT_DOUBLE_EQ(conversion("inc", "count"), 1);
}

TEST(Units, KeepMetresRadiansAndPulsesApart) {
  EXPECT_THROW(conversion("mm", "deg"), InputError);
  EXPECT_THROW(conversion("deg", "pulse"), InputError);
  EXPECT_THROW(conversion("pulse", "mm"), InputError);
  EXPECT_THROW(conversion("s", "Hz"), InputError) << "an inverse is not a unit of the same thing";
}

TEST(Units, RejectUnknownUnits) {
  for (const char* text : {"", " ", "furlong", "1", "3.5", "m @ 3", "mm)", "[mm]"})
    EXPECT_FALSE(is_unit(text)) << text;
  for (const char* text : {"mm", "mm/deg^2", "1/s", "pulse/pulse", "N.m"})
    EXPECT_TRUE(is_unit(text)) << text;
}

TEST(Quantity, ReadsANumberWithOrWithoutUnit) {
  EXPECT_DOUBLE_EQ(quantity("12.5", "mm"), 12.5);
  EXPECT_DOUBLE_EQ(quantity(" +12.5 cm ", "mm"), 125);
  EXPECT_DOUBLE_EQ(quantity("-3e2deg", "deg"), -300);
  EXPECT_DOUBLE_EQ(quantity("50 pulse/ms", "pulse/s"), 50000);
}

std::string complaint(const char* text, const char* unit) {
  return test::rule_of([&] { (void)quantity(text, unit); }, "no error");
}

TEST(Quantity, ReportsErrorsWithPossibleValues) {
  EXPECT_EQ(complaint("3 deg", "mm"), "deg is not a unit of this quantity: give the value in mm");
  EXPECT_EQ(complaint("2 mm", "1"),
            "mm is not a unit of this quantity: give the value without a unit");
  EXPECT_EQ(complaint("50 mm 3", "mm"), "\"mm 3\" is not a known unit; give the value in mm");
  EXPECT_EQ(complaint("3 furlong", "mm"), "\"furlong\" is not a known unit; give the value in mm");
  for (const char* text : {"", "mm", "nan", "inf", "-inf mm", "1e400"})
    EXPECT_EQ(complaint(text, "mm"),
              "must be a finite number, with or without a unit, such as \"12.5 mm\"")
        << text;
  EXPECT_EQ(complaint("1,5 mm", "mm"), "has a decimal comma: write a point, \"1.5 mm\"");
  EXPECT_EQ(complaint("1,jerk", "mm"), "\",jerk\" is not a known unit; give the value in mm");
}

TEST(Units, KnowTheInternationalFootAndYard) {
  EXPECT_DOUBLE_EQ(conversion("ft", "mm"), 304.8);
  EXPECT_DOUBLE_EQ(conversion("yd", "in"), 36);
  EXPECT_DOUBLE_EQ(conversion("inch/s", "mm/s"), 25.4);
  EXPECT_DOUBLE_EQ(conversion("inches", "in"), 1);
  EXPECT_DOUBLE_EQ(quantity("100 ft/min", "mm/s"), 508);
}

TEST(RateUnit, ReadsAsPeopleWriteIt) {
  EXPECT_EQ(rate_unit("mm", "deg", 0), "mm");
  EXPECT_EQ(rate_unit("mm", "deg", 1), "mm/deg");
  EXPECT_EQ(rate_unit("mm", "s", 3), "mm/s^3");
}

TEST(Units, CyclesAreNoAngle) {
  EXPECT_DOUBLE_EQ(conversion("cpm", "1/s"), 1.0 / 60);
  EXPECT_FALSE(is_convertible("cpm", "rpm"));
  EXPECT_TRUE(is_convertible("mm/s", "m/min"));
  EXPECT_FALSE(is_convertible("mm/s", "furlong"));
}

TEST(Units, ThoseOfPositionsAreLengthsAnglesAndPulses) {
  for (const char* unit : {"mm", "in", "deg", "rev", "pulse", "inc"})
    EXPECT_TRUE(is_position_unit(unit)) << unit;
  for (const char* unit : {"s", "N", "mm/s", "1/m", "deg^2", "", "furlong"})
    EXPECT_FALSE(is_position_unit(unit)) << unit;
}

TEST(Units, AreFoundInAQuantity) {
  EXPECT_EQ(quantity_unit(" 12.5 mm/s "), "mm/s");
  EXPECT_EQ(quantity_unit("+3"), "");
  EXPECT_EQ(quantity_unit("mm"), "");
}

}  // namespace
}  // namespace jounce::units_test
