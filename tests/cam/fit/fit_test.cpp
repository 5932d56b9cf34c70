// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/fit/fit.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce::fit_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// tests/oracle/measured.json: cams of known laws with the error of an encoder, from measured.py.
const json& cases() {
  static const json all =
      json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/measured.json"));
  return all;
}

MeasuredCam measured(const json& of) {
  MeasuredCam cam{.points = {}, .periodic = of.at("periodic")};
  for (const json& row : of.at("points"))
    cam.points.push_back({row[0], row[1], of.at("tolerance")});
  return cam;
}

double slave(const Cam& cam, double master) {
  return cam.jet(master, Side::left)[0];
}

class Measured : public ::testing::TestWithParam<std::size_t> {
 protected:
  const json& of = cases()[GetParam()];
  CamFit fit = fit_cam(measured(of));
  Cam cam = design(fit.spec).cam;
};

TEST_P(Measured, PassesEveryPointWithinTheTolerance) {
  double gap = 0;
  for (const json& row : of.at("points"))
    gap = std::max(gap, std::abs(slave(cam, row[0]) - row[1].get<double>()));
  EXPECT_LE(gap, of.at("tolerance"));
  EXPECT_NEAR(fit.gap, gap, 1e-12);
}

TEST_P(Measured, HasTheLawsOfTheCam) {
  if (of.at("laws").is_null()) {
    EXPECT_TRUE(is_spline(fit.spec.segments[0].law));
    return;
  }
  ASSERT_EQ(fit.spec.segments.size(), of.at("laws").size());
  for (std::size_t i = 0; i < fit.spec.segments.size(); ++i) {
    EXPECT_EQ(std::string(name(fit.spec.segments[i].law)), of.at("laws")[i]) << i;
    const CamKnot& knot = fit.spec.segments[i].end;
    const json& known = of.at("knots")[i];
    // A law begins with a vanishing acceleration, so its knot is known to a fraction of a degree
    // only. Beside a line of a slope up to 1, it moves along the line.
    EXPECT_NEAR(knot.master, known[0].get<double>(), 0.15) << i;
    EXPECT_NEAR(knot.slave, known[1].get<double>(),
                0.01 + std::abs(knot.master - known[0].get<double>()))
        << i;
  }
}

TEST_P(Measured, IsCloserToTheCamThanItsPoints) {
  double error = 0;
  for (const json& row : of.at("truth"))
    error = std::max(error, std::abs(slave(cam, row[0]) - row[1].get<double>()));
  EXPECT_LE(error, of.at("tolerance"));
}

TEST_P(Measured, IsContinuous) {
  const Report report = check_continuity(cam, 1);
  EXPECT_TRUE(report.ok());
}

INSTANTIATE_TEST_SUITE_P(Cams, Measured, ::testing::Range<std::size_t>(0, 10),
                         [](const auto& each) {
                           std::string name = cases()[each.param].at("name");
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

TEST(FitCam, WritesFewDecimals) {
  const CamFit fit = fit_cam(measured(cases()[2]));  // without noise
  for (const CamSegment& segment : fit.spec.segments)
    EXPECT_EQ(segment.end.master, std::round(segment.end.master));
}

TEST(FitCam, ASplineNeedsFewPoints) {
  const CamFit fit = fit_cam(measured(cases()[9]));
  std::size_t points = fit.spec.segments.size();
  for (const CamSegment& segment : fit.spec.segments) points += segment.points.size();
  EXPECT_LE(points, 24);  // instead of 721
}

TEST(FitCam, NamesTheNextLaw) {
  const CamFit fit = fit_cam(measured(cases()[0]));
  ASSERT_TRUE(fit.segments[0].next);
  EXPECT_GT(fit.segments[0].next_gap, fit.segments[0].gap);
  EXPECT_FALSE(fit.segments[1].next);  // a dwell
}

std::string complaint(const MeasuredCam& measured) {
  try {
    (void)fit_cam(measured);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(FitCam, RejectsWhatItCannotFit) {
  MeasuredCam few{.points = {{0, 0, 1}, {1, 1, 1}, {2, 2, 1}}, .periodic = false};
  EXPECT_THAT(complaint(few), HasSubstr("points"));
  MeasuredCam exact{.points = {{0, 0, 1}, {1, 1, 1}, {2, 2, 0}, {3, 3, 1}, {4, 4, 1}},
                    .periodic = false};
  EXPECT_EQ(complaint(exact), "points[3].tolerance = 0: must be greater than 0");
}

TEST(FitCam, ALineIsALine) {
  MeasuredCam line;
  for (int i = 0; i <= 20; ++i) line.points.push_back({1.0 * i, 2.0 * i + (i % 2) * 0.01, 0.02});
  const CamFit fit = fit_cam(line);
  ASSERT_EQ(fit.spec.segments.size(), 1);
  EXPECT_EQ(fit.spec.segments[0].law, Law::line);
}

TEST(FitCam, ARestIsADwell) {
  MeasuredCam rest;
  for (int i = 0; i <= 20; ++i) rest.points.push_back({1.0 * i, 3 + (i % 3) * 0.01, 0.02});
  const CamFit fit = fit_cam(rest);
  ASSERT_EQ(fit.spec.segments.size(), 1);
  EXPECT_EQ(fit.spec.segments[0].law, Law::dwell);
}

}  // namespace
}  // namespace jounce::fit_test
