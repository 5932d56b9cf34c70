// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>

#include "jounce/profiles/curve/between.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/pvt/position_compare.hpp"

namespace jounce {
namespace {

std::string point(std::size_t i) {
  return "point " + std::to_string(i + 1);
}

/// The finding for the pair of events whose velocity in between is the highest share of the
/// permitted one.
Finding speed(const std::vector<CompareEvent>& events, const Trajectory& motion, double frequency) {
  Finding worst;
  worst.margin = 2;
  for (std::size_t i = 1; i < events.size(); ++i) {
    const double most = std::abs(events[i].position - events[i - 1].position) * frequency;
    if (!(events[i].time > events[i - 1].time)) continue;
    const Extremum peak = extrema(between(motion, events[i - 1].time, events[i].time), 1).peak();
    const double margin = most > 0 ? 1 - std::abs(peak.value) / most : -1;
    if (margin >= worst.margin) continue;
    worst = {.rule = "compare/speed",
             .axis = {},
             .quantity = "velocity",
             .where = peak.where,
             .value = peak.value,
             .limit = std::copysign(most, peak.value),
             .margin = margin,
             .broken = margin <= 0,
             .segment = {},
             .advice = margin <= 0 ? "pass the points more slowly, or move " +
                                         point(events[i].point) + " further from the previous one"
                                   : ""};
  }
  return worst;
}

/// `next`: position of the point that does not fire. `remedy`: what to do about it.
Finding missed(std::size_t fired, std::size_t points, const std::string& next,
               const Trajectory& motion, const std::string& remedy) {
  const bool broken = fired < points;
  return {.rule = "compare/missed",
          .axis = {},
          .quantity = "points",
          .where = motion.end(),
          .value = static_cast<double>(fired),
          .limit = static_cast<double>(points),
          .margin = broken ? static_cast<double>(fired) / static_cast<double>(points) - 1 : 0,
          .broken = broken,
          .segment = {},
          .advice = broken ? point(fired) + " at " + next +
                                 (fired == 0 ? " is never passed"
                                             : " is not passed between " + point(fired - 1) +
                                                   " and the end of the motion") +
                                 (fired + 1 < points ? ", and blocks the following points" : "") +
                                 remedy
                           : "",
          .unit = "1"};
}

/// " mm"; "" without a unit.
std::string unit_text(const std::string& unit) {
  return unit.empty() ? "" : " " + unit;
}

/// The remedy for a point that does not fire: where the motion passes.
std::string remedy_for(double position, const Trajectory& motion, const std::string& unit) {
  const Range all = extrema(motion, 0);
  const double least = all.min.value;
  const double most = all.max.value;
  if (position >= least && position <= most)
    return ": give the points in the order and direction in which the motion passes them";
  return "; the motion goes from " + six_digits(least) + " to " + six_digits(most) +
         unit_text(unit) + ": leave out the points outside, or extend the motion";
}

}  // namespace

Report check(const PlaneCompare& compare, const Trajectory& x, const Trajectory& y,
             const std::string& unit) {
  const std::size_t fired = compared(compare, x, y).size();
  std::string next;
  if (fired < compare.points.size())
    next = "(" + number(compare.points[fired].x) + ", " + number(compare.points[fired].y) + ")" +
           unit_text(unit);
  return {{missed(fired, compare.points.size(), next, x,
                  ": widen its band, or let the motion pass through it")}};
}

Report check(const PositionCompare& compare, const Trajectory& motion, const CompareDevice& device,
             const std::string& unit) {
  require_not_negative("sampling_frequency", device.sampling_frequency);
  require_not_negative("latency", device.latency);
  const Compared all = compared(compare, motion);
  Report report;
  const std::size_t fired = all.events.size();
  const bool misses = fired < compare.points.size();
  const double next = misses ? compare.points[fired].position : 0;
  report.findings.push_back(missed(fired, compare.points.size(), number(next) + unit_text(unit),
                                   motion, misses ? remedy_for(next, motion, unit) : ""));
  if (device.sampling_frequency > 0 && all.events.size() > 1)
    report.findings.push_back(speed(all.events, motion, device.sampling_frequency));
  for (std::size_t i = 1; i < all.events.size() && compare.pulse > 0; ++i) {
    const double gap = all.events[i].time - all.events[i - 1].time;
    if (gap > compare.pulse) continue;
    report.findings.push_back({.rule = "compare/merged",
                               .axis = {},
                               .quantity = "time",
                               .where = all.events[i].time,
                               .value = gap,
                               .limit = compare.pulse,
                               .margin = gap / compare.pulse - 1,
                               .broken = false,
                               .segment = {},
                               .advice = "the pulses of " + point(all.events[i - 1].point) +
                                         " and the next are one: shorten them",
                               .where_unit = {},
                               .severity = Severity::warning});
    break;
  }
  const double delay =
      device.latency + (device.sampling_frequency > 0 ? 1 / device.sampling_frequency : 0);
  const auto fastest = std::max_element(
      all.events.begin(), all.events.end(),
      [](const auto& a, const auto& b) { return std::abs(a.velocity) < std::abs(b.velocity); });
  if (delay > 0 && fastest != all.events.end())
    report.findings.push_back({.rule = "compare/latency",
                               .axis = {},
                               .quantity = "position",
                               .where = fastest->time,
                               .value = std::abs(fastest->velocity) * delay,
                               .limit = 0,
                               .margin = 0,
                               .broken = false,
                               .segment = {},
                               .advice = {},
                               .unit = {},
                               .where_unit = {},
                               .severity = Severity::note,
                               .has_limit = false});
  sort(report);
  return report;
}

}  // namespace jounce
