// SPDX-License-Identifier: Apache-2.0
// [compensation] of an axis: its table, its references, a user table, and mistakes.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/spec/spec.hpp"

#include "support/errors.hpp"

namespace jounce::compensation_spec_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string folder = JOUNCE_SOURCE_DIR "/examples/compensated-table/";

Spec axis(const std::string& compensation) {
  return parse_spec(
      "jounce = 1\nkind = \"axis\"\nname = \"x\"\nunits = { position = \"mm\" }\n[axis]\n"
      "[limits]\nvelocity = 1\nacceleration = 1\n[compensation]\n" +
          compensation,
      folder + "a.toml");
}

const AxisSpec::Compensation& of(const Spec& spec) {
  return *std::get<AxisSpec>(spec.subject).compensation;
}

std::string error(const std::string& compensation) {
  return test::error_of([&] { (void)axis(compensation); });
}

const std::string grid = "reference = [{ base = -1, interval = 1, count = 3 }]\n";

TEST(CompensationSpecOfAnAxis, HasItsTableAndItsReferences) {
  const Spec spec = axis(
      "most = \"0.5 mm\"\nrule = \"cubic\"\nvalues = [0.1, 0, \"200 um\", 0, 0, 0]\n"
      "reference = [{ base = 0, interval = 1, count = 3 },\n"
      "  { axis = \"c\", unit = \"deg\", base = \"1 rev\", interval = 90, count = 2 }]\n");
  const auto& got = of(spec);
  EXPECT_THAT(got.axes, ElementsAre("", "c"));
  EXPECT_THAT(got.units, ElementsAre("mm", "deg"));
  EXPECT_THAT(got.table.values, ElementsAre(0.1, 0, 0.2, 0, 0, 0));
  EXPECT_EQ(got.table.axes[1].base, 360);
  EXPECT_EQ(got.table.most, 0.5);
  EXPECT_EQ(got.table.rule, GridRule::cubic);
}

TEST(CompensationSpecOfAnAxis, TakesItsValuesFromAUserTable) {
  const Spec spec =
      axis("most = 1\n" + grid + "user_table = { file = \"corrections.csv\", start = 11 }\n");
  EXPECT_THAT(of(spec).table.values, ElementsAre(0.1, -0.4, -0.4));
}

TEST(CompensationSpecOfAnAxis, MistakesAreNamed) {
  EXPECT_THAT(error(grid + "values = [0, 0, 0]\n"), HasSubstr("compensation.most: is missing"));
  EXPECT_THAT(error("most = 1\nvalues = [0]\n"), HasSubstr("compensation.reference: is missing"));
  EXPECT_THAT(error("most = 1\n" + grid + "values = [0, 1.1, 0]\n"),
              HasSubstr("values[2] = 1.1 mm: exceeds most, 1 mm (HIMC error 0x83aa0802)"));
  EXPECT_THAT(error("most = 0\n" + grid + "values = [0, 1, 0]\n"),
              HasSubstr("must be greater than 0"));
  EXPECT_THAT(error("most = 1\n" + grid + "values = [0, 1]\n"), HasSubstr("values"));
  EXPECT_THAT(error("most = 1\n" + grid + "values = [0, \"1 deg\", 0]\n"), HasSubstr("deg"));
  EXPECT_THAT(error("most = 1\nvalues = [0, 0]\n"
                    "reference = [{ base = 0, interval = -1, count = 2 }]\n"),
              HasSubstr("compensation.reference[1].interval = -1 mm: must be greater than 0"));
  EXPECT_THAT(error("most = 1\nvalues = [0, 0]\n"
                    "reference = [{ base = 0, interval = 1, count = 2, unit = \"deg\" }]\n"),
              HasSubstr("must be mm, the unit of this axis"));
  EXPECT_THAT(error("most = 1\nvalues = [0, 0, 0, 0]\n"
                    "reference = [{ base = 0, interval = 1, count = 2 },\n"
                    "  { axis = \"x\", base = 0, interval = 1, count = 2 }]\n"),
              HasSubstr("reference[2].axis = \"x\": is this axis, as in another reference"));
  EXPECT_THAT(error("most = 1\nvalues = [0, 0, 0, 0]\n"
                    "reference = [{ axis = \"y\", base = 0, interval = 1, count = 2 },\n"
                    "  { axis = \"y\", base = 0, interval = 1, count = 2 }]\n"),
              HasSubstr("is the axis of two references"));
  EXPECT_THAT(error("most = 1\n" + grid + "user_table = { file = \"none.csv\" }\n"),
              HasSubstr("none.csv"));
  EXPECT_THAT(
      error("most = 1\n" + grid + "user_table = { file = \"corrections.csv\", start = 17 }\n"),
      HasSubstr(
          "user_table.start = 17: needs 3 entries of the table, but the index 19 has no value"));
  EXPECT_THAT(error("most = 1\n" + grid +
                    "values = [0, 0, 0]\nuser_table = { file = \"corrections.csv\" }\n"),
              HasSubstr("cannot be combined with values"));
}

}  // namespace
}  // namespace jounce::compensation_spec_test
