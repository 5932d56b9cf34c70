// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/knots/exchange_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jounce::optimize_detail {
namespace {

constexpr double greatest_margin = 1e-9;  ///< relative, kept from limits
// Bounds of the precision of a program, relative.
constexpr double finest_rows = 1e-11;
constexpr double coarsest_rows = 1e-8;

constexpr int first_places = 7;  ///< Chebyshev points of a piece in the first program
constexpr int max_sharpened = 30;
constexpr double same_place = 1e-7;  ///< positions in a piece closer than this are one
constexpr double fixed = 1e-12;      ///< a row whose slope is not above this cannot be changed

}  // namespace

ExchangeRows::ExchangeRows(const Subproblem& subproblem, const Point& start)
    : subproblem_(subproblem),
      reference_(subproblem.objective
                     ? std::max(merit(subproblem, start).value, subproblem.insignificant)
                     : 1),
      margin_(std::min(greatest_margin, subproblem.tolerance / 4)) {
  const Space& space = subproblem.space;
  for (std::size_t i = 0; i < space.moves.size(); ++i)
    if (space.moves[i]) add_spacing(i);
  for (std::size_t i = 0; i < space.pieces.size(); ++i)
    if (space.moves[space.pieces[i].segment]) add_everywhere(i, start);
  if (subproblem.rms_ceiling)
    rows_.push_back({Rms{}, 1 / *subproblem.rms_ceiling, 1 - margin_, false});
  if (subproblem.objective == Objective::rms_acceleration)
    rows_.push_back({Rms{}, 1 / reference_, 0, true});
}

double ExchangeRows::precision() const {
  return std::clamp(subproblem_.tolerance / 100, finest_rows, coarsest_rows);
}

int ExchangeRows::exchange(const Shape& shape, const Point& z, double t) {
  const Space& space = subproblem_.space;
  int added = 0;
  for (std::size_t i = 0; i < space.pieces.size(); ++i) {
    if (!space.moves[space.pieces[i].segment]) continue;
    const Ranges& range = shape.ranges[i];
    for (const DerivativeBound& c : subproblem_.ceilings) {
      const Range limited = shape.range(i, c);
      const double excess = excess_of(c, limited) - (subproblem_.objective ? 0 : t);
      if (excess > rounding_tolerance)
        added += exclude(c, i, shape.place(i, worst(limited, c.sign)), z, excess);
    }
    if (const auto order = peak_order(subproblem_.objective))
      for (const double sign : {1.0, -1.0})
        if (sign * worst(range[*order], sign).value > reference_ * (t + precision()))
          added += add_peak(i, shape.place(i, worst(range[*order], sign)), *order, sign, z);
  }
  return added;
}

void ExchangeRows::add_spacing(std::size_t segment) {
  const Space& space = subproblem_.space;
  const double given = space.knots[segment + 1][0] - space.knots[segment][0];
  rows_.push_back({Spacing{segment}, -1 / given, -space.least_length[segment] / given, false});
}

void ExchangeRows::add_everywhere(std::size_t piece, const Point& z) {
  for (int k = 0; k < first_places; ++k) {
    const double s = (1 - std::cos(std::numbers::pi * k / (first_places - 1))) / 2;
    for (const DerivativeBound& c : subproblem_.ceilings) add(row_of(c, piece, s, z), z);
    if (const auto order = peak_order(subproblem_.objective))
      for (const double sign : {1.0, -1.0}) add_peak(piece, s, *order, sign, z);
  }
}

/// Adds a row. If rounding of the solver broke a row that is there, makes that row sharper.
bool ExchangeRows::exclude(const DerivativeBound& ceiling, std::size_t piece, double s,
                           const Point& z, double excess) {
  const Row row = row_of(ceiling, piece, s, z);
  Row* known = find(row);
  if (!known) return add(row, z);
  if (row.relaxed || sharpened_ >= max_sharpened) return false;
  known->offset -= 2 * excess;
  ++sharpened_;
  return true;
}

bool ExchangeRows::add_peak(std::size_t piece, double s, std::size_t order, double sign,
                            const Point& z) {
  return add({sample(subproblem_.space.pieces, piece, order, s), sign / reference_, 0, true}, z);
}

bool ExchangeRows::add(const Row& row, const Point& z) {
  if (largest_slope(row, z) <= fixed || find(row)) return false;
  rows_.push_back(row);
  return true;
}

/// Near a fixed knot a row can hardly be changed, so the margin shrinks with its slope.
Row ExchangeRows::row_of(const DerivativeBound& ceiling, std::size_t piece, double s,
                         const Point& z) const {
  Row row{sample(subproblem_.space.pieces, piece, ceiling.order, s, ceiling.lower),
          ceiling.sign / ceiling.scale, ceiling.limit / ceiling.scale, !subproblem_.objective};
  row.offset -= margin_ * std::min(1.0, largest_slope(row, z));
  return row;
}

double ExchangeRows::largest_slope(const Row& row, const Point& z) const {
  std::vector<double> gradient(z.size());
  evaluate(subproblem_.space, row, knots_at(subproblem_.space, z), gradient);
  double largest = 0;
  for (const double g : gradient) largest = std::max(largest, std::abs(g));
  return largest;
}

Row* ExchangeRows::find(const Row& row) {
  const auto& at = std::get<Sample>(row.f);
  for (Row& other : rows_) {
    const auto* b = std::get_if<Sample>(&other.f);
    if (b && b->piece == at.piece && b->order == at.order && b->lower == at.lower &&
        other.factor == row.factor && other.relaxed == row.relaxed &&
        std::abs(b->s - at.s) < same_place)
      return &other;
  }
  return nullptr;
}

}  // namespace jounce::optimize_detail
