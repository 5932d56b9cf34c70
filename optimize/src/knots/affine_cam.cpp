// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/knots/affine_cam.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce::optimize_detail {

double peak_of(const CamSpec& spec) {
  return std::abs(extrema(design(spec).cam, 2).peak().value);
}

AffineCam::AffineCam(const CamSpec& spec, const std::vector<FreeDerivatives>& free)
    : spec_(spec), knots_(resolved_knots(spec)), index_(knots_.size()), peak_(peak_of(spec)) {
  const std::size_t last = spec.segments.size();
  mean_ = (knots_.back().master - knots_.front().master) / static_cast<double>(last);
  for (std::size_t i = 0; i <= last; ++i) {
    // f' takes the slope of the chord somewhere in each adjacent segment.
    const double reach = length(std::min(i, last - 1)) / mean_;
    if (spec.periodic && i == last)
      index_[i] = index_[0];
    else
      index_[i] = {add(free[i].geo_velocity, peak_ * mean_, reach),
                   add(free[i].geo_acceleration, peak_, 1)};
  }
}

bool AffineCam::straight() const {
  double natural = 0;
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i)
    natural = std::max(natural,
                       std::abs(knots_[i + 1].slave - knots_[i].slave) / (length(i) * length(i)));
  return peak_ <= profiles_detail::rounded_root * natural;
}

bool AffineCam::moves(std::size_t segment) const {
  for (const std::size_t i : {segment, segment + 1})
    for (const auto& index : index_[i])
      if (index) return true;
  return false;
}

CamSpec AffineCam::at(const std::vector<double>& x) const {
  CamSpec spec = spec_;
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    CamKnot& knot = i == 0 ? spec.start : spec.segments[i - 1].end;
    const auto& [velocity, acceleration] = index_[i];
    if (velocity) *knot.geo_velocity += x[*velocity] * unknowns_[*velocity].unit;
    if (acceleration) *knot.geo_acceleration += x[*acceleration] * unknowns_[*acceleration].unit;
  }
  return spec;
}

Form AffineCam::derivative(std::size_t segment, double s, std::size_t order) const {
  const CamKnot& a = knots_[segment];
  const CamKnot& b = knots_[segment + 1];
  const double h = length(segment);
  const double unit = order == 2 ? peak_ : peak_ / mean_;
  const auto of = [&](const Segment& f) { return evaluate(f, s)[order] / unit; };
  Form form{of(quintic(h, 0, *a.geo_velocity, *a.geo_acceleration, b.slave - a.slave,
                       *b.geo_velocity, *b.geo_acceleration)),
            {}};
  const auto term = [&](const std::optional<std::size_t>& index, const Segment& shape) {
    if (index) form.terms.push_back({*index, of(shape) * unknowns_[*index].unit});
  };
  term(index_[segment][0], quintic(h, 0, 1, 0, 0, 0, 0));
  term(index_[segment][1], quintic(h, 0, 0, 1, 0, 0, 0));
  term(index_[segment + 1][0], quintic(h, 0, 0, 0, 0, 1, 0));
  term(index_[segment + 1][1], quintic(h, 0, 0, 0, 0, 0, 1));
  return form;
}

std::vector<Form> AffineCam::square_jerk() const {
  std::vector<Form> squares;
  const double off = std::sqrt(0.15);
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
    if (!moves(i)) continue;
    for (const auto& [s, weight] : {std::pair{0.5 - off, 5.0}, {0.5, 8.0}, {0.5 + off, 5.0}})
      squares.push_back(scaled(derivative(i, s, 3), std::sqrt(length(i) / mean_ * weight / 18)));
  }
  return squares;
}

std::optional<std::size_t> AffineCam::add(bool free, double unit, double reach) {
  if (!free) return {};
  unknowns_.push_back({unit, reach});
  return unknowns_.size() - 1;
}

}  // namespace jounce::optimize_detail
