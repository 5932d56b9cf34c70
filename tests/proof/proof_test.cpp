// SPDX-License-Identifier: Apache-2.0
#include "jounce/proof/proof.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/proof/report_page.hpp"

#include "support/errors.hpp"

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

TEST(Proof, ADriveAndAFollowerHaveTheirParts) {
  const Input cam = example("valve-train/cam.toml");
  ASSERT_TRUE(cam.spec->follower);
  const Proof proof = prove(cam, {.drive_samples = 11});
  ASSERT_TRUE(proof.follower);
  EXPECT_EQ(proof.follower->samples.size(), 11U);
  EXPECT_THAT(proof_text(proof, cam), ::testing::HasSubstr("contact force"));
  for (const Finding& finding : proof.report.findings) EXPECT_NE(finding.axis, "");
}

TEST(Proof, ALogThatIsNoneIsRefused) {
  const Input input = example("pmc600-cam/cam.toml");
  EXPECT_NE(test::error_of([&] { prove(input, {.log = examples + "pmc600-cam/cam.toml"}); }), "");
}

TEST(ReportPage, HoldsTheFindingsOfCheckAndProof) {
  const Input input = example("pmc600-cam/cam.toml");
  const ReportPage page = report_page(input, std::nullopt, {});
  EXPECT_GT(page.findings.findings.size(), prove(input).report.findings.size());
  EXPECT_EQ(page.page.sections.size(), 4U);
  EXPECT_EQ(page.findings.ok(), page.page.verdict->ok);
}

TEST(ReportPage, AMotionBeforeACamIsRefused) {
  const Input cam = example("pmc600-cam/cam.toml");
  EXPECT_EQ(test::key_of([&] { report_page(cam, example("generators/03-move.toml"), {}); }),
            "before");
}

}  // namespace
}  // namespace jounce::proof_test
