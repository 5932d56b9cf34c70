// SPDX-License-Identifier: Apache-2.0
// The input of SLSQP: the rows of constraints, convex figures and peaks, and the means.

#include <algorithm>
#include <array>
#include <cmath>

#include "jounce/cam/detail/quadrature.hpp"

#include "optimize/src/shapes/fixed_knots.hpp"
#include "optimize/src/tolerances.hpp"

namespace jounce::optimize_detail {
namespace {

constexpr double flat_slope = 1e-9;     ///< slope of a row that no step changes
constexpr double row_precision = 1e-9;  ///< share of the level
constexpr double kept_by = 1e-9;  ///< distance kept from limits: SLSQP leaves as much rounding

}  // namespace

PlaceRow FixedKnots::place_row(const Pointwise& figure, std::size_t piece, double s,
                               double sign) const {
  PlaceRow row{&figure, model_.space.knots()[piece] + s * model_.space.length(piece), sign};
  for (const LinearQuantity& q : figure.of)
    row.q.push_back(reduced_.row(model_.space.at(q, piece, s)));
  return row;
}

void FixedKnots::add_constraint(const Form& form, double scale) {
  DescentRow row{.linear = reduced_.row(form), .factor = 1 / scale};
  const double slope = row.linear.slope.lpNorm<Eigen::Infinity>() / scale;
  if (slope < flat_slope) return;
  row.offset = -kept_by * std::min(1.0, slope);
  rows_.push_back(std::move(row));
}

void FixedKnots::add_peak(const SearchedFigure& part, std::size_t t, std::size_t piece, double s,
                          double sign, double direction) {
  DescentRow row{.place = place_row(part.figure, piece, s, sign), .factor = direction / part.unit};
  if (part.at_most)
    row.offset = *part.at_most / part.unit - kept_by;
  else
    row.t = t;
  rows_.push_back(std::move(row));
}

void FixedKnots::list_rows() {
  for (const ShapeConstraint& constraint : model_.constraints)
    for (const Form& form : constraint.start) add_constraint(form, constraint.scale);
  std::size_t t = 0;
  for (const Term& term : model_.terms) {
    if (term.rows.by_squares()) continue;
    for (const Form& form : term.rows.start)
      rows_.push_back({.linear = reduced_.row(form), .factor = 1 / term.unit, .t = t});
    ++t;
  }
  for (const SearchedFigure& part : parts_) {
    if (part.figure.over != Pointwise::Over::peak) continue;
    for (std::size_t i = 0; i < model_.space.pieces(); ++i)
      for (const double s : {0.0, 0.25, 0.5, 0.75})
        for (const double direction : {1.0, -1.0})
          add_peak(part, t, i, s, sign_at(part, i, s), direction);
    if (!part.at_most) ++t;
  }
}

std::vector<double> FixedKnots::weights() const {
  std::vector<double> all;
  for (const Term& term : model_.terms)
    if (!term.rows.by_squares()) all.push_back(term.weight);
  for (const SearchedFigure& part : parts_)
    if (!part.at_most && part.figure.over == Pointwise::Over::peak) all.push_back(part.weight);
  return all;
}

Mean FixedKnots::mean_of(const SearchedFigure& part) const {
  Mean mean{.root = part.figure.over == Pointwise::Over::rms};
  const double length = problem_.end - problem_.begin;
  for (std::size_t i = 0; i < model_.space.pieces(); ++i)
    for (const auto& [s, weight] : jounce::cam_detail::gauss_6) {
      mean.places.push_back(place_row(part.figure, i, s, sign_at(part, i, s)));
      mean.weight.push_back(weight * model_.space.length(i) / (mean.root ? length : 1));
    }
  mean.factor = (part.at_most ? 1 : part.weight) / part.unit;
  if (part.at_most) mean.offset = *part.at_most / part.unit - kept_by;
  return mean;
}

Mean FixedKnots::mean_of(const FigureRows& rows, double factor, double offset) const {
  Mean mean{.factor = factor, .offset = offset};
  for (const Form& form : rows.squares) mean.forms.push_back(reduced_.row(form));
  return mean;
}

DescentProgram FixedKnots::program() const {
  DescentProgram p{.unknowns = reduced_.size(), .weight = weights(), .rows = rows_};
  for (const Term& term : model_.terms)
    if (term.rows.by_squares()) p.means.push_back(mean_of(term.rows, term.weight / term.unit, 0));
  for (const RoundCeiling& c : model_.round)
    p.ceilings.push_back(mean_of(c.rows, 1 / scale_of(c), c.at_most / scale_of(c) - kept_by));
  for (const SearchedFigure& part : parts_)
    if (part.figure.over != Pointwise::Over::peak)
      (part.at_most ? p.ceilings : p.means).push_back(mean_of(part));
  return p;
}

double FixedKnots::sign_at(const SearchedFigure& part, std::size_t piece, double s) const {
  if (!part.figure.signed_by) return 1;
  return value(derivative(held_[piece]), s) < 0 ? -1 : 1;
}

bool FixedKnots::hold_signs(const std::vector<Segment>& shape) {
  held_ = shape;
  if (shape.size() != model_.space.pieces())
    held_ = model_.space.segments(model_.space.coordinates(shape));
  bool turned = false;
  for (DescentRow& row : rows_) {
    if (!row.place || !row.place->figure->signed_by) continue;
    const std::size_t i = piece_of(row.place->x);
    const double s = (row.place->x - model_.space.knots()[i]) / model_.space.length(i);
    const double v = value(derivative(held_[i]), std::clamp(s, 0.0, 1.0));
    if (std::abs(v) <= natural_zero * model_.space.natural(derivative_of_shape(1)) ||
        v * row.place->sign > 0)
      continue;
    row.place->sign = -row.place->sign;
    turned = true;
  }
  return turned;
}

int FixedKnots::add_peaks(const SearchedFigure& part, std::size_t t,
                          const std::vector<Segment>& shape, double level) {
  int added = 0;
  for (const Wave& wave : part.figure.waves(shape, problem_.begin)) {
    const Range range = range_of(wave, row_precision * level * part.unit);
    for (const double direction : {1.0, -1.0}) {
      const Extremum& e = direction > 0 ? range.max : range.min;
      if (direction * e.value <= level * part.unit) continue;
      const double from = model_.space.knots()[wave.piece];
      const double s = std::clamp((e.where - from) / model_.space.length(wave.piece), 0.0, 1.0);
      drop_near(part, wave.piece, e.where, direction);
      add_peak(part, t, wave.piece, s, part.figure.signed_by ? wave.sign : 1, direction);
      ++added;
    }
  }
  return added;
}

void FixedKnots::drop_near(const SearchedFigure& part, std::size_t piece, double x,
                           double direction) {
  const double near = 1e-4 * model_.space.length(piece);
  std::erase_if(rows_, [&](const DescentRow& row) {
    return row.place && row.place->figure == &part.figure && row.factor * direction > 0 &&
           std::abs(row.place->x - x) < near;
  });
}

}  // namespace jounce::optimize_detail
