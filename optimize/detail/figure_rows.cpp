#include "jounce/optimize/detail/figure_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

#include <Eigen/SparseCholesky>

#include "jounce/optimize/detail/pointwise.hpp"
#include "jounce/optimize/detail/quadrature.hpp"
#include "jounce/profiles/error.hpp"

// Peak: |q| at one place is the higher of two planes, q and -q. To begin with both stand where the
// pieces begin, end, and (where q bends within a piece) in the middle; then where the exact extrema of
// q on a piece exceed the level.
//
// Rms: a sum of squares (SplineSpace::squares).
//
// Response: y is known by what it gives for shapes. It is affine in the shape, so with z_k the shapes of
// a basis and c_k their coordinates
//
//   (1)  y(z) = y(0) + sum_k c_k (y(z_k) - y(0))
//
// One coordinate at a time is no spline, but pieces apart: what that costs, jumps of the position, cancels
// in any spline. Rows a of y are therefore taken as they are within the joints E z = 0:
//
//   (2)  a <- a - E' (E E')^-1 E a
//
// (A basis of splines instead, what a jump of the top derivative becomes to the end, loses all digits.)
// A response that is wanted small in the mean has a square for each of the m numbers, y_i^2 / m.

namespace jounce::optimizer {
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

/// Runs of pieces that touch the level with one sign, each told once, where it begins.
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
      sum +=
          f.length * integral([&](double s) { return jounce::value(g, s) * jounce::value(g, s); });
      continue;
    }
    for (std::size_t i = 0; i <= static_cast<std::size_t>(g.degree); ++i)
      for (std::size_t j = 0; j <= static_cast<std::size_t>(g.degree); ++j)
        sum += f.length * g.c[i] * g.c[j] / static_cast<double>(i + j + 1);
  }
  return std::sqrt(std::max(sum, 0.0) / length);
}

double largest(const std::vector<double>& y) {
  double peak = 0;
  for (const double v : y) {
    if (std::isnan(v)) return v;  // std::max would lose it
    peak = std::max(peak, std::abs(v));
  }
  return peak;
}

/// (1).
struct Affine {
  std::vector<double> at_zero;
  std::vector<std::pair<std::size_t, std::vector<double>>> by;  ///< coordinate, change of y

  [[nodiscard]] Form plane(std::size_t i, double sign) const {
    Form form{sign * at_zero[i], {}};
    for (const auto& [k, change] : by)
      if (change[i] != 0) form.terms.push_back({k, sign * change[i]});
    return form;
  }
};

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

using Respond = std::function<std::vector<double>(const std::vector<Segment>&)>;

Respond responding(const std::function<std::vector<double>(const Trajectory&)>& of, double begin) {
  return [of, begin](const std::vector<Segment>& shape) { return of(Trajectory(shape, begin)); };
}

/// (2).
Eigen::MatrixXd without_joints(const Eigen::MatrixXd& rows, const SplineSpace& space) {
  const std::vector<Form> joints = space.joints();
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < joints.size(); ++i)
    for (const Form::Term& t : joints[i].terms)
      entries.emplace_back(static_cast<int>(i), static_cast<int>(t.index), t.factor);
  Eigen::SparseMatrix<double> e(static_cast<Eigen::Index>(joints.size()), rows.rows());
  e.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseMatrix<double> square = e * e.transpose();
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(square);
  Eigen::MatrixXd left = rows;
  for (int round = 0; round < 2; ++round) left -= e.transpose() * solver.solve(e * left);
  return left;
}

Affine affine(const Respond& respond, const SplineSpace& space) {
  Affine y{respond(space.segments(Coordinates(space.size(), 0))), {}};
  const auto size = static_cast<Eigen::Index>(y.at_zero.size());
  const std::size_t at_the_end = space.index(space.pieces(), 0);  // in no segment
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(space.size()), size);
  for (std::size_t k = 0; k < at_the_end; ++k) {
    Coordinates z(space.size(), 0);
    z[k] = 1;
    const std::vector<double> now = respond(space.segments(z));
    for (Eigen::Index i = 0; i < size; ++i)
      rows(static_cast<Eigen::Index>(k), i) =
          now[static_cast<std::size_t>(i)] - y.at_zero[static_cast<std::size_t>(i)];
  }
  rows = without_joints(rows, space);
  for (std::size_t k = 0; k < space.size(); ++k) {
    const auto row = rows.row(static_cast<Eigen::Index>(k));
    y.by.emplace_back(k, std::vector<double>(row.begin(), row.end()));
  }
  return y;
}

/// The largest of all y(z_k), or 1 where all are 0.
double natural(const Affine& y) {
  double size = largest(y.at_zero);
  for (const auto& [k, change] : y.by) size = std::max(size, largest(change));
  return size > 0 ? size : 1;
}

double rms(const std::vector<double>& y) {
  double sum = 0;
  for (const double v : y) sum += v * v;
  return y.empty() ? 0 : std::sqrt(sum / static_cast<double>(y.size()));
}

}  // namespace

FigureRows rows_of(const RmsResponseOf& figure, const SplineSpace& space) {
  const Respond respond = responding(figure.of, space.knots().front());
  const Affine y = affine(respond, space);
  FigureRows rows{.name = figure.name,
                  .value = [respond](const auto& shape) { return rms(respond(shape)); }};
  for (std::size_t i = 0; i < y.at_zero.size(); ++i)
    rows.squares.push_back(
        scaled(y.plane(i, 1), 1 / std::sqrt(static_cast<double>(y.at_zero.size()))));
  rows.natural = natural(y);
  return rows;
}

FigureRows rows_of(const ResponseOf& figure, const SplineSpace& space) {
  const Respond respond = responding(figure.of, space.knots().front());
  const Affine y = affine(respond, space);
  FigureRows rows{.name = figure.name,
                  .value = [respond](const auto& shape) { return largest(respond(shape)); }};
  const std::size_t every = std::max<std::size_t>(y.at_zero.size() / 32, 1);
  for (std::size_t i = 0; i < y.at_zero.size(); i += every)
    for (const double sign : signs) rows.start.push_back(y.plane(i, sign));
  rows.cuts = [respond, y](const std::vector<Segment>& shape, double level) {
    const std::vector<double> now = respond(shape);
    std::vector<Form> planes;
    const auto magnitude = [&](std::size_t i) { return std::abs(now[i]); };
    for (std::size_t i = 0; i < now.size(); ++i) {  // local peaks alone: planes are dense
      if (!(magnitude(i) > level)) continue;
      if (i > 0 && magnitude(i - 1) > magnitude(i)) continue;
      if (i + 1 < now.size() && magnitude(i + 1) >= magnitude(i)) continue;
      planes.push_back(y.plane(i, now[i] > 0 ? 1 : -1));
    }
    return planes;
  };
  rows.natural = natural(y);
  return rows;
}

namespace {

template <class Figure>
constexpr bool convex = std::is_same_v<Figure, PeakOf> || std::is_same_v<Figure, RmsOf> ||
                        std::is_same_v<Figure, ResponseOf> ||
                        std::is_same_v<Figure, RmsResponseOf> || std::is_same_v<Figure, ResidualOf>;

/// The size of a figure that is not convex in a perfect spline, its parts added up.
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

/// A figure that is not convex: what it is worth, and where, but no planes.
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

FigureRows figure_rows(const ShapeFigure& figure, const SplineSpace& space) {
  return std::visit(
      [&]<class Figure>(const Figure& f) -> FigureRows {
        if constexpr (convex<Figure>)
          return rows_of(f, space);
        else
          return value_alone(figure, space);
      },
      figure);
}

}  // namespace jounce::optimizer
