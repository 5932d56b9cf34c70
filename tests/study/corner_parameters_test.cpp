// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/study/tune.hpp"

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

TEST(CornerParameters, NeedACornerWithANumber) {
  const Spec spec = read_spec(examples + "path-square/stop.toml");
  EXPECT_THROW((void)corner_parameters(spec), InputError);
}

}  // namespace
}  // namespace jounce::corner_parameters_test
