// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/sample.hpp"

#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "jounce/cam/laws/law.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/pvt/check.hpp"

#include "support/oracle.hpp"

namespace jounce::sample_test {
namespace {

using test::oracle;

const std::map<std::string, Interpolation> rules{{"linear", Interpolation::linear},
                                                 {"cubic", Interpolation::cubic_hermite},
                                                 {"quintic", Interpolation::quintic_hermite}};

Cam cycloid() {
  return Cam(normalized(Law::inclined_sine));
}

TEST(SampleWithin, KeepsItsToleranceWhereTheAccelerationSteps) {
  for (const Law law :
       {Law::simple_sine, Law::parabola, Law::cubic, Law::sine_straight, Law::double_harmonic})
    for (const Extrapolation outside : {Extrapolation::hold, Extrapolation::advance})
      for (const double tolerance : {1e-3, 1e-5, 1e-8}) {
        std::vector<Segment> segments{line(0.5, 0, 0)};
        for (const Segment& f : normalized(law)) segments.push_back(f);
        segments.push_back(line(0.7, 1, 1));
        for (const Segment& f : normalized(Law::poly345)) segments.push_back(scaled(f, 1, 1));
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

TEST(Sample, FindsTheErrorInTheMiddleOfASymmetricSine) {
  // The greatest error is in the middle, where the sine and its derivatives have closed forms. The derivative of the
  // error vanishes there, which is an end of the pieces of roots.cpp.
  constexpr double half_pi = 1.5707963267948966;
  for (int i = 1; i <= 800; ++i)
    for (const double amplitude : {1.0, 43.172}) {
      const double angle = 0.01 * i;
      Segment f;
      f.length = 2.5;
      f.c[0] = 111.25;
      f.sines = 1;
      f.sine[0] = {amplitude, angle, half_pi - angle / 2};
      const Sampled made = sample(Trajectory({f}), Interpolation::quintic_hermite, std::size_t{1});
      // Even quintic: p + v h 5/16 + a h^2 / 32 in the middle, with those of the start.
      const double c = std::cos(angle / 2);
      const double s = angle * std::sin(angle / 2);
      const double middle = c + s * 5 / 16 - c * angle * angle / 32;
      const double error = amplitude * std::abs(middle - 1);
      EXPECT_GE(made.error.position, error * (1 - 1e-9) - 1e-13) << angle << " " << amplitude;
    }
}

/// Limits at the curve's own greatest rates, times `factor`.
Limits limits_of(const Cam& cam, double factor) {
  const Ranges peaks = extrema(cam);
  const auto limit = [&](std::size_t k) { return factor * std::abs(peaks[k].peak().value); };
  return {.velocity = limit(1), .acceleration = limit(2), .jerk = limit(3)};
}

TEST(SampleWithin, KeepsTheLimitsThatTheCurveKeeps) {
  for (const Law law : {Law::inclined_sine, Law::poly345, Law::poly4567})
    for (const Interpolation rule : {Interpolation::cubic_hermite, Interpolation::quintic_hermite})
      for (const double margin : {1e-3, 1e-6}) {
        const Cam cam(normalized(law));
        const Limits limits = limits_of(cam, 1 + margin);
        const Sampled kept = sample_within(cam, rule, 1e-3, limits);
        EXPECT_TRUE(check(kept.table, limits).ok()) << name(law) << " " << name(rule) << margin;
        EXPECT_LE(kept.error.position, 1e-3);
      }
  const Limits limits = limits_of(cycloid(), 1 + 1e-6);
  const Table coarse = sample_within(cycloid(), Interpolation::cubic_hermite, 1e-3).table;
  EXPECT_FALSE(check(coarse, limits).ok()) << "without limits, the acceleration is too great";
  const Table kept = sample_within(cycloid(), Interpolation::cubic_hermite, 1e-3, limits).table;
  EXPECT_LT(kept.size(), coarse.size() + 80) << "only the intervals beside a peak are halved";
}

TEST(SampleWithin, ExceedsALimitNoMoreThanTheCurve) {
  const Limits own = limits_of(cycloid(), 1);
  Limits low = own;
  low.acceleration = 0.9 * *own.acceleration;
  const Table made = sample_within(cycloid(), Interpolation::cubic_hermite, 1e-3, low).table;
  EXPECT_TRUE(check(made, own).ok());
}

TEST(SampleWithin, AddsNoKnotsWhereHalvesDoNotHelp) {
  // The acceleration of the parabola steps. A quintic cannot step: the shorter, the greater its third derivative.
  const Cam cam(normalized(Law::parabola));
  const auto size = [&](const Limits& limits) {
    return sample_within(cam, Interpolation::quintic_hermite, 1e-3, limits).table.size();
  };
  EXPECT_EQ(size({.jerk = 1e-3}), size({}));
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

TEST(Sample, RejectsKnotsThatDoNotSpanTheCurve) {
  EXPECT_THROW(sample(cycloid(), Interpolation::linear, std::vector<double>{0, 0.5}), InputError);
  EXPECT_THROW(sample(cycloid(), Interpolation::linear, std::size_t{0}), InputError);
  EXPECT_THROW(sample_within(cycloid(), Interpolation::linear, 0), InputError);
  EXPECT_THROW(sample_within(cycloid(), Interpolation::linear, 1e-12, {}, 1000), InputError)
      << "too many knots";
}

}  // namespace
}  // namespace jounce::sample_test
