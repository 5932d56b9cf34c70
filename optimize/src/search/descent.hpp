// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "jounce/optimize/detail/pointwise.hpp"

#include "optimize/src/solvers/reduced_space.hpp"

namespace jounce::optimize_detail {

/// The function g of a figure at one place, as a function of y (ReducedSpace).
struct PlaceRow {
  const Pointwise* figure = nullptr;  ///< the figure
  double x = 0;                       ///< the place
  double sign = 1;                    ///< fixed sign of the velocity
  std::vector<DenseRow> q = {};       ///< its linear quantities there

  /// Returns g at y, and adds `factor` times its gradient to `gradient`.
  double evaluate(const Eigen::VectorXd& y, double factor,
                  Eigen::Ref<Eigen::VectorXd> gradient) const;
};

/// A constraint: factor * (a linear form, or g at a place) - offset - (t, if it has one) <= 0.
struct DescentRow {
  std::optional<PlaceRow> place = {};  ///< g at a place; nullopt: `linear` is used
  DenseRow linear = {};                ///< the linear form
  double factor = 1;
  double offset = 0;
  std::optional<std::size_t> t = {};  ///< index of t; nullopt: none

  /// Returns factor * (...) - offset at y, without t. Adds its gradient to `gradient`.
  double evaluate(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> gradient) const;
};

/// A mean over places: the root of the sum of weight * g^2, or the sum of weight * g.
struct Mean {
  bool root = true;                   ///< true: the root of the sum of squares
  std::vector<PlaceRow> places = {};  ///< places of g
  std::vector<DenseRow> forms = {};   ///< in place of `places`: forms that contain their weights
  std::vector<double> weight = {};    ///< weight of each place
  double factor = 1;                  ///< factor of the mean
  double offset = 0;                  ///< in a ceiling: factor * mean - offset <= 0

  /// Returns factor times the mean at y, and adds its gradient to `gradient`.
  double evaluate(const Eigen::VectorXd& y, double factor,
                  Eigen::Ref<Eigen::VectorXd> gradient) const;
};

/// A program: minimize the sum of weight[k] t[k] and of the means, subject to the rows and
/// ceilings.
struct DescentProgram {
  Eigen::Index unknowns = 0;          ///< number of entries of y
  std::vector<double> weight = {};    ///< weight of each t
  std::vector<Mean> means = {};       ///< means in the objective; their factors contain the weights
  std::vector<Mean> ceilings = {};    ///< means that are limited
  std::vector<DescentRow> rows = {};  ///< all rows
};

/// Result of descend().
struct Descended {
  Eigen::VectorXd y;    ///< the point
  Eigen::VectorXd t;    ///< values of t
  int evaluations = 0;  ///< number of evaluations
  bool finite = true;   ///< true if all values were finite
};

/// Returns a local solution from y by SLSQP, or the point where SLSQP ended (see
/// run_local_solver()). `go_on` is called at each evaluation of the rows.
Descended descend(const DescentProgram& program, const Eigen::VectorXd& y, int max_evaluations,
                  const std::function<bool()>& go_on);

/// Returns the least t that the rows permit at y.
Eigen::VectorXd least_t(const DescentProgram& program, const Eigen::VectorXd& y);

}  // namespace jounce::optimize_detail
