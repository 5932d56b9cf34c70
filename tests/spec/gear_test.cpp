// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/design/detail/sync_check.hpp"
#include "jounce/design/make.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/report/report_text.hpp"

#include "support/errors.hpp"

namespace jounce::gear_test {
namespace {

/// The sentence of a finding over a master in this unit, without the name of the segment.
std::string sentence_over(Finding finding, const char* unit) {
  finding.segment.reset();
  return sentence(finding, Labels{{unit, ""}, true, {}});
}

std::string spec(const std::string& gear) {
  return "jounce = 1\nkind = \"gear\"\nunits = { position = \"mm\", master = \"deg\" }\n" + gear;
}

TEST(GearSpec, MakesALineThatContinuesBeyondItsEnd) {
  const Made made =
      make(parse_spec(spec("[gear]\nnumerator = -4\ndenominator = 3\nmaster_period = 360\n"), "g"));
  const Cam& cam = std::get<Cam>(*made.curve);
  EXPECT_EQ(cam.outside(), Extrapolation::advance);
  EXPECT_EQ(cam.jet(90)[0], -120);
  EXPECT_EQ(cam.jet(360e9 + 90)[0], -480e9 - 120);
  EXPECT_EQ(made.segments, std::vector<std::string>{"1 gear"});
  ASSERT_EQ(made.zones.size(), 1U);
}

TEST(GearSpec, RejectsARatioThatNeverMovesTheSlave) {
  EXPECT_THAT(
      test::error_of(
          [] { (void)parse_spec(spec("[gear]\nnumerator = 0\nmaster_period = 360\n"), "g"); }),
      ::testing::HasSubstr("gear.numerator = 0: must not be 0, because the slave would never "
                           "move"));
}

TEST(GearSpec, EngagesOverADistanceOfItsMaster) {
  const Made made = make(parse_spec(
      spec("[gear]\nengage = \"distance\"\nnumerator = 1\ndenominator = 2\ndistance = 100\n"
           "engage_at = 10\nmaster_end = 1000\nslave_start = 7\n"
           "[[gear.change]]\nat = 500\nnumerator = 2\ndistance = 40\nlaw = \"345\"\n"
           "[[gear.shift]]\nat = 700\nshift = -3\ndistance = 100\n"),
      "g"));
  const Cam& cam = std::get<Cam>(*made.curve);
  EXPECT_EQ(cam.jet(10)[0], 7);
  EXPECT_NEAR(cam.jet(110)[0], 7 + 25, 1e-12);
  EXPECT_NEAR(cam.jet(540)[0], 7 + 25 + 195 + 50, 1e-12);
  EXPECT_NEAR(cam.jet(1000)[0], 277 + 2 * 460 - 3, 1e-11);
  EXPECT_EQ(made.segments, (std::vector<std::string>{"1 hold", "2 clutch", "3 gear", "4 clutch",
                                                     "5 gear", "6 phase", "7 gear"}));
  EXPECT_EQ(made.zones.size(), 3U);
}

TEST(GearSpec, ItsMasterPassesTheTableOnceByDefault) {
  const std::string clutch =
      "[gear]\nengage = \"distance\"\nnumerator = 1\ndistance = 100\nmaster_start = 200\n"
      "engage_at = 250\nmaster_end = 1000\n[master]\nvelocity = 50\n";
  EXPECT_EQ(parse_spec(spec(clutch), "g").master->distance, 800);
  EXPECT_EQ(parse_spec(spec(clutch + "distance = 100\n"), "g").master->distance, 100);
  const std::string in_pos =
      "[gear]\nengage = \"position\"\nnumerator = 1\ndenominator = 2\n"
      "master_sync_position = 5000\nslave_sync_position = 2000\nmaster_end = 10000\n"
      "master_start_distance = 4000\n[master]\nvelocity = 50\n";
  EXPECT_EQ(parse_spec(spec(in_pos), "g").master->distance, 10000);
}

TEST(GearSpec, EngagesAtPositions) {
  const std::string text =
      "[gear]\nengage = \"position\"\nnumerator = 1\ndenominator = 2\n"
      "master_sync_position = 5000\nslave_sync_position = 2000\nmaster_end = 10000\n";
  const Made made = make(parse_spec(spec(text + "master_start_distance = 4000\n"), "g"));
  const Cam& cam = std::get<Cam>(*made.curve);
  EXPECT_EQ(cam.jet(1000)[0], 0);
  EXPECT_NEAR(cam.jet(5000)[0], 2000, 1e-12);
  EXPECT_NEAR(cam.jet(10000)[0], 4500, 1e-12);
  ASSERT_EQ(made.zones.size(), 1U);
  EXPECT_EQ(made.zones[0].from, 5000);
}

TEST(GearSpec, AnEngagementThatReversesIsReported) {
  const auto checked = [](const std::string& gear) {
    return check_sync(parse_spec(
        spec("[gear]\nengage = \"position\"\ndenominator = 2\nmaster_sync_position = 5000\n"
             "master_start_distance = 4000\nmaster_end = 10000\n" +
             gear),
        "g"));
  };
  EXPECT_TRUE(checked("numerator = 1\nslave_sync_position = 1000\n").findings.empty());
  const Report still = checked("numerator = 1\nslave_sync_position = 0\n");  // h = 0
  ASSERT_EQ(still.findings.size(), 1U);
  const Finding& f = still.findings[0];
  EXPECT_EQ(f.rule, "gear/reversal");
  EXPECT_EQ(f.severity, Severity::warning);
  EXPECT_FALSE(f.broken);
  EXPECT_NEAR(f.where, 2600, 1e-6);  // z = 0.4 of k D (-4 z^3 + 7 z^4 - 3 z^5)
  EXPECT_NEAR(f.value, -0.256, 1e-12);
  EXPECT_THAT(f.advice, testing::HasSubstr("it must reverse to gain speed, here to -395.062 mm"));
  EXPECT_THAT(f.advice, testing::HasSubstr("with slave_start between -1200 and -800 the slave"));
  EXPECT_TRUE(
      checked("numerator = 1\nslave_sync_position = 0\nslave_start = -1000\n").findings.empty());
  const Report against = checked("numerator = -1\nslave_sync_position = 2000\n");  // rho = -1
  ASSERT_EQ(against.findings.size(), 1U);
  EXPECT_GT(against.findings[0].value, 0.5);
  EXPECT_THAT(against.findings[0].advice, testing::HasSubstr("moves against the gear"));
  EXPECT_THAT(against.findings[0].advice, testing::HasSubstr("to 2218.73 mm"));
  EXPECT_THAT(against.findings[0].advice, testing::HasSubstr("between 2800 and 3200"));
}

TEST(GearSpec, AClutchOfNoDistanceIsFoundWhereTheCamBegins) {
  const auto checked = [](const std::string& gear) {
    return check_sync(
        parse_spec(spec("[gear]\nengage = \"distance\"\nnumerator = 4\ndenominator = 3\n"
                        "master_end = 1440\n" +
                        gear),
                   "g"));
  };
  const Report steps = checked("distance = 0\n");
  ASSERT_EQ(steps.findings.size(), 1U);
  EXPECT_EQ(steps.findings[0].rule, "gear/ratio_step");
  EXPECT_TRUE(steps.findings[0].broken);
  EXPECT_EQ(steps.findings[0].where, 0);
  EXPECT_EQ(steps.findings[0].value, 4.0 / 3);
  EXPECT_EQ(sentence_over(steps.findings[0], "deg"),
            "the ratio steps from 0 to 1.33333 mm/deg at 0 deg, where the slave engages");
  EXPECT_TRUE(checked("distance = 10\n").findings.empty());
  EXPECT_TRUE(checked("distance = 0\nengage_at = 5\n").findings.empty()) << "continuity reports it";
}

std::string refusal(const std::string& text) {
  return test::error_of([&] { (void)make(parse_spec(spec(text), "g.toml")); });
}

TEST(GearSpec, NamesTheEngagementThatAKeyNeeds) {
  const std::string at_once = "[gear]\nnumerator = 1\n";
  EXPECT_THAT(refusal(at_once + "engage_at = 45\n"),
              testing::HasSubstr("gear.engage_at = 45: needs engage = \"distance\""));
  EXPECT_THAT(refusal(at_once + "change = [{ at = 1, numerator = 2, distance = 1 }]\n"),
              testing::HasSubstr("needs engage = \"distance\""));
  EXPECT_THAT(refusal(at_once + "master_period = 1\nmaster_end = 9\n"),
              testing::HasSubstr("gear.master_end = 9: needs engage = \"distance\" or "
                                 "\"position\", without master_period"));
  EXPECT_THAT(refusal(at_once + "slave_sync_position = 9\n"),
              testing::HasSubstr("needs engage = \"position\""));
}

TEST(GearSpec, RejectsInTheWordsOfTheDocument) {
  const std::string position =
      "[gear]\nengage = \"position\"\nnumerator = 1\nmaster_sync_position = 500\n"
      "slave_sync_position = 100\nmaster_start_distance = 400\navoid_reversal = true\n";
  EXPECT_THAT(refusal(position + "master_end = 900\n"),
              testing::StrEq(
                  "g.toml:9:25: gear.master_start_distance = 400 deg: makes the slave reverse: use "
                  "master_start_distance from 166.667 deg to 250 deg, or set avoid_reversal = "
                  "false (error 777 of the PMC600)"));
  EXPECT_THAT(refusal(position + "master_end = 900\nslave_period = 30\n"), testing::StrEq(""));
  EXPECT_THAT(refusal(position + "master_end = 900\nslave_period = 1\n"),
              testing::HasSubstr("776"));
  const std::string distance = "[gear]\nengage = \"distance\"\nnumerator = 1\nmaster_end = 100\n";
  EXPECT_THAT(refusal(distance + "distance = -1\n"),
              testing::StartsWith("g.toml:8:12: gear.distance = -1 deg: must not be negative"));
  EXPECT_THAT(
      refusal(distance + "distance = 10\n[[gear.change]]\nat = 5\nnumerator = 2\n"
                         "distance = 1\n"),
      testing::StartsWith("g.toml:10:6: gear.change[1].at = 5 deg: must be at least 10 deg"));
  EXPECT_THAT(refusal(distance + "distance = 10\nmaster_period = 3\n"),
              testing::HasSubstr("master_period"));
}

TEST(AxesSpec, WithoutLimitsOfItsOwnAnAxisFollowsOnTheLine) {
  const std::string head =
      "jounce = 1\nkind = \"axes\"\nsync = \"phase\"\nunits = { position = \"pulse\" }\n"
      "[[axis]]\nname = \"m\"\nfrom = 0\nto = 4000\nvelocity = 2000\nacceleration = 4000\n";
  const auto both = make_axes(parse_spec(head + "[[axis]]\nname = \"s\"\nfrom = 10\nto = "
                                                "-1990\n[[axis]]\nname = \"z\"\nfrom = 5\nto = 5\n",
                                         "a"));
  const auto& master = std::get<Trajectory>(*both[0].curve);
  const auto& slave = std::get<Trajectory>(*both[1].curve);
  EXPECT_NEAR(slave.end(), 2.5, 1e-12);  // PMC600 manual 6.3, example 6.7
  EXPECT_EQ(slave.end(), master.end());
  EXPECT_NEAR(extrema(slave, 1).min.value, -1000, 1e-9);
  for (int i = 0; i <= 100; ++i)
    EXPECT_NEAR(slave.at(i * 0.025).position, 10 - master.at(i * 0.025).position / 2, 1e-9);
  EXPECT_EQ(std::get<Trajectory>(*both[2].curve).at(1).position, 5);
}

TEST(GearSpec, RejectsADenominatorOfNought) {
  try {
    parse_spec(spec("[gear]\nnumerator = 1\ndenominator = 0\nmaster_period = 360\n"), "g.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "g.toml:6:15: gear.denominator = 0: must be at least 1");
  }
}

}  // namespace
}  // namespace jounce::gear_test
