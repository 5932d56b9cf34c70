// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/program/shape_norms.hpp"

#include <algorithm>
#include <cmath>

#include "optimize/src/tolerances.hpp"

namespace jounce::optimize_detail {
namespace {

constexpr double settled_norm = 1e-8;  ///< relative change of a norm that needs no further program

}  // namespace

void Root::advance(double value, double slope) {
  if (last_ && last_->first != at_) {
    const double secant = (value - last_->second) / (at_ - last_->first);
    if (secant < 0 && std::isfinite(secant)) slope = std::clamp(secant, 5 * slope, slope / 50);
  }
  last_ = {at_, value};
  at_ += std::clamp(-value / slope, -8.0, 8.0);
}

ShapeNorms::ShapeNorms(const ShapeModel& model, const std::vector<Segment>& start) : model_(model) {
  for (const Term& term : model_.terms)
    c_.emplace_back(std::log(
        std::max(term.rows.by_squares() ? term.rows.value(start) / term.unit : 1.0, 1e-3)));
}

bool ShapeNorms::any() const {
  return std::any_of(model_.terms.begin(), model_.terms.end(),
                     [](const Term& t) { return t.rows.by_squares(); });
}

std::vector<Form> ShapeNorms::squares() const {
  std::vector<Form> squares;
  const auto add = [&](const FigureRows& rows, double factor) {
    for (const Form& f : rows.squares) squares.push_back(scaled(f, factor));
  };
  for (std::size_t p = 0; p < model_.terms.size(); ++p) {
    const Term& t = model_.terms[p];
    add(t.rows, std::sqrt(t.weight / (2 * std::exp(c_[p].at()))) / t.unit);
  }
  return squares;
}

bool ShapeNorms::settle(const std::vector<Segment>& shape) {
  bool settled = true;
  for (std::size_t p = 0; p < model_.terms.size(); ++p) {
    const Term& t = model_.terms[p];
    if (!t.rows.by_squares()) continue;
    const double now = t.rows.value(shape) / t.unit;
    if (now <= natural_zero) continue;
    const double off = std::log(now) - c_[p].at();
    if (std::abs(off) <= settled_norm) continue;
    c_[p].advance(off, -1);
    settled = false;
  }
  return settled;
}

double ShapeNorms::to_bound(const std::vector<Segment>& shape, double sum) const {
  double more = 0;
  for (std::size_t k = 0; k < model_.terms.size(); ++k) {
    const Term& t = model_.terms[k];
    if (!t.rows.by_squares()) continue;
    const double c = std::exp(c_[k].at());
    const double ratio = t.rows.value(shape) / t.unit / c;
    more +=
        t.weight * c / 2 - t.weight * std::abs(1 - ratio * ratio) / 2 * std::max(c, sum / t.weight);
  }
  return more;
}

}  // namespace jounce::optimize_detail
