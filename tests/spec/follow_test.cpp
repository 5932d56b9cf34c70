// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/design/make.hpp"
#include "jounce/profiles/error.hpp"

#include "design/src/sync/sync_follow.hpp"
#include "support/errors.hpp"

namespace jounce::follow_test {
namespace {

using ::testing::HasSubstr;

std::string spec(const std::string& body) {
  return "jounce = 1\nkind = \"follow\"\n"
         "units = { position = \"mm\", master = \"deg\", time = \"ms\" }\n" +
         body;
}

std::string error_of(const std::string& body) {
  return test::error_of([&] { (void)make(parse_spec(spec(body), "f.toml")); });
}

TEST(FollowSpecFile, IncrementsAndRepeatsAreAddedUp) {
  const Made made =
      make(parse_spec(spec("[follow]\nincrements = true\n[[segment]]\nmaster = 100\nslave = 50\n"
                           "[[segment]]\nmaster = 10\nslave = 10\ntype = \"even\"\nrepeat = 5\n"
                           "[[segment]]\nmaster = 100\nslave = 50\ntype = \"stop\"\n"),
                      "f"));
  const Cam& cam = std::get<Cam>(*made.curve);
  EXPECT_EQ(cam.segments().size(), 7U);
  EXPECT_EQ(cam.end(), 250);
  EXPECT_EQ(cam.at(250).position, 150);
  EXPECT_EQ(made.segments[1], "2 even to 110");
  ASSERT_EQ(made.zones.size(), 1U);
  EXPECT_EQ(made.zones[0].name, "ratio 1");
}

TEST(FollowSpecFile, UnitsAreConverted) {
  const Made made = make(parse_spec(
      spec("[[segment]]\nmaster = \"1 rev\"\nslave = \"2 cm\"\ntype = \"even\"\n"), "f"));
  EXPECT_EQ(std::get<Cam>(*made.curve).end(), 360);
  EXPECT_EQ(std::get<Cam>(*made.curve).at(360).position, 20);
}

TEST(FollowSpecFile, APlanIsSmoothOrATable) {
  const std::string plan =
      "periodic = true\n[[zone]]\nfrom = 0\nto = 90\nratio = 0.5\n"
      "[[point]]\nmaster = 360\nslave = 120\n";
  const Made smooth = make(parse_spec(spec("[follow]\n" + plan), "f"));
  EXPECT_TRUE(check_continuity(std::get<Cam>(*smooth.curve), 2).ok());
  const Spec table = parse_spec(spec("[follow]\nform = \"table\"\n" + plan), "f");
  EXPECT_EQ(table.master_period(), 360);
  EXPECT_EQ(std::get<Cam>(*make(table).curve).segments().size(), 3U);
  EXPECT_TRUE(check_follow(table).findings.empty());
}

TEST(FollowSpecFile, ReportsWhenItBeginsOrThatItNeverDoes) {
  const auto text = [](const char* pass, const char* distance = "180000") {
    return spec("[follow]\npass = " + std::string(pass) +
                "\n[[segment]]\nmaster = 100\nslave = 50\n[[segment]]\nmaster = 200\nslave = "
                "100\ntype = \"stop\"\n[master]\nvelocity = 50\nacceleration = 1\ndistance = " +
                distance + "\n");
  };
  const Report begins = check_follow(parse_spec(text("{ position = 50000 }"), "f"));
  ASSERT_EQ(begins.findings.size(), 1U);
  EXPECT_EQ(begins.findings[0].rule, "follow/begin");
  EXPECT_NEAR(begins.findings[0].where, 1025, 1e-9);
  EXPECT_EQ(begins.findings[0].where_unit, "ms");
  EXPECT_FALSE(begins.findings[0].broken);
  for (const char* never : {"{ position = -5 }", "{ position = 50000, direction = -1 }"}) {
    const Report waits = check_follow(parse_spec(text(never), "f"));
    ASSERT_EQ(waits.findings.size(), 1U) << never;
    EXPECT_TRUE(waits.findings[0].broken);
    EXPECT_THAT(waits.findings[0].advice,
                HasSubstr("the slave waits until its master passes this position"));
  }
  const Report too_short = check_follow(parse_spec(text("{ position = 50000 }", "2000"), "f"));
  ASSERT_EQ(too_short.findings.size(), 1U);
  EXPECT_TRUE(too_short.findings[0].broken);
  EXPECT_THAT(too_short.findings[0].advice, HasSubstr("the master moves from 0 to 2000 deg"));
}

TEST(FollowSpecFile, ErrorsNameTheirPlace) {
  EXPECT_EQ(
      error_of("[[segment]]\nmaster = 10\nslave = 1\n[[segment]]\nmaster = 10\nslave = 2\n"),
      "f.toml:8:10: segment[2].master = 10 deg: must be greater than 10 deg, the previous point");
  EXPECT_EQ(error_of("[[follow.table]]\nloops = 0\nsegment = [{ master = 1, slave = 1 }]\n"
                     "[[follow.table]]\nsegment = [{ master = 1, slave = 1 }]\n"),
            "f.toml:5:9: follow.table[1].loops = 0: is endless: only the last table can be. Give "
            "the number of passes before the next table");
  EXPECT_EQ(error_of("[[zone]]\nfrom = 5\nto = 4\nratio = 1\n"),
            "f.toml:6:6: zone[1].to = 4 deg: must be greater than from = 5 deg");
  EXPECT_THAT(
      error_of("[follow]\nperiodic = true\nstart_ratio = 0\n[[zone]]\nfrom = 5\nto = 9\n"
               "ratio = 1\n"),
      HasSubstr("f.toml:5:12: follow.periodic = true: needs the same ratio at start and end"));
  EXPECT_THAT(error_of("[[segment]]\nmaster = 1\nslave = 1\nrepeat = 3\n"),
              HasSubstr("needs increments = true"));
  EXPECT_THAT(error_of("[follow]\nform = \"table\"\nlaw = \"quintic\"\n[[point]]\nmaster = 1\n"
                       "slave = 1\n"),
              HasSubstr("follow.law = \"quintic\": does not apply to form = \"table\""));
  EXPECT_THAT(error_of("[follow]\nlaw = \"parabola\"\n[[point]]\nmaster = 1\nslave = 1\n"),
              HasSubstr("follow.law"));
  EXPECT_THAT(error_of(""), HasSubstr("segment: is missing"));
  EXPECT_THAT(error_of("[[point]]\nmaster = 1\nslave = 1\n[[segment]]\nmaster = 1\nslave = 1\n"),
              HasSubstr("[[segment]]: cannot be combined with [[point]] and [[zone]]"));
  EXPECT_EQ(
      error_of("[follow]\nform = \"smooth\"\nperiodic = true\n[[point]]\nmaster = 1\nslave = 1\n"
               "[[zone]]\nfrom = 0\nto = 1\nratio = 1\n[[segment]]\nmaster = 1\nslave = 1\n"),
      "f.toml:14:1: [[segment]]: cannot be combined with [[point]] and [[zone]]: leave it out, "
      "or remove these sections");
  EXPECT_EQ(
      error_of("[follow]\nlaw = \"quintic\"\n[[segment]]\nmaster = 1\nslave = 1\n"),
      "f.toml:5:7: follow.law = \"quintic\": applies only to [[point]] and [[zone]]: leave it "
      "out");
  EXPECT_THAT(error_of("[follow]\npass = { position = 1, direction = 2 }\n[[segment]]\nmaster = "
                       "1\nslave = 1\n"),
              HasSubstr("must be 1 or -1"));
  EXPECT_THAT(error_of("[follow]\nincrements = true\n[[segment]]\nmaster = -1\nslave = 1\n"),
              HasSubstr("with increments = true it counts from the previous segment"));
}

TEST(FollowSpecFile, KeepsToWhatAGoogolTakes) {
  const auto complaint = [](const std::string& body) {
    const std::string head =
        "jounce = 1\nkind = \"follow\"\nunits = { position = \"pulse\", master = \"pulse\" }\n";
    return test::error_of([&] { (void)make(parse_spec(head + body, "f.toml")); });
  };
  const std::string googol = "[follow]\ncontroller = \"googol\"\nincrements = true\n[[segment]]\n";
  EXPECT_EQ(complaint(googol + "master = 100\nslave = 50.5\nrepeat = 512\n"), "");
  EXPECT_EQ(complaint(googol + "master = 100\nslave = 50.5\nrepeat = 513\n"),
            "f.toml:7:1: segment = 513 segments: must be at most 512 in a table: the FIFO of the "
            "controller holds no more (memory 1)");
  EXPECT_EQ(
      complaint(googol + "master = 0.5\nslave = 1\n"),
      "f.toml:8:10: segment[1].master = 0.5 pulse: must be a whole number of pulses: GT_FollowData "
      "takes a long");
  EXPECT_EQ(complaint(googol + "master = 1500000000\nslave = 1\nrepeat = 2\n"),
            "f.toml:8:10: segment[1].master = 3000000000 pulse: must be at most 2147483647 pulses: "
            "GT_FollowData "
            "takes a long of 32 bits");
  EXPECT_THAT(error_of("[follow]\ncontroller = \"googol\"\n[[segment]]\nmaster = 1\nslave = 1\n"),
              HasSubstr("must be pulse for the profiles of Googol"));
}

}  // namespace
}  // namespace jounce::follow_test
