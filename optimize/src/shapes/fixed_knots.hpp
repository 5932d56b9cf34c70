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

namespace jounce::optimize_detail {

/// Residual of the equalities of a shape, relative, that no solution has.
inline constexpr double greatest_contradiction = 1e-7;
/// The least precise search of the knots of a shape, relative.
inline constexpr double coarsest_knots = 1e-7;
/// A figure that is not convex.
struct SearchedFigure {
  Pointwise figure;   ///< the figure
  double unit = 1;    ///< its unit
  double weight = 1;  ///< weight in the objective
  /// If given, the figure is not minimized, but limited to this value.
  std::optional<double> at_most = {};
};

/// Budget of a search, for all its starts and refinements, and the part that is used.
struct SearchBudget {
  int evaluations = 0;       ///< evaluations so far
  int rounds = 0;            ///< rounds so far
  int most_evaluations = 0;  ///< greatest number of evaluations
  std::optional<std::chrono::steady_clock::time_point> until = {};  ///< time limit; nullopt: none
  bool cancelled = false;  ///< true if the caller has stopped the search

  /// True if the search must end.
  [[nodiscard]] bool spent() const {
    return cancelled || evaluations >= most_evaluations ||
           (until && std::chrono::steady_clock::now() >= *until);
  }
};

/// The shape at the end of a round.
struct FoundShape {
  std::vector<Segment> shape = {};  ///< the shape
  double value = 0;                 ///< weighted sum
  double violation = 0;             ///< greatest violation of a limit; 0: none
  bool settled = false;             ///< true if the search has converged

  /// True if this shape is better: it has less violation or, without violations, a lower value.
  [[nodiscard]] bool better_than(const FoundShape& other) const {
    if (other.shape.empty()) return true;
    if (violation > 0 || other.violation > 0) return violation < other.violation;
    return value < other.value || (std::isnan(other.value) && !std::isnan(value));
  }
};

/// Returns the convex part of the problem.
ShapeProblem convex_part(ShapeProblem problem);

/// The search for a shape over fixed knots, with figures that are not convex. The head of
/// fixed_knots.cpp describes the method.
class FixedKnots {
 public:
  FixedKnots(const ShapeProblem& problem, const std::vector<SearchedFigure>& parts,
             std::vector<double> knots, const std::vector<Segment>& near);

  [[nodiscard]] bool contradicts() const {
    return reduced_.contradiction() > greatest_contradiction;
  }
  /// False if a value was not finite.
  [[nodiscard]] bool finite() const { return finite_; }
  /// True if the equalities determine the shape.
  [[nodiscard]] bool has_no_freedom() const { return reduced_.size() == 0; }
  /// Returns the only shape, if has_no_freedom().
  [[nodiscard]] FoundShape only_shape() const;

  /// Runs the rounds from `start`. Each round starts from the best shape so far, since SLSQP may
  /// end at a worse one.
  FoundShape run(const Eigen::VectorXd& start, SearchBudget& budget, const KeepGoing& keep_going);

  /// Returns the y of a shape near the given one, in the random direction number `start`; 0: of the
  /// nearest one.
  [[nodiscard]] Eigen::VectorXd beside(int start) const;

  /// Returns the knots, with those pieces halved on which a peaked figure reaches its peak and is
  /// farthest below it.
  [[nodiscard]] std::vector<double> finer(const std::vector<Segment>& shape) const;
  /// True if a shape is better by more than `share` of the tolerance.
  [[nodiscard]] bool gain(const FoundShape& now, const FoundShape& best, double share = 0.01) const;
  [[nodiscard]] std::size_t pieces() const { return model_.space.pieces(); }

 private:
  /// Adds, for each piece on which the peak is reached, an estimate of the integral of peak - |g|.
  void add_lost(const Pointwise& figure, const std::vector<Segment>& shape,
                std::vector<double>& lost) const;

  [[nodiscard]] std::size_t piece_of(double x) const { return model_.space.piece_at(x); }

  // ---- rows ------------------------------------------------------------------------------------

  [[nodiscard]] PlaceRow place_row(const Pointwise& figure, std::size_t piece, double s,
                                   double sign) const;

  /// Adds a row for a constraint, unless the constraint cannot change.
  void add_constraint(const Form& form, double scale);

  void add_peak(const SearchedFigure& part, std::size_t t, std::size_t piece, double s, double sign,
                double direction);

  void list_rows();

  /// Returns the weights of the epigraphs of the objective, in the order of list_rows().
  [[nodiscard]] std::vector<double> weights() const;

  [[nodiscard]] Mean mean_of(const SearchedFigure& part) const;

  [[nodiscard]] Mean mean_of(const FigureRows& rows, double factor, double offset) const;

  [[nodiscard]] DescentProgram program() const;

  // ---- signs -----------------------------------------------------------------------------------

  [[nodiscard]] double sign_at(const SearchedFigure& part, std::size_t piece, double s) const;

  /// Sets the signs to the signs of a shape. Returns true if the sign of a row has changed.
  bool hold_signs(const std::vector<Segment>& shape);

  // ---- value of a shape ------------------------------------------------------------------------

  [[nodiscard]] FoundShape standing(const Eigen::VectorXd& y) const;

  static double scale_of(const RoundCeiling& c);

  static double beyond(double value, double limit, double scale);

  /// Adds the places where the shape exceeds a row. Returns their number.
  int exchange(const std::vector<Segment>& shape, const Eigen::VectorXd& t);

  [[nodiscard]] double precision() const {
    return std::min(coarsest_knots, 0.1 * problem_.options.tolerance);
  }

  int add_peaks(const SearchedFigure& part, std::size_t t, const std::vector<Segment>& shape,
                double level);

  /// Removes rows at almost the same place: they are almost dependent, and SLSQP would lose
  /// accuracy.
  void drop_near(const SearchedFigure& part, std::size_t piece, double x, double direction);

  const ShapeProblem& problem_;
  const std::vector<SearchedFigure>& parts_;
  ShapeModel model_;
  ReducedSpace reduced_;
  std::vector<Segment> held_;  ///< shape that determines the signs
  std::vector<DescentRow> rows_;
  bool finite_ = true;
};

}  // namespace jounce::optimize_detail
