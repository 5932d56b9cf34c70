// SPDX-License-Identifier: Apache-2.0
#include "jounce/proof/proof.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/base/file.hpp"
#include "jounce/proof/any_figure.hpp"
#include "jounce/proof/report_page.hpp"

#include "support/errors.hpp"
#include "support/temporary_folder.hpp"

namespace jounce::proof_test {
namespace {

const std::string examples = JOUNCE_SOURCE_DIR "/examples/";

Input example(const std::string& path) {
  return read_inputs(examples + path).front();
}

TEST(Proof, AnExampleIsProven) {
  const Input input = example("rotary-knife/knife.toml");
  const Proof proof = prove(input);
  EXPECT_TRUE(proof.report.ok()) << full_text(proof.report, input.labels);
  EXPECT_FALSE(proof.drive);
  const auto document = nlohmann::json::parse(proof_json(proof, input));
  EXPECT_EQ(document["ok"], true);
  EXPECT_EQ(document["witness"]["table"]["position"], proof.table.position.relative);
}

/// The limits are not part of the proof, but its text names a broken one. The greatest slope of the law is
/// 1.875 * 100 / 360.
TEST(Proof, ABrokenLimitIsInTheAnswer) {
  const test::TemporaryFolder folder;
  const auto answer = [&](const std::string& velocity) {
    write_file(folder / "c.toml",
               "jounce = 1\nkind = \"cam\"\nunits = { position = \"mm\", master = \"deg\" }\nstart "
               "= { master = 0, slave = 0 }\n[limits]\ngeo_velocity = " +
                   velocity +
                   "\n[[segment]]\nlaw = \"345\"\nend = { master = 360, slave = 100 }\n");
    const Input input = read_inputs(folder / "c.toml").front();
    return proof_answer(prove(input), input);
  };
  EXPECT_THAT(answer("0.52"), testing::HasSubstr("the motion breaks one"));
  EXPECT_THAT(answer("0.53"), testing::Not(testing::HasSubstr("the motion breaks one")));
}

/// Short pieces of nearly constant jerk begin seconds after the start. Between them, the axis is in motion for
/// seconds, so an error of the acceleration in one of them grows a thousand times. With 60 digits, the
/// pieces of this program agree to 2e-15 of the range (decision 0162).
TEST(Proof, AProgramWithHelicesIsProven) {
  const test::TemporaryFolder folder;
  write_file(folder / "bore.ngc", R"(G21 G90 G17
G54 G64 P0.01
G0 X10 Y10 Z10
G4 P0.25
G0 Z5
G0 X40 Y30
G1 Z0 F900
G1 X43 F2400
G3 X43 Y30 I-3 J0 Z-1 F1800
G3 X43 Y30 I-3 J0 Z-2
G3 X43 Y30 I-3 J0 Z-3
G3 I-3 J0
G1 X46 Y30 F3600
M30
)");
  write_file(folder / "bore.toml", R"(jounce = 1
kind = "path"
units = { position = "mm" }
[path]
corner = { deviation = 0.02 }
[gcode]
file = "bore.ngc"
rapid = "15 m/min"
G54 = [15, 25, 0]
[[axis]]
name = "x"
limits = { velocity = 300, acceleration = 2500, jerk = 60000 }
[[axis]]
name = "y"
limits = { velocity = 250, acceleration = 2000, jerk = 50000 }
[[axis]]
name = "z"
limits = { velocity = 120, acceleration = 1200, jerk = 30000 }
)");
  for (const Input& axis : read_inputs(folder / "bore.toml")) {
    const Proof proof = prove(axis);
    EXPECT_TRUE(proof.report.ok()) << full_text(proof.report, axis.labels);
    EXPECT_LT(proof.curve.position.relative, 2e-11) << axis.axis;
  }
}

TEST(Proof, ADriveAndAFollowerHaveTheirParts) {
  const Input cam = example("valve-train/cam.toml");
  ASSERT_TRUE(cam.spec->follower);
  const Proof proof = prove(cam, {.drive_samples = 11});
  ASSERT_TRUE(proof.follower);
  EXPECT_EQ(proof.follower->samples.size(), 11U);
  EXPECT_THAT(proof_text(proof, cam), ::testing::HasSubstr("contact force"));
  for (const Finding& finding : proof.report.findings) EXPECT_NE(finding.axis, "");
}

/// The torque in the remedy of a saturated drive is the limit with which the drive can follow.
TEST(Proof, ASaturatedDriveNamesTheTorqueThatTheMotionNeeds) {
  Input input = example("fastest-for-motor/move.toml");
  ASSERT_TRUE(input.drive);
  double& limit = input.drive->drive.motor.torque_limit;
  limit = std::abs(prove(input).drive->torque.value) / 2;
  const Proof saturated = prove(input);
  const auto& findings = saturated.report.findings;
  const auto found = std::find_if(findings.begin(), findings.end(), [](const Finding& f) {
    return f.rule == "drive/saturation" && f.broken;
  });
  ASSERT_NE(found, findings.end());
  EXPECT_THAT(sentence(*found, input.labels),
              ::testing::StartsWith("the torque reaches the limit "));
  const std::string before = "without this limit, the torque reaches ";
  ASSERT_THAT(found->advice, ::testing::StartsWith(before));
  limit = std::stod(found->advice.substr(before.size()));
  EXPECT_TRUE(prove(input).drive->saturation.empty());
}

TEST(Proof, ALogThatIsNoneIsRejected) {
  const Input input = example("pmc600-cam/cam.toml");
  EXPECT_NE(test::error_of([&] { prove(input, {.log = examples + "pmc600-cam/cam.toml"}); }), "");
}

template <class Part>
const Part* part_of(const Page& page, const std::string& heading) {
  for (const Section& section : page.sections)
    if (section.heading == heading)
      for (const Block& block : section.blocks)
        if (const auto* part = std::get_if<Part>(&block)) return part;
  return nullptr;
}

TEST(ReportPage, ShowsTheSpecWithItsFindingsAtTheirLines) {
  const Input input = example("pmc600-cam/cam.toml");
  const Page page = report_page(input, std::nullopt).page;
  const auto* listing = part_of<Listing>(page, "Spec");
  ASSERT_NE(listing, nullptr);
  EXPECT_EQ(listing->text, input.spec->document.text);
  std::size_t broken = 0;
  for (const auto& remark : listing->remarks) {
    broken += remark.broken ? 1U : 0U;
    EXPECT_GT(remark.line, 0);
  }
  EXPECT_EQ(broken, 2U) << "as printed, the cam breaks both limits";
}

TEST(ReportPage, ShowsThePlateOfADiscAndThePlaneOfAPath) {
  const Page cam = report_page(example("valve-cam/valve.toml"), std::nullopt).page;
  const auto* plate = part_of<Image>(cam, "Disc");
  ASSERT_NE(plate, nullptr);
  EXPECT_THAT(plate->svg, ::testing::HasSubstr("class=\"cam\""));
  const Page path = report_page(example("path-square/deviation.toml"), std::nullopt).page;
  const auto* plane = part_of<Image>(path, "Path");
  ASSERT_NE(plane, nullptr);
  EXPECT_THAT(plane->svg, ::testing::HasSubstr("speed"));
}

TEST(AnyFigure, NamesTheSpecAndWhatEachPictureOfADriveShows) {
  using ::testing::HasSubstr;
  using ::testing::StartsWith;
  const std::string motor = examples + "fastest-for-motor/move.toml";
  const std::string name = example("fastest-for-motor/move.toml").name;
  for (const char* which : {"bode", "nyquist", "torque-speed", "response"})
    EXPECT_THAT(any_figure({.file = motor, .drive = which}).title, StartsWith(name + ": "))
        << which;
  // The series draws the point of the rms torque, as the legend shows it.
  const Figure torque = any_figure({.file = motor, .drive = "torque-speed"});
  const Panel& panel = torque.panels[0];
  ASSERT_EQ(panel.markers.size(), 1U);
  EXPECT_TRUE(panel.markers[0].text_only);
  EXPECT_EQ(panel.series.back().style, Style::dots);
  EXPECT_EQ(panel.series.back().x[0], panel.markers[0].x);
  EXPECT_EQ(panel.series.back().y[0], panel.markers[0].y);
  const Figure spectrum =
      any_figure({.file = examples + "residual-17hz/cam.toml", .drive = "spectrum"});
  EXPECT_THAT(spectrum.x_label, HasSubstr("natural frequency"));
  EXPECT_THAT(spectrum.x_note, HasSubstr("motion alone"));
}

TEST(ReportPage, ShowsTheResultOfTheOptimizer) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "optimum.json";
  write_file(file, R"({"status":"converged","reason":"none better","evaluations":9,"objectives":[
    {"objective":"peak geo_jerk","unit":"mm/deg^3","given":2,"reached":1.5,"bound":1.2,"gap":0.2}],
    "active":[{"rule":"limit/geo_velocity","quantity":"geo_velocity","where":12,"value":3,"limit":3}],
    "peaks":[{"quantity":"geo_velocity","unit":"mm/deg","given":2,"optimized":3,"limit":3}]})");
  const Input input = example("pmc600-cam/cam.toml");
  const Page page = report_page(input, std::nullopt, {.optimum = file}).page;
  const auto* objectives = part_of<DataTable>(page, "Optimization");
  ASSERT_NE(objectives, nullptr);
  EXPECT_THAT(objectives->rows.at(0).cells, ::testing::ElementsAre("peak geo_jerk", "mm/deg^3", "2",
                                                                   "1.5", "25 %", "1.2", "20 %"));
  const std::string shown = html(page);
  EXPECT_THAT(shown, ::testing::HasSubstr("data-from=\"12\""));
  EXPECT_THAT(shown, ::testing::HasSubstr("50 %"));
  write_file(file, "{}");
  EXPECT_THAT(test::why([&] { report_page(input, std::nullopt, {.optimum = file}); }),
              ::testing::HasSubstr("is not the output of `jounce optimize --json`"));
}

TEST(ReportPage, ShowsTheResultOfASearchOverNumbers) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "optimum.json";
  write_file(file, R"({"status":"converged","reason":"the best value","evaluations":257,"figures":[
    {"name":"cycle time","unit":"s","given":1.5,"reached":1.28}],"parameters":[
    {"key":"shear.cut_length","unit":"mm","given":1800,"reached":1538,"range":[1000,3000]}],
    "active":["acceleration 11000 mm/s^2 just meets its limit"],
    "refinement":{"unit":"s","given":69.2,"reached":68.1}})");
  const Page page =
      report_page(example("pmc600-cam/cam.toml"), std::nullopt, {.optimum = file}).page;
  const std::string shown = html(page);
  for (const char* text :
       {"cycle time", "1.28", "shear.cut_length", "1538", "3000", "just meets its limit", "68.1 s"})
    EXPECT_THAT(shown, ::testing::HasSubstr(text));
  const auto* figures = part_of<DataTable>(page, "Optimization");
  ASSERT_NE(figures, nullptr);
  EXPECT_THAT(figures->rows.at(0).cells,
              ::testing::ElementsAre("cycle time", "s", "1.5", "1.28", "", ""));
}

TEST(ReportPage, HoldsTheFindingsOfCheckAndProof) {
  const Input input = example("pmc600-cam/cam.toml");
  const ReportPage page = report_page(input, std::nullopt, {});
  EXPECT_GT(page.findings.findings.size(), prove(input).report.findings.size());
  EXPECT_EQ(page.page.sections.size(), 5U);
  EXPECT_EQ(page.findings.ok(), page.page.verdict->ok);
}

TEST(ReportPage, AMotionBeforeACamIsRejected) {
  const Input cam = example("pmc600-cam/cam.toml");
  EXPECT_EQ(test::key_of([&] { report_page(cam, example("generators/03-move.toml"), {}); }),
            "before");
}

}  // namespace
}  // namespace jounce::proof_test
