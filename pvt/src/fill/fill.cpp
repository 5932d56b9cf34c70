// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/fill.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "jounce/profiles/error.hpp"
#include "jounce/pvt/detail/local_velocities.hpp"

#include "pvt/src/fill/c2_velocities.hpp"
#include "pvt/src/fill/demands.hpp"
#include "pvt/src/fill/least_jerk.hpp"

namespace jounce {
namespace {

constexpr std::array names{"natural",  "clamped",          "periodic",     "not_a_knot",
                           "monotone", "shape_preserving", "minimum_jerk", "within_limits"};

using Given = std::vector<std::optional<double>>;

// ---- refusals --------------------------------------------------------------------------------

std::string key_of(const FillSpec& spec, std::size_t knot, std::size_t order) {
  const auto& words = spec.axis == Domain::time ? OverTime::names : OverMaster::names;
  return "knot[" + std::to_string(knot + 1) + "]." + words[order];
}

void require_given(const FillSpec& spec, const Given& given, std::size_t order) {
  if (given.empty()) return;
  const char* word = order == 1 ? "v" : "a";
  if (given.size() != spec.x.size())
    throw InputError(word, std::to_string(given.size()) + " values",
                     "must be one for each knot, or none: there are " +
                         std::to_string(spec.x.size()) + " knots");
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!given[i]) continue;
    if (order == 2 && spec.rule != Interpolation::quintic_hermite)
      throw InputError(key_of(spec, i, order), *given[i],
                       "only a quintic_hermite table has accelerations");
    if (!std::isfinite(*given[i]))
      throw InputError(key_of(spec, i, order), *given[i], "must be a finite number");
  }
}

bool looks_across(const FillSpec& spec) {
  if (spec.filling == Filling::periodic) return true;
  const bool can = spec.filling == Filling::monotone || spec.filling == Filling::shape_preserving ||
                   spec.filling == Filling::minimum_jerk;
  return can && repeats(spec.outside);
}

void require_equal_ends(const FillSpec& spec, const Given& given, std::size_t order) {
  if (given.empty() || !given.front() || !given.back() || *given.front() == *given.back()) return;
  throw InputError(key_of(spec, given.size() - 1, order), *given.back(),
                   "must equal that of the first knot, " + number(*given.front()) +
                       ", where the table continues");
}

void require_seam(const FillSpec& spec) {
  if (!looks_across(spec)) return;
  if (spec.outside == Extrapolation::wrap && spec.p.front() != spec.p.back())
    throw InputError(
        key_of(spec, spec.p.size() - 1, 0), spec.p.back(),
        "must be the first position, " + number(spec.p.front()) + ": a table that wraps is closed");
  require_equal_ends(spec, spec.v, 1);
  require_equal_ends(spec, spec.a, 2);
}

void require_method(const FillSpec& spec) {
  if (spec.rule == Interpolation::linear)
    throw InputError("rule", name(spec.rule), "has no velocities");
  const bool of_shape =
      spec.filling == Filling::monotone || spec.filling == Filling::shape_preserving;
  if (of_shape && spec.rule != Interpolation::cubic_hermite)
    throw InputError("rule", name(spec.rule),
                     std::string(name(spec.filling)) + " velocities need cubic_hermite");
  if (spec.filling != Filling::within_limits) return;
  require_valid(spec.limits);
  if (!spec.limits.velocity && !spec.limits.acceleration && !spec.limits.jerk)
    throw InputError("limits", "",
                     "are missing: within_limits needs a limit of velocity, acceleration or jerk");
}

/// Requires valid knots: the constructor of a linear Table through them throws otherwise.
void require_knots(const FillSpec& spec) {
  (void)Table(spec.axis, Interpolation::linear, spec.outside, {spec.x, spec.p, {}, {}});
}

// ---- input of every method -------------------------------------------------------------------

struct Pieces {
  std::vector<double> length, chord;

  explicit Pieces(const FillSpec& spec) {
    const std::size_t last = spec.x.size() - 1;
    length.resize(last);
    chord.resize(last);
    for (std::size_t i = 0; i < last; ++i) {
      length[i] = spec.x[i + 1] - spec.x[i];
      chord[i] = (spec.p[i + 1] - spec.p[i]) / length[i];
    }
  }
  [[nodiscard]] pvt_detail::Chords view() const { return {length, chord}; }
};

bool is_given(const Given& given, std::size_t i) {
  return !given.empty() && given[i].has_value();
}

/// Copies a given value from one end of a periodic table to the other.
Given both_ends(Given given) {
  if (given.empty()) return given;
  if (!given.front()) given.front() = given.back();
  given.back() = given.front();
  return given;
}

void keep(const Given& given, std::span<double> v) {
  for (std::size_t i = 0; i < given.size(); ++i)
    if (given[i]) v[i] = *given[i];
}

// ---- splines with continuous acceleration ----------------------------------------------------

using pvt_detail::EndRow;

EndRow open_end(std::span<const double> x, std::span<const double> p, Filling ends, bool at_start) {
  const std::size_t last = x.size() - 1;
  const auto chord = [&](std::size_t i) { return (p[i + 1] - p[i]) / (x[i + 1] - x[i]); };
  const std::size_t i = at_start ? 0 : last - 1;
  if (ends == Filling::clamped) return pvt_detail::given_end(0);
  if (ends != Filling::not_a_knot || last < 2) return pvt_detail::natural_end(chord(i));
  const std::size_t j = at_start ? 1 : last - 2;
  return pvt_detail::not_a_knot_end(x[i + 1] - x[i], chord(i), x[j + 1] - x[j], chord(j));
}

/// Three points: both conditions at the ends require the parabola.
void parabola(std::span<const double> x, std::span<const double> p, std::span<double> v) {
  const double h0 = x[1] - x[0], h1 = x[2] - x[1];
  const double d0 = (p[1] - p[0]) / h0, d1 = (p[2] - p[1]) / h1;
  v[1] = (h1 * d0 + h0 * d1) / (h0 + h1);
  v[0] = 2 * d0 - v[1];
  v[2] = 2 * d1 - v[1];
}

/// Given velocities divide the table into separate splines.
void spline_between(const FillSpec& spec, const Given& given, Filling ends, std::span<double> v) {
  const std::span<const double> x = spec.x, p = spec.p;
  const std::size_t last = x.size() - 1;
  const EndRow first_open = open_end(x, p, ends, true), last_open = open_end(x, p, ends, false);
  for (std::size_t from = 0, to = 0; from < last; from = to) {
    do ++to;
    while (to < last && !is_given(given, to));
    const std::size_t count = to - from + 1;
    c2_velocities(x.subspan(from, count), p.subspan(from, count),
                  is_given(given, from) ? pvt_detail::given_end(*given[from]) : first_open,
                  is_given(given, to) ? pvt_detail::given_end(*given[to]) : last_open,
                  v.subspan(from, count));
  }
}

bool any_given(const Given& given) {
  return std::any_of(given.begin(), given.end(), [](const auto& each) { return each.has_value(); });
}

/// A periodic table with given velocities is divided at the first of them.
void spline_around(const FillSpec& spec, const Given& given, std::span<double> v) {
  const std::size_t last = spec.x.size() - 1;
  std::size_t cut = 0;
  while (!is_given(given, cut)) ++cut;
  FillSpec turned;
  Given turned_given;
  for (std::size_t k = 0; k <= last; ++k) {
    const bool wrapped = cut + k > last;
    const std::size_t i = wrapped ? cut + k - last : cut + k;
    turned.x.push_back(spec.x[i] + (wrapped ? spec.x[last] - spec.x[0] : 0));
    turned.p.push_back(spec.p[i] + (wrapped ? spec.p[last] - spec.p[0] : 0));
    turned_given.push_back(given[i]);
  }
  std::vector<double> found(last + 1);
  spline_between(turned, turned_given, Filling::natural, found);
  for (std::size_t k = 0; k < last; ++k) v[(cut + k) % last] = found[k];
  v[last] = v[0];
}

void spline(const FillSpec& spec, const Given& given, Filling ends, std::span<double> v) {
  if (ends == Filling::periodic && any_given(given)) return spline_around(spec, given, v);
  if (!any_given(given)) return spline_velocities(spec.x, spec.p, ends, v);
  spline_between(spec, given, ends, v);
}

// ---- velocities with demands -----------------------------------------------------------------

void add(Report& report, const FillSpec& spec, const char* rule, std::size_t piece, double value,
         double limit, bool broken, std::string advice) {
  Finding finding;
  finding.rule = rule;
  finding.quantity = broken ? "interval" : "velocity";
  finding.where = spec.x[piece];
  finding.value = value;
  finding.limit = limit;
  finding.margin = broken ? value / limit - 1 : 0;
  finding.broken = broken;
  finding.segment = piece;
  finding.advice = std::move(advice);
  finding.severity = broken ? Severity::required : Severity::warning;
  report.findings.push_back(std::move(finding));
}

/// Reports the pieces that turn against their chord because of given velocities or of the joint
/// between two periods.
void report_turning_back(const FillSpec& spec, const Pieces& pieces, std::span<const double> v,
                         Report& report) {
  for (std::size_t i = 0; i < pieces.chord.size(); ++i) {
    const double d = pieces.chord[i];
    if (pvt_detail::is_monotone(d, v[i], v[i + 1])) continue;
    const double worse = std::abs(v[i] - d) > std::abs(v[i + 1] - d) ? v[i] : v[i + 1];
    add(report, spec, "fill/monotone", i, worse, 3 * d, false,
        "the velocities at both knots may be between 0 and this limit");
  }
}

void fix(const Given& given, std::vector<pvt_detail::Gap>& gaps) {
  for (std::size_t i = 0; i < given.size(); ++i)
    if (given[i]) gaps[i] = {*given[i], *given[i]};
}

/// The error of each chord by rounding of the positions.
std::vector<double> rounding_of(const FillSpec& spec, const Pieces& pieces) {
  std::vector<double> all(pieces.chord.size());
  constexpr double epsilon = 4 * std::numeric_limits<double>::epsilon();
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = epsilon * ((std::abs(spec.p[i]) + std::abs(spec.p[i + 1])) / pieces.length[i] +
                        2 * std::abs(pieces.chord[i]));
  return all;
}

void preserve_shape(const FillSpec& spec, const Pieces& pieces, const Given& given,
                    std::span<double> v, Report& report) {
  const bool around = looks_across(spec);
  spline(spec, given, around ? Filling::periodic : Filling::natural, v);
  std::vector<pvt_detail::Gap> gaps = pvt_detail::monotone_gaps(pieces.view(), around);
  fix(given, gaps);
  // Chooses the velocity at the joint between two periods first: follow() requires an open chain.
  if (around) {
    const double seam = std::clamp(v[0], gaps[0].lo, gaps[0].hi);
    gaps.front() = gaps.back() = {seam, seam};
  }
  const std::vector<double> rounding = rounding_of(spec, pieces);
  const std::vector<pvt_detail::Turn> turns = turns_of(pieces.view(), rounding, around);
  const auto demand = [&](std::size_t i) {
    return pvt_detail::turning(turns[i], pieces.chord[i], rounding[i]);
  };
  const pvt_detail::Corridor way = pvt_detail::corridor(std::move(gaps), demand);
  pvt_detail::follow(way, demand, v);
  for (const std::size_t i : way.closed)
    add(report, spec, "fill/convex", i, v[i], pieces.chord[i], false, "add a knot there");
  if (any_given(given)) report_turning_back(spec, pieces, v, report);
}

/// A bound for velocities that have no other limit.
double far_beyond(const FillSpec& spec, const Pieces& pieces) {
  if (spec.limits.velocity) return *spec.limits.velocity;
  double most = 0;
  for (const double d : pieces.chord) most = std::max(most, std::abs(d));
  return 1000 * most;
}

std::string advice_for(double stretch, double length) {
  return std::isfinite(stretch)
             ? "give the piece a length of " + number(stretch * length) + " at least"
             : "no length is sufficient: give other velocities";
}

/// The limits, reduced by the error of acceleration and jerk that rounding of a piece's positions
/// causes.
Limits less_rounding(const FillSpec& spec, std::size_t i, double h) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double rounding = epsilon * std::max(std::abs(spec.p[i]), std::abs(spec.p[i + 1]));
  Limits limits = spec.limits;
  const auto lower = [](std::optional<double>& limit, double by) {
    if (limit) *limit -= std::min(by, *limit / 2);
  };
  lower(limits.acceleration, 24 * rounding / (h * h));
  lower(limits.jerk, 48 * rounding / (h * h * h));
  return limits;
}

void keep_limits(const FillSpec& spec, const Pieces& pieces, std::span<double> v, Report& report) {
  const double bound = far_beyond(spec, pieces);
  std::vector<pvt_detail::Gap> gaps(v.size(), {-bound, bound});
  gaps.front() = gaps.back() = {0, 0};
  fix(spec.v, gaps);
  spline(spec, spec.v, Filling::clamped, v);
  const auto demand = [&](std::size_t i) {
    const double h = pieces.length[i];
    return pvt_detail::within_limits(less_rounding(spec, i, h), h, pieces.chord[i]);
  };
  const std::vector<pvt_detail::Gap> before = gaps;
  const pvt_detail::Corridor way = pvt_detail::corridor(std::move(gaps), demand);
  pvt_detail::follow(way, demand, v);
  for (const std::size_t i : way.closed) {
    const double h = pieces.length[i];
    const double stretch =
        pvt_detail::needed_stretch(spec.limits, h, pieces.chord[i], way.gaps[i], before[i + 1]);
    add(report, spec, "fill/limits", i, h, stretch * h, true, advice_for(stretch, h));
  }
}

// ---- all together ----------------------------------------------------------------------------

std::vector<pvt_detail::JerkKnot> jerk_knots(const Given& v, const Given& a, std::size_t size) {
  std::vector<pvt_detail::JerkKnot> knots(size);
  for (std::size_t i = 0; i < size; ++i) {
    knots[i].fixed = {is_given(v, i), is_given(a, i)};
    if (knots[i].fixed[0]) knots[i].state[0] = *v[i];
    if (knots[i].fixed[1]) knots[i].state[1] = *a[i];
  }
  return knots;
}

void least_jerk(const FillSpec& spec, const Given& given, Columns& columns) {
  const std::size_t size = spec.x.size();
  std::vector<pvt_detail::JerkKnot> knots = jerk_knots(given, spec.a, size);
  pvt_detail::least_jerk(spec.x, spec.p, looks_across(spec), knots);
  if (spec.rule == Interpolation::quintic_hermite) columns.a.resize(size);
  for (std::size_t i = 0; i < size; ++i) {
    columns.v[i] = knots[i].state[0];
    if (spec.rule == Interpolation::quintic_hermite) columns.a[i] = knots[i].state[1];
  }
}

void choose_velocities(const FillSpec& spec, const Given& given, Columns& columns, Report& report) {
  switch (spec.filling) {
    case Filling::natural:
    case Filling::clamped:
    case Filling::periodic:
    case Filling::not_a_knot:
      return spline(spec, given, spec.filling, columns.v);
    case Filling::monotone: {
      const Pieces pieces(spec);
      pvt_detail::monotone_velocities(pieces.view(), looks_across(spec), columns.v);
      keep(given, columns.v);
      if (any_given(given)) report_turning_back(spec, pieces, columns.v, report);
      return;
    }
    case Filling::shape_preserving:
      return preserve_shape(spec, Pieces(spec), given, columns.v, report);
    case Filling::within_limits:
      return keep_limits(spec, Pieces(spec), columns.v, report);
    case Filling::minimum_jerk:
      return least_jerk(spec, given, columns);
  }
}

/// True if all velocities are given.
bool is_complete(const FillSpec& spec) {
  const bool is_spline =
      spec.filling <= Filling::not_a_knot && spec.rule == Interpolation::cubic_hermite;
  return is_spline && spec.v.size() == spec.x.size() &&
         std::all_of(spec.v.begin(), spec.v.end(), [](const auto& v) { return v.has_value(); });
}

}  // namespace

const char* name(Filling filling) {
  return names.at(static_cast<std::size_t>(filling));
}

std::optional<Filling> filling_named(std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Filling>(found - names.begin());
}

Filled filled(const FillSpec& spec) {
  require_knots(spec);
  require_method(spec);
  require_given(spec, spec.v, 1);
  require_given(spec, spec.a, 2);
  require_seam(spec);
  Columns columns{spec.x, spec.p, std::vector<double>(spec.x.size()), {}};
  Report report;
  if (is_complete(spec))  // a recording with millions of rows: nothing else is stored
    std::transform(spec.v.begin(), spec.v.end(), columns.v.begin(),
                   [](const auto& v) { return *v; });
  else
    choose_velocities(spec, looks_across(spec) ? both_ends(spec.v) : spec.v, columns, report);
  if (spec.rule == Interpolation::quintic_hermite && spec.filling != Filling::minimum_jerk)
    least_jerk(spec, Given(columns.v.begin(), columns.v.end()), columns);
  sort(report);
  return {Table(spec.axis, spec.rule, spec.outside, std::move(columns)), std::move(report)};
}

void spline_velocities(std::span<const double> x, std::span<const double> p, Filling ends,
                       std::span<double> v) {
  assert(ends <= Filling::not_a_knot);
  if (x.size() < 2)
    throw InputError("x", std::to_string(x.size()) + " entries", "must have at least 2");
  require_size("p", p.size(), x.size());
  require_size("v", v.size(), x.size());
  if (ends == Filling::periodic) return pvt_detail::c2_periodic_velocities(x, p, v);
  if (ends == Filling::not_a_knot && x.size() == 3) return parabola(x, p, v);
  pvt_detail::c2_velocities(x, p, open_end(x, p, ends, true), open_end(x, p, ends, false), v);
}

}  // namespace jounce
