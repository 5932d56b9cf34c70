// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/design/make.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"

namespace jounce::time_table_spec_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string googol(const std::string& rest) {
  return "jounce = 1\nkind = \"pt\"\nunits = { position = \"pulse\", time = \"ms\" }\n" + rest;
}

std::string pmc600(const std::string& rest) {
  return "jounce = 1\nkind = \"pt\"\nunits = { position = \"mm\", time = \"s\" }\n" + rest;
}

Trajectory motion(const std::string& text) {
  return std::get<Trajectory>(*make(parse_spec(text, "t.toml")).curve);
}

std::string message(const std::string& text) {
  return test::error_of([&] { (void)make(parse_spec(text, "t.toml")); });
}

std::vector<std::string> rules(const std::string& text) {
  std::vector<std::string> all;
  for (const Finding& f : table_warnings(parse_spec(text, "t.toml")).findings)
    all.push_back(f.rule.text());
  return all;
}

const std::string ex_7_3 =
    "point = [{time = 1024, position = 1024}, {time = 2048, position = 3072}, {time = 3072, "
    "position = "
    "4096}]\n";

TEST(PtSpec, IsPlayedAsItStandsAndItsTableIsExact) {
  const Made made = make(parse_spec(googol(ex_7_3 + "[pt]\ncontroller = \"googol\"\n"), "t.toml"));
  const auto& f = std::get<Trajectory>(*made.curve);
  EXPECT_EQ(f.at(1024).velocity, 2);
  EXPECT_EQ(f.outside(), Extrapolation::hold);
  EXPECT_THAT(made.segments, ElementsAre("1 normal", "2 normal", "3 normal"));
  EXPECT_EQ(made.sampled.table.rule(), Interpolation::cubic_hermite);
  EXPECT_EQ(made.sampled.table.size(), 4U);
  EXPECT_LT(made.sampled.error.position, 1e-11);
  EXPECT_THAT(rules(googol(ex_7_3 + "[pt]\n")), ElementsAre());
}

TEST(PtSpec, TakesIncrements) {
  const Trajectory f =
      motion(googol("point = [{time = 1024, position = 1024}, {time = 1024, position = 2048}, "
                    "{time = 1024, position "
                    "= 1024}]\n[pt]\nincrements = true\n"));
  EXPECT_EQ(f.end(), 3072);
  EXPECT_EQ(f.at(3072).position, 4096);
  EXPECT_EQ(message(googol("[pt]\nincrements = true\n[[point]]\ntime = 0\nposition = 1\n")),
            "t.toml:7:8: point[1].time = 0 ms: must be greater than 0: with increments = true it "
            "counts from the previous point");
}

TEST(PtSpec, LoopsAreNamedByPassOrHaveNoEnd) {
  const Made two = make(parse_spec(googol(ex_7_3 + "[pt]\nloops = 2\n"), "t.toml"));
  EXPECT_EQ(two.segments[3], "pass 2: 1 normal");
  EXPECT_EQ(std::get<Trajectory>(*two.curve).at(6144).position, 8192);
  const Trajectory endless = motion(googol(ex_7_3 + "[pt]\nloops = 0\n"));
  EXPECT_EQ(endless.outside(), Extrapolation::advance);
  EXPECT_EQ(endless.at(3072e3 + 512).position, 4096e3 + 256);
  EXPECT_THAT(message(googol(ex_7_3 + "[pt]\nloops = 0\noutside = \"hold\"\n")),
              HasSubstr("pt.outside = \"hold\": does not apply to loops = 0"));
  EXPECT_THAT(message(googol(ex_7_3 + "[pt]\nloops = -1\n")),
              HasSubstr("pt.loops = -1: must be at least 1, or 0 for an endless table"));
}

TEST(PtSpec, WithStepsGetsALinearTable) {
  const Made made = make(parse_spec(googol("point = [{time = 10, position = 10, type = \"even\"}, "
                                           "{time = 20, position = 30}]\n[pt]\n"),
                                    "t.toml"));
  EXPECT_EQ(made.sampled.table.rule(),
            Interpolation::cubic_hermite);  // the step is at the start, from rest
  const Made steps = make(parse_spec(googol("point = [{time = 10, position = 10, type = \"even\"}, "
                                            "{time = 20, position = 30, type = \"even\"}]\n[pt]\n"),
                                     "t.toml"));
  EXPECT_EQ(steps.sampled.table.rule(), Interpolation::linear);
  EXPECT_EQ(steps.sampled.table.size(), 3U);
}

TEST(PtSpec, WarnsInTheOrderOfWhatIsWorst) {
  const std::string moving = "point = [{time = 10, position = 20, type = \"even\"}]\n[pt]\n";
  EXPECT_THAT(rules(googol(moving)), ElementsAre("pt/velocity_step", "pt/end_velocity"));
  EXPECT_THAT(rules(googol(moving + "outside = \"refuse\"\n")), ElementsAre("pt/end_velocity"));
  EXPECT_THAT(rules(googol(moving + "loops = 0\n")), ElementsAre());
  EXPECT_THAT(rules(googol(moving + "loops = 3\n")),
              ElementsAre("pt/velocity_step", "pt/end_velocity"));
  const std::string ramp =
      "point = [{time = 10, position = 20}]\n[pt]\n";  // 0 to 4, again and again
  EXPECT_THAT(rules(googol(ramp + "loops = 3\n")), ElementsAre("pt/end_velocity", "pt/wrap"));
}

TEST(PtSpec, RejectsExample74AsPrinted) {
  const std::string printed =
      "point = [{time = 0.016, position = 40.1447}]\n[pt]\ncontroller = \"googol\"\n";
  EXPECT_EQ(message(googol(printed)),
            "t.toml:4:18: point[1].time = 0.016 ms: must be a whole number of ms: GT_PtData "
            "would take 0 ms, and the table would never advance");
  EXPECT_THAT(message(pmc600(printed)), HasSubstr("units.position = \"mm\": must be pulse"));
  EXPECT_THAT(
      message(googol("[pt]\ncontroller = \"googol\"\n[[point]]\ntime = 1\nposition = 1\ntype = "
                     "\"continue\"\n")),
      HasSubstr("normal, even, stop"));
}

TEST(PtSpec, Pmc600TablesComeInThreeQuantities) {
  const std::string head = "[pt]\ncontroller = \"pmc600\"\n";
  const Trajectory p =
      motion(pmc600("point = [{delta_time = 1, position = 10000}, {delta_time = 2, position = "
                    "40000}, {delta_time = "
                    "1, position = -10000}, {delta_time = \"500 ms\", position = -5000}]\n" +
                    head + "quantity = \"position\"\nis_absolute = false\n"));
  EXPECT_EQ(p.end(), 4.5);
  EXPECT_NEAR(p.at(3).position, 50000, 1e-9);
  EXPECT_NEAR(p.at(4.5).position, 35000, 1e-9);
  const Trajectory v = motion(pmc600("point = [{delta_time = 1, velocity = 10}]\n" + head +
                                     "quantity = \"velocity\"\nscale = 2\noffset = 1\nfrom = 5\n"));
  EXPECT_EQ(v.at(1, Side::left).velocity, 21);
  EXPECT_EQ(v.at(1).position, 15.5);
  const Trajectory a = motion(pmc600("point = [{delta_time = 1, acceleration = 6}]\n" + head +
                                     "quantity = \"acceleration\"\noutside = \"refuse\"\n"));
  EXPECT_EQ(a.at(1).position, 1);
  EXPECT_EQ(a.outside(), Extrapolation::refuse);
}

TEST(PtSpec, Pmc600ErrorsStandAtTheirKeys) {
  const std::string head = "[pt]\ncontroller = \"pmc600\"\nquantity = \"position\"\n";
  EXPECT_EQ(message(pmc600(head + "[[point]]\ndelta_time = 0\nposition = 1\n")),
            "t.toml:8:14: point[1].delta_time = 0 s: must be greater than 0 (PMC600 error 326)");
  EXPECT_EQ(
      message(pmc600(head + "array_size = 101\n[[point]]\ndelta_time = 1\nposition = 1\n")),
      "t.toml:7:14: pt.array_size = 101: must be 1, the points played, to 100 (PMC600 error 325)");
  EXPECT_THAT(message(pmc600(head + "[[point]]\ndelta_time = 1e-12\nposition = 1\n")),
              HasSubstr("point[1].delta_time = 1e-12 s: must be a whole number of ms"));
  EXPECT_THAT(message(pmc600(head + "[[point]]\ndelta_time = 0.0005\nposition = 1\n")),
              HasSubstr("must be a whole number of ms, the resolution of the data type TIME"));
}

TEST(PvtSpec, StatesTheBehaviorAtItsEnd) {
  const std::string knots =
      "knot = [{time = 0, position = 0, velocity = 1}, {time = 1, position = 1, velocity = 1}]\n";
  const std::string head =
      "jounce = 1\nkind = \"pvt\"\nunits = { position = \"mm\", time = \"s\" }\n";
  EXPECT_EQ(motion(head + knots).outside(), Extrapolation::hold);
  EXPECT_EQ(motion(head + "outside = \"advance\"\n" + knots).at(7.5).position, 7.5);
  EXPECT_EQ(motion(head + "outside = \"wrap\"\n" + knots).outside(), Extrapolation::wrap);
  EXPECT_THAT(rules(head + knots), ElementsAre("pt/velocity_step", "pt/end_velocity"));
  EXPECT_THAT(rules(head + "outside = \"advance\"\n" + knots), ElementsAre());
}

TEST(PvtSpec, KeepsHimcsLimits) {
  std::string text =
      "jounce = 1\nkind = \"pvt\"\ncontroller = \"himc\"\nunits = { position = \"mm\", time = "
      "\"s\" }\n";
  for (int i = 0; i < 50; ++i)
    text += "[[knot]]\ntime = " + std::to_string(i) + "\nposition = 0\nvelocity = 0\n";
  EXPECT_EQ(message(text), "");
  std::string back = text;
  back.replace(back.find("time = 7\n"), 9, "time = 6\n");
  EXPECT_THAT(message(back),
              HasSubstr("knot[8].time = 6 s: must be greater than 6 s, the previous knot "
                        "(HIMC error 0x83aa08b6"));
  EXPECT_THAT(
      message(text + "[[knot]]\ntime = 50\nposition = 0\nvelocity = 0\n"),
      HasSubstr("knot = 51 knots: must be at most 50, the greatest number for MovePVT of HIMC"));
}

}  // namespace
}  // namespace jounce::time_table_spec_test
