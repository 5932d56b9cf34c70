// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "../support/random.hpp"
#include "optimize/src/solvers/certificate.hpp"
#include "optimize/src/solvers/interior_point.hpp"

namespace jounce::optimize_detail {
namespace {

struct Ball {
  ConvexProgram program;
  double least = 0;
};

/// c . x over |x - 0.3| <= 0.7: least 0.3 sum c - 0.7 |c|; with x_0 held at 0.3 without c_0 in |c|.
Ball ball(std::size_t n, bool held, std::uint64_t seed) {
  test::Random random(seed);
  Ball all;
  RoundConstraint round{0.7, {}};
  double squares = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double c = random.uniform(-1, 1);
    all.program.slope.push_back(c);
    round.forms.push_back({-0.3, {{i, 1}}});
    all.least += 0.3 * c;
    if (i > 0 || !held) squares += c * c;
  }
  all.least -= 0.7 * std::sqrt(squares);
  all.program.round.push_back(round);
  if (held) all.program.equalities.push_back({-0.3, {{0, 1}}});
  return all;
}

TEST(RoundConstraint, IsMetToTheClosedForm) {
  for (const std::size_t n : {1U, 5U, 60U})
    for (const bool held : {false, true}) {
      if (held && n == 1) continue;
      const Ball all = ball(n, held, n);
      const ConvexSolution found = solve(all.program, std::vector<double>(n, 0));
      double reached = 0;
      for (std::size_t i = 0; i < n; ++i) reached += all.program.slope[i] * found.x[i];
      EXPECT_NEAR(reached, all.least, 1e-9) << n << " held " << held;
      EXPECT_LE(found.residual, 1e-10) << n << " held " << held;
      const double bound = weak_bound(all.program, found, std::vector<double>(n, 10));
      EXPECT_LE(bound, all.least + 1e-12) << n << " held " << held;
      EXPECT_GE(bound, all.least - 1e-8) << n << " held " << held;
    }
}

TEST(RoundConstraint, BoundHoldsWhateverTheSolutionIsWorth) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Ball all = ball(7, false, seed);
    const ConvexSolution early =
        solve(all.program, std::vector<double>(7, 0), {.thorough = false, .precision = 0.1});
    EXPECT_LE(weak_bound(all.program, early, std::vector<double>(7, 10)), all.least)
        << "seed " << seed;
  }
}

TEST(RoundConstraint, StandsBesideOthers) {
  // x_0 + x_1 least, |x| <= 1, x_0 >= -0.6: at (-0.6, -0.8).
  ConvexProgram program{{1, 1}, {}, {{-0.6, {{0, -1}}}}};
  program.round.push_back({1, {{0, {{0, 1}}}, {0, {{1, 1}}}}});
  const ConvexSolution found = solve(program, {0, 0});
  EXPECT_NEAR(found.x[0], -0.6, 1e-9);
  EXPECT_NEAR(found.x[1], -0.8, 1e-9);
  // Two at once: the lens of |x - (1/2, 0)| <= 1 and |x + (1/2, 0)| <= 1 has its tips at (0, +-sqrt(3)/2).
  ConvexProgram lens{{0, 1}, {}, {}};
  lens.round.push_back({1, {{-0.5, {{0, 1}}}, {0, {{1, 1}}}}});
  lens.round.push_back({1, {{0.5, {{0, 1}}}, {0, {{1, 1}}}}});
  const ConvexSolution tip = solve(lens, {0, 0});
  EXPECT_NEAR(tip.x[0], 0, 1e-8);
  EXPECT_NEAR(tip.x[1], -std::sqrt(3.0) / 2, 1e-8);
}

}  // namespace
}  // namespace jounce::optimize_detail
