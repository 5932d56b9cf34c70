// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/design/make.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"

namespace jounce::polydyne_test {
namespace {

using ::testing::HasSubstr;

/// A pusher behind a 12 Hz mode, at 400 deg/s.
std::string spec_text(const std::string& law, const std::string& below,
                      const std::string& master = "velocity = 400\ndistance = 360\n") {
  return "jounce = 1\nkind = \"cam\"\nname = \"pusher\"\nperiodic = true\nunits = { master = "
         "\"deg\", position = \"mm\" }\nstart = { master = 0, slave = 0 }\nsegment = [ { law = \"" +
         law +
         "\", end = { master = 120, slave = 40 } },\n { law = \"dwell\", end = { master = 180, "
         "slave = 40 } },\n { law = \"" +
         law +
         "\", end = { master = 300, slave = 0 } },\n { law = \"dwell\", end = { master = 360, "
         "slave "
         "= 0 } } ]\n" +
         (master.empty() ? "" : "[master]\n" + master) + below;
}

Spec spec_of(const std::string& text) {
  return parse_spec(text, "pusher.toml");
}

TEST(PolydyneSpec, DrivesTheModeAtTheMastersSpeed) {
  const Spec spec =
      spec_of(spec_text("56789", "[polydyne]\nfrequency = \"12 Hz\"\ndamping = 0.02\n"));
  const Made made = make(spec);
  ASSERT_EQ(made.residuals.size(), 1U);
  EXPECT_GT(made.residuals[0].before, 1e-3);
  EXPECT_LT(made.residuals[0].after, 1e-12 * 40);
  const Cam& cam = std::get<Cam>(*made.curve);
  EXPECT_EQ(cam.outside(), Extrapolation::wrap);
  EXPECT_EQ(cam.at(150).position, 40);
  // (1) of jounce/cam/laws/polydyne.hpp at 60 deg, where the output's velocity is 315/128 * 40/120 and its
  // acceleration 0.
  const double w = 2 * 3.14159265358979323846 * 12 / 400;
  EXPECT_NEAR(cam.at(60).position, 20 + 2 * 0.02 / w * 315.0 / 128 * 40 / 120, 1e-12);
  EXPECT_TRUE(table_warnings(spec).findings.empty());
}

TEST(PolydyneSpec, CountsInTheSpecsUnitOfTime) {
  const std::string tail = "[polydyne]\nfrequency = \"12 Hz\"\n";
  const std::string text = spec_text("56789", tail, "velocity = \"400 deg/s\"\ndistance = 360\n");
  std::string in_minutes = text;
  in_minutes.replace(in_minutes.find("position = \"mm\""), 15, "position = \"mm\", time = \"min\"");
  const Cam a = std::get<Cam>(*make(spec_of(text)).curve);
  const Cam b = std::get<Cam>(*make(spec_of(in_minutes)).curve);
  EXPECT_NEAR(a.at(33).position, b.at(33).position, 1e-12);
}

TEST(PolydyneSpec, WarnsOfTheKnockAndRejectsWhatCannotBe) {
  const std::string tail = "[polydyne]\nfrequency = 12\n";
  EXPECT_EQ(table_warnings(spec_of(spec_text("4567", tail))).warnings(), 1U);
  const auto refused = [](const std::string& text) {
    return test::error_of([&] { (void)make(spec_of(text)); }, "nothing");
  };
  EXPECT_THAT(refused(spec_text("345", tail)), HasSubstr("geo_velocity would step"));
  EXPECT_THAT(refused(spec_text("56789", tail, "")), HasSubstr("add [master]"));
  EXPECT_THAT(refused(spec_text("56789", "[polydyne]\nfrequency = -1\n")),
              HasSubstr("pusher.toml:15:13: polydyne.frequency = -1 Hz: must be greater than 0"));
  EXPECT_THAT(refused(spec_text("56789", "[polydyne]\nfrequency = 12\ndamping = 1\n")),
              HasSubstr("less than 1"));
  EXPECT_THAT(refused(spec_text("56789", "[polydyne]\nfrequency = nan\n")),
              HasSubstr("polydyne.frequency"));
  EXPECT_THAT(refused(spec_text("56789", "[polydyne]\nfrequency = 12\nratio = 1\n")),
              HasSubstr("polydyne.ratio"));
  EXPECT_THROW((void)make_problem(spec_of(spec_text("56789", tail))), InputError);
}

}  // namespace
}  // namespace jounce::polydyne_test
