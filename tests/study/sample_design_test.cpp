// SPDX-License-Identifier: Apache-2.0
// Latin hypercubes and Sobol's sequence, against SciPy (tests/oracle/sobol.py) and their definitions.
#include "jounce/study/detail/sample_design.hpp"

#include <cmath>
#include <cstdint>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "study/src/sweep/sobol.hpp"
#include "support/errors.hpp"

namespace jounce::sample_design_test {
namespace {

std::vector<std::string> names(std::size_t n) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < n; ++i) all.push_back("p" + std::to_string(i));
  return all;
}

TEST(Sobol, IsTheOracles) {
  const auto all =
      nlohmann::json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/sobol.json"));
  ASSERT_EQ(all.at("points").size(), 20u);
  for (const auto& point : all.at("points")) {
    ASSERT_EQ(point.at("x").size(), sobol_dimensions);
    for (std::size_t d = 0; d < sobol_dimensions; ++d)
      EXPECT_EQ(sobol(point.at("number"), d), point.at("x")[d].get<std::uint32_t>())
          << point.at("number") << ", dimension " << d;
  }
}

/// One sample in each of N equal intervals of every parameter.
void expect_even(const SampleDesign& design, std::size_t parameters, std::size_t samples) {
  for (std::size_t p = 0; p < parameters; ++p) {
    std::set<std::size_t> taken;
    for (std::size_t s = 0; s < samples; ++s) {
      const double u = design.at(p, s);
      ASSERT_GT(u, 0);
      ASSERT_LT(u, 1);
      taken.insert(static_cast<std::size_t>(u * static_cast<double>(samples)));
    }
    EXPECT_EQ(taken.size(), samples) << "parameter " << p;
  }
}

TEST(SampleDesign, HasOneSampleInEachInterval) {
  expect_even({Design::latin_hypercube, 3, names(5), 100}, 5, 100);
  expect_even({Design::sobol, 3, names(sobol_dimensions), 256}, sobol_dimensions, 256);
}

/// The first two coordinates of Sobol's sequence make a (0, k, 2)-net: one of 2^k points in every
/// box of 2^-i by 2^-(k-i).
TEST(SampleDesign, OfSobolIsEvenOverTwoParametersAtOnce) {
  const SampleDesign design(Design::sobol, 9, names(2), 64);
  for (int i = 0; i <= 6; ++i) {
    std::set<std::pair<int, int>> boxes;
    for (std::size_t s = 0; s < 64; ++s)
      boxes.emplace(static_cast<int>(design.at(0, s) * (1 << i)),
                    static_cast<int>(design.at(1, s) * (1 << (6 - i))));
    EXPECT_EQ(boxes.size(), 64u) << i;
  }
}

TEST(SampleDesign, DependsOnItsSeedAndGivesEachParameterItsOwn) {
  for (const Design kind : {Design::latin_hypercube, Design::sobol}) {
    const SampleDesign one(kind, 1, names(2), 50), same(kind, 1, names(2), 50),
        other(kind, 2, names(2), 50);
    EXPECT_EQ(one.at(0, 7), same.at(0, 7));
    EXPECT_NE(one.at(0, 7), other.at(0, 7));
    EXPECT_NE(one.at(0, 7), one.at(1, 7));
  }
}

TEST(SampleDesign, RejectsMoreParametersThanSobolHasDimensions) {
  EXPECT_THAT(test::error_of([] {
                const SampleDesign design(Design::sobol, 1, names(sobol_dimensions + 1), 8);
              }),
              ::testing::HasSubstr("takes at most 21 random parameters; there are 22"));
}

TEST(NormalQuantile, HasTheValuesOfTheTables) {
  EXPECT_NEAR(normal_quantile(0.5), 0, 1e-15);
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-14);
  EXPECT_NEAR(normal_quantile(0.0013498980316300933), -3, 1e-14);
  EXPECT_NEAR(normal_quantile(1e-100), -21.273453560965322, 1e-13);
}

}  // namespace
}  // namespace jounce::sample_design_test
