#include "jounce/pvt/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/cam/law.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/extrema.hpp"
#include "jounce/profiles/s_curve.hpp"
#include "jounce/pvt/detail/interval.hpp"
#include "jounce/pvt/detail/longest.hpp"

#include "cam/random_cams.hpp"
#include "support/random.hpp"

namespace jounce {
namespace {

using testing::Random;

constexpr Rule all_rules[] = {Rule::linear, Rule::cubic_hermite, Rule::quintic_hermite};

Cam cycloid() {
  return Cam(normalised(Law::inclined_sine));
}

double stroke_of(const Cam& f) {
  const Range travel = extrema(f, 0);
  return travel.max.value - travel.min.value;
}

/// What the rounding of its numbers is measured against.
double magnitude_of(const Cam& f) {
  double all = 0;
  for (const Segment& segment : f.segments()) all = std::max(all, magnitude(segment));
  return all;
}

/// max |table - curve| over many points: at most the certified one, and not far below it.
template <class Over>
SampleError seen(const Table& table, const Curve<Over>& f, int points = 20000) {
  SampleError worst;
  for (int i = 0; i < points; ++i) {
    const double x = table.start() + (table.end() - table.start()) * (i + 0.5) / points;
    const Jet is = table.jet(x);
    const Jet wanted = f.jet(x);
    worst.position = std::max(worst.position, std::abs(is[0] - wanted[0]));
    worst.velocity = std::max(worst.velocity, std::abs(is[1] - wanted[1]));
  }
  return worst;
}

TEST(Reduced, TakesFewerKnotsThanEqualIntervalsOnTheCycloid) {
  // Equal intervals to 1e-6 of the stroke: 887, 29, 8 (see sample_test.cpp).
  const std::size_t equal[] = {887, 29, 8};
  for (const Rule rule : all_rules) {
    const Reduced made = reduced(cycloid(), {.rule = rule, .tolerance = 1e-6});
    EXPECT_LE(made.error.position, 1e-6);
    EXPECT_LT(made.table.size() - 1, equal[static_cast<int>(rule)]) << name(rule);
    EXPECT_EQ(made.bound, Bound::tolerance);
    std::printf("%s %zu %g\n", name(rule), made.table.size() - 1, made.error.position);
  }
}

TEST(Reduced, KeepsItsToleranceOnRandomCams) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const Cam cam = testing::random_cam(random, random.below(2) == 0);
    const double tolerance = stroke_of(cam) * random.log_uniform(1e-7, 1e-2);
    for (const Rule rule : all_rules) {
      const std::string which = std::string(name(rule)) + " seed " + std::to_string(seed);
      const Reduced made = reduced(cam, {.rule = rule, .tolerance = tolerance});
      EXPECT_LE(made.error.position, tolerance * (1 + 1e-9)) << which;
      const SampleError points = seen(made.table, cam);
      EXPECT_LE(points.position, made.error.position * (1 + 1e-9) + 1e-15 * magnitude_of(cam))
          << which;
      const std::size_t equal = sample_within(cam, rule, tolerance).table.size();
      EXPECT_LE(made.table.size(), equal) << which;
    }
  }
}

}  // namespace
}  // namespace jounce
