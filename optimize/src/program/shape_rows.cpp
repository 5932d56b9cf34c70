// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/program/shape_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

// Constraints are tightened by `off` where there is freedom, so that rounding does not break them.

namespace jounce::optimize_detail {
namespace {

constexpr double alike = 1e-7;

bool same(const ShapeRow& a, const ShapeRow& b) {
  if (a.term != b.term || a.form.terms.size() != b.form.terms.size()) return false;
  double apart = 0;
  double size = 0;
  for (std::size_t i = 0; i < b.form.terms.size(); ++i) {
    if (a.form.terms[i].index != b.form.terms[i].index) return false;
    apart = std::max(apart, std::abs(a.form.terms[i].factor - b.form.terms[i].factor));
    size = std::max(size, std::abs(b.form.terms[i].factor));
  }
  return apart <= alike * size && std::abs(a.form.constant - b.form.constant) <= alike * size;
}

}  // namespace

ShapeRows::ShapeRows(const ShapeModel& model) : model_(model) {
  for (std::size_t p = 0; p < model.terms.size(); ++p)
    for (const Form& f : model.terms[p].rows.start)
      rows_.push_back({scaled(f, 1 / model.terms[p].unit), p});
  for (const ShapeConstraint& constraint : model.constraints)
    for (const Form& f : constraint.start)
      if (auto row = constraint_row(f, constraint)) rows_.push_back(std::move(*row));
}

/// True if the row is new.
bool ShapeRows::add(ShapeRow row) {
  if (std::any_of(rows_.rbegin(), rows_.rend(),
                  [&](const auto& other) { return same(other, row); }))
    return false;
  rows_.push_back(std::move(row));
  return true;
}

/// None where no free coordinate changes it.
std::optional<ShapeRow> ShapeRows::constraint_row(const Form& form,
                                                  const ShapeConstraint& constraint) const {
  const double free = model_.freedom(form);
  if (free <= no_freedom) return {};
  ShapeRow row{scaled(form, 1 / constraint.scale), {}, constraint.off * std::min(1.0, free)};
  row.form.constant += row.off;
  return row;
}

int ShapeRows::exchange(const std::vector<Segment>& shape, const std::vector<double>& level,
                        double slack) {
  int added = 0;
  for (std::size_t p = 0; p < model_.terms.size(); ++p) {
    const Term& term = model_.terms[p];
    if (term.rows.by_squares()) continue;
    for (const Form& f : term.rows.cuts(shape, term.unit * level[p]))
      added += add({scaled(f, 1 / term.unit), p});
  }
  for (const ShapeConstraint& constraint : model_.constraints)
    for (const Form& f : constraint.beyond(shape, slack))
      if (auto row = constraint_row(f, constraint)) added += add(std::move(*row));
  return added;
}

}  // namespace jounce::optimize_detail
