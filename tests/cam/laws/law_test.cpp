// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/laws/law.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"
#include "support/invariants.hpp"
#include "support/oracle.hpp"

namespace jounce::law_test {
namespace {

using test::oracle;

struct Case {
  Law law;
  const char* oracle;
  int order;  // continuous up to this derivative
  LawForm form = {};
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.oracle;
}

class Laws : public ::testing::TestWithParam<Case> {};

TEST_P(Laws, MeetTheOracleInCoefficientsAndPoints) {
  const auto& expected = oracle("laws")["laws"][GetParam().oracle];
  const Cam f(normalized(GetParam().law, GetParam().form));
  const Ranges r = extrema(f);
  EXPECT_NEAR(r[1].max.value, expected["cv"].get<double>(), 1e-12);
  EXPECT_NEAR(r[2].max.value, expected["ca_inside"].get<double>(), 1e-12);
  EXPECT_NEAR(-r[2].min.value, expected["ca_inside"].get<double>(), 1e-12) << "point symmetry";
  EXPECT_NEAR(std::abs(r[3].peak().value), expected["cj_inside"].get<double>(), 1e-10);

  const auto& z = oracle("laws")["z"];
  const std::array names{"f", "f1", "f2", "f3"};
  // A sum of powers has the rounding of its largest terms, which grow with the degree.
  std::array tolerance{1e-15, 1e-14, 1e-13, 1e-11};
  Segment g = f.segments().front();
  for (double& t : tolerance) {
    t = std::max(t, 2e-16 * magnitude(g));
    g = derivative(g);
  }
  for (std::size_t i = 0; i < z.size(); ++i) {
    const double at = z[i];
    const Jet jet = f.jet(at, at == 1 ? Side::left : Side::right);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& column = expected[names[k]];
      EXPECT_NEAR(jet[k], column[i].get<double>(), tolerance[k])
          << "derivative " << k << " at " << at;
    }
  }
}

TEST_P(Laws, KeepTheInvariants) {
  test::expect_invariants(Cam(normalized(GetParam().law, GetParam().form)), GetParam().order);
}

TEST_P(Laws, ReachTheBoundOfSevenSegmentsAndNoMore) {
  // 1/Cv + Cv/Ca + Ca/Cj <= 1 for every rest-to-rest law; Cj is infinite where Ca jumps.
  const Ranges r = extrema(Cam(normalized(GetParam().law, GetParam().form)));
  const double cv = r[1].max.value;
  const double ca = r[2].max.value;
  const double jerk_term = GetParam().order < 2 ? 0 : ca / std::abs(r[3].peak().value);
  const double sum = 1 / cv + cv / ca + jerk_term;
  EXPECT_LE(sum, 1 + 1e-15);
  const auto& sums = oracle("laws")["sum_seven_segment"];
  if (sums.contains(GetParam().oracle)) {
    EXPECT_NEAR(sum, sums[GetParam().oracle].get<double>(), 1e-12);
  }
}

const LawForm cycloid_shares{.shares = std::array{0.5, 0.0, 0.5}};

INSTANTIATE_TEST_SUITE_P(
    RestToRest, Laws,
    ::testing::Values(
        Case{Law::cubic, "cubic_23", 1}, Case{Law::poly345, "poly_345", 2},
        Case{Law::poly4567, "poly_4567", 3}, Case{Law::poly56789, "poly_56789", 3},
        Case{Law::quintic, "poly_345", 2}, Case{Law::septic, "poly_4567", 3},
        Case{Law::nonic, "poly_56789", 3}, Case{Law::parabola, "quadratic_parabola", 1},
        Case{Law::simple_sine, "simple_sine", 1}, Case{Law::inclined_sine, "inclined_sine", 2},
        Case{Law::modified_sine, "modified_sine", 2},
        Case{Law::modified_trapezoid, "modified_trapezoid", 2},
        Case{Law::modified_constant_velocity, "modified_constant_velocity_50", 2},
        Case{Law::scca, "inclined_sine", 2, cycloid_shares}, Case{Law::gutman13, "gutman_13", 2},
        Case{Law::freudenstein13, "freudenstein_13", 2},
        Case{Law::freudenstein135, "freudenstein_135", 2},
        Case{Law::minimum_peak_jerk, "minimum_peak_jerk", 2}),
    [](const auto& test) {
      return std::string(name(test.param.law)) + "_as_" + test.param.oracle;
    });

/// Cv, peak acceleration, peak deceleration (Ca*).
void expect_peaks(const Cam& f, double cv, double ca, double deceleration, double tolerance) {
  const Ranges r = extrema(f);
  EXPECT_NEAR(r[0].max.value, 1, 1e-14);
  EXPECT_NEAR(r[1].max.value, cv, tolerance);
  EXPECT_NEAR(r[2].max.value, ca, tolerance);
  EXPECT_NEAR(-r[2].min.value, deceleration, tolerance);
}

constexpr double pi = std::numbers::pi;

TEST(RestToReversal, HarmonicCombinationHasItsClosedFormForEveryInflection) {
  for (const double lambda : {0.1, 0.3, 0.5, 0.8}) {
    SCOPED_TRACE(lambda);
    const Cam f(normalized(Law::harmonic_combination, {.inflection = lambda}));
    const double cv = 1 / (lambda * (4 + pi) / (4 * pi) + 2 * (1 - lambda) / pi);
    expect_peaks(f, cv, pi * cv / (2 * lambda), pi * cv / (2 * (1 - lambda)), 2e-13);
    EXPECT_NEAR(extrema(f, 1).max.where, lambda, 1e-7);
    test::expect_invariants(f, 2);
  }
  expect_peaks(Cam(normalized(Law::harmonic_combination)), 1.659848, 5.214566, 5.214566, 6e-7);
}

TEST(RestToReversal, OtherLawsHaveTheirPrintedPeaks) {
  expect_peaks(Cam(normalized(Law::modified_trapezoid_ru)), 1.916718, 4.684578, 4.216484, 7e-7);
  const Cam harmonic(normalized(Law::double_harmonic));
  expect_peaks(harmonic, 3 * std::sqrt(3) * pi / 8, 9 * pi * pi / 16, pi * pi, 1e-13);
  EXPECT_NEAR(extrema(harmonic, 1).max.where, 2. / 3, 1e-8);
  EXPECT_NEAR(std::abs(extrema(harmonic, 3).peak().value), 42.4137, 5e-5);
  const Cam eighth(normalized(Law::eighth_degree));
  expect_peaks(eighth, 1.776661, 5.26830, 5.26830, 3e-6);
  EXPECT_NEAR(eighth.at(0).geo_jerk, 36.5853, 1e-12);
  EXPECT_NEAR(eighth.at(1).geo_jerk, 0, 1e-3) << "of the five published decimals";
}

TEST(RestToReversal, TheInflectionFollowsFromTheDeceleration) {
  for (const Law law : {Law::harmonic_combination, Law::modified_trapezoid_ru})
    for (const double lambda : {0.01, 0.2, 0.5, 0.77, 0.99}) {
      const Cam f(normalized(law, {.inflection = lambda}));
      const double end = f.jet(f.end(), Side::left)[2];
      EXPECT_NEAR(inflection_for(law, -end), lambda, 1e-13) << name(law);
      EXPECT_LT(least_deceleration(law), -end);
    }
}

TEST(SineStraight, HasTheClosedFormOfEveryShare) {
  for (const double straight : {0.0, 0.2, 0.5, 0.9}) {
    const double c = 1 - straight;
    const double cv = 1 / (1 - c + 2 * c / pi);
    expect_peaks(Cam(normalized(Law::sine_straight, {.straight = straight})), cv, pi * cv / c,
                 pi * cv / c, 1e-12);
  }
  expect_peaks(Cam(normalized(Law::sine_straight)), 1.222031, 7.678247, 7.678247, 6e-7);
}

TEST(Inflection, KeepsTheVelocityAndScalesTheRest) {
  for (const LawInfo& law : all_laws()) {
    if (!law.inflection || reverses(law.ends)) continue;
    SCOPED_TRACE(law.name);
    LawForm form;
    if (law.law == Law::scca) form.shares = std::array{0.2, 0.3, 0.5};
    const Ranges own = extrema(Cam(normalized(law.law, form)));
    for (const double lambda : {0.2, 0.35, 0.9}) {
      form.inflection = lambda;
      const Cam f(normalized(law.law, form));
      const double after = 1 - lambda;
      expect_peaks(f, own[1].max.value, own[2].max.value / (2 * lambda),
                   own[2].max.value / (2 * after), 1e-11);
      EXPECT_NEAR(f.at(lambda).position, lambda, 1e-14) << "the inflection lies on the chord";
    }
  }
}

TEST(EndVelocities, JoinAnyTwoWithoutAcceleration) {
  for (const LawInfo& law : all_laws()) {
    if (law.ends != Ends::moving) continue;
    for (const std::optional<double> lambda : {std::optional<double>{}, {0.3}}) {
      SCOPED_TRACE(std::string(law.name) + (lambda ? " shifted" : ""));
      std::vector<Segment> segments;
      for (const LawPiece& f : pieces(law.law, {.inflection = lambda}))
        segments.push_back(*sum(f.rise, *sum(scaled(f.enter, 0.4), scaled(f.leave, -1.5))));
      const Cam f(segments);
      const Jet from = f.jet(0);
      const Jet to = f.jet(f.end(), Side::left);
      const std::array<double, 3> start{0, 0.4, 0}, end{1, -1.5, 0};
      double rounding = 0;  // in the values, and in the arguments of the sines
      for (const Segment& segment : segments) {
        const Segment acceleration = derivative(derivative(segment));
        rounding = std::max({rounding, 4e-16 * magnitude(acceleration),
                             1.2e-16 * magnitude(derivative(acceleration))});
      }
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(from[k], start[k], rounding);
        EXPECT_NEAR(to[k], end[k], rounding);
      }
      test::expect_invariants(f, 2);
    }
  }
}

TEST(EndVelocities, EqualOnesArePutUnderTheLaw) {
  // The recovery of a rotary knife: rho z + (1 - rho) f(z).
  constexpr double rho = 0.485454;
  for (const Law law : {Law::modified_sine, Law::gutman13, Law::modified_trapezoid}) {
    const Cam f(normalized(law));
    double z0 = 0;
    for (const LawPiece& piece : pieces(law)) {
      const Segment g = *sum(piece.rise, *sum(scaled(piece.enter, rho), scaled(piece.leave, rho)));
      for (const double s : {0.1, 0.5, 0.8}) {
        const double z = z0 + s * piece.rise.length;
        EXPECT_NEAR(value(g, s), rho * z + (1 - rho) * f.at(z).position, 1e-15) << name(law);
      }
      z0 += piece.rise.length;
    }
  }
}

TEST(LawForms, NameWhatALawDoesNotTake) {
  const auto complaint = [](Law law, const LawForm& form) {
    return test::error_of([&] { (void)normalized(law, form); }, "no error");
  };
  EXPECT_EQ(complaint(Law::double_harmonic, {.inflection = 0.4}),
            "inflection = 0.4: does not apply to the law `double_harmonic`: leave it out");
  EXPECT_EQ(complaint(Law::modified_sine, {.inflection = 1}),
            "inflection = 1: must lie inside the segment: above 0 and below 1");
  EXPECT_EQ(complaint(Law::modified_sine, {.straight = 0.1}),
            "straight = 0.1: does not apply to the law `modified_sine`: leave it out");
  EXPECT_EQ(complaint(Law::sine_straight, {.straight = 1}),
            "straight = 1: must be a share of the segment: at least 0 and below 1");
  EXPECT_EQ(complaint(Law::scca, {}),
            "shares: is missing: the law `scca` needs shares = [sine, constant, cosine]");
  EXPECT_EQ(complaint(Law::scca, {.shares = std::array{0.5, 0.5, 0.5}}),
            "shares = 0.5 + 0.5 + 0.5: must add up to 1, not 1.5");
}

TEST(Scca, RejectsAStraightShareThatLeavesNoRamp) {
  EXPECT_EQ(test::error_of([] { (void)scca(0.25, 0.5, 0.25, 1); }),
            "straight = 1: must be less than 1: no share is left for the ramps");
  EXPECT_NO_THROW((void)scca(0.25, 0.5, 0.25, 0.99));
}

TEST(Scca, OneCodePathYieldsTheWholeFamily) {
  const auto peak = [](double b, double c, double d, int order) {
    return extrema(Cam(scca(b, c, d)), order).max.value;
  };
  EXPECT_NEAR(peak(0, 1, 0, 2), 4, 1e-14) << "parabola";
  EXPECT_NEAR(peak(0, 0, 1, 2), pi * pi / 2, 1e-14) << "simple sine";
  EXPECT_NEAR(peak(0.5, 0, 0.5, 2), 2 * pi, 1e-14) << "cycloid";
  EXPECT_NEAR(peak(0.25, 0, 0.75, 2), 4 * pi * pi / (4 + pi), 1e-13) << "modified sine";
  EXPECT_NEAR(peak(0.25, 0.5, 0.25, 2), 8 * pi / (2 + pi), 1e-13) << "modified trapezoid";
  for (const double b : {0.0, 0.1, 0.3, 0.5})
    for (const double c : {0.0, 0.2, 0.5}) {
      const double d = 1 - b - c;
      const double ca =
          4 * pi * pi / ((pi * pi - 8) * (b * b - d * d) - 2 * pi * (pi - 2) * b + pi * pi);
      EXPECT_NEAR(peak(b, c, d, 2), ca, 1e-12 * ca) << b << " " << c;
    }
}

TEST(Scca, RejectsSharesThatDoNotAddUp) {
  EXPECT_THROW(scca(0.5, 0.5, 0.5), InputError);
  EXPECT_THROW(scca(-0.5, 1, 0.5), InputError);
}

TEST(LawNames, ReadBack) {
  for (const LawInfo& law : all_laws()) EXPECT_EQ(law_named(law.name), law.law);
  EXPECT_FALSE(law_named("sinus"));
}

}  // namespace
}  // namespace jounce::law_test
