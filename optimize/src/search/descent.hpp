// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "jounce/optimize/detail/pointwise.hpp"

#include "optimize/src/solvers/reduced_space.hpp"

namespace jounce::optimizer {

/// g of a figure at one place, as a function of y.
struct PlaceRow {
  const Pointwise* figure = nullptr;
  double x = 0;
  double sign = 1;  ///< fixed sign of the velocity
  std::vector<DenseRow> q = {};

  /// g at y, and its gradient times `factor` added to `gradient`.
  double evaluate(const Eigen::VectorXd& y, double factor,
                  Eigen::Ref<Eigen::VectorXd> gradient) const;
};

/// factor * (a linear form, or g at a place) - offset - (t where there is one) <= 0.
struct DescentRow {
  std::optional<PlaceRow> place = {};  ///< otherwise linear
  DenseRow linear = {};
  double factor = 1;
  double offset = 0;
  std::optional<std::size_t> t = {};

  /// factor * (...) - offset at y, without t. Adds its gradient to `gradient`.
  double evaluate(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> gradient) const;
};

/// root of the sum of weight g^2, or the sum of weight g.
struct Mean {
  bool root = true;
  std::vector<PlaceRow> places = {};
  std::vector<DenseRow> forms = {};  ///< instead of places: squares that contain their weights
  std::vector<double> weight = {};
  double factor = 1;  ///< factor of the whole
  double offset = 0;  ///< in a constraint: factor * mean - offset <= 0

  double evaluate(const Eigen::VectorXd& y, double factor,
                  Eigen::Ref<Eigen::VectorXd> gradient) const;
};

/// minimize sum weight[k] t[k] + sum of means   subject to   rows, ceilings.
struct DescentProgram {
  Eigen::Index unknowns = 0;
  std::vector<double> weight = {};  ///< weights of t
  std::vector<Mean> means = {};     ///< in the objective; their factors contain the weights
  std::vector<Mean> ceilings = {};
  std::vector<DescentRow> rows = {};
};

struct Descended {
  Eigen::VectorXd y;
  Eigen::VectorXd t;
  int evaluations = 0;
  bool finite = true;
};

/// A local solution from y by SLSQP, or the point where it stopped (see run_local_solver()). `go_on` is called
/// at each evaluation of the rows.
Descended descend(const DescentProgram& program, const Eigen::VectorXd& y, int max_evaluations,
                  const std::function<bool()>& go_on);

/// The least t that the rows permit at y.
Eigen::VectorXd least_t(const DescentProgram& program, const Eigen::VectorXd& y);

}  // namespace jounce::optimizer
