// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "optimize/src/program/shape_model.hpp"

namespace jounce::optimize_detail {

/// The inequality form(z) <= t of its term; without a term a constraint, form(z) <= 0.
struct ShapeRow {
  Form form;                             ///< left side
  std::optional<std::size_t> term = {};  ///< index of the term; nullopt: a constraint
  double off = 0;                        ///< distance that is kept from the constraint
};

/// The present planes and constraints of a model: the first ones, and those that shapes have
/// exceeded. The model must outlive the object.
class ShapeRows {
 public:
  explicit ShapeRows(const ShapeModel& model);

  /// All rows.
  [[nodiscard]] const std::vector<ShapeRow>& all() const { return rows_; }
  /// Adds the rows that a shape exceeds: planes that are above the level of their term (in its
  /// unit), and constraints that are exceeded by more than `slack`. Returns the number of new rows.
  int exchange(const std::vector<Segment>& shape, const std::vector<double>& level, double slack);

 private:
  [[nodiscard]] std::optional<ShapeRow> constraint_row(const Form& form,
                                                       const ShapeConstraint& constraint) const;
  bool add(ShapeRow row);

  const ShapeModel& model_;
  std::vector<ShapeRow> rows_;
};

/// If a smaller share of the slope of a form is free, the form counts as fixed.
constexpr double no_freedom = 1e-11;

}  // namespace jounce::optimize_detail
