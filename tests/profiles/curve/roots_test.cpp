// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/roots.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "jounce/profiles/error.hpp"

#include "support/random.hpp"

namespace jounce::roots_test {
namespace {

using ::testing::ElementsAre;
using ::testing::Pointwise;

std::vector<double> roots_of(const Segment& f) {
  std::vector<double> found;
  roots(f, 1e-16 * magnitude(f), found);
  return found;
}

/// The polynomial with the given roots, in s.
Segment with_roots(const std::vector<double>& wanted) {
  Segment f;
  f.c[0] = 1;
  for (const double r : wanted) {
    ++f.degree;
    for (std::size_t k = static_cast<std::size_t>(f.degree); k > 0; --k)
      f.c[k] = f.c[k - 1] - r * f.c[k];
    f.c[0] *= -r;
  }
  return f;
}

MATCHER_P(NearTo, tolerance, "") {
  return std::abs(std::get<0>(arg) - std::get<1>(arg)) <= tolerance;
}

TEST(Roots, FindsEveryRootOfAPolynomialThatWasMadeFromThem) {
  test::Random random(3);
  for (int n = 1; n <= 6; ++n)
    for (int round = 0; round < 50; ++round) {
      std::vector<double> wanted;
      for (int i = 0; i < n; ++i) wanted.push_back((i + random.uniform(0.2, 0.8)) / n);
      EXPECT_THAT(roots_of(with_roots(wanted)), Pointwise(NearTo(1e-9), wanted));
    }
}

TEST(Roots, LeavesOutWhatLiesOutside) {
  EXPECT_THAT(roots_of(with_roots({-0.5, 0.25, 1.5})), Pointwise(NearTo(1e-14), {0.25}));
}

TEST(Roots, FindsADoubleRoot) {
  const auto found = roots_of(with_roots({0.3, 0.3, 0.8}));
  ASSERT_GE(found.size(), 2U);
  EXPECT_NEAR(found.front(), 0.3, 1e-7);
  EXPECT_NEAR(found.back(), 0.8, 1e-12);
}

TEST(Roots, FindsTwoRootsCloserThanAnySamplingWouldSee) {
  // 1 - cos is 0 at 0.4 only by touching; lowered by 1e-10 it crosses twice, 3.2e-6 apart.
  Segment f;
  f.c[0] = 1 - 1e-10;
  f.sines = 1;
  constexpr double pi = std::numbers::pi;
  f.sine[0] = {-1, 2 * pi, pi / 2 - 0.4 * 2 * pi};
  const auto found = roots_of(f);
  ASSERT_EQ(found.size(), 2U);
  const double apart = std::acos(1 - 1e-10) / (2 * pi);
  EXPECT_NEAR(found[0], 0.4 - apart, 1e-9);
  EXPECT_NEAR(found[1], 0.4 + apart, 1e-9);
}

TEST(Roots, FindsTripleRootsWithoutLosingItselfInThem) {
  // The jerk of Freudenstein's 1-3 law: cos x + cos 3x / 3 - ... vanishes threefold at 1/4 and 3/4.
  constexpr double pi = std::numbers::pi;
  Segment f;
  f.sines = 2;
  f.sine[0] = {27, 2 * pi, pi / 2};
  f.sine[1] = {9, 6 * pi, pi / 2};
  const auto found = roots_of(f);
  ASSERT_FALSE(found.empty());
  for (const double s : found)
    EXPECT_LT(std::min(std::abs(s - 0.25), std::abs(s - 0.75)), 1e-5) << s;
  EXPECT_LT(found.size(), 100U);
  EXPECT_NEAR(found.front(), 0.25, 1e-5);
  EXPECT_NEAR(found.back(), 0.75, 1e-5);
}

TEST(Roots, FindsAllZerosOfASineWithTrend) {
  // sin(40 pi s) + 0.5 s: as many sign changes as a dense scan of the derivative's own bound
  // allows.
  Segment f;
  f.degree = 1;
  f.c[1] = 0.5;
  f.sines = 1;
  f.sine[0] = {1, 40 * std::numbers::pi, 0};
  const auto found = roots_of(f);
  int changes = 0;
  const int n = 100'000;  // far denser than |f'| <= 127 needs for sign changes 1e-3 apart
  for (int i = 1; i < n - 1; ++i)
    if ((value(f, static_cast<double>(i) / n) > 0) !=
        (value(f, static_cast<double>(i + 1) / n) > 0))
      ++changes;
  EXPECT_EQ(found.size(), static_cast<std::size_t>(changes));
  for (const double s : found) EXPECT_NEAR(value(f, s), 0, 1e-13);
}

TEST(Roots, AnswersForAConstantAndForNothing) {
  Segment f;
  f.c[0] = 3;
  EXPECT_THAT(roots_of(f), ElementsAre());
  f.c[0] = 0;
  EXPECT_EQ(roots_of(f).size(), 1U) << "a flat stretch yields its middle";
}

TEST(Roots, AMultipleRootOfSinesIsAFewPoints) {
  // 1 + 27/28 cos t + 1/28 cos 3t, t over a turn: a double root in the middle.
  Segment f;
  f.c[0] = 1;
  f.sines = 2;
  f.sine[0] = {27.0 / 28, 2 * 3.14159265358979324, 3.14159265358979324 / 2};
  f.sine[1] = {1.0 / 28, 6 * 3.14159265358979324, 3.14159265358979324 / 2};
  const auto roots = roots_of(f);
  EXPECT_GE(roots.size(), 1U);
  EXPECT_LE(roots.size(), 50U) << "not every piece of 1e-13 beside it";
  for (const double s : roots) EXPECT_NEAR(s, 0.5, 1e-6);
}

TEST(Crossings, FindsWhereALevelIsPassed) {
  const Trajectory f({quintic(2, 0, 0, 0, 1, 0, 0), line(1, 1, 0)});
  const auto half = crossings(f, 0, 0.5);
  ASSERT_EQ(half.size(), 2U);
  EXPECT_NEAR(half[0], 1, 1e-14);
  EXPECT_NEAR(half[1], 2.5, 1e-14);
  EXPECT_TRUE(crossings(f, 0, 2).empty());
}

TEST(Crossings, RejectsALevelThatIsNoNumber) {
  const Trajectory f({quintic(2, 0, 0, 0, 1, 0, 0)});
  for (const double level : {NAN, INFINITY, -INFINITY})
    for (const int order : {0, 1}) EXPECT_THROW(crossings(f, order, level), InputError) << level;
}

}  // namespace
}  // namespace jounce::roots_test
