// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/figures/figure_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

#include "jounce/cam/detail/quadrature.hpp"
#include "jounce/optimize/detail/pointwise.hpp"
#include "jounce/profiles/error.hpp"

// Peak of a quantity q: |q| at one place is the higher of the two planes q and -q. The first planes
// are at the beginning and the end of each piece and, if q bends within a piece, at its middle.
// Later planes are where the exact extrema of q on a piece exceed the level.
//
// Rms: a sum of squares (SplineSpace::squares).

namespace jounce::optimize_detail {
namespace {

constexpr std::array signs{1.0, -1.0};

/// 1 / sqrt(length), so that squares add up to a mean.
double per_root_length(const SplineSpace& space) {
  return 1 / std::sqrt(space.knots().back() - space.knots().front());
}

/// q on every piece of a shape, with its exact range.
template <class Visit>
void each_range(const LinearQuantity& q, const std::vector<Segment>& shape, double begin,
                const Visit& visit) {
  double x = begin;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const double end = x + shape[i].length;
    visit(i, x, segment_range(quantity_of(q, shape[i]), x, end, 0));
    x = end;
  }
}

double place_in(const Extremum& e, double from, double length) {
  return std::clamp((e.where - from) / length, 0.0, 1.0);
}

std::vector<Form> planes_to_begin_with(const LinearQuantity& q, const SplineSpace& space) {
  const int bends =
      space.degree() - order_of(q);  // degree of q on a piece, if only order_of counts
  std::vector<Form> planes;
  const auto add = [&](std::size_t piece, double s) {
    const Form f = space.at(q, piece, s);
    for (const double sign : signs) planes.push_back(scaled(f, sign));
  };
  for (std::size_t i = 0; i < space.pieces(); ++i) {
    add(i, 0);
    if (bends >= 2) add(i, 0.5);
    if (bends >= 3)
      for (const double s : {0.25, 0.75}) add(i, s);
  }
  if (bends >= 1) add(space.pieces() - 1, 1);
  return planes;
}

/// The runs of pieces that touch the level with one sign, each listed once, where it begins.
std::vector<Extremum> touching(const LinearQuantity& q, const std::vector<Segment>& shape,
                               double begin, double level) {
  std::vector<Extremum> places;
  std::array<std::size_t, 2> last{shape.size() + 1, shape.size() + 1};
  each_range(q, shape, begin, [&](std::size_t i, double, const Range& range) {
    for (std::size_t k = 0; k < signs.size(); ++k) {
      const Extremum& e = signs[k] > 0 ? range.max : range.min;
      if (signs[k] * e.value < level) continue;
      if (last[k] + 1 != i) places.push_back(e);
      last[k] = i;
    }
  });
  return places;
}

double rms_of(const LinearQuantity& q, const std::vector<Segment>& shape) {
  // The square of a polynomial of degree n, integrated term by term.
  double sum = 0;
  double length = 0;
  for (const Segment& f : shape) {
    const Segment g = quantity_of(q, f);
    length += f.length;
    if (g.sines > 0) {
      sum += f.length * jounce::cam_detail::integral(
                            [&](double s) { return jounce::value(g, s) * jounce::value(g, s); });
      continue;
    }
    for (std::size_t i = 0; i <= static_cast<std::size_t>(g.degree); ++i)
      for (std::size_t j = 0; j <= static_cast<std::size_t>(g.degree); ++j)
        sum += f.length * g.c[i] * g.c[j] / static_cast<double>(i + j + 1);
  }
  return std::sqrt(std::max(sum, 0.0) / length);
}

}  // namespace

std::vector<double> places_around(const Segment& g, double s, double excess) {
  std::vector<double> places{s};
  if (s <= 0 || s >= 1) return places;
  const double bend = std::abs(evaluate(g, s)[2]) * g.length * g.length;
  const double half = bend > 0 ? std::sqrt(2 * excess / bend) / 2 : 1;
  for (const double at : {s - half, s + half})
    if (at > 0 && at < 1) places.push_back(at);
  return places;
}

Extremum peak_of(const LinearQuantity& q, const std::vector<Segment>& shape, double x) {
  Extremum peak{0, x, Side::right};
  each_range(q, shape, x, [&](std::size_t, double, const Range& range) {
    if (std::abs(range.peak().value) > std::abs(peak.value)) peak = range.peak();
  });
  return peak;
}

FigureRows rows_of(const PeakOf& figure, const SplineSpace& space) {
  const LinearQuantity& q = figure.quantity;
  const double begin = space.knots().front();
  FigureRows rows{.name = name(figure), .value = [q, begin](const auto& shape) {
                    return std::abs(peak_of(q, shape, begin).value);
                  }};
  rows.start = planes_to_begin_with(q, space);
  rows.cuts = [q, &space](const std::vector<Segment>& shape, double level) {
    std::vector<Form> planes;
    each_range(q, shape, space.knots().front(), [&](std::size_t i, double x, const Range& range) {
      for (const double sign : signs) {
        const Extremum& e = sign > 0 ? range.max : range.min;
        const double excess = sign * e.value - level;
        if (excess <= 0) continue;
        const double at = place_in(e, x, shape[i].length);
        for (const double s : places_around(quantity_of(q, shape[i]), at, excess))
          planes.push_back(scaled(space.at(q, i, s), sign));
      }
    });
    return planes;
  };
  rows.places = [q, begin](const auto& shape, double level) {
    return touching(q, shape, begin, level);
  };
  rows.natural = space.natural(q);
  return rows;
}

FigureRows rows_of(const RmsOf& figure, const SplineSpace& space) {
  const LinearQuantity& q = figure.quantity;
  FigureRows rows{.name = name(figure),
                  .value = [q](const auto& shape) { return rms_of(q, shape); }};
  for (Form& f : space.squares(q))
    rows.squares.push_back(scaled(std::move(f), per_root_length(space)));
  rows.natural = space.natural(q);
  return rows;
}

namespace {

/// A figure of few numbers with many planes.
template <class Figure>
constexpr bool has_auxiliary =
    std::is_same_v<Figure, ResponseOf> || std::is_same_v<Figure, RmsResponseOf> ||
    std::is_same_v<Figure, ResidualOf>;

template <class Figure>
constexpr bool convex =
    std::is_same_v<Figure, PeakOf> || std::is_same_v<Figure, RmsOf> || has_auxiliary<Figure>;

/// The size of a figure that is not convex, for a perfect spline: the sum of its parts.
double natural_of(const ShapeFigure& figure, const SplineSpace& space) {
  const auto derivative = [&](int order) { return space.natural(derivative_of_shape(order)); };
  const auto torque = [&](const LoadTorque& load) {
    double sum = space.natural(load.linear) + std::abs(load.linear.constant) + load.coulomb +
                 std::abs(load.gravity);
    for (const Segment& j : load.inertia)
      sum = std::max(
          sum, magnitude(j) * derivative(2) + magnitude(jounce::derivative(j)) * derivative(1));
    return sum;
  };
  double natural = 0;
  if (const auto* f = std::get_if<PowerOf>(&figure))
    natural = space.natural(f->force) * space.natural(f->velocity);
  if (const auto* f = std::get_if<TorqueOf>(&figure)) natural = torque(f->load);
  if (const auto* f = std::get_if<RmsTorqueOf>(&figure)) natural = torque(f->load);
  if (const auto* f = std::get_if<EnergyOf>(&figure)) natural = torque(f->load) * derivative(0);
  return natural > 0 ? natural : 1;
}

/// A figure that is not convex: its value and its places, without planes.
FigureRows value_alone(const ShapeFigure& figure, const SplineSpace& space) {
  const double begin = space.knots().front();
  const Pointwise p = pointwise(figure, begin).value();
  FigureRows rows{.name = name(figure),
                  .value = [p, begin](const auto& shape) { return value_of(p, shape, begin); }};
  rows.places = [p, begin](const std::vector<Segment>& shape, double level) {
    return places_of(p, shape, begin, level);
  };
  rows.natural = natural_of(figure, space);
  return rows;
}

}  // namespace

bool has_rows(const ShapeFigure& figure) {
  return std::visit([]<class Figure>(const Figure&) { return convex<Figure>; }, figure);
}

FigureRows figure_rows(const ShapeFigure& figure, const SplineSpace& space,
                       const Auxiliary* auxiliary) {
  return std::visit(
      [&]<class Figure>(const Figure& f) -> FigureRows {
        if constexpr (has_auxiliary<Figure>)
          return rows_of(f, space, auxiliary);
        else if constexpr (convex<Figure>)
          return rows_of(f, space);
        else
          return value_alone(figure, space);
      },
      figure);
}

}  // namespace jounce::optimize_detail
