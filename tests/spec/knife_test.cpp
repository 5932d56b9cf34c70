// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/design/detail/cut_lengths.hpp"
#include "jounce/design/detail/sync_check.hpp"
#include "jounce/design/make.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/report/report_text.hpp"

#include "support/errors.hpp"

namespace jounce::knife_test {
namespace {

/// The sentence of a finding over a master in this unit, without the name of the segment.
std::string sentence_over(Finding finding, const char* unit) {
  finding.segment.reset();
  return sentence(finding, Labels{{unit, ""}, true, {}});
}

using ::testing::HasSubstr;

constexpr double pi = std::numbers::pi;

Spec spec(const std::string& position, const std::string& knife, const std::string& rest = "") {
  return parse_spec("jounce = 1\nkind = \"knife\"\nunits = { position = \"" + position +
                        "\", master = \"in\" }\n[knife]\ndiameter = 3\n" + knife + rest,
                    "k.toml");
}

std::string refusal(const std::string& position, const std::string& knife) {
  return test::error_of([&] { (void)spec(position, knife); });
}

double advance(const Spec& of) {
  return std::get<Cam>(*make(of).curve).advance();
}

TEST(KnifeSpec, CountsTheKnifeInTheSpecsUnit) {
  EXPECT_EQ(advance(spec("deg", "cut_length = 4.71\nsync_angle = 10\n")), 360);
  EXPECT_NEAR(advance(spec("rad", "cut_length = 4.71\nsync_angle = \"10 deg\"\n")), 2 * pi, 1e-15);
  EXPECT_NEAR(advance(spec("rev", "cut_length = 4.71\nsync_angle = \"10 deg\"\nblades = 4\n")),
              0.25, 1e-15);
  EXPECT_NEAR(advance(spec("mm", "cut_length = 4.71\nsync_angle = 10\n")), 3 * pi * 25.4, 1e-11);
  EXPECT_EQ(advance(spec("pulse", "cut_length = 4.71\nsync_angle = 10\nturn = 4096\n")), 4096);
}

TEST(KnifeSpec, MakesTheSameKnifeWhateverItsUnit) {
  const Made degrees = make(spec("deg", "cut_length = 4.71\nsync_angle = 10\n"));
  const Made pulses = make(spec("pulse", "cut_length = 4.71\nsync_angle = 10\nturn = 3600\n"));
  for (const double x : {0.1, 1.0, 2.5, 4.65})
    EXPECT_NEAR(std::get<Cam>(*pulses.curve).jet(x)[0],
                10 * std::get<Cam>(*degrees.curve).jet(x)[0], 1e-9);
  EXPECT_EQ(degrees.segments, (std::vector<std::string>{"1 sync", "2 recovery", "3 sync"}));
  EXPECT_EQ(degrees.zones.size(), 2U);
}

TEST(KnifeSpec, NumbersThePiecesOfALawOnce) {
  const Made made =
      make(spec("deg", "cut_length = 4.71\nsync_angle = 10\nlaw = \"modified_sine\"\n"));
  ASSERT_EQ(made.segments.size(), 6U);  // a modified sine has four pieces
  EXPECT_EQ(made.segments[1], "2 recovery");
  EXPECT_EQ(made.segments[4], "2 recovery");
  EXPECT_EQ(made.segments[5], "3 sync");
}

TEST(KnifeSpec, RejectsInTheDocumentsWords) {
  EXPECT_EQ(
      refusal("deg", "cut_length = 0.2\nsync_angle = 10\n"),
      "k.toml:6:14: knife.cut_length = 0.2 in: must be longer than the sync zone on the web, "
      "0.2618 in: raise cut_length, or shorten the sync zone (sync_angle must be less than 7.63943 "
      "deg)");
  EXPECT_EQ(refusal("pulse", "cut_length = 4.71\nsync_angle = 10\n"),
            "k.toml:4:1: knife.turn: is missing: add turn = NUMBER, one revolution in pulse");
  EXPECT_THAT(refusal("deg", "cut_length = 4\n"), HasSubstr("knife.sync_angle: is missing"));
  EXPECT_THAT(refusal("deg", "cut_length = 4\nsync_angle = 10\nsync_length = 1\n"),
              HasSubstr("knife.sync_length = 1 in: cannot be combined"));
  EXPECT_THAT(refusal("deg", "cut_length = 4\nsync_angle = 10\nlaw = \"line\"\n"),
              HasSubstr("knife.law = line: must be a symmetric law from rest to rest"));
  EXPECT_THAT(refusal("deg", "cut_length = 4\nsync_angle = 10\nmatching = \"none\"\n"),
              HasSubstr("knife.matching"));
}

TEST(KnifeSpec, ReportsAReversalWithItsRemedy) {
  const Report report = check_sync(spec("deg", "cut_length = 25\nsync_angle = 10\n"));
  ASSERT_FALSE(report.ok());
  const Finding& worst = report.findings.front();
  EXPECT_EQ(worst.rule, "knife/reversal");
  EXPECT_NEAR(worst.where, 12.5, 1e-6);
  EXPECT_EQ(worst.advice,
            "cut lengths above 19.8968 in need a stop between the cuts: add dwell = true to "
            "[knife]");
  EXPECT_EQ(sentence_over(worst, "in"), "the knife reverses at 12.5 in");
  EXPECT_TRUE(check_sync(spec("deg", "cut_length = 25\nsync_angle = 10\ndwell = true\n")).ok());
}

TEST(KnifeSpec, StatesTheShortestCutAtTheSpeedOfTheLine) {
  const Spec of =
      spec("rad", "cut_length = 4.71\nsync_angle = \"10 deg\"\n",
           "[master]\nvelocity = 20\ndistance = 10\n[limits.slave]\nacceleration = 400\n");
  const auto all = sync_figures(of);
  ASSERT_EQ(all.back().name, "shortest cut");
  EXPECT_THAT(all.back().meaning, HasSubstr("acceleration"));
  // amax b^2 + g v^2 Ca b - h v^2 Ca = 0
  const double h = 350 * pi / 180;
  const double q = 400 * 10 / std::sqrt(3.0);
  const double b = (-q / 1.5 + std::sqrt(q * q / 2.25 + 4 * 400 * h * q)) / 800;
  EXPECT_NEAR(all.back().value, b + 1.5 * 10 * pi / 180, 1e-11);
}

TEST(CutLengths, OfAKnifeThatTurnsBackAreNone) {
  const std::string knife = "cut_length = 4.71\nsync_angle = 10\n";
  const CutLengths cuts = cut_lengths(spec("deg", knife));
  const CutLimits limits{{.velocity = 14400}};
  const double longest = cuts.marks[1].length;
  EXPECT_EQ(cuts.fastest(longest, limits).limit, "velocity");
  const CutSpeed beyond = cuts.fastest(longest * (1 + 1e-9), limits);
  EXPECT_EQ(beyond.limit, "reversal");
  EXPECT_EQ(beyond.speed, 0);
  const CutLengths stops = cut_lengths(spec("deg", knife + "dwell = true\n"));
  EXPECT_EQ(stops.fastest(30, limits).limit, "velocity");
}

TEST(CutLengths, AreOfKindsThatCut) {
  const CutLengths cuts = cut_lengths(spec("deg", "cut_length = 4.71\nsync_angle = 10\n"));
  const CutLimits limits{{.velocity = 14400}};
  EXPECT_EQ(cuts.fastest(1.5 * pi / 18, limits).limit, "length");  // the web in step
  EXPECT_EQ(cuts.fastest(4.71, limits).limit, "velocity");
  ASSERT_EQ(cuts.marks.size(), 2U);
  EXPECT_NEAR(cuts.marks[1].length, 19.896753472735, 1e-11);
  EXPECT_THROW(
      cut_lengths(parse_spec("jounce = 1\nkind = \"gear\"\nunits = { position = \"mm\", "
                             "master = \"deg\" }\n[gear]\nnumerator = 1\nmaster_period = 1\n",
                             "g")),
      InputError);
}

}  // namespace
}  // namespace jounce::knife_test
