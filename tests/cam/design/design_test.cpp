// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/design/design.hpp"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"
#include "support/fig_6_14.hpp"
#include "support/invariants.hpp"
#include "support/oracle.hpp"

namespace jounce::design_test {
namespace {

using test::fig_6_14;
using test::oracle;

/// True if a value has all the digits that the manual prints. Its column cuts digits off rather
/// than rounding them, so the value lies between the printed number and the next one.
bool has_printed_digits(double value, const std::string& printed) {
  const auto point = printed.find('.');
  const double unit = point == std::string::npos
                          ? 1
                          : std::pow(10, -static_cast<double>(printed.size() - point - 1));
  const double shown = std::stod(printed);
  return value >= shown - 1e-12 * std::abs(shown) - 1e-13 && value < shown + unit;
}

TEST(Design, Pmc600Fig614HasAllPrintedDigits) {
  const Cam cam = design(fig_6_14()).cam;
  const auto& segments = oracle("pmc600_fig_6_14")["segments"];
  ASSERT_EQ(cam.segments().size(), segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    SCOPED_TRACE(i + 1);
    const Ranges r = segment_extrema(cam, i);
    const auto& printed = segments[i]["printed"];
    EXPECT_TRUE(has_printed_digits(r[0].min.value, printed["min_position"])) << r[0].min.value;
    EXPECT_TRUE(has_printed_digits(r[0].max.value, printed["max_position"])) << r[0].max.value;
    EXPECT_TRUE(has_printed_digits(std::abs(r[1].peak().value), printed["max_abs_v"]))
        << r[1].peak().value;
    EXPECT_TRUE(has_printed_digits(std::abs(r[2].peak().value), printed["max_abs_a"]))
        << r[2].peak().value;

    const double stroke = 232;
    EXPECT_NEAR(r[0].min.value, segments[i]["min_position"].get<double>(), 1e-14 * stroke);
    EXPECT_NEAR(r[0].max.value, segments[i]["max_position"].get<double>(), 1e-14 * stroke);
    EXPECT_NEAR(std::abs(r[1].peak().value), segments[i]["max_abs_v"].get<double>(), 1e-13);
    EXPECT_NEAR(std::abs(r[2].peak().value), segments[i]["max_abs_a"].get<double>(), 1e-14);
  }
  EXPECT_NEAR(segment_extrema(cam, 0)[1].max.where, 42, 1e-9) << "peak slope at master 42";
}

TEST(Design, Fig614IsSmoothAlsoWhereItWraps) {
  const Cam cam = design(fig_6_14()).cam;
  test::expect_invariants(cam, 2);
  EXPECT_NEAR(cam.at(360 * 1000 + 100).position, 125, 1e-9);
}

TEST(Design, PlacesRestToRestLawsAndKeepsTheirOrigin) {
  CamSpec spec;
  spec.start = {10, 5, {}, {}};
  spec.segments = {{Law::modified_sine, {130, 55, {}, {}}, "rise"},
                   {Law::dwell, {200, 55, {}, {}}, "dwell"},
                   {Law::modified_trapezoid, {360, -45, {}, {}}, "return"}};
  const CamDesign made = design(spec);
  EXPECT_EQ(made.origin, (std::vector<std::size_t>{0, 0, 0, 0, 1, 2, 2, 2, 2, 2, 2}));
  EXPECT_NEAR(made.cam.at(70).position, 30, 1e-13);
  EXPECT_NEAR(made.cam.at(150).position, 55, 1e-13);
  EXPECT_NEAR(made.cam.at(500).position, -45, 1e-13) << "not periodic: holds";
  EXPECT_NEAR(extrema(made.cam, 1).min.value, -2 * 100.0 / 160, 1e-13)
      << "Cv of the modified trapezoid";
  test::expect_invariants(made.cam, 2);
}

TEST(Design, TakesTheSlopeOfALineWhereNoneIsGiven) {
  CamSpec spec;
  spec.segments = {{Law::quintic, {100, 50, {}, {}}, ""},
                   {Law::line, {200, 150, {}, {}}, ""},
                   {Law::quintic, {300, 200, {}, {}}, ""}};
  const auto knots = resolved_knots(spec);
  EXPECT_DOUBLE_EQ(*knots[1].geo_velocity, 1);
  EXPECT_DOUBLE_EQ(*knots[0].geo_velocity, 0);
  EXPECT_TRUE(check_continuity(design(spec).cam, 2).ok());
}

TEST(Design, ALawThatMovesTakesUpTheLineBesideIt) {
  for (const LawInfo& law : all_laws()) {
    if (law.ends != Ends::moving) continue;
    SCOPED_TRACE(law.name);
    CamSpec spec;
    spec.segments = {{law.law, {100, 50}}, {Law::line, {200, 150}}, {law.law, {360, 0}}};
    const CamDesign made = design(spec);
    EXPECT_TRUE(check_continuity(made.cam, 2).ok());
    EXPECT_EQ(transition(made, 0), "R-G");
    EXPECT_EQ(transition(made, 1), "G-G");
    EXPECT_EQ(transition(made, 2), "G-R");
  }
}

TEST(Design, TurnsARestToReversalLawToItsRest) {
  for (const LawInfo& law : all_laws()) {
    if (law.ends != Ends::rest_to_reversal) continue;
    SCOPED_TRACE(law.name);
    CamSpec spec;
    spec.periodic = true;
    spec.segments = {{law.law, {120, 30}}, {law.law, {240, 0}}, {Law::dwell, {360, 0}}};
    const CamDesign made = design(spec);
    EXPECT_EQ(transition(made, 0), "R-U");
    EXPECT_EQ(transition(made, 1), "U-R");
    EXPECT_TRUE(check_continuity(made.cam, 2).ok()) << "one acceleration at the reversal";
    for (const double u : {10., 60., 110.})
      EXPECT_NEAR(made.cam.at(120 - u).position, made.cam.at(120 + u).position, 1e-13);
  }
}

TEST(Design, FindsTheInflectionThatAReversalsAccelerationAsksFor) {
  CamSpec spec;
  spec.segments = {{Law::harmonic_combination, {100, 30, {}, -0.02}},
                   {Law::harmonic_combination, {180, 0}},
                   {Law::dwell, {360, 0}}};
  const CamDesign made = design(spec);
  EXPECT_TRUE(check_continuity(made.cam, 2).ok()) << "both sides meet the acceleration asked for";
  EXPECT_NEAR(made.cam.at(100).geo_acceleration, -0.02, 1e-15);
  EXPECT_NEAR(made.cam.at(100).position, 30, 1e-13);
}

TEST(Design, BringsASinesReversalToTheNeighbourThatTakesIt) {
  CamSpec spec;
  spec.segments = {{Law::simple_sine, {100, 40}}, {Law::quintic, {220, 0}}};
  const CamDesign made = design(spec);
  EXPECT_NEAR(*resolved_knots(spec)[1].geo_acceleration, -std::pow(std::acos(-1), 2) / 2 * 40 / 1e4,
              1e-17);
  EXPECT_EQ(transition(made, 0), "U-U");
  EXPECT_EQ(transition(made, 1), "U-R");
}

TEST(Design, ReachesThePointsOfAPolynomial) {
  CamSpec spec;
  spec.start = {10, 1};
  CamSegment segment{Law::polynomial, {70, 5, 0.1, 0}};
  segment.points = {{.master = 10, .geo_jerk = 0},
                    {.master = 30, .slave = 1.8},
                    {.master = 40, .geo_velocity = 0.08},
                    {.master = 55, .slave = 3.5, .geo_acceleration = 0.002}};
  spec.segments = {segment, {Law::quintic, {80, 5.5}}};
  const Cam f = design(spec).cam;
  EXPECT_EQ(f.segments()[0].degree, 10);
  EXPECT_NEAR(f.at(10).geo_jerk, 0, 1e-14);
  EXPECT_NEAR(f.at(30).position, 1.8, 1e-12);
  EXPECT_NEAR(f.at(40).geo_velocity, 0.08, 1e-12);
  EXPECT_NEAR(f.at(55).position, 3.5, 1e-12);
  EXPECT_NEAR(f.at(55).geo_acceleration, 0.002, 1e-12);
  EXPECT_TRUE(check_continuity(f, 2).ok());
}

TEST(Design, ARotarySlaveAdvancesFromTurnToTurn) {
  CamSpec spec;
  spec.periodic = true;
  spec.slave_period = 360;
  spec.start = {0, 10};
  spec.segments = {
      {Law::modified_sine, {90, 250}}, {Law::dwell, {180, 250}}, {Law::poly345, {360, 370}}};
  const Cam f = design(spec).cam;
  EXPECT_EQ(f.outside(), Extrapolation::advance);
  EXPECT_NEAR(f.at(360 + 90).position, 250 + 360, 1e-12);
  EXPECT_NEAR(f.at(-360 * 1000 + 180).position, 250 - 360 * 1000, 1e-9);
  EXPECT_NEAR(f.jet(360, Side::left)[0], 370, 1e-12);
  EXPECT_NEAR(f.jet(360)[0], 370, 1e-12);
  EXPECT_TRUE(check_continuity(f, 2).ok()) << "nothing jumps where the period ends";
  spec.segments.back().end.slave = 371;
  EXPECT_THROW(design(spec), InputError);
}

TEST(Design, ASplinesOpenEndIsTheRestBesideItAlsoAcrossTheSeam) {
  for (const Law back : {Law::poly345, Law::modified_sine, Law::quintic, Law::dwell}) {
    SCOPED_TRACE(name(back));
    CamSpec spec;
    spec.periodic = true;
    CamSegment measured{Law::quintic_spline, {180, back == Law::dwell ? 0. : 30.}};
    measured.points = {{.master = 60, .slave = 11}, {.master = 120, .slave = 24}};
    spec.segments = {measured, {back, {360, 0}}};
    if (back != Law::dwell)
      spec.segments.insert(spec.segments.begin() + 1, {Law::dwell, {220, 30}});
    const CamDesign made = design(spec);
    EXPECT_TRUE(check_continuity(made.cam, back == Law::quintic ? 1 : 2).ok());
  }
}

TEST(Design, AReversalMayBeAtTheSeam) {
  CamSpec spec;
  spec.periodic = true;
  spec.start = {0, 30};
  spec.segments = {{Law::harmonic_combination, {100, 0}},
                   {Law::dwell, {260, 0}},
                   {Law::harmonic_combination, {360, 30}}};
  const CamDesign made = design(spec);
  EXPECT_EQ(transition(made, 0), "U-R");
  EXPECT_EQ(transition(made, 2), "R-U");
  EXPECT_TRUE(check_continuity(made.cam, 2).ok());
  spec.segments.back().law = Law::modified_sine;
  EXPECT_THROW(design(spec), InputError) << "a rest on both sides";
}

TEST(Design, TwoSplinesMeetAtTheSeamAsOneKnot) {
  CamSpec spec;
  spec.periodic = true;
  CamSegment up{Law::quintic_spline, {180, 30}};
  up.points = {{.master = 60, .slave = 11}, {.master = 120, .slave = 24}};
  CamSegment down{Law::quintic_spline, {360, 0}};
  down.points = {{.master = 240, .slave = 22}, {.master = 300, .slave = 9}};
  spec.segments = {up, down};
  EXPECT_TRUE(check_continuity(design(spec).cam, 2).ok());
}

TEST(Design, RejectsNumbersThatNothingCanBeComputedWith) {
  CamSpec spec;
  spec.segments = {{Law::modified_sine, {100, 1e200}}};
  EXPECT_THROW(design(spec), InputError);
  spec.segments = {{Law::quintic, {100, 10}, "", {.inflection = 0.4}}};
  EXPECT_THROW(design(spec), InputError) << "quintic takes no inflection";
}

std::string complaint(const CamSpec& spec) {
  return test::error_of([&] { (void)design(spec); });
}

TEST(Design, NamesWhatContradictsItself) {
  CamSpec spec;
  EXPECT_EQ(complaint(spec), "segment: is missing: a cam needs at least one [[segment]]");

  spec.segments = {{Law::quintic, {75, 100, 1, 0}, ""}, {Law::quintic, {75, 225, 1, 0}, ""}};
  EXPECT_EQ(complaint(spec),
            "segment[2].end.master = 75: must be greater than 75, the previous knot");

  spec.segments = {{Law::line, {100, 50, 0.6, {}}, ""}};
  EXPECT_EQ(complaint(spec),
            "segment[1].end.geo_velocity = 0.6: must be 0.5, the value of the adjacent law `line`: "
            "change this number or that law");

  spec.segments = {{Law::line, {100, 50, {}, {}}, ""}, {Law::dwell, {200, 50, {}, {}}, ""}};
  EXPECT_EQ(complaint(spec),
            "segment[1].law = \"line\": ends at master 100 with the slope 0.5, but the adjacent "
            "segment 2 (dwell) has the slope 0 there: use a law from rest to rest, such as "
            "modified_sine");
  spec.segments = {{Law::dwell, {100, 0, {}, {}}, ""}, {Law::line, {200, 50, {}, {}}, ""}};
  EXPECT_THAT(complaint(spec),
              testing::HasSubstr("segment[2].law = \"line\": begins at master 100"));
  spec.segments = {{Law::line, {100, 50, {}, {}}, ""}, {Law::line, {200, 60, {}, {}}, ""}};
  EXPECT_THAT(complaint(spec),
              testing::HasSubstr("put a segment with the law quintic between the two"));

  spec.segments = {{Law::modified_sine, {100, 50, 1, 0.1}, ""}};
  EXPECT_EQ(complaint(spec),
            "segment[1].end.geo_acceleration = 0.1: must be 0, the value of the adjacent law "
            "`modified_sine`: change this number or that law");

  spec.segments = {{Law::dwell, {100, 50, {}, {}}, ""}};
  EXPECT_EQ(complaint(spec),
            "segment[1].end.slave = 50: must be 0, the position where this dwell starts: "
            "change one of the two, or the law");

  spec.segments = {{Law::harmonic_combination, {100, 50}}, {Law::dwell, {200, 50}}};
  EXPECT_EQ(
      complaint(spec),
      "segment[1].law = \"harmonic_combination\": reverses at master 100, where the adjacent law "
      "`dwell` has no acceleration: use a law from rest to rest");

  spec.segments = {{Law::harmonic_combination, {100, 50, {}, -0.001}}};
  EXPECT_EQ(complaint(spec).substr(0, 69),
            "segment[1].end.geo_acceleration = -0.001: must be less than -0.012337")
      << "pi^2 / 4 of stroke / length^2";

  spec.segments = {{Law::double_harmonic, {100, 50, {}, -0.001}}};
  EXPECT_EQ(complaint(spec).substr(0, 59),
            "segment[1].end.geo_acceleration = -0.001: must be -0.049348");

  spec.segments = {{Law::modified_sine, {100, 50}, "", {.inflection = 1.5}}};
  EXPECT_EQ(complaint(spec),
            "segment[1].inflection = 1.5: must lie inside the segment: above 0 and below 1");

  spec.segments = {{Law::modified_sine, {100, 50}}};
  spec.segments[0].points = {{.master = 50, .slave = 3}};
  EXPECT_EQ(complaint(spec),
            "segment[1].points: the law modified_sine takes no points: leave them out, or use "
            "polynomial, "
            "cubic_spline, quintic_spline or hermite");

  spec.segments = {{Law::quintic, {100, std::nan(""), {}, {}}, ""}};
  EXPECT_EQ(complaint(spec), "segment[1].end.slave = nan: must be a finite number");
}

}  // namespace
}  // namespace jounce::design_test
