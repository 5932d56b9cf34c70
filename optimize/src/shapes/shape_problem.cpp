// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "jounce/optimize/detail/pointwise.hpp"
#include "jounce/optimize/shape.hpp"
#include "jounce/profiles/detail/entry_key.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "optimize/src/program/spline_space.hpp"

namespace jounce {
namespace {

using profiles_detail::entry_key;
using profiles_detail::rounded_input;
using profiles_detail::rounded_sum;

constexpr double affine_error = 1e-6;  ///< share of the figure that an affine one may be off

constexpr std::array quantity_names{"value",    "geo_velocity", "geo_acceleration",
                                    "geo_jerk", "geo_jounce",   "geo_crackle"};

void require(bool holds, const std::string& key, double value, const char* rule) {
  if (!holds) throw InputError(key, value, rule);
}

void require_quantity(const std::string& key, const LinearQuantity& q, int degree) {
  for (const double by : q.by) require(std::isfinite(by), key + ".by", by, "must be finite");
  require(std::isfinite(q.constant), key + ".constant", q.constant, "must be finite");
  const int order = optimize_detail::order_of(q);
  if (order < 0) throw InputError(key + ".by", 0.0, "must not be zero throughout");
  if (order > degree)
    throw InputError(key, q.name,
                     "needs the derivative of order " + std::to_string(order) +
                         ", the shape has degree " + std::to_string(degree));
}

/// Requires finite numbers, always the same number of them, and an affine response: y(f + g) + y(0) = y(f) +
/// y(g) for two rises.
void require_response(const std::string& key, const ResponseOf& r, const ShapeProblem& p) {
  if (!r.of) throw InputError(key, r.name, "must be a function");
  const double length = p.end - p.begin;
  const double apart = p.to.value.value_or(0) - p.from.value.value_or(0);
  const double u = apart != 0 ? apart : 1;
  const auto respond = [&](double rise, double bump) {
    const auto y =
        r.of(Trajectory({quintic(length, bump, 0, bump / length / length, rise, 0, 0)}, p.begin));
    for (const double each : y)
      if (!std::isfinite(each)) throw InputError(key, r.name, "must give finite numbers");
    return y;
  };
  const auto zero = respond(0, 0), f = respond(u, 0), g = respond(0, u), both = respond(u, u);
  if (zero.empty()) throw InputError(key, r.name, "must give at least one number");
  if (f.size() != zero.size() || g.size() != zero.size() || both.size() != zero.size())
    throw InputError(key, r.name, "must always give the same number of values");
  double size = 0;
  double off = 0;
  for (std::size_t i = 0; i < zero.size(); ++i) {
    size = std::max({size, std::abs(f[i]), std::abs(g[i]), std::abs(zero[i])});
    off = std::max(off, std::abs(both[i] + zero[i] - f[i] - g[i]));
  }
  if (off > affine_error * size) throw InputError(key, r.name, "must be affine in the shape");
}

void require_figure(const std::string& key, const ShapeFigure& figure, const ShapeProblem& p) {
  const int degree = p.degree;
  if (const auto* f = std::get_if<PeakOf>(&figure)) require_quantity(key, f->quantity, degree);
  if (const auto* f = std::get_if<RmsOf>(&figure)) require_quantity(key, f->quantity, degree);
  if (const auto* f = std::get_if<PowerOf>(&figure)) {
    require_quantity(key + ".force", f->force, degree);
    require_quantity(key + ".velocity", f->velocity, degree);
  }
  if (const auto* f = std::get_if<ResponseOf>(&figure)) require_response(key + ".of", *f, p);
  if (const auto* f = std::get_if<RmsResponseOf>(&figure))
    require_response(key + ".of", ResponseOf{f->name, f->of}, p);
  if (const auto* f = std::get_if<ResidualOf>(&figure)) {
    require(std::isfinite(f->low) && f->low > 0, key + ".low", f->low, "must be > 0");
    require(std::isfinite(f->high) && f->high >= f->low, key + ".high", f->high,
            "must not be below low");
    require(f->damping_low >= 0 && f->damping_low < 1, key + ".damping_low", f->damping_low,
            "must be in [0, 1)");
    require(f->damping_high >= f->damping_low && f->damping_high < 1, key + ".damping_high",
            f->damping_high, "must be in [damping_low, 1)");
  }
}

/// True if x is 0, or if |x| lies between 1 / most and most: then the squares of seven derivatives and of a power
/// do not overflow.
bool is_in_range(double x, double most) {
  return x == 0 || (std::abs(x) <= most && std::abs(x) >= 1 / most);
}

/// The interval of a shape: long enough to separate the ends of its pieces, short enough for its powers.
void require_place(const ShapeProblem& p) {
  const double length = p.end - p.begin;
  require(is_in_range(length, 1e12), "end", p.end, "must be 1e-12 to 1e12 after begin");
  const double far = std::max(std::abs(p.begin), std::abs(p.end));
  require(length / static_cast<double>(p.pieces) >= rounded_sum * far, "pieces",
          static_cast<double>(p.pieces),
          "must be fewer: at this distance from 0 a double cannot separate their ends");
}

/// A periodic shape has the same derivatives at both ends.
void require_periodic(const ShapeProblem& p) {
  const auto from = optimize_detail::derivatives_of(p.from);
  const auto to = optimize_detail::derivatives_of(p.to);
  for (std::size_t k = 1; p.periodic && k < to.size(); ++k)
    if (from[k] && to[k])
      require(*from[k] == *to[k], std::string("to.") + quantity_names[k], *to[k],
              "must equal that of from, because the shape is periodic");
}

void require_end(const char* key, const ShapeEnd& end, int degree, double length) {
  const auto given = optimize_detail::derivatives_of(end);
  double power = 1;
  for (std::size_t k = 0; k < given.size(); ++k, power *= length) {
    if (!given[k]) continue;
    const std::string field = std::string(key) + "." + quantity_names[k];
    require(std::isfinite(*given[k]), field, *given[k], "must be finite");
    require(static_cast<int>(k) < degree, field, *given[k],
            "can be given only if the degree is above its order");
    require(is_in_range(*given[k] * power, 1e60), field, *given[k],
            "times the length to the power of its order must be 0, or 1e-60 to 1e60");
  }
}

void require_edge(const std::string& key, const std::optional<Edge>& edge) {
  if (!edge) return;
  require(std::isfinite(edge->at_from), key + ".at_from", edge->at_from, "must be finite");
  require(std::isfinite(edge->at_to), key + ".at_to", edge->at_to, "must be finite");
}

void require_corridor(std::size_t i, const Corridor& c, const ShapeProblem& p) {
  require_quantity(entry_key("corridors", i, "quantity"), c.quantity, p.degree);
  require(c.from >= p.begin && c.from <= p.end, entry_key("corridors", i, "from"), c.from,
          "must be within the shape");
  const double least =
      optimize_detail::same_knot * (p.end - p.begin) / static_cast<double>(p.pieces);
  require(c.to >= c.from && c.to <= p.end, entry_key("corridors", i, "to"), c.to,
          "must not be before from, nor beyond the end");
  require(c.to == c.from || c.to - c.from > 2 * least, entry_key("corridors", i, "to"), c.to,
          "must be from (a point), or farther from it than a 500000th of a piece");
  require_edge(entry_key("corridors", i, "lower"), c.lower);
  require_edge(entry_key("corridors", i, "upper"), c.upper);
  if (!c.lower && !c.upper)
    throw InputError(entry_key("corridors", i, "lower"), "none", "a corridor needs an edge");
  if (!c.lower || !c.upper) return;
  require(c.lower->at_from <= c.upper->at_from, entry_key("corridors", i, "lower.at_from"),
          c.lower->at_from, "must not be above the upper edge");
  require(c.lower->at_to <= c.upper->at_to, entry_key("corridors", i, "lower.at_to"),
          c.lower->at_to, "must not be above the upper edge");
}

void require_given(const ShapeProblem& p) {
  if (p.given.empty()) return;
  const Trajectory given(p.given, p.begin);  // throws for a bad segment
  require(std::abs(given.end() - p.end) <= rounded_input * (p.end - p.begin), "given", given.end(),
          "must end at the end of the shape");
}

}  // namespace

LinearQuantity derivative_of_shape(int order) {
  assert(order >= 0 && order < static_cast<int>(quantity_names.size()));
  const auto k = static_cast<std::size_t>(order);
  LinearQuantity q{.name = quantity_names[k]};
  q.by[k] = 1;
  return q;
}

std::string name(const ShapeFigure& figure) {
  struct Name {
    std::string operator()(const PeakOf& f) const { return "peak " + f.quantity.name; }
    std::string operator()(const RmsOf& f) const { return "rms " + f.quantity.name; }
    std::string operator()(const ResidualOf&) const { return "residual"; }
    std::string operator()(const PowerOf& f) const {
      return "peak " + f.force.name + " * " + f.velocity.name;
    }
    std::string operator()(const ResponseOf& f) const { return f.name; }
    std::string operator()(const RmsResponseOf& f) const { return f.name; }
    std::string operator()(const TorqueOf& f) const { return "peak " + f.load.name; }
    std::string operator()(const RmsTorqueOf& f) const { return "rms " + f.load.name; }
    std::string operator()(const EnergyOf& f) const { return "energy of " + f.load.name; }
  };
  return std::visit(Name{}, figure);
}

void require_valid(const ShapeProblem& p) {
  require_finite("begin", p.begin);
  require_finite("end", p.end);
  require(p.end > p.begin, "end", p.end, "must be after begin");
  require(p.degree >= 2 && p.degree <= 7, "degree", p.degree, "must be 2 to 7");
  const auto pieces = static_cast<double>(p.pieces);
  require(p.pieces >= 1 && p.pieces <= 100000, "pieces", pieces, "must be 1 to 100000");
  require_valid(p.options);
  require_place(p);
  require_end("from", p.from, p.degree, p.end - p.begin);
  require_end("to", p.to, p.degree, p.end - p.begin);
  require_periodic(p);
  if (p.minimize.empty()) throw InputError("minimize", "", "must name at least one figure");
  for (std::size_t i = 0; i < p.minimize.size(); ++i) {
    require_figure(entry_key("minimize", i, "figure"), p.minimize[i].figure, p);
    const double weight = p.minimize[i].weight;
    require(std::isfinite(weight) && weight > 0, entry_key("minimize", i, "weight"), weight,
            "must be finite and > 0");
  }
  for (std::size_t i = 0; i < p.minimize.size(); ++i)
    optimize_detail::require_pointwise(entry_key("minimize", i, "figure"), p.minimize[i].figure, p);
  for (std::size_t i = 0; i < p.ceilings.size(); ++i)
    optimize_detail::require_pointwise(entry_key("ceilings", i, "figure"), p.ceilings[i].figure, p);
  for (std::size_t i = 0; i < p.corridors.size(); ++i) require_corridor(i, p.corridors[i], p);
  for (std::size_t i = 0; i < p.ceilings.size(); ++i) {
    require_figure(entry_key("ceilings", i, "figure"), p.ceilings[i].figure, p);
    const double most = p.ceilings[i].at_most;
    require(std::isfinite(most) && most >= 0, entry_key("ceilings", i, "at_most"), most,
            "must be finite and >= 0");
  }
  require_given(p);
}

}  // namespace jounce
