// SPDX-License-Identifier: Apache-2.0
#include "jounce/validate/witness.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/pvt/sample.hpp"
#include "jounce/validate/integration_watch.hpp"

#include "support/errors.hpp"
#include "validate/references.hpp"

namespace jounce::witness_test {
namespace {

using test::MadeUp;

/// All three quantities within `limit`, independent of the report's own limit.
void expect_agreement(const Witness& w, double limit) {
  EXPECT_TRUE(w.report.ok());
  EXPECT_TRUE(w.integration.ok()) << w.integration.reason;
  EXPECT_LE(w.position.relative, limit);
  EXPECT_LE(w.velocity.relative, limit);
  EXPECT_LE(w.acceleration.relative, limit);
  EXPECT_EQ(w.report.findings.size(), 3u);
}

bool breaks_rule(const Witness& w, const std::string& rule) {
  for (const Finding& f : w.report.findings)
    if (f.rule == rule) return f.broken;
  return false;
}

/// The cam of PMC600 manual Fig. 6.14.
Cam pmc600_cam() {
  CamSpec spec{{0, 0, 0, 0}, {}, true};
  spec.segments = {{Law::quintic, {75, 100, 1, 0}, ""},
                   {Law::quintic, {200, 225, 1, 0}, ""},
                   {Law::quintic, {280, 100, 0.01739120485, 0}, ""},
                   {Law::quintic, {360, 0, 0, 0}, ""}};
  return design(spec).cam;
}

Followed three_periods() {
  return {pmc600_cam(),
          trapezoid({.from = 0, .to = 1080, .velocity = 200, .acceleration = 1000}).curve()};
}

// ---- the truth is believed ----------------------------------------------------------------------

TEST(Witness, AgreesOnEveryLawInEveryForm) {
  constexpr double accuracy = 1e-11;  // accuracy of the integration: 1.5e-12 with three harmonics
  for (const LawInfo& law : all_laws()) {
    if (!has_own_shape(law.law)) continue;
    SCOPED_TRACE(law.name);
    LawForm form;
    if (law.law == Law::scca) form.shares = std::array{0.2, 0.3, 0.5};
    expect_agreement(witness(Cam(normalized(law.law, form))), accuracy);
    if (!law.inflection) continue;
    form.inflection = 0.3;
    expect_agreement(witness(Cam(normalized(law.law, form))), accuracy);
  }
}

TEST(Witness, AgreesOnTrapezoidAndSCurve) {
  expect_agreement(witness(test::trapezoid_move()), 1e-13);
  expect_agreement(witness(test::s_curve_move()), 1e-13);
}

TEST(Witness, AgreesOnThePmc600CamAndOnItsTable) {
  expect_agreement(witness(pmc600_cam()), 1e-12);
  for (const std::size_t knots : {36u, 360u})
    expect_agreement(witness(sample(pmc600_cam(), Interpolation::quintic_hermite, knots).table),
                     1e-12);
}

TEST(Witness, AgreesOnTheCamThatFollowsATrapezoidalMaster) {
  expect_agreement(witness(three_periods()), 2e-11);
}

TEST(Witness, AgreesOnCubicTablesWhoseAccelerationStepsAtEveryKnot) {
  const Table table = sample(test::law_345(50, 2), Interpolation::cubic_hermite, 200).table;
  expect_agreement(witness(table), 1e-12);
}

TEST(Witness, DoesNotFightTheRoundingOfTheAxis) {
  // The places are accurate to 1e-10 of the interval. With the tolerance 1e-15, the solver follows their rounding, in
  // 59 723 steps.
  const Trajectory law = scaled(test::law_345(1, 1), 1, 0.01);
  EXPECT_LT(witness(shifted(law, 1e4)).integration.steps, 200);
}

/// A piece whose jerk is the Chebyshev polynomial T4, which reaches 1 and -1 five times.
Segment chebyshev_jerk(double length) {
  Segment f;
  f.length = length;
  f.degree = 7;
  const std::array<double, 5> jerk{1, -32, 160, -256, 128};
  for (std::size_t k = 0; k < jerk.size(); ++k) {
    const auto n = static_cast<double>(k);
    f.c[k + 3] = jerk[k] * std::pow(length, 3) / ((n + 1) * (n + 2) * (n + 3));
  }
  return f;
}

/// A piece whose jerk is a sine with three periods.
Segment sine_jerk(double length) {
  Segment f;
  f.length = length;
  f.degree = 1;
  f.c[1] = 0.1 * std::pow(length, 3);
  f.sines = 1;
  f.sine[0] = {std::pow(length / 20, 3), 20, 0.3};
  return f;
}

TEST(Witness, AgreesOnShortPiecesFarFromTheStartOfTheAxis) {
  for (const double start : {1.0, 1000.0})
    for (const double length : {1.0, 1e-2, 1e-4, 1e-6})
      for (const Segment& f : {chebyshev_jerk(length), sine_jerk(length)}) {
        SCOPED_TRACE(testing::Message() << length << " at " << start << ", degree " << f.degree);
        const Witness w = witness(Trajectory({f}, start));
        EXPECT_TRUE(w.report.ok())
            << w.position.relative << " " << w.velocity.relative << " " << w.acceleration.relative;
        EXPECT_LT(w.integration.steps, 1000);
        // A few hundred roundings of a place: the tolerance does not grow otherwise.
        const double rounding = 1e-10 + 2e-13 * start / length;
        EXPECT_LT(w.position.limit, rounding);
        EXPECT_LT(w.velocity.limit, rounding);
        EXPECT_LT(w.acceleration.limit, rounding);
      }
}

TEST(Witness, DoesNotMindTheUnit) {
  for (const double factor : {1e-9, 1e9})
    for (const double stretch : {1e-6, 1e6})
      expect_agreement(witness(scaled(test::law_345(1, 1), factor, stretch)), 1e-12);
}

TEST(Witness, ASignalThatStandsStillAgreesExactly) {
  const Witness w = witness(Trajectory({line(1, 0.1, 0.1)}));
  EXPECT_TRUE(w.report.ok());
  EXPECT_EQ(w.position.relative, 0);
}

TEST(Witness, AllowsForTheRoundingOfAPlaceFarFromZero) {
  const Witness w = witness(shifted(test::s_curve_move(), 1e6, 1e9));
  EXPECT_TRUE(w.report.ok());
  EXPECT_GT(w.position.limit, 1e-10);  // the breaks are known to 1e-10 s only
  EXPECT_LT(w.position.limit, 1e-5);
}

TEST(Witness, NamesQuantitiesAfterTheAxis) {
  EXPECT_EQ(witness(test::s_curve_move()).report.findings[0].quantity.find("geo_"),
            std::string::npos);
  const Table table = sample(pmc600_cam(), Interpolation::quintic_hermite, 36).table;
  for (const Report& report : {witness(pmc600_cam()).report, witness(table).report}) {
    std::size_t geo = 0;
    for (const Finding& f : report.findings) geo += f.quantity.starts_with("geo_") ? 1 : 0;
    EXPECT_EQ(geo, 2u);
  }
}

// ---- lies are caught ----------------------------------------------------------------------------

/// The followed cam with one derivative changed.
MadeUp lying(std::size_t order, const std::function<double(double, double)>& change) {
  const auto truth = std::make_shared<Followed>(three_periods());
  const auto breaks = truth->breaks();
  return {[=](double t, Side side) {
            Jet f = truth->jet(t, side);
            f[order] = change(f[order], t);
            return f;
          },
          {breaks.begin(), breaks.end()}};
}

TEST(Witness, TheSignalUnchangedPasses) {
  EXPECT_TRUE(witness(lying(0, [](double f, double) { return f; })).report.ok());
}

TEST(Witness, CatchesAJerkOffByOneInAMillion) {
  const Witness w = witness(lying(3, [](double f, double) { return f * (1 + 1e-6); }));
  EXPECT_TRUE(breaks_rule(w, "witness/position"));
  EXPECT_TRUE(breaks_rule(w, "witness/velocity"));
  EXPECT_TRUE(breaks_rule(w, "witness/acceleration"));
}

TEST(Witness, CatchesAVelocityThatIsNotThePositionsDerivative) {
  const Witness w = witness(lying(1, [](double f, double) { return f * (1 + 1e-9); }));
  EXPECT_TRUE(breaks_rule(w, "witness/velocity"));
  EXPECT_FALSE(breaks_rule(w, "witness/acceleration"));
}

TEST(Witness, CatchesAConstantAddedToTheVelocity) {
  // Velocity, acceleration and jerk agree with each other; only the position betrays them.
  const Witness w = witness(lying(1, [](double f, double) { return f + 1e-4; }));
  EXPECT_TRUE(breaks_rule(w, "witness/position"));
  EXPECT_FALSE(breaks_rule(w, "witness/velocity"));
}

TEST(Witness, CatchesABumpBetweenTwoBreaks) {
  const auto bump = [](double f, double t) {
    return t > 0.5 && t < 1 ? f + 1e-6 * (t - 0.5) * (1 - t) : f;  // nothing at any break
  };
  const Witness w = witness(lying(0, bump));
  EXPECT_TRUE(breaks_rule(w, "witness/position"));
  EXPECT_NEAR(w.position.where, 0.75, 0.15);
}

TEST(Witness, CatchesAJumpOfPosition) {
  const Trajectory jump = concatenated(test::law_345(1, 1), shifted(test::law_345(1, 1), 0, 1.001));
  const Witness w = witness(jump);
  EXPECT_TRUE(breaks_rule(w, "witness/position"));
  EXPECT_NEAR(w.position.relative, 0.001 / 2.001, 1e-9);
}

TEST(Witness, AStepOfVelocityIsBrokenUnlessItIsDeclared) {
  const Table table = sample(test::law_345(1, 1), Interpolation::linear, 50).table;
  EXPECT_TRUE(breaks_rule(witness(table), "witness/velocity"));
  expect_agreement(witness(table, {.velocity_steps = true}), 1e-13);
}

TEST(Witness, SmallErrorsAddUp) {
  // A jerk too large by so little that no interval shows it: a hundredth of the limit in each of
  // 200.
  const auto truth = std::make_shared<Table>(
      sample(test::law_345(1, 1), Interpolation::quintic_hermite, 200u).table);
  const double peak = 10 / std::sqrt(3.0);  // peak of the law's acceleration
  const MadeUp lie{[=](double t, Side side) {
                     Jet f = truth->jet(t, side);
                     f[3] += 2e-10 * peak;
                     return f;
                   },
                   {truth->breaks().begin(), truth->breaks().end()}};
  const Witness w = witness(lie);
  EXPECT_TRUE(breaks_rule(w, "witness/acceleration"));
  EXPECT_NEAR(w.acceleration.relative, 2e-10, 1e-11);
  EXPECT_EQ(w.acceleration.where, 1);
}

TEST(Witness, FindingCarriesValueLimitAndMargin) {
  const Witness w =
      witness(lying(3, [](double f, double) { return f * (1 + 1e-6); }), {.limit = 1e-8});
  const Finding& worst = w.report.findings.front();
  EXPECT_TRUE(worst.broken);
  EXPECT_EQ(worst.limit, 1e-8);
  EXPECT_GT(worst.value, 1e-7);
  EXPECT_NEAR(worst.margin, 1 - worst.value / 1e-8, 1e-9 * std::abs(worst.margin));
  EXPECT_FALSE(worst.advice.empty());
}

// ---- trouble ------------------------------------------------------------------------------------

TEST(Witness, ASignalThatIsNotFiniteIsAnOutcome) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const MadeUp signal{[bad](double t, Side) { return Jet{t, 1, 0, t > 0.6 ? bad : 0}; }};
    const Witness w = witness(signal);
    EXPECT_EQ(w.integration.ended, Ended::not_finite);
    EXPECT_FALSE(w.report.ok());
    EXPECT_TRUE(breaks_rule(w, "witness/integration"));
    EXPECT_LE(w.integration.reached, 0.66);
  }
}

TEST(Witness, APositionThatIsNotFiniteIsBroken) {
  const MadeUp signal{[](double t, Side) {
    return Jet{t > 0.6 ? std::numeric_limits<double>::quiet_NaN() : t, 1, 0, 0};
  }};
  EXPECT_TRUE(breaks_rule(witness(signal), "witness/position"));
}

TEST(Witness, RunningOutOfStepsIsAnOutcome) {
  const Witness w = witness(pmc600_cam(), {.max_steps = 30});
  EXPECT_EQ(w.integration.ended, Ended::too_many_steps);
  EXPECT_EQ(w.integration.steps, 30);
  EXPECT_LT(w.integration.reached, 360);
  EXPECT_THAT(w.integration.reason, testing::HasSubstr("30 steps"));
  EXPECT_TRUE(breaks_rule(w, "witness/integration"));
}

TEST(Witness, AnExceptionOfTheSignalComesThroughTheSolver) {
  int calls = 0;
  const MadeUp signal{[&calls](double t, Side) -> Jet {
    if (++calls > 30) throw std::runtime_error("out of paper");  // within the integration
    return {std::sin(t), std::cos(t), -std::sin(t), -std::cos(t)};
  }};
  EXPECT_THROW(static_cast<void>(witness(signal)), std::runtime_error);
  EXPECT_EQ(calls, 31);
}

TEST(Witness, RejectsBadOptionsAndBreaks) {
  const Trajectory f = test::s_curve_move();
  const auto key = [&](const WitnessOptions& options) {
    return test::key_of([&] { witness(f, options); }, "none");
  };
  EXPECT_EQ(key({.limit = 0}), "limit");
  EXPECT_EQ(key({.tolerance = 1}), "tolerance");
  EXPECT_EQ(key({.max_steps = 0}), "max_steps");
  const auto zero = [](double, Side) { return Jet{}; };
  EXPECT_THROW(static_cast<void>(witness(MadeUp{zero, {0}})), InputError);
  EXPECT_THROW(static_cast<void>(witness(MadeUp{zero, {0, 2, 1, 3}})), InputError);
}

TEST(Witness, EndsWithTheExceptionOfAWatch) {
  const Trajectory move =
      s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve();
  int steps = 0;
  {
    const IntegrationWatch watch([&] {
      if (++steps == 3) throw std::domain_error("enough");
    });
    EXPECT_THROW(static_cast<void>(witness(move)), std::domain_error);
    EXPECT_EQ(steps, 3);
  }
  EXPECT_TRUE(witness(move).report.ok());
  EXPECT_EQ(steps, 3) << "the watch has ended";
}

}  // namespace
}  // namespace jounce::witness_test
