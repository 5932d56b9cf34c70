// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "jounce/optimize/detail/pointwise.hpp"

#include "optimize/src/program/shape_model.hpp"
#include "optimize/src/search/descent.hpp"

namespace jounce::optimizer {

/// Residual of the equalities of a shape, relative, that no solution has.
inline constexpr double greatest_contradiction = 1e-7;
/// The least precise search of the knots of a shape, relative.
inline constexpr double coarsest_knots = 1e-7;

/// A figure that is not convex, with its unit.
struct SearchedFigure {
  Pointwise figure;
  double unit = 1;
  double weight = 1;                   ///< weight of the objective
  std::optional<double> at_most = {};  ///< a ceiling instead
};

/// The rest of the budget, for all starts and refinements.
struct SearchBudget {
  int evaluations = 0;
  int rounds = 0;
  int most_evaluations = 0;
  std::optional<std::chrono::steady_clock::time_point> until = {};
  bool cancelled = false;

  [[nodiscard]] bool spent() const {
    return cancelled || evaluations >= most_evaluations ||
           (until && std::chrono::steady_clock::now() >= *until);
  }
};

/// The shape at the end of a round.
struct FoundShape {
  std::vector<Segment> shape = {};
  double value = 0;
  double violation = 0;  ///< 0: it meets every limit
  bool settled = false;

  [[nodiscard]] bool better_than(const FoundShape& other) const {
    if (other.shape.empty()) return true;
    if (violation > 0 || other.violation > 0) return violation < other.violation;
    return value < other.value || (std::isnan(other.value) && !std::isnan(value));
  }
};

/// The convex part of the problem.
ShapeProblem convex_part(ShapeProblem problem);

/// The search for a shape over fixed knots, with figures that are not convex. The head of fixed_knots.cpp has
/// the equations and the rounds.
class FixedKnots {
 public:
  FixedKnots(const ShapeProblem& problem, const std::vector<SearchedFigure>& parts,
             std::vector<double> knots, const std::vector<Segment>& near);

  [[nodiscard]] bool contradicts() const {
    return reduced_.contradiction() > greatest_contradiction;
  }
  [[nodiscard]] bool finite() const { return finite_; }
  [[nodiscard]] bool has_no_freedom() const { return reduced_.size() == 0; }
  /// The only shape, where the ends leave nothing free.
  [[nodiscard]] FoundShape only_shape() const;

  /// Each round starts from the best shape so far: where SLSQP gets lost, its next start is no worse.
  FoundShape run(const Eigen::VectorXd& start, SearchBudget& budget, const KeepGoing& keep_going);

  /// y of a shape near the nearest one, in direction number `start`; 0: of the nearest one.
  [[nodiscard]] Eigen::VectorXd beside(int start) const;

  /// The knots, with those pieces halved on which a peaked figure meets its peak and is farthest below it.
  [[nodiscard]] std::vector<double> finer(const std::vector<Segment>& shape) const;
  /// True if a shape is better by more than a share of the tolerance.
  [[nodiscard]] bool gain(const FoundShape& now, const FoundShape& best, double share = 0.01) const;
  [[nodiscard]] std::size_t pieces() const { return model_.space.pieces(); }

 private:
  /// Adds an estimate of the integral of peak - |g| over each piece on which the peak is met.
  void add_lost(const Pointwise& figure, const std::vector<Segment>& shape,
                std::vector<double>& lost) const;

  [[nodiscard]] std::size_t piece_of(double x) const { return model_.space.piece_at(x); }

  // ---- rows ------------------------------------------------------------------------------------

  [[nodiscard]] PlaceRow place_row(const Pointwise& figure, std::size_t piece, double s,
                                   double sign) const;

  /// Adds a row for a constraint, unless nothing can change it.
  void add_constraint(const Form& form, double scale);

  void add_peak(const SearchedFigure& part, std::size_t t, std::size_t piece, double s, double sign,
                double direction);

  void list_rows();

  /// The weights of the epigraphs of the objective, in the order of list_rows().
  [[nodiscard]] std::vector<double> weights() const;

  [[nodiscard]] Mean mean_of(const SearchedFigure& part) const;

  [[nodiscard]] Mean mean_of(const FigureRows& rows, double factor, double offset) const;

  [[nodiscard]] DescentProgram program() const;

  // ---- signs -----------------------------------------------------------------------------------

  [[nodiscard]] double sign_at(const SearchedFigure& part, std::size_t piece, double s) const;

  /// Takes the signs of a shape. Returns true if the sign of a row has changed.
  bool hold_signs(const std::vector<Segment>& shape);

  // ---- value of a shape ------------------------------------------------------------------------

  [[nodiscard]] FoundShape standing(const Eigen::VectorXd& y) const;

  static double scale_of(const RoundCeiling& c);

  static double beyond(double value, double limit, double scale);

  /// Adds the places where the shape breaks a row. Returns their number.
  int exchange(const std::vector<Segment>& shape, const Eigen::VectorXd& t);

  [[nodiscard]] double precision() const {
    return std::min(coarsest_knots, 0.1 * problem_.options.tolerance);
  }

  int add_peaks(const SearchedFigure& part, std::size_t t, const std::vector<Segment>& shape,
                double level);

  /// Two rows at almost the same place are almost one row, which costs SLSQP its digits.
  void drop_near(const SearchedFigure& part, std::size_t piece, double x, double direction);

  const ShapeProblem& problem_;
  const std::vector<SearchedFigure>& parts_;
  ShapeModel model_;
  ReducedSpace reduced_;
  std::vector<Segment> held_;  ///< shape that determines the signs
  std::vector<DescentRow> rows_;
  bool finite_ = true;
};

}  // namespace jounce::optimizer
