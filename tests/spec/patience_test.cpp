// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/spec/axis_drive.hpp"
#include "jounce/spec/machine_spec.hpp"
#include "jounce/spec/spec.hpp"

#include "support/errors.hpp"

// Permitted silence and lateness of an axis, its owner and its machine; and named files that are
// missing.

namespace jounce::patience_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

template <class Read>
std::string complaint(const Read& read) {
  return test::error_of([&] { (void)read(); });
}

Spec axis(const std::string& keys) {
  return parse_spec(
      "jounce = 1\nkind = \"axis\"\nunits = { position = \"mm\" }\n[axis]\ncycle = \"2 ms\"\n" +
          keys + "[limits]\nvelocity = 1\nacceleration = 1\n",
      "a.toml");
}

MachineSpec machine(const std::string& keys) {
  return parse_machine("jounce = 1\nkind = \"machine\"\n" + keys + "[[axis]]\nspec = \"x.toml\"\n",
                       "m.toml")
      .value();
}

TEST(AxisPatience, IsInSecondsAndLeftOutAsItEverWas) {
  const Spec left_out = axis("");
  EXPECT_EQ(std::get<AxisSpec>(left_out.subject).longest_gap, 0) << "the executor's own";
  EXPECT_EQ(std::get<AxisSpec>(left_out.subject).session_timeout, 1);
  const Spec given = axis("longest_gap = \"50 ms\"\nsession_timeout = 2.5\n");
  EXPECT_DOUBLE_EQ(std::get<AxisSpec>(given.subject).longest_gap, 0.05);
  EXPECT_EQ(std::get<AxisSpec>(given.subject).session_timeout, 2.5);
}

TEST(AxisPatience, RejectsWhatNoMachineCouldMean) {
  const auto said = [](const std::string& keys) { return complaint([&] { return axis(keys); }); };
  EXPECT_THAT(
      said("longest_gap = \"1 ms\"\n"),
      AllOf(HasSubstr("a.toml:6"), HasSubstr("longest_gap = 1 ms: must be 1 to 1e6 cycles")));
  EXPECT_THAT(said("longest_gap = 3000\n"), HasSubstr("longest_gap"));
  EXPECT_THAT(said("longest_gap = nan\n"), HasSubstr("longest_gap"));
  EXPECT_THAT(said("longest_gap = \"5 mm\"\n"), HasSubstr("longest_gap"));
  EXPECT_THAT(said("session_timeout = \"200 ms\"\n"),
              HasSubstr("session_timeout = 200 ms: must be between 250 ms and 1 h"));
  EXPECT_THAT(said("session_timeout = inf\n"), HasSubstr("session_timeout"));
}

TEST(MachineWatchdog, IsNeverOrNotTooShort) {
  EXPECT_FALSE(machine("").watchdog);
  EXPECT_EQ(machine("watchdog = 0\n").watchdog, 0);
  EXPECT_DOUBLE_EQ(machine("watchdog = \"200 ms\"\n").watchdog.value(), 0.2);
  EXPECT_THAT(complaint([] { return machine("watchdog = \"5 ms\"\n"); }),
              AllOf(HasSubstr("m.toml:3"), HasSubstr("must be 10 ms to 1 h, or 0 for none")));
  EXPECT_THAT(complaint([] { return machine("watchdog = -1\n"); }), HasSubstr("watchdog"));
}

TEST(NamedFiles, ThatAreMissingAreReportedWhereTheyAreNamed) {
  const Document document{"m.toml", "", {}, {{"axis[1].spec", {4, 1}}}, {}};
  const InputError unread = InputError("", "", "cannot be read: No such file").at("x.toml");
  EXPECT_STREQ(document.naming("axis[1].spec", "x.toml", unread).what(),
               "m.toml:4:1: axis[1].spec = x.toml: cannot be read: No such file");
  const InputError inside = InputError("cycle", "0", "must be more").at("x.toml", 3, 1);
  EXPECT_STREQ(document.naming("axis[1].spec", "x.toml", inside).what(), inside.what())
      << "an error in the file names the file";
}

TEST(NamedFiles, OfADriveAreReportedInTheSpecOfTheAxis) {
  EXPECT_THAT(complaint([] { return axis("[drive]\nspec = \"/no/such/drive.toml\"\n"); }),
              AllOf(HasSubstr("a.toml:7"), HasSubstr("drive.spec = /no/such/drive.toml"),
                    HasSubstr("cannot be read")));
}

Spec compare_of(const std::string& of) {
  return parse_spec(
      "jounce = 1\nkind = \"axis\"\nunits = { position = \"mm\" }\n[axis]\n[limits]\n"
      "velocity = 1\nacceleration = 1\n[compare]\n" +
          of + "mode = \"equal\"\nposition = 1\n",
      "a.toml");
}

TEST(CompareOf, IsThePositionOrTheFeedback) {
  EXPECT_EQ(compare_of("").compare->of, SwitchesOf::position);
  EXPECT_EQ(compare_of("of = \"position\"\n").compare->of, SwitchesOf::position);
  EXPECT_EQ(compare_of("of = \"actual\"\n").compare->of, SwitchesOf::actual);
  EXPECT_THAT(complaint([] { return compare_of("of = \"master\"\n"); }),
              AllOf(HasSubstr("a.toml:9"), HasSubstr("compare.of")));
  EXPECT_THAT(complaint([] {
                return parse_spec(
                    "jounce = 1\nkind = \"move\"\nunits = { position = \"mm\" }\n[move]\n"
                    "profile = \"trapezoid\"\nto = 30\nvelocity = 100\nacceleration = 1000\n"
                    "[compare]\nof = \"actual\"\nmode = \"equal\"\nposition = 1\n",
                    "c.toml");
              }),
              HasSubstr("compare.of"))
      << "a move that is not played has no drive";
}

}  // namespace
}  // namespace jounce::patience_test
