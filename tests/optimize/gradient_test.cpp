// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "optimize/rest_to_rest.hpp"
#include "optimize/src/knots/pieces.hpp"
#include "optimize/src/solvers/program.hpp"

namespace jounce::optimize_detail {
namespace {

using test_optimize::fig614;
using test_optimize::rest_to_rest;

/// A cam with every law that can move, and a line and a dwell that cannot.
CamSpec every_law() {
  CamSpec spec;
  spec.start = {0, 0, {}, {}};
  spec.segments = {
      {Law::modified_sine, {40, 30, {}, {}}, ""}, {Law::quintic, {70, 50, 0.7, -0.01}, ""},
      {Law::quintic, {95, 45, -1.5, 0}, ""},      {Law::line, {105, 30, {}, {}}, ""},
      {Law::quintic, {150, 10, {}, {}}, ""},      {Law::dwell, {170, 10, {}, {}}, ""},
      {Law::inclined_sine, {260, 0, {}, {}}, ""}};
  return spec;
}

/// Central difference; the step leaves a relative error of about 1e-9.
double slope(const std::function<double(double)>& f, double x, double step) {
  return (f(x + step) - f(x - step)) / (2 * step);
}

TEST(Pieces, GiveTheDesignedCam) {
  const CamSpec spec = every_law();
  const auto all = pieces(spec);
  const auto knots = knots_of(spec);
  const CamDesign made = design(spec);
  ASSERT_EQ(all.size(), made.origin.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i].segment, made.origin[i]);
    for (const double s : {0.0, 0.2, 0.5, 0.9, 1.0}) {
      const Jet expected = evaluate(made.cam.segments()[i], s);
      for (std::size_t k = 0; k < 4; ++k) {
        KnotGradient ignored{};
        const double scale = 50 / std::pow(10, k);  // slave, slopes over about 10 of master
        EXPECT_NEAR(value(sample(all, i, k, s), knots, ignored), expected[k], 1e-12 * scale);
      }
    }
  }
}

TEST(Pieces, DerivativesByKnotsAreExact) {
  const CamSpec spec = every_law();
  const auto all = pieces(spec);
  const auto given = knots_of(spec);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k)
      for (const double s : {0.0, 0.3, 0.8, 1.0}) {
        const Sample at = sample(all, i, k, s, k > 1 ? 0.07 : 0);
        KnotGradient gradient{};
        value(at, given, gradient);
        for (std::size_t side = 0; side < 2; ++side)
          for (std::size_t q = 0; q < 4; ++q) {
            const double step = std::array{1e-3, 1e-3, 1e-4, 1e-5}[q];
            const auto f = [&](double x) {
              auto knots = given;
              knots[at.segment + side][q] = x;
              KnotGradient ignored{};
              return value(at, knots, ignored);
            };
            const double exact = gradient[4 * side + q];
            EXPECT_NEAR(exact, slope(f, given[at.segment + side][q], step),
                        1e-6 * (std::abs(exact) + 1e-3))
                << "piece " << i << " order " << k << " s " << s << " side " << side << " q " << q;
          }
      }
}

TEST(Pieces, SquareOfAccelerationAndItsGradientAreExact) {
  const CamSpec spec = every_law();
  const auto all = pieces(spec);
  const auto gram = grams(all);
  const auto given = knots_of(spec);
  double total = 0;
  for (std::size_t i = 0; i < gram.size(); ++i) {
    KnotGradient gradient{};
    total += square_acceleration(gram[i], given[i], given[i + 1], gradient);
    for (std::size_t side = 0; side < 2; ++side)
      for (std::size_t q = 0; q < 4; ++q) {
        const auto f = [&](double x) {
          std::array ends{given[i], given[i + 1]};
          ends[side][q] = x;
          KnotGradient ignored{};
          return square_acceleration(gram[i], ends[0], ends[1], ignored);
        };
        const double step = std::array{1e-3, 1e-3, 1e-4, 1e-5}[q];
        EXPECT_NEAR(gradient[4 * side + q], slope(f, given[i + side][q], step),
                    1e-6 * (std::abs(gradient[4 * side + q]) + 1e-4));
      }
  }
  const double rms = value_of(Objective::rms_acceleration, design(spec).cam);
  EXPECT_NEAR(std::sqrt(total / 260), rms, 1e-12 * rms);
}

/// All kinds of rows, by the scaled variables, the seam of a periodic cam included.
TEST(Rows, GradientsByTheFreeQuantitiesAreExact) {
  CamProblem problem = fig614();
  problem.free = {{0, {}, Bound{-10, 10}, Bound{-1, 1}, Bound{-0.1, 0.1}},
                  {1, Bound{60, 90}, Bound{80, 120}, {}, Bound{-0.1, 0.1}},
                  {3, Bound{205, 355}, Bound{-20, 240}, Bound{-3, 3}, Bound{-0.1, 0.1}}};
  const Space space(problem);
  ASSERT_EQ(space.variables.size(), 10U);
  Point z = start_point(space, 7, 1);
  for (double& x : z) x *= 0.5;  // off the bounds, where a difference would be one-sided
  std::vector<Row> rows{
      {Rms{}, 3, 0.5, true}, {Spacing{0}, -1, 0, false}, {Spacing{2}, 2, 0, false}};
  for (std::size_t piece = 0; piece < 4; ++piece)
    for (std::size_t order = 0; order < 4; ++order)
      rows.push_back({sample(space.pieces, piece, order, 0.37), 1.5, 0.25, false});
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::vector<double> gradient(z.size());
    evaluate(space, rows[r], knots_at(space, z), gradient);
    for (std::size_t i = 0; i < z.size(); ++i) {
      const auto f = [&](double x) {
        Point moved = z;
        moved[i] = x;
        std::vector<double> ignored(z.size());
        return evaluate(space, rows[r], knots_at(space, moved), ignored);
      };
      EXPECT_NEAR(gradient[i], slope(f, z[i], 1e-5), 1e-6 * (std::abs(gradient[i]) + 1e-3))
          << "row " << r << " variable " << i;
    }
  }
}

TEST(Space, StartsKeepBoundsAndOrder) {
  CamProblem problem = rest_to_rest({0.2, 0.5, 0.7}, Objective::peak_jerk);
  const Space space(problem);
  for (std::size_t n = 0; n < 200; ++n) {
    const auto knots = knots_at(space, start_point(space, 99, n));
    for (std::size_t i = 1; i < knots.size(); ++i)
      EXPECT_GE(knots[i][0] - knots[i - 1][0], 0.999999 * space.least_length[i - 1]);
    EXPECT_NO_THROW(design(spec_at(space, start_point(space, 99, n))));
  }
}

TEST(Space, BringsCrossedMastersBackInOrder) {
  const Space space(rest_to_rest({0.4, 0.6}, Objective::peak_jerk));
  Point z(space.variables.size(), 0.0);
  z[0] = 100;   // first knot far right,
  z[4] = -100;  // second far left
  const CamSpec spec = spec_at(space, clamped(space, z));
  EXPECT_LT(spec.segments[0].end.master, spec.segments[1].end.master);
  EXPECT_NO_THROW(design(spec));
}

}  // namespace
}  // namespace jounce::optimize_detail
