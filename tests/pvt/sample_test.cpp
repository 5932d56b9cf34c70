// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/sample.hpp"

#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "jounce/cam/laws/law.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/oracle.hpp"

namespace jounce::sample_test {
namespace {

using test::oracle;

const std::map<std::string, Interpolation> rules{{"linear", Interpolation::linear},
                                                 {"cubic", Interpolation::cubic_hermite},
                                                 {"quintic", Interpolation::quintic_hermite}};

Cam cycloid() {
  return Cam(normalised(Law::inclined_sine));
}

TEST(SampleWithin, KeepsItsToleranceWhereTheAccelerationSteps) {
  for (const Law law :
       {Law::simple_sine, Law::parabola, Law::cubic, Law::sine_straight, Law::double_harmonic})
    for (const Extrapolation outside : {Extrapolation::hold, Extrapolation::advance})
      for (const double tolerance : {1e-3, 1e-5, 1e-8}) {
        std::vector<Segment> segments{line(0.5, 0, 0)};
        for (const Segment& f : normalised(law)) segments.push_back(f);
        segments.push_back(line(0.7, 1, 1));
        for (const Segment& f : normalised(Law::poly345)) segments.push_back(scaled(f, 1, 1));
        const Sampled made =
            sample_within(Cam(segments, 0, outside), Interpolation::quintic_hermite, tolerance);
        EXPECT_LE(made.error.position, tolerance) << name(law);
      }
}

TEST(Sample, ErrorIsTheTrueMaximumOfTheCycloid) {
  for (const auto& [key, rule] : rules) {
    const auto& expected = oracle("hermite_error")["rules"][key];
    for (std::size_t i = 0; i < expected["n"].size(); ++i) {
      const std::size_t n = expected["n"][i];
      const double error = expected["max_error"][i];
      EXPECT_NEAR(sample(cycloid(), rule, n).error.position, error, 1e-9 * error + 4e-16)
          << key << " " << n;
    }
  }
}

TEST(Sample, FortyCubicIntervalsAsMeasured) {
  EXPECT_NEAR(sample(cycloid(), Interpolation::cubic_hermite, 40).error.position, 2.514e-7,
              0.5e-10);
}

TEST(SampleWithin, NeedsAsFewIntervalsAsKnown) {
  // To 1e-6 of the stroke: 887 linear, 29 cubic, 8 quintic.
  for (const auto& [key, rule] : rules) {
    const std::size_t expected = oracle("hermite_error")["rules"][key]["smallest_n_by_error"];
    EXPECT_EQ(sample_within(cycloid(), rule, 1e-6).table.size() - 1, expected) << key;
  }
}

TEST(SampleWithin, HoldsWhatTheRuleHoldsExactlyInItsKnots) {
  const Trajectory move =
      s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve();
  const Sampled sampled = sample_within(move, Interpolation::cubic_hermite, 1e-12);
  EXPECT_EQ(sampled.table.size(), move.breaks().size()) << "cubics are cubics";
  EXPECT_LT(sampled.error.position, 1e-13);
}

TEST(Sample, FindsTheErrorBetweenKnotsThatMissABreak) {
  // A triangle with its tip between two knots: the table cuts it off.
  const Trajectory triangle({line(1, 0, 1), line(1, 1, 0)});
  const Sampled sampled = sample(triangle, Interpolation::linear, 3);
  EXPECT_NEAR(sampled.error.position, 1.0 / 3, 1e-15);
  EXPECT_NEAR(sampled.error.where, 1, 1e-15);
}

TEST(Sample, APeriodicTableEndsOnTheNumbersItBeginsWith) {
  const Cam cam({quintic(0.3, 0.1, 0.2, 0, 7, -1, 0.4), quintic(0.7, 7, -1, 0.4, 0.1, 0.2, 0)}, 0,
                Extrapolation::wrap);
  for (const std::size_t intervals : {std::size_t{7}, std::size_t{100}}) {
    const Sampled sampled = sample(cam, Interpolation::quintic_hermite, intervals);
    const Columns& c = sampled.table.columns();
    EXPECT_EQ(c.p.front(), c.p.back());
    EXPECT_EQ(c.v.front(), c.v.back());
    EXPECT_EQ(c.a.front(), c.a.back());
  }
  const Cam jump({line(1, 0, 1)}, 0, Extrapolation::wrap);
  const Sampled sawtooth = sample(jump, Interpolation::linear, std::size_t{4});
  EXPECT_EQ(sawtooth.table.columns().p.back(), 1) << "a real step is kept";
}

TEST(Sample, RefusesKnotsThatDoNotSpanTheCurve) {
  EXPECT_THROW(sample(cycloid(), Interpolation::linear, std::vector<double>{0, 0.5}), InputError);
  EXPECT_THROW(sample(cycloid(), Interpolation::linear, std::size_t{0}), InputError);
  EXPECT_THROW(sample_within(cycloid(), Interpolation::linear, 0), InputError);
  EXPECT_THROW(sample_within(cycloid(), Interpolation::linear, 1e-12, 1000), InputError)
      << "too many knots";
}

}  // namespace
}  // namespace jounce::sample_test
