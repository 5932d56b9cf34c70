// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/knots/exchange.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jounce::optimizer {
namespace {

constexpr int places = 7;  ///< Chebyshev points of a piece in the first program
constexpr int max_sharpened = 30;
constexpr double same_place = 1e-7;  ///< positions in a piece closer than this are one
constexpr double fixed = 1e-12;      ///< a row whose slope is not above this cannot be changed

}  // namespace

Exchange::Exchange(const Stage& stage, const Point& start)
    : stage_(stage),
      reference_(stage.objective ? std::max(standing(stage, start).value, stage.insignificant) : 1),
      margin_(std::min(1e-9, stage.tolerance / 4)) {
  const Space& space = stage.space;
  for (std::size_t i = 0; i < space.moves.size(); ++i)
    if (space.moves[i]) add_spacing(i);
  for (std::size_t i = 0; i < space.pieces.size(); ++i)
    if (space.moves[space.pieces[i].segment]) add_everywhere(i, start);
  if (stage.rms_ceiling) rows_.push_back({Rms{}, 1 / *stage.rms_ceiling, 1 - margin_, false});
  if (stage.objective == Objective::rms_acceleration)
    rows_.push_back({Rms{}, 1 / reference_, 0, true});
}

double Exchange::precision() const {
  return std::clamp(stage_.tolerance / 100, 1e-11, 1e-8);
}

int Exchange::exchange(const Shape& shape, const Point& z, double t) {
  const Space& space = stage_.space;
  int added = 0;
  for (std::size_t i = 0; i < space.pieces.size(); ++i) {
    if (!space.moves[space.pieces[i].segment]) continue;
    const Ranges& range = shape.ranges[i];
    for (const DerivativeBound& c : stage_.ceilings) {
      const Range limited = shape.range(i, c);
      const double excess = excess_of(c, limited) - (stage_.objective ? 0 : t);
      if (excess > rounding)
        added += exclude(c, i, shape.place(i, worst(limited, c.sign)), z, excess);
    }
    if (const auto order = peak_order(stage_.objective))
      for (const double sign : {1.0, -1.0})
        if (sign * worst(range[*order], sign).value > reference_ * (t + precision()))
          added += add_peak(i, shape.place(i, worst(range[*order], sign)), *order, sign, z);
  }
  return added;
}

void Exchange::add_spacing(std::size_t segment) {
  const Space& space = stage_.space;
  const double given = space.knots[segment + 1][0] - space.knots[segment][0];
  rows_.push_back({Spacing{segment}, -1 / given, -space.least_length[segment] / given, false});
}

void Exchange::add_everywhere(std::size_t piece, const Point& z) {
  for (int k = 0; k < places; ++k) {
    const double s = (1 - std::cos(std::numbers::pi * k / (places - 1))) / 2;
    for (const DerivativeBound& c : stage_.ceilings) add(row_of(c, piece, s, z), z);
    if (const auto order = peak_order(stage_.objective))
      for (const double sign : {1.0, -1.0}) add_peak(piece, s, *order, sign, z);
  }
}

/// Adds a row. If rounding of the solver broke a row that is there, makes that row sharper.
bool Exchange::exclude(const DerivativeBound& ceiling, std::size_t piece, double s, const Point& z,
                       double excess) {
  const Row row = row_of(ceiling, piece, s, z);
  Row* known = find(row);
  if (!known) return add(row, z);
  if (row.relaxed || sharpened_ >= max_sharpened) return false;
  known->offset -= 2 * excess;
  ++sharpened_;
  return true;
}

bool Exchange::add_peak(std::size_t piece, double s, std::size_t order, double sign,
                        const Point& z) {
  return add({sample(stage_.space.pieces, piece, order, s), sign / reference_, 0, true}, z);
}

bool Exchange::add(const Row& row, const Point& z) {
  if (largest_slope(row, z) <= fixed || find(row)) return false;
  rows_.push_back(row);
  return true;
}

/// Near a fixed knot a row can hardly be changed, so the margin shrinks with its slope.
Row Exchange::row_of(const DerivativeBound& ceiling, std::size_t piece, double s,
                     const Point& z) const {
  Row row{sample(stage_.space.pieces, piece, ceiling.order, s, ceiling.lower),
          ceiling.sign / ceiling.scale, ceiling.limit / ceiling.scale, !stage_.objective};
  row.offset -= margin_ * std::min(1.0, largest_slope(row, z));
  return row;
}

double Exchange::largest_slope(const Row& row, const Point& z) const {
  std::vector<double> gradient(z.size());
  evaluate(stage_.space, row, knots_at(stage_.space, z), gradient);
  double largest = 0;
  for (const double g : gradient) largest = std::max(largest, std::abs(g));
  return largest;
}

Row* Exchange::find(const Row& row) {
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

}  // namespace jounce::optimizer
