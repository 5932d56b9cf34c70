// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "optimize/src/program/shape_model.hpp"

namespace jounce::optimizer {

/// form(z) <= t of its term; of none: a wall, form(z) <= 0.
struct ShapeRow {
  Form form;
  std::optional<std::size_t> term = {};
  double off = 0;  ///< by which a wall is kept off
};

/// The planes and walls of a model that are looked at: those to begin with, and those that shapes were
/// found to exceed. The model must outlive it.
class ShapeRows {
 public:
  explicit ShapeRows(const ShapeModel& model);

  [[nodiscard]] const std::vector<ShapeRow>& all() const { return rows_; }
  /// Adds what a shape exceeds: planes above the level of their term (in its unit), walls by more than
  /// slack. How many are new.
  int exchange(const std::vector<Segment>& shape, const std::vector<double>& level, double slack);

 private:
  [[nodiscard]] std::optional<ShapeRow> wall_row(const Form& form, const Wall& wall) const;
  bool add(ShapeRow row);

  const ShapeModel& model_;
  std::vector<ShapeRow> rows_;
};

/// A share of a form's slope that is less is no freedom.
constexpr double no_freedom = 1e-11;

}  // namespace jounce::optimizer
