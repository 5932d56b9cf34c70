// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/design/detail/cut_lengths.hpp"
#include "jounce/design/detail/sync_check.hpp"
#include "jounce/design/make.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/report/report_text.hpp"

#include "support/errors.hpp"

namespace jounce::shear_test {
namespace {

/// The sentence of a finding over a master in this unit, without the name of the segment.
std::string sentence_over(Finding finding, const char* unit) {
  finding.segment.reset();
  return sentence(finding, Labels{{unit, ""}, true, {}});
}

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string spec(const std::string& shear, const std::string& master = "mm") {
  return "jounce = 1\nkind = \"shear\"\nunits = { position = \"mm\", master = \"" + master +
         "\" }\n[shear]\n" + shear + "\n[limits.slave]\nvelocity = 2000\nacceleration = 10000\n";
}

std::string refusal(const std::string& text) {
  return test::error_of([&] { (void)make(parse_spec(text, "s.toml")); });
}

TEST(ShearSpec, OfTenLinesMakesTheCamAndItsMaster) {
  const Spec read = parse_spec(spec("cut_length = 1000\nline_speed = 1000\nsync_time = 0.15"), "s");
  const Made made = make(read);
  const Cam& cam = std::get<Cam>(*made.curve);
  EXPECT_EQ(cam.end(), 1000);
  EXPECT_EQ(cam.outside(), Extrapolation::wrap);
  EXPECT_EQ(read.master_period(), 1000);
  EXPECT_EQ(made.segments,
            (std::vector<std::string>{"1 accelerate", "2 sync", "3 decelerate", "4 return"}));
  ASSERT_EQ(made.zones.size(), 1U);
  EXPECT_NEAR(made.zones[0].from, 187.5, 1e-12);
  EXPECT_NEAR(made.zones[0].to, 337.5, 1e-12);
  ASSERT_TRUE(read.master);
  EXPECT_EQ(read.master->velocity, 1000);
  EXPECT_EQ(read.master->distance, 3000);
}

TEST(ShearSpec, AMasterOfItsOwnStays) {
  const Spec read = parse_spec(spec("cut_length = 1000\nline_speed = 1000\nsync_time = 0.15") +
                                   "[master]\nvelocity = 500\ndistance = 2000\n",
                               "s");
  EXPECT_EQ(read.master->velocity, 500);
}

TEST(ShearSpec, ReadsEveryKeyInItsUnit) {
  const Spec read = parse_spec(
      spec("cut_length = 2\nline_speed = \"60 m/min\"\nsync_length = \"150 mm\"\nstroke = 400\n"
           "acceleration_length = 0.2\ndeceleration_length = 0.3\nreturn_length = 0.9\n"
           "ramp = \"4567\"\nreturn_law = \"scca\"\n"
           "return_form = { straight = 0.5, shares = [0, 1, 0] }\nangle = 60\nsafety = 1.5",
           "m"),
      "s");
  const auto& shear = std::get<FlyingShear>(std::get<SyncSpec>(read.subject));
  EXPECT_DOUBLE_EQ(shear.line_speed, 1);
  EXPECT_DOUBLE_EQ(*shear.sync_length, 0.15);
  EXPECT_EQ(*shear.stroke, 400);
  EXPECT_EQ(*shear.acceleration_length, 0.2);
  EXPECT_EQ(*shear.deceleration_length, 0.3);
  EXPECT_EQ(*shear.return_length, 0.9);
  EXPECT_EQ(shear.ramp, Law::poly4567);
  EXPECT_EQ(shear.return_law, Law::scca);
  EXPECT_EQ(*shear.return_form.straight, 0.5);
  EXPECT_EQ(shear.ratio, 1000);  // mm of the carriage for a m of the line
  EXPECT_DOUBLE_EQ(shear.angle, std::numbers::pi / 3);
  EXPECT_EQ(shear.safety, 1.5);
  EXPECT_EQ(*shear.limits.velocity, 2000);
}

TEST(ShearSpec, ErrorsStandWhereTheUserWroteThem) {
  const std::string power7 = spec(
      "cut_length = 1000\nline_speed = 1000\nsync_time = 0.15\nramp = \"4567\"\n"
      "return_law = \"4567\"");
  EXPECT_THAT(refusal(power7),
              StartsWith("s.toml:5:14: shear.cut_length = 1000 mm: must be at least "
                         "1113.8"));
  EXPECT_THAT(refusal(power7),
              HasSubstr(", or line_speed at most 940.716 mm/s with this cut_length"));
  EXPECT_THAT(refusal(power7),
              HasSubstr("a shorter return would exceed limits.slave.acceleration"));
  EXPECT_THAT(
      refusal(spec("cut_length = 1000\nline_speed = 3000\nsync_time = 0.15")),
      StartsWith("s.toml:6:14: shear.line_speed = 3000 mm/s: must be at most 1019.76 mm/s with "
                 "this cut_length, and at most 2000 mm/s with any: at a higher speed, the carriage "
                 "in the sync zone exceeds limits.slave.velocity = 2000 "
                 "mm/s"));
  EXPECT_THAT(
      refusal(spec("cut_length = 1000\nline_speed = 1000\nsync_time = 0.6\nstroke = 400")),
      HasSubstr("must be at least 787.5 mm at line_speed = 1000 mm/s, with cut_length greater than "
                "1713.29 mm, or "));
  EXPECT_THAT(refusal(spec("cut_length = 1000\nline_speed = 1000\nsync_time = 0.6\nstroke = 400")),
              HasSubstr("or line_speed at most 566.41 mm/s with this stroke"));
  EXPECT_THAT(refusal(spec("cut_length = 9\nline_speed = 1\nsync_time = 1", "deg")),
              HasSubstr("shear.ratio: is missing: add ratio = NUMBER, in mm/deg: the travel of the "
                        "carriage per deg of the line in the sync zone"));
  EXPECT_THAT(refusal(spec("cut_length = 9\nline_speed = 1\nsync_time = 1\nangle = 90")),
              HasSubstr("shear.angle = 90 deg: must be greater than -90 deg and less than 90 deg"));
  EXPECT_THAT(refusal(spec("cut_length = 9\nline_speed = 1")), HasSubstr("shear.sync_time"));
}

TEST(IndexerSpec, MakesACamThatAdvances) {
  const Spec read = parse_spec(
      "jounce = 1\nkind = \"indexer\"\nunits = { position = \"deg\", master = \"ms\" }\n"
      "[indexer]\ndistance = 45\ncycle = 2000\nmotion = 400\n",
      "i");
  const Made made = make(read);
  const Cam& cam = std::get<Cam>(*made.curve);
  EXPECT_EQ(cam.outside(), Extrapolation::advance);
  EXPECT_EQ(cam.jet(2000 * 8 + 1000)[0], 9 * 45);
  EXPECT_EQ(read.master_period(), 2000);
  EXPECT_EQ(made.segments, (std::vector<std::string>{"1 index", "2 dwell"}));
  EXPECT_NEAR(extrema(cam, 2).max.value * 1e6, 1623.798, 5e-4);
}

TEST(IndexerSpec, ReportsContradictions) {
  EXPECT_THAT(refusal("jounce = 1\nkind = \"indexer\"\n"
                      "units = { position = \"deg\", master = \"ms\" }\n"
                      "[indexer]\ndistance = 45\ncycle = 2000\nmotion = 400\ncount = 8\n"),
              StartsWith("s.toml:7:10: indexer.motion = 400 ms: must be at most 250 ms"));
}

const SyncFigure& figure(const std::vector<SyncFigure>& all, const std::string& name) {
  for (const SyncFigure& each : all)
    if (each.name == name) return each;
  throw InputError("figure", name, "is missing");
}

TEST(ShearSpec, StatesTheShortestCutAndTheFastestLine) {
  const Spec read = parse_spec(spec("cut_length = 1000\nline_speed = 1000\nsync_time = 0.15"), "s");
  const auto all = sync_figures(read);
  // Run-up and braking 187.5 mm each; the return of S = 337.5 mm at 10 m/s^2 with 3-4-5.
  const double back = 1000 * std::sqrt(10 / std::sqrt(3.0) * 337.5 / 10000);
  EXPECT_NEAR(figure(all, "shortest cut").value, 525 + back, 1e-9);
  EXPECT_EQ(figure(all, "shortest cut").meaning,
            "at 1000 mm/s, limited by the slave's acceleration on its return");
  // L / v = 0.15 + 2 r v / a + sqrt(Ca (r v / a + 0.15) v / a), all in seconds.
  const double v = figure(all, "fastest line").value;
  const double ramp = 1.875 * v / 10000;
  EXPECT_NEAR(1000 / v,
              0.15 + 2 * ramp + std::sqrt(10 / std::sqrt(3.0) * (ramp + 0.15) * v / 10000), 1e-12);
  EXPECT_GT(v, 1000);
  EXPECT_EQ(figure(all, "in step").value, 150);
  EXPECT_EQ(figure(all, "in step").meaning, "0.15 s at 1000 mm/s");
  EXPECT_TRUE(is_made_for_a_speed(read));
}

TEST(ShearSpec, WarnsOfASyncThatIsAsGoodAsNone) {
  const auto of = [](const std::string& stroke) {
    return parse_spec(spec("cut_length = 1000\nline_speed = 1000\nstroke = " + stroke), "s");
  };
  const Report little = check_sync(of("192"));  // run-up and braking take 187.5 of it
  ASSERT_EQ(little.findings.size(), 1U);
  EXPECT_TRUE(little.ok());
  const Finding& f = little.findings[0];
  EXPECT_EQ(f.severity, Severity::warning);
  EXPECT_NEAR(f.value, 4.5, 1e-9);
  EXPECT_EQ(f.limit, 10);
  EXPECT_EQ(f.advice, "the stroke is too short: lengthen it, or slow the line down");
  EXPECT_EQ(
      sentence_over(f, "mm"),
      "the carriage is in step for only 4.5 mm, from 187.5 mm on; at least 10 mm is recommended");
  EXPECT_THAT(figure(sync_figures(of("192")), "in step").meaning,
              StartsWith("0.0045 s at 1000 mm/s"));
  EXPECT_TRUE(check_sync(of("250")).findings.empty());
}

TEST(ShearSpec, IsMappedForEverySpeedAnew) {
  const Spec read = parse_spec(spec("cut_length = 1000\nline_speed = 1000\nsync_time = 0.15"), "s");
  const CutLengths cuts = cut_lengths(read);
  const CutLimits limits{read.slave, 1200};
  EXPECT_NEAR(*cuts.shortest(1000, limits), figure(sync_figures(read), "shortest cut").value, 1e-9);
  EXPECT_EQ(cuts.fastest(1e4, limits).limit, "line");
  const CutSpeed faster = cuts.fastest(1100, limits);  // than the spec's own line
  EXPECT_GT(faster.speed, 1050);
  EXPECT_EQ(faster.limit, "acceleration");
  EXPECT_NEAR(*cuts.shortest(faster.speed, limits), 1100, 1e-9);
  EXPECT_EQ(cuts.fastest(1e5, {read.slave, 1e9}).limit, "velocity");  // in step, at 2000 mm/s
  EXPECT_FALSE(cuts.shortest(2001, limits));
}

TEST(ShearSpec, AMapNeedsItsSync) {
  try {
    (void)cut_lengths(
        parse_spec(spec("cut_length = 1000\nline_speed = 1000\nstroke = 400"), "s.toml"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), StartsWith("s.toml:4:1: shear.sync_time: is missing"));
  }
}

}  // namespace
}  // namespace jounce::shear_test
