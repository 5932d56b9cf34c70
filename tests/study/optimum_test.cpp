// SPDX-License-Identifier: Apache-2.0
#include "jounce/study/optimum.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/design/make.hpp"
#include "jounce/optimize/optimize.hpp"

#include "support/errors.hpp"

namespace jounce::optimum_test {
namespace {

using nlohmann::json;
using testing::StartsWith;

const std::string examples = JOUNCE_SOURCE_DIR "/examples/";

TEST(Optimum, OfKnotsIsThatOfTheOptimizer) {
  const Spec spec = read_spec(examples + "pmc600-cam/cam.toml");
  const Outcome<CamSpec> outcome = optimize(make_problem(spec));
  double last = 0;
  const SpecOptimum best = optimum_of(spec, [&](double done, const std::string& step) {
    EXPECT_GE(done, 0);
    EXPECT_LE(done, 1);
    EXPECT_FALSE(step.empty());
    last = done;
    return true;
  });
  EXPECT_GT(last, 0) << "reports its progress";
  EXPECT_THAT(best.text, StartsWith(std::string(name(outcome.status)) + ": "));
  const json document = json::parse(best.json);
  EXPECT_EQ(document["objectives"][0]["reached"], outcome.figures[0].reached);
  ASSERT_TRUE(best.spec);
  const Spec optimized = parse_spec(*best.spec, "better.toml");
  const auto& segments = std::get<CamSpec>(optimized.subject).segments;
  ASSERT_EQ(segments.size(), outcome.best.segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i)
    EXPECT_DOUBLE_EQ(segments[i].end.master, outcome.best.segments[i].end.master) << i;
}

TEST(Optimum, IsStoppedByItsCaller) {
  const Spec spec = read_spec(examples + "pmc600-cam/cam.toml");
  const SpecOptimum best = optimum_of(spec, [](double, const std::string&) { return false; });
  EXPECT_THAT(best.text, StartsWith("cancelled: "));
}

TEST(Optimum, AgainstADriveNeedsOne) {
  const Spec cam = read_spec(examples + "against-drive/cam.toml");
  EXPECT_EQ(test::key_of([&] { optimum_against(cam, cam); }), "drive");
}

}  // namespace
}  // namespace jounce::optimum_test
