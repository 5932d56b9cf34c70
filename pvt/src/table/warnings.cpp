// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/warnings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/pvt/check.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_value;

/// The slopes at both ends; one that is only rounding beside the other is 0.
std::array<double, 2> end_slopes(const Segment& f) {
  std::array slopes{evaluate(f, 0)[1], evaluate(f, 1)[1]};
  const double scale = std::max(std::abs(slopes[0]), std::abs(slopes[1]));
  for (double& slope : slopes)
    if (std::abs(slope) <= rounded_input * scale) slope = 0;
  return slopes;
}

/// A cubic from slope a to slope b over a chord of slope m stays between its ends if
/// 0 <= a/m, b/m <= 3. `unit`: unit of the velocity.
std::string advice_against_overshoot(const Segment& f, const std::string& unit) {
  if (f.sines > 0 || f.degree > 3) return "move the knots, or lower their velocities";
  const auto [a, b] = end_slopes(f);
  const double mean = (value(f, 1) - value(f, 0)) / f.length;
  const std::string of_unit = unit.empty() ? "" : " " + unit;
  const std::string ends = "the velocity is " + six_digits(a) + of_unit +
                           " at the start of the segment and " + six_digits(b) + of_unit +
                           " at its end, on average " + six_digits(mean) + of_unit + ": ";
  if (mean == 0) return ends + "let both velocities be 0";
  return ends + "the segment does not overshoot if both velocities are between 0 and " +
         six_digits(3 * mean) + of_unit;
}

/// The end of the segment's range that lies further beyond its knots.
std::optional<Finding> overshoot_of(const Segment& f, const Range& range, double least,
                                    const std::string& unit) {
  const double first = value(f, 0);
  const double last = value(f, 1);
  const double above = range.max.value - std::max(first, last);
  const double below = std::min(first, last) - range.min.value;
  if (std::max(above, below) <= least) return std::nullopt;
  const Extremum& reached = above >= below ? range.max : range.min;
  Finding found;
  found.rule = "warning/overshoot";
  found.quantity = "position";
  found.where = reached.where;
  found.value = reached.value;
  found.limit = above >= below ? std::max(first, last) : std::min(first, last);
  found.margin = -std::max(above, below);
  const auto [a, b] = end_slopes(f);
  const bool turns = a * b < 0;
  found.severity = turns ? Severity::note : Severity::warning;
  if (!turns) found.advice = advice_against_overshoot(f, unit);
  return found;
}

template <class Over>
Finding step_of(const char* rule, double where, double step, double scale, std::size_t segment) {
  Finding found;
  found.rule = rule;
  found.quantity = std::string("step of ") + Over::names[1];
  found.where = where;
  found.value = step;
  found.margin = -std::abs(step) / scale;
  found.segment = segment;
  found.severity = Severity::warning;
  found.has_limit = false;
  return found;
}

template <class Over>
Finding end_of(const auto& f, double velocity, double scale) {
  const std::size_t last = f.breaks().size() - 2;
  Finding found = step_of<Over>("pt/end_velocity", f.end(), velocity, scale, last);

  if (f.outside() == Extrapolation::hold) {
    found.advice =
        "the table ends at a nonzero velocity, so the axis stops abruptly: let the last segment "
        "end at rest";
  } else {
    found.severity = Severity::note;
    found.advice =
        "the table ends at a nonzero velocity: another motion must continue at this velocity";
  }
  found.quantity = Over::names[1];
  return found;
}

/// The input that is checked segment by segment: a curve, or a table without making its curve.
template <class Over>
struct CurveSegments {
  const Curve<Over>& f;
  [[nodiscard]] const Segment& segment(std::size_t i) const { return f.segments()[i]; }
  [[nodiscard]] Range range(std::size_t i) const { return segment_range(f, i, 0); }
  [[nodiscard]] static bool surely_between_ends(std::size_t, double) { return false; }
  [[nodiscard]] static bool velocity_is_continuous() { return false; }
};

struct TableSegments {
  const Table& f;
  [[nodiscard]] Segment segment(std::size_t i) const { return f.segment(i); }
  [[nodiscard]] Range range(std::size_t i) const {
    return segment_range(f.segment(i), f.breaks()[i], f.breaks()[i + 1], 0);
  }
  /// A polynomial stays between its least and greatest Bernstein coefficient. `least`: the smallest
  /// excess that counts; half of it is left for the rounding of the coefficients.
  [[nodiscard]] bool surely_between_ends(std::size_t i, double least) const {
    const auto& [x, p, v, a] = f.columns();
    const double low = std::min(p[i], p[i + 1]) - least / 2;
    const double high = std::max(p[i], p[i + 1]) + least / 2;
    const auto between = [&](double b) { return low <= b && b <= high; };
    const double h = x[i + 1] - x[i];
    switch (f.rule()) {
      case Interpolation::linear:
        return true;
      case Interpolation::cubic_hermite:
        return between(p[i] + h / 3 * v[i]) && between(p[i + 1] - h / 3 * v[i + 1]);
      case Interpolation::quintic_hermite:
        break;
    }
    const double bend = h * h / 20;
    return between(p[i] + h / 5 * v[i]) && between(p[i] + 2 * h / 5 * v[i] + bend * a[i]) &&
           between(p[i + 1] - h / 5 * v[i + 1]) &&
           between(p[i + 1] - 2 * h / 5 * v[i + 1] + bend * a[i + 1]);
  }
  [[nodiscard]] bool velocity_is_continuous() const { return f.rule() != Interpolation::linear; }
};

Report overshoots_in(const auto& segments, const Range& travel, const std::string& unit,
                     double tolerance) {
  const double stroke = travel.max.value - travel.min.value;
  // An excess below the rounding of the positions cannot be detected.
  const double least = std::max(tolerance * stroke, rounded_value * std::abs(travel.peak().value));
  Report report;
  for (std::size_t i = 0; i + 1 < segments.f.breaks().size(); ++i) {
    if (segments.surely_between_ends(i, least)) continue;
    auto found = overshoot_of(segments.segment(i), segments.range(i), least, unit);
    if (!found) continue;
    found->segment = i;
    found->margin /= stroke;
    report.findings.push_back(std::move(*found));
  }
  sort(report);
  return report;
}

template <class Over>
Report steps_of(const auto& segments, double scale, double tolerance) {
  const auto& f = segments.f;
  const std::size_t count = f.breaks().size() - 1;
  Report report;
  const auto is_step = [&](double step) { return std::abs(step) > tolerance * scale; };
  const auto add = [&](const char* rule, double where, double step, std::size_t segment,
                       const char* advice) {
    if (!is_step(step)) return;
    report.findings.push_back(step_of<Over>(rule, where, step, scale, segment));
    report.findings.back().advice = advice;
  };
  const auto begin = [&](std::size_t i) { return evaluate(segments.segment(i), 0)[1]; };
  const auto end = [&](std::size_t i) { return evaluate(segments.segment(i), 1)[1]; };
  const char* infinite =
      "the step needs an infinite acceleration: let the velocities on both sides of the point be "
      "equal";
  if (f.outside() == Extrapolation::hold) add("pt/velocity_step", f.start(), begin(0), 0, infinite);
  for (std::size_t i = 1; i < count && !segments.velocity_is_continuous(); ++i)
    add("pt/velocity_step", f.breaks()[i], begin(i) - end(i - 1), i, infinite);
  const double last = end(count - 1);
  if (repeats(f.outside()))
    add("pt/wrap", f.end(), begin(0) - last, 0,
        "the velocity steps from each pass to the next: let the table end at the velocity of its "
        "start");
  else if (is_step(last))
    report.findings.push_back(end_of<Over>(f, last, scale));
  sort(report);
  return report;
}

}  // namespace

template <class Over>
Report overshoot(const Curve<Over>& f, const std::string& unit, double tolerance) {
  return overshoots_in(CurveSegments<Over>{f}, extrema(f, 0), unit, tolerance);
}

Report overshoot(const Table& table, const std::string& unit, double tolerance) {
  return overshoots_in(TableSegments{table}, extrema(table)[0], unit, tolerance);
}

template <class Over>
Report velocity_steps(const Curve<Over>& f, double tolerance) {
  return steps_of<Over>(CurveSegments<Over>{f}, std::abs(extrema(f, 1).peak().value), tolerance);
}

Report velocity_steps(const Table& table, double tolerance) {
  const double scale = std::abs(extrema(table)[1].peak().value);
  return table.axis() == Domain::time
             ? steps_of<OverTime>(TableSegments{table}, scale, tolerance)
             : steps_of<OverMaster>(TableSegments{table}, scale, tolerance);
}

#define JOUNCE_INSTANTIATE(Over)                                             \
  template Report overshoot(const Curve<Over>&, const std::string&, double); \
  template Report velocity_steps(const Curve<Over>&, double);
JOUNCE_INSTANTIATE(OverTime)
JOUNCE_INSTANTIATE(OverMaster)
#undef JOUNCE_INSTANTIATE

}  // namespace jounce
