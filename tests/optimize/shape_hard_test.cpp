// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "jounce/optimize/shape.hpp"
#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/error.hpp"

#include "optimize/shape_problems.hpp"
#include "support/random.hpp"

// Requests of a hostile user: no failure here may be reported as a success.

namespace jounce::shape_hard_test {
namespace {

using test_optimize::rest_to_rest_shape;
using Status = OptimizeStatus;

const LinearQuantity position = derivative_of_shape(0);
const LinearQuantity acceleration = derivative_of_shape(2);

ShapeProblem least_acceleration(std::size_t pieces = 20, int degree = 5) {
  ShapeProblem p = rest_to_rest_shape(3);
  p.pieces = pieces;
  p.degree = degree;
  p.minimize = {{PeakOf{acceleration}}};
  return p;
}

LoadTorque inertia() {
  LoadTorque load;
  load.linear.by[2] = 1;
  return load;
}

void refused(const ShapeProblem& p, const std::string& key) {
  try {
    (void)optimize_shape(p);
    ADD_FAILURE() << "accepted, though " << key << " is wrong";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind(key, 0), 0U) << error.what();
  }
}

void refused_response(const std::function<std::vector<double>(const Trajectory&)>& of) {
  ShapeProblem p = least_acceleration();
  p.minimize = {{ResponseOf{"r", of}}};
  refused(p, "minimize[1].figure.of");
  p.minimize = {{TorqueOf{inertia()}}, {ResponseOf{"r", of}}};
  refused(p, "minimize[2].figure.of");
}

TEST(HardShape, AResponseThatIsNoneIsRejected) {
  refused_response([](const Trajectory&) { return std::vector<double>{NAN, 1.0}; });
  refused_response([](const Trajectory&) { return std::vector<double>{}; });
  refused_response([n = 0](const Trajectory&) mutable {
    return std::vector<double>(static_cast<std::size_t>(3 + n++ % 3), 1.0);
  });
  refused_response([](const Trajectory& shape) {  // not affine
    return std::vector<double>{std::pow(shape.jet(0.3)[0], 2)};
  });
}

TEST(HardShape, ACorridorTooNarrowForAKnotIsRejectedNotForgotten) {
  ShapeProblem p = least_acceleration();
  p.corridors = {{position, 0.5, 0.5 + 1e-9, Edge{2, 2}, {}}};
  refused(p, "corridors[1].to");
  p.corridors[0].to = 0.5 + 1e-6;
  const ShapeOutcome narrow = optimize_shape(p);
  ASSERT_TRUE(narrow.usable()) << narrow.reason;
  EXPECT_GE(Trajectory(narrow.best).jet(0.5)[0], 2 - 1e-8);
}

TEST(HardShape, NumbersBeyondWhatADoubleCarriesAreRejected) {
  ShapeProblem p = least_acceleration();
  for (const double u : {1e-300, 1e-150, 1e150, 1e300}) {
    p.to.value = u;
    refused(p, "to.value");
  }
  for (const double u : {1e-50, 1e50}) {
    p.to.value = u;
    const ShapeOutcome best = optimize_shape(p);
    EXPECT_EQ(best.status, Status::optimal) << best.reason;
    EXPECT_NEAR(best.figures[0].reached / u, 4.222933, 1e-5);
  }
  p = least_acceleration();
  p.end = 1e80;
  refused(p, "end");
  p.begin = 1e16;
  p.end = 1e16 + 4;
  refused(p, "pieces");
}

TEST(HardShape, APeriodicShapeHasOneDerivativeAtBothEnds) {
  ShapeProblem p = least_acceleration();
  p.periodic = true;
  p.to.velocity = 2;
  refused(p, "to.geo_velocity");
}

/// `given` need not begin where the shape must: it once was taken for what is fixed.
TEST(HardShape, WhatIsFixedIsNotWhatIsGiven) {
  ShapeProblem p = least_acceleration();
  p.given = {quintic(1, 5, 0, 0, 6, 0, 0)};
  p.corridors = {{position, 0, 0.2, Edge{-1, -1}, Edge{1, 1}}};
  const ShapeOutcome best = optimize_shape(p);
  EXPECT_EQ(best.status, Status::optimal) << best.reason;
  EXPECT_TRUE(best.usable());
}

TEST(HardShape, WhatCannotBeIsProvenSo) {
  ShapeProblem p = least_acceleration();
  p.corridors = {{position, 0.3, 0.7, Edge{0.6, 0.6}, {}},
                 {position, 0.3, 0.7, {}, Edge{0.5, 0.5}}};
  const ShapeOutcome apart = optimize_shape(p);
  EXPECT_EQ(apart.status, Status::infeasible) << apart.reason;
  EXPECT_NE(apart.reason.find("limit/value"), std::string::npos) << apart.reason;
  p.corridors.clear();
  p.ceilings = {{RmsOf{acceleration}, 0}};
  const ShapeOutcome still = optimize_shape(p);
  EXPECT_EQ(still.status, Status::infeasible) << still.reason;
  EXPECT_NE(still.reason.find("3.51"), std::string::npos) << "the least there is: " << still.reason;
}

/// A shape that misses its ends is not usable either: the limits show this.
TEST(HardShape, AnInfeasibleShapeThatMissesItsEndsIsNotUsable) {
  for (const int degree : {3, 4}) {
    const ShapeOutcome one = optimize_shape(least_acceleration(1, degree));
    EXPECT_EQ(one.status, Status::infeasible) << one.reason;
    EXPECT_FALSE(one.usable()) << degree;
  }
  ShapeProblem p = least_acceleration();
  p.corridors = {{position, 0, 1, Edge{0, 1}, Edge{0, 1}}};  // leaves with a velocity
  const ShapeOutcome line = optimize_shape(p);
  EXPECT_EQ(line.status, Status::infeasible) << line.reason;
  EXPECT_FALSE(line.usable());
}

TEST(HardShape, ExactStretchesMayTouchTheEndsAndOverlap) {
  ShapeProblem p = least_acceleration();
  for (const auto& [from, level] : {std::pair{0.0, 0.0}, {0.8, 1.0}}) {
    p.corridors = {{position, from, from + 0.2, Edge{level, level}, Edge{level, level}}};
    const ShapeOutcome best = optimize_shape(p);
    EXPECT_EQ(best.status, Status::optimal) << best.reason;
    EXPECT_EQ(Trajectory(best.best).jet(from + 0.1)[0], level);
  }
  p.corridors = {{position, 0.4, 0.6, Edge{0.4, 0.6}, Edge{0.4, 0.6}},
                 {position, 0.5, 0.7, Edge{0.6, 0.7}, Edge{0.6, 0.7}}};
  EXPECT_EQ(optimize_shape(p).status, Status::infeasible);
  p.corridors[1].lower = p.corridors[1].upper = Edge{0.5, 0.7};
  const ShapeOutcome agree = optimize_shape(p);  // the same problem twice: rounding may stop it
  EXPECT_NE(agree.status, Status::infeasible) << agree.reason;
  EXPECT_TRUE(agree.usable()) << agree.reason;
}

TEST(HardShape, NothingIsTheLeastThereIs) {
  ShapeProblem p = least_acceleration();
  p.from.value = p.to.value = 1e9;
  for (const ShapeFigure& figure : {ShapeFigure{PeakOf{acceleration}}, {RmsOf{acceleration}}}) {
    p.minimize = {{figure}};
    const ShapeOutcome best = optimize_shape(p);
    EXPECT_EQ(best.status, Status::optimal) << best.reason;
    EXPECT_EQ(best.value, 0);
    EXPECT_LE(best.bound.value_or(0), best.value);
  }
  p.from = p.to = {};
  p.periodic = true;
  p.minimize = {{PeakOf{acceleration}}};
  p.corridors = {{position, 0.2, 0.3, Edge{1, 1}, {}}};
  const ShapeOutcome flat = optimize_shape(p);
  EXPECT_EQ(flat.status, Status::optimal) << flat.reason;
}

TEST(HardShape, EveryDegreeAndFewPieces) {
  for (int degree = 2; degree <= 7; ++degree)
    for (const std::size_t pieces : {1U, 2U, 3U, 7U}) {
      ShapeProblem p = least_acceleration(pieces, degree);
      if (degree == 2) p.from.acceleration = p.to.acceleration = {};
      const ShapeOutcome best = optimize_shape(p);
      SCOPED_TRACE("degree " + std::to_string(degree) + ", pieces " + std::to_string(pieces));
      if (best.status == Status::infeasible) {
        EXPECT_LT(static_cast<int>(pieces) + degree, degree == 2 ? 4 : 6);
        continue;
      }
      EXPECT_TRUE(best.usable()) << best.reason;
      EXPECT_GE(best.figures[0].reached, best.figures[0].bound.value() * (1 - 1e-9));
      EXPECT_LE(best.bound.value(), best.value * (1 + 1e-9));
      EXPECT_LE(best.value, *best.bound * (1 + 1e-3)) << best.reason;
    }
}

TEST(HardShape, IsStoppedWithinARound) {
  ShapeProblem p = least_acceleration(2000);
  int asked = 0;
  const ShapeOutcome best = optimize_shape(p, [&](const OptimizeProgress&) { return ++asked < 5; });
  EXPECT_EQ(best.status, Status::cancelled) << best.reason;
  EXPECT_LE(best.rounds, 1) << "five questions are less than one round";
}

// ---- not convex -----------------------------------------------------------------------------------

TEST(HardSearch, WeighsAFigureByItsOwnSize) {
  double first = 0;
  for (const double u : {1.0, 1e-6, 1e6}) {
    ShapeProblem p = least_acceleration(12);
    p.to.value = u;
    p.minimize = {{PowerOf{acceleration, derivative_of_shape(1)}}};
    const ShapeOutcome best = optimize_shape(p);
    ASSERT_TRUE(best.usable()) << best.reason;
    EXPECT_NEAR(best.value, best.figures[0].reached / best.figures[0].given, 1e-9);
    if (first == 0) first = best.value;
    EXPECT_NEAR(best.value, first, 1e-6) << u;
  }
}

TEST(HardSearch, EnergyMayBeNothingOrLessThanThat) {
  ShapeProblem p = least_acceleration(12);
  p.minimize = {{EnergyOf{inertia(), 1}}};  // all comes back
  const ShapeOutcome nothing = optimize_shape(p);
  EXPECT_EQ(nothing.status, Status::converged) << nothing.reason;
  EXPECT_NEAR(nothing.figures[0].reached, 0, 1e-12);
  LoadTorque lever;
  lever.gravity = 3;
  lever.turn = 3.14159;
  p.minimize = {{EnergyOf{lever, 1}}};
  p.from.value = 1;
  p.to.value = 0;
  const ShapeOutcome lowered = optimize_shape(p);
  EXPECT_EQ(lowered.status, Status::converged) << lowered.reason;
  EXPECT_NEAR(lowered.figures[0].reached, 3 / 3.14159 * (std::cos(3.14159) - 1), 1e-6);
}

TEST(HardSearch, ReportsMissingFreedomOrEndsThatDisagree) {
  ShapeProblem p = least_acceleration(1, 5);
  p.minimize = {{TorqueOf{inertia()}}};
  const ShapeOutcome only = optimize_shape(p);
  EXPECT_EQ(only.status, Status::converged) << only.reason;
  EXPECT_NEAR(only.figures[0].reached, 10 / std::sqrt(3.0), 1e-9);
  p.degree = 4;
  EXPECT_EQ(optimize_shape(p).status, Status::infeasible);
}

TEST(HardSearch, ForEverIsNoTimeAtAllOnlyInTheory) {
  ShapeProblem p = least_acceleration(8);
  p.minimize = {{TorqueOf{inertia()}}};
  p.options.budget.seconds = INFINITY;
  EXPECT_EQ(optimize_shape(p).status, Status::converged);
}

TEST(HardSearch, IsStoppedWithinARound) {
  ShapeProblem p = least_acceleration(30);
  p.minimize = {{TorqueOf{inertia()}}};
  int asked = 0;
  const ShapeOutcome best = optimize_shape(p, [&](const OptimizeProgress&) { return ++asked < 4; });
  EXPECT_EQ(best.status, Status::cancelled) << best.reason;
  EXPECT_EQ(best.rounds, 1);
  EXPECT_LE(best.evaluations, 5) << "a round has up to 200";
}

TEST(HardSearch, ACeilingOfNothingIsNotANaN) {
  ShapeProblem p = least_acceleration(8);
  p.minimize = {{TorqueOf{inertia()}}};
  p.ceilings = {{RmsOf{acceleration}, 0}};
  const ShapeOutcome none = optimize_shape(p);
  EXPECT_FALSE(none.usable());
  EXPECT_TRUE(std::isfinite(none.value));
  EXPECT_NE(none.status, Status::converged);
}

/// Over random loads: every report is true, nothing is worse than given, and a repetition gives the
/// same.
TEST(HardSearch, HoldsOverRandomLoads) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::Random random(seed);
    LoadTorque load = inertia();
    load.linear.by[1] = random.uniform(0, 1);
    load.coulomb = random.below(2) == 0 ? 0 : random.log_uniform(0.01, 3);
    load.gravity = random.uniform(-3, 3);
    load.turn = random.uniform(-2, 2);
    load.angle = random.uniform(-3, 3);
    if (random.below(2) == 0)
      load.inertia = {line(1, random.uniform(0.1, 1), random.uniform(0.1, 1))};
    ShapeProblem p = least_acceleration(8);
    const ShapeFigure figures[] = {TorqueOf{load}, RmsTorqueOf{load}, EnergyOf{load, 0.5}};
    p.minimize = {{figures[seed % 3]}};
    p.corridors = {test_optimize::within(acceleration, 8, p)};
    p.options.budget.evaluations = 1500;
    const ShapeOutcome best = optimize_shape(p);
    ASSERT_TRUE(best.usable()) << best.reason;
    EXPECT_LE(best.figures[0].reached,
              best.figures[0].given + 1e-9 * std::abs(best.figures[0].given));
    EXPECT_EQ(optimize_shape(p).value, best.value) << "not deterministic";
    const Trajectory shape(best.best);
    for (int i = 0; i <= 2000; ++i) ASSERT_LE(std::abs(shape.jet(i / 2000.0)[2]), 8 * (1 + 1e-9));
    EXPECT_TRUE(best.status != Status::optimal || best.figures[0].bound.has_value());
  }
}

}  // namespace
}  // namespace jounce::shape_hard_test
