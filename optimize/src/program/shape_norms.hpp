// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "optimize/src/program/shape_model.hpp"

namespace jounce::optimize_detail {

/// Finds the root of a decreasing function by the secant method.
class Root {
 public:
  explicit Root(double at) : at_(at) {}
  /// The present estimate.
  [[nodiscard]] double at() const { return at_; }
  /// Continues from the value of the function at the present estimate. `slope`: the slope of the
  /// first step.
  void advance(double value, double slope);

 private:
  double at_;
  std::optional<std::pair<double, double>> last_;
};

/// The figures of a model that are norms (rms), as squares in a quadratic program. With c > 0
///
///     (1)  |v| = min over c of (|v|^2 / c + c) / 2,   attained at c = |v|,
///
/// which is jointly convex in v and c. The minimum of a sum that contains weight |F z| is therefore
/// a fixed point:
///
///     (2)  mu = weight / (2 c),   c = |F z|   where z minimizes the sum with mu |F z|^2 instead.
///
/// There is one number c for each norm. It is found by the secant method in log c.
class ShapeNorms {
 public:
  ShapeNorms(const ShapeModel& model, const std::vector<Segment>& start);

  /// True if a figure of the model is a norm.
  [[nodiscard]] bool any() const;
  /// Returns the squares for the present c.
  [[nodiscard]] std::vector<Form> squares() const;

  /// Changes c towards its value for the present minimum. Returns true if c has converged.
  bool settle(const std::vector<Segment>& shape);

  /// Returns the correction that makes a bound of the quadratic program a bound of the sum. The sum
  /// is convex in c with the slope weight (1 - (|F z| / c)^2) / 2, and no better shape has
  /// |F z| > sum / weight:
  ///
  ///     (3)  + sum over norms of weight c / 2 - |slope| max(c, sum / weight)
  [[nodiscard]] double to_bound(const std::vector<Segment>& shape, double sum) const;

 private:
  const ShapeModel& model_;
  std::vector<Root> c_;  ///< log c of each term; unused for peaks
};

}  // namespace jounce::optimize_detail
