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
  double sign = 1;  ///< sign of the velocity; held
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

  /// factor * (...) - offset at y, without t; its gradient is added to `gradient`.
  double evaluate(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> gradient) const;
};

/// root of the sum of weight g^2, or the sum of weight g.
struct Mean {
  bool root = true;
  std::vector<PlaceRow> places = {};
  std::vector<DenseRow> forms = {};  ///< instead of places: squares, weights in them
  std::vector<double> weight = {};
  double factor = 1;  ///< factor of the whole
  double offset = 0;  ///< as a constraint: factor * mean - offset <= 0

  double evaluate(const Eigen::VectorXd& y, double factor,
                  Eigen::Ref<Eigen::VectorXd> gradient) const;
};

/// minimise sum weight[k] t[k] + sum of means   subject to   rows, ceilings.
struct DescentProgram {
  Eigen::Index unknowns = 0;
  std::vector<double> weight = {};  ///< weight of t
  std::vector<Mean> means = {};     ///< in the objective, factors contain their weights
  std::vector<Mean> ceilings = {};
  std::vector<DescentRow> rows = {};
};

struct Descended {
  Eigen::VectorXd y;
  Eigen::VectorXd t;
  int evaluations = 0;
  bool finite = true;
};

/// A local solution from y by SLSQP, or where it stopped: the caller judges by exact values, NLopt's own
/// verdict counts for nothing. `go_on` is asked at each evaluation of rows.
Descended descend(const DescentProgram& program, const Eigen::VectorXd& y, int max_evaluations,
                  const std::function<bool()>& go_on);

/// The least t that the rows permit at y.
Eigen::VectorXd least_t(const DescentProgram& program, const Eigen::VectorXd& y);

}  // namespace jounce::optimizer
