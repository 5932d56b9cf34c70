// SPDX-License-Identifier: Apache-2.0
#include "study/src/sweep/pareto.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/random.hpp"

namespace jounce::pareto_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Points = std::vector<std::vector<double>>;

TEST(ParetoFront, ContainsTheNonDominatedPoints) {
  EXPECT_THAT(pareto_front(Points{{1, 5}, {2, 3}, {2, 4}, {4, 1}}), ElementsAre(0, 1, 3));
  EXPECT_THAT(pareto_front(Points{{3}, {1}, {2}, {1}}), ElementsAre(1, 3));
  EXPECT_THAT(pareto_front(Points{}), IsEmpty());
}

TEST(ParetoFront, KeepsEqualPointsAndDropsThoseThatAreWorseInOne) {
  EXPECT_THAT(pareto_front(Points{{1, 1}, {1, 1}, {1, 2}, {2, 1}}), ElementsAre(0, 1));
  EXPECT_THAT(pareto_front(Points{{0, 1, 1}, {0, 1, 1}, {0, 1, 2}}), ElementsAre(0, 1));
}

TEST(ParetoFront, RejectsNanButAcceptsInfinity) {
  const double nan = std::nan("");
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_THAT(pareto_front(Points{{nan, 0}, {1, 1}, {0, nan}}), ElementsAre(1));
  EXPECT_THAT(pareto_front(Points{{nan, nan}}), IsEmpty());
  EXPECT_THAT(pareto_front(Points{{inf, 0}, {0, inf}, {inf, inf}}), ElementsAre(0, 1));
  EXPECT_THAT(pareto_front(Points{{inf, inf}, {inf, inf}}), ElementsAre(0, 1));
}

/// By the definition: each against each.
std::vector<std::size_t> by_definition(const Points& points) {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool dominated = false;
    for (const auto& other : points) {
      bool nowhere_above = true;
      bool below = false;
      for (std::size_t k = 0; k < other.size(); ++k) {
        nowhere_above = nowhere_above && other[k] <= points[i][k];
        below = below || other[k] < points[i][k];
      }
      dominated = dominated || (nowhere_above && below);
    }
    if (!dominated) front.push_back(i);
  }
  return front;
}

TEST(ParetoFront, IsTheDefinitionsOnRandomPointsWithTies) {
  test::Random random(7);
  for (int round = 0; round < 300; ++round) {
    const auto dimension = static_cast<std::size_t>(1 + random.below(4));
    Points points(static_cast<std::size_t>(1 + random.below(60)));
    for (auto& point : points)
      for (std::size_t k = 0; k < dimension; ++k) point.push_back(random.below(8));
    EXPECT_EQ(pareto_front(points), by_definition(points)) << "round " << round;
  }
}

}  // namespace
}  // namespace jounce::pareto_test
