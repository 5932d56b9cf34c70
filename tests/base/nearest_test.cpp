// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/detail/nearest.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace jounce::nearest_test {
namespace {

std::string meant(const char* word, const std::vector<std::string>& known) {
  return nearest(word, known);
}

TEST(Nearest, CorrectsUpToTwoLetters) {
  EXPECT_EQ(meant("jrek", {"jerk"}), "jerk");
  EXPECT_EQ(meant("fase", {"phase"}), "phase");
  EXPECT_EQ(meant("shap", {"shape", "shaper"}), "shape");
  EXPECT_EQ(meant("velocity", {"position"}), "");
}

TEST(Nearest, TakesNoWordForAnotherThatOnlyEndsAlike) {
  EXPECT_EQ(meant("deceleration", {"acceleration"}), "");
  EXPECT_EQ(meant("lathe", {"path"}), "");
  EXPECT_EQ(meant("xath", {"path"}), "path");
  EXPECT_EQ(meant("spec", {"sync"}), "");
}

}  // namespace
}  // namespace jounce::nearest_test
