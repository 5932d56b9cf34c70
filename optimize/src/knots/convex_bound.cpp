// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/knots/convex_bound.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "optimize/src/solvers/certificate.hpp"
#include "optimize/src/solvers/program.hpp"

namespace jounce::optimize_detail {
namespace {

constexpr int places =
    13;  ///< Chebyshev points of a piece in the first program, in addition to its extrema
constexpr int rounds = 5;

/// The tangents of a subproblem at z as a convex program in z and t, both in their units.
class Tangent {
 public:
  Tangent(const Subproblem& subproblem, const Point& z)
      : subproblem_(subproblem),
        z_(z),
        knots_(knots_at(subproblem.space, z)),
        reference_(std::max(merit(subproblem, z).value, subproblem.insignificant)) {
    program_.slope.assign(z.size() + 1, 0);
    program_.slope.back() = 1;
    add_box();
    const Shape shape(subproblem.space, z);
    each_moving([&](std::size_t i) { add_piece(shape, i, places); });
    if (subproblem.objective == Objective::rms_acceleration) add({Rms{}, 1 / reference_, 0, true});
  }

  /// The highest bound of a few rounds, each with the extrema of the round before.
  double bound() {
    std::vector<double> range;
    for (const Variable& v : subproblem_.space.variables)
      range.push_back((v.upper - v.lower) / v.scale);
    range.push_back(2);
    std::vector<double> x = z_;
    x.push_back(1);
    double highest = 0;
    for (int round = 0; round < rounds; ++round) {
      const ConvexSolution found = solve(program_, x);
      highest = std::max(highest, weak_bound(program_, found, range));
      x = found.x;
      const Shape shape(subproblem_.space, clamped(subproblem_.space, {x.begin(), x.end() - 1}));
      each_moving([&](std::size_t i) { add_piece(shape, i, 0); });
    }
    return highest * reference_;
  }

 private:
  template <class Visit>
  void each_moving(const Visit& visit) const {
    for (std::size_t i = 0; i < subproblem_.space.pieces.size(); ++i)
      if (subproblem_.space.moves[subproblem_.space.pieces[i].segment]) visit(i);
  }

  void add_box() {
    const auto& variables = subproblem_.space.variables;
    for (std::size_t k = 0; k < variables.size(); ++k) {
      const Variable& v = variables[k];
      program_.constraints.push_back({-(v.upper - v.given) / v.scale, {{k, 1}}});
      program_.constraints.push_back({(v.lower - v.given) / v.scale, {{k, -1}}});
    }
    program_.constraints.push_back({floor_of(subproblem_) / reference_, {{z_.size(), -1}}});
  }

  /// Adds rows at the extrema of a piece and at `count` Chebyshev points.
  void add_piece(const Shape& shape, std::size_t piece, int count) {
    const auto peak = peak_order(subproblem_.objective);
    for (const DerivativeBound& c : subproblem_.ceilings)
      for (const double s : places_of(shape, piece, shape.range(piece, c), count))
        add({sample(subproblem_.space.pieces, piece, c.order, s, c.lower), c.sign / c.scale,
             c.limit / c.scale, false});
    if (!peak) return;
    for (const double s : places_of(shape, piece, shape.ranges[piece][*peak], count))
      for (const double sign : {1.0, -1.0})
        add({sample(subproblem_.space.pieces, piece, *peak, s), sign / reference_, 0, true});
  }

  static std::vector<double> places_of(const Shape& shape, std::size_t piece, const Range& range,
                                       int count) {
    std::vector<double> all{shape.place(piece, range.min), shape.place(piece, range.max)};
    for (int k = 0; k < count; ++k)
      all.push_back((1 - std::cos(std::numbers::pi * k / (count - 1))) / 2);
    return all;
  }

  void add(const Row& row) {
    std::vector<double> gradient(z_.size());
    Form form{evaluate(subproblem_.space, row, knots_, gradient), {}};
    for (std::size_t k = 0; k < z_.size(); ++k) {
      if (gradient[k] == 0) continue;
      form.constant -= gradient[k] * z_[k];
      form.terms.push_back({k, gradient[k]});
    }
    if (row.relaxed) form.terms.push_back({z_.size(), -1});
    if (!form.terms.empty()) program_.constraints.push_back(std::move(form));
  }

  const Subproblem& subproblem_;
  const Point& z_;
  std::vector<Knot> knots_;
  double reference_;
  ConvexProgram program_;
};

}  // namespace

double convex_bound(const Subproblem& subproblem, const Point& z) {
  return Tangent(subproblem, z).bound();
}

}  // namespace jounce::optimize_detail
