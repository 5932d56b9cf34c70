// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/study/optimum.hpp"
#include "jounce/study/tune.hpp"

#include "support/temporary_folder.hpp"

namespace jounce::corner_parameters_test {
namespace {

const std::string examples = JOUNCE_SOURCE_DIR "/examples/";

TEST(CornerParameters, AreTheNumbersOfTheCorners) {
  Spec spec = read_spec(examples + "path-square/deviation.toml");
  spec.parameters = corner_parameters(spec);
  ASSERT_EQ(spec.parameters->parameters.size(), 1U);
  EXPECT_EQ(spec.parameters->parameters[0].key, "path.corner.deviation");
  EXPECT_DOUBLE_EQ(spec.parameters->parameters[0].lower, 0.01);
  EXPECT_DOUBLE_EQ(spec.parameters->parameters[0].upper, 1);
  const TuneOutcome best = tune(spec);
  ASSERT_TRUE(best.usable());
  EXPECT_LE(best.figures[0].reached, *best.figures[0].given * (1 + 1e-9));
  EXPECT_LE(best.numbers[0].reached, 1);
}

// The second corner lasts as long with any deviation near the given one, within the tolerance.
TEST(CornerParameters, KeepTheirValueIfAChangeGainsNothing) {
  const std::string given =
      "jounce = 1\nkind = \"path\"\nunits = { position = \"mm\", time = \"s\" }\n[path]\n"
      "velocity = 150\ncorner = { deviation = 0.1 }\n"
      "[[axis]]\nname = \"x\"\nlimits = { velocity = 200, acceleration = 1500, jerk = 30000 }\n"
      "[[axis]]\nname = \"y\"\nlimits = { velocity = 200, acceleration = 1500, jerk = 30000 }\n"
      "[[command]]\ntype = \"line\"\nto = [100, 0]\n"
      "[[command]]\ntype = \"arc\"\ncenter = [100, 30]\nto = [100, 60]\n"
      "rotation = \"counterclockwise\"\n[[command]]\ntype = \"line\"\nto = [40, 60]\n"
      "[[command]]\ntype = \"line\"\nto = [40, 0]\n";
  Spec spec = parse_spec(given, "given.toml");
  spec.parameters = corner_parameters(spec);
  const TuneOutcome best = tune(spec);
  ASSERT_TRUE(best.usable());
  EXPECT_EQ(best.text, given);
  EXPECT_EQ(best.figures[0].reached, best.figures[0].given);
}

TEST(CornerParameters, NeedACornerWithANumber) {
  const Spec spec = read_spec(examples + "path-square/stop.toml");
  EXPECT_THROW((void)corner_parameters(spec), InputError);
}

TEST(PathOptimum, RefinesTheTimingLaw) {
  Spec spec = read_spec(examples + "path-square/deviation.toml");
  prepare_optimum(spec);
  ASSERT_TRUE(spec.parameters->refine);
  const SpecOptimum best = optimum_of(spec);
  ASSERT_TRUE(best.spec);
  EXPECT_NE(best.spec->find("[path]\nrefine = true\n"), std::string::npos);
  EXPECT_NE(best.text.find("refined timing law: "), std::string::npos);
  EXPECT_NE(best.json.find("\"refinement\""), std::string::npos);
  EXPECT_EQ(broken_checks(parse_spec(*best.spec, "best.toml")), "");
  // A second time, only the corners are left.
  Spec again = parse_spec(*best.spec, "best.toml");
  prepare_optimum(again);
  EXPECT_FALSE(again.parameters->refine);
}

TEST(PathOptimum, WithoutCornersOnlyRefines) {
  Spec spec = read_spec(examples + "path-square/stop.toml");
  prepare_optimum(spec);
  EXPECT_TRUE(spec.parameters->parameters.empty());
  const SpecOptimum best = optimum_of(spec);
  EXPECT_EQ(best.spec, spec.document.text) << "single lines have the fastest law";
  EXPECT_NE(best.text.find("not faster"), std::string::npos);
}

TEST(PathOptimum, RefinesIfTheProgramReplacesTheCorner) {
  Spec effective = read_spec(examples + "path-square/deviation.toml");
  effective.parameters = corner_parameters(effective);
  EXPECT_TRUE(idle_parameters(effective).empty());
  const test::TemporaryFolder folder;
  const std::string program = (folder.path() / "a.ngc").string();
  std::ofstream(program) << "G64 P0.1\nG1 X10 F6000\nY10\nX0\nY0\n";
  std::string axes;
  for (const char* name : {"x", "y"})
    axes += std::string("[[axis]]\nname = \"") + name +
            "\"\nlimits = { velocity = 300, acceleration = 2000, jerk = 50000 }\n";
  Spec spec = parse_spec(
      "jounce = 1\nkind = \"path\"\nunits = { position = \"mm\", time = \"s\" }\n"
      "[path]\ncorner = { deviation = 0.02 }\n[gcode]\nfile = \"" +
          program + "\"\n" + axes,
      "b.toml");
  prepare_optimum(spec);
  ASSERT_EQ(spec.parameters->parameters.size(), 1U);
  EXPECT_EQ(idle_parameters(spec).size(), 1U);
  EXPECT_THROW((void)tune(spec), InputError) << "without a search";
  const SpecOptimum best = optimum_of(spec);
  ASSERT_TRUE(best.spec);
  EXPECT_EQ(best.text.find("path.corner.deviation has no effect on the duration"), 0U) << best.text;
  EXPECT_NE(best.json.find("\"refinement\""), std::string::npos);
}

TEST(PathOptimum, LeavesOverlapAndOverrideAlone) {
  for (const char* name : {"path-square/overlap.toml", "pmc600-path/ratio.toml"}) {
    Spec spec = read_spec(examples + name);
    EXPECT_THROW(prepare_optimum(spec), InputError) << name;
  }
}

}  // namespace
}  // namespace jounce::corner_parameters_test
