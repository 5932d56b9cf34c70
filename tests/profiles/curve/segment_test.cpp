// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/segment.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace jounce::segment_test {
namespace {

using test::Random;

/// A segment with everything in it: degree 11 and three sines.
Segment rich(std::uint64_t seed) {
  Random random(seed);
  Segment f;
  f.length = random.log_uniform(0.01, 100);
  f.degree = Segment::max_degree;
  f.sines = Segment::max_sines;
  for (double& c : f.c) c = random.uniform(-1, 1);
  for (auto& t : f.sine)
    t = {random.uniform(-1, 1), random.uniform(-20, 20), random.uniform(-3, 3)};
  return f;
}

TEST(Segment, EvaluatesValueAndDerivativesOfAKnownFormula) {
  // f(u) = u^3 over length 2, by hand: f = 1, f' = 3, f'' = 6, f''' = 6 at u = 1.
  Segment f;
  f.length = 2;
  f.degree = 3;
  f.c[3] = 8;
  const Jet jet = evaluate(f, 0.5);
  EXPECT_DOUBLE_EQ(jet[0], 1);
  EXPECT_DOUBLE_EQ(jet[1], 3);
  EXPECT_DOUBLE_EQ(jet[2], 6);
  EXPECT_DOUBLE_EQ(jet[3], 6);
}

TEST(Segment, DerivativeAgreesWithTheJet) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Segment f = rich(seed);
    Segment g = f;
    for (std::size_t k = 1; k <= 3; ++k) {
      g = derivative(g);
      for (const double s : {0.0, 0.1, 0.5, 0.77, 1.0})
        EXPECT_NEAR(value(g, s), evaluate(f, s)[k], 1e-13 * magnitude(g)) << "seed " << seed;
    }
  }
}

TEST(Segment, IntegralBeginsWhereAskedAndDerivesBack) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Segment f = rich(seed);
    f.degree = 10;
    f.c[11] = 0;
    const auto g = integral(f, 5);
    ASSERT_TRUE(g);
    EXPECT_NEAR(value(*g, 0), 5, 1e-13 * magnitude(*g));
    for (const double s : {0.0, 0.3, 1.0})
      EXPECT_NEAR(value(derivative(*g), s), value(f, s), 1e-12 * magnitude(f)) << "seed " << seed;
  }
  EXPECT_FALSE(integral(rich(1), 0)) << "degree 12 does not fit";
}

TEST(Segment, ReversedRunsBackwards) {
  const Segment f = rich(7);
  const Segment g = reversed(f);
  for (const double s : {0.0, 0.25, 0.6, 1.0}) EXPECT_NEAR(value(g, s), value(f, 1 - s), 1e-11);
}

TEST(Segment, PartIsTheSameFunctionOverLess) {
  const Segment f = rich(11);
  const Segment g = part(f, 0.2, 0.7);
  EXPECT_DOUBLE_EQ(g.length, 0.5 * f.length);
  for (const double s : {0.0, 0.25, 0.6, 1.0}) {
    const Jet whole = evaluate(f, 0.2 + 0.5 * s);
    const Jet cut = evaluate(g, s);
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(cut[k], whole[k], 1e-11 * std::max(1.0, std::abs(whole[k])));
  }
}

TEST(Segment, SumMergesSinesOfOneFrequency) {
  Segment f = line(1, 0, 1);
  f.sines = 3;
  f.sine = {{{1, 2, 0.3}, {1, 3, 0}, {1, 4, 0}}};
  Segment g = line(1, 2, 1);
  g.sines = 1;
  g.sine[0] = {0.5, 2, -1.1};
  const auto h = sum(f, g);
  ASSERT_TRUE(h);
  EXPECT_EQ(h->sines, 3);
  EXPECT_EQ(h->degree, 0) << "2 - s + s";
  for (const double s : {0.0, 0.4, 1.0})
    EXPECT_NEAR(value(*h, s), value(f, s) + value(g, s), 1e-14);
  g.sine[0].angle = 5;
  EXPECT_FALSE(sum(f, g)) << "a fourth frequency does not fit";
}

TEST(Segment, HermitePiecesMeetTheirEnds) {
  const Segment c = cubic(2, 1, -3, 4, 5);
  EXPECT_NEAR(evaluate(c, 0)[0], 1, 1e-15);
  EXPECT_NEAR(evaluate(c, 0)[1], -3, 1e-15);
  EXPECT_NEAR(evaluate(c, 1)[0], 4, 1e-14);
  EXPECT_NEAR(evaluate(c, 1)[1], 5, 1e-14);
  const Segment q = quintic(2, 1, -3, 0.5, 4, 5, -2);
  const std::array<double, 3> start{1, -3, 0.5};
  const std::array<double, 3> end{4, 5, -2};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(evaluate(q, 0)[k], start[k], 1e-14);
    EXPECT_NEAR(evaluate(q, 1)[k], end[k], 1e-13);
  }
}

}  // namespace
}  // namespace jounce::segment_test
