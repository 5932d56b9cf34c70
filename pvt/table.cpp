#include "jounce/pvt/table.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

std::string entry(const char* column, std::size_t knot) {
  return std::string("knot[") + std::to_string(knot) + "]." + column;
}

void require_column(const char* column, const std::vector<double>& values, std::size_t knots,
                    bool needed, Rule rule) {
  const std::size_t expected = needed ? knots : 0;
  if (values.size() != expected)
    throw InputError(std::string("column ") + column, std::to_string(values.size()) + " values",
                     std::string("a ") + name(rule) + " table of " + std::to_string(knots) +
                         " knots needs " + std::to_string(expected));
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw InputError(entry(column, i), values[i], "must be a finite number");
}

}  // namespace

Table::Table(Axis axis, Rule rule, Outside outside, Columns columns)
    : axis_(axis), rule_(rule), outside_(outside), columns_(std::move(columns)) {
  const std::size_t knots = columns_.x.size();
  if (knots < 2) throw InputError("knots", std::to_string(knots), "a table needs at least two");
  require_column("x", columns_.x, knots, true, rule);
  require_column("p", columns_.p, knots, true, rule);
  require_column("v", columns_.v, knots, rule != Rule::linear, rule);
  require_column("a", columns_.a, knots, rule == Rule::quintic_hermite, rule);
  for (std::size_t i = 1; i < knots; ++i)
    if (!(columns_.x[i] > columns_.x[i - 1]))
      throw InputError(entry("x", i), columns_.x[i],
                       "must be greater than " + number(columns_.x[i - 1]) + ", the knot before");
}

Segment Table::segment(std::size_t i) const {
  assert(i + 1 < size());
  const auto& [x, p, v, a] = columns_;
  const double length = x[i + 1] - x[i];
  switch (rule_) {
    case Rule::linear:
      return line(length, p[i], p[i + 1]);
    case Rule::cubic_hermite:
      return cubic(length, p[i], v[i], p[i + 1], v[i + 1]);
    case Rule::quintic_hermite:
      break;
  }
  return quintic(length, p[i], v[i], a[i], p[i + 1], v[i + 1], a[i + 1]);
}

Jet Table::jet(double x, Side side) const {
  double at = x;
  if (x < start() || x > end() ||
      (x == end() && side == Side::right && outside_ == Outside::wrap)) {
    assert(outside_ != Outside::refuse && "query outside a table that refuses it");
    if (outside_ != Outside::wrap)
      return {x < start() ? columns_.p.front() : columns_.p.back(), 0, 0, 0};
    at = wrapped(x, start(), length());
    if (side == Side::left && at == start()) at = end();
  }
  const auto first = columns_.x.begin() + 1;
  const auto last = columns_.x.end() - 1;
  const auto it =
      side == Side::right ? std::upper_bound(first, last, at) : std::lower_bound(first, last, at);
  const auto i = static_cast<std::size_t>(it - first);
  const Segment f = segment(i);
  return evaluate(f, std::clamp((at - columns_.x[i]) / f.length, 0.0, 1.0));
}

template <class Over>
Curve<Over> Table::curve() const {
  constexpr Axis wanted = std::is_same_v<Over, OverTime> ? Axis::time : Axis::master;
  if (axis_ != wanted)
    throw InputError("axis", name(axis_),
                     std::string("a table over ") + name(wanted) + " is needed here");
  std::vector<Segment> segments;
  segments.reserve(size() - 1);
  for (std::size_t i = 0; i + 1 < size(); ++i) segments.push_back(segment(i));
  return Curve<Over>(std::move(segments), start(), outside_);
}

template Curve<OverTime> Table::curve() const;
template Curve<OverMaster> Table::curve() const;

const char* name(Rule rule) {
  switch (rule) {
    case Rule::linear:
      return "linear";
    case Rule::cubic_hermite:
      return "cubic_hermite";
    case Rule::quintic_hermite:
      break;
  }
  return "quintic_hermite";
}

const char* name(Axis axis) {
  return axis == Axis::time ? "time" : "master";
}

const char* name(Outside outside) {
  switch (outside) {
    case Outside::refuse:
      return "refuse";
    case Outside::hold:
      return "hold";
    case Outside::wrap:
      break;
  }
  return "wrap";
}

}  // namespace jounce
