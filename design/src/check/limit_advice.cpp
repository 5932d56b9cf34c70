// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/limit_advice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

#include "jounce/base/units.hpp"
#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/pvt/detail/knot_rounding.hpp"

#include "design/src/check/cam_limit_advice.hpp"
#include "design/src/check/stretch.hpp"
#include "design/src/input/excursions.hpp"

namespace jounce {

using design_detail::begins_beyond;
using design_detail::impossibility;
using design_detail::least_length;
using design_detail::least_peaks;
using design_detail::order_of;
using design_detail::rest;
using design_detail::Stretch;
using design_detail::stretch_between;
using design_detail::stretch_of;
using design_detail::Words;

namespace {

/// The part of a cam over the segment of a spec whose index the finding has.
Stretch stretch_of(const CamDesign& cam, const CamSpec& spec, const Finding& finding,
                   std::size_t order) {
  const std::size_t i = std::min(*finding.segment, spec.segments.size() - 1);
  const double x0 = i == 0 ? spec.start.master : spec.segments[i - 1].end.master;
  return stretch_between(cam.cam, x0, spec.segments[i].end.master, finding, order);
}

/// Why no law keeps the limit, with the least length for the best law.
std::string impossible(const Finding& f, std::size_t order, const Stretch& s, const Words& words,
                       const std::string& who) {
  const std::string why = impossibility(f, order, s, words, who);
  const double k = static_cast<double>(order);
  const double least = std::pow(least_peaks[order] * std::abs(s.stroke / f.limit), 1 / k);
  return why.empty() ? ""
                     : why + "Lengthen the segment to more than " + words.at_least(least) +
                           ", or raise the limit";
}

constexpr std::array coefficients{"", "velocity", "acceleration", "jerk"};

std::string cam_advice(const Finding& f, std::size_t order, const Stretch& s, const Words& words) {
  if (std::string text = impossible(f, order, s, words, "the segment"); !text.empty()) return text;
  return fmt::format("lengthen the segment{}, or raise the limit",
                     s.scales() ? " to at least " + words.at_least(least_length(f, order, s)) : "");
}

/// The advice for a table of points with velocities (kind "pvt").
std::string points_advice(const Finding& f, std::size_t order, const Stretch& s, const Words& words,
                          const std::optional<double>& velocity) {
  const double mean = s.stroke / s.length;
  if (order == 1 && std::abs(mean) > std::abs(f.limit))
    return fmt::format(
        "the segment moves {} in {}: its mean velocity is {}, above the limit {}. Give the segment "
        "more than {}, or raise the limit",
        words.of(std::abs(s.stroke), 0), words.x(s.length), words.of(std::abs(mean), 1),
        words.limit(std::abs(f.limit), 1), words.at_least(std::abs(s.stroke / f.limit)));
  if (order == 1 && s.at_end)
    return fmt::format(
        "the point at {} has the velocity {}: {} {}", words.x(f.where), words.of(f.value, 1),
        f.limit > 0 ? "lower it to at most" : "raise it to at least", words.limit(f.limit, 1));
  const std::string closer = fmt::format(
      "bring the velocities of its two points closer to {}, the mean velocity of the segment",
      words.of(mean, 1));
  if (order == 1) return closer;
  return velocity && std::abs(mean) > *velocity
             ? "give the segment more time, or raise the limit"
             : closer + ", or give the segment more time and lower velocities";
}

/// The advice for two points that are so close that the rounding of their numbers breaks the limit; "" if
/// it does not.
std::string rounding_advice(const Finding& f, std::size_t order, const Input& input) {
  const Table& table = input.table.table;
  const auto& x = table.columns().x;
  if (*f.segment + 1 >= x.size()) return "";
  const double error = pvt_detail::KnotRounding(table).of(order, *f.segment);
  if (std::abs(f.value - f.limit) > error) return "";
  const Words words{input.labels};
  return fmt::format(
      "its two points are {} apart, so the rounding of their numbers causes up to {}. Remove one "
      "of "
      "them",
      words.x(x[*f.segment + 1] - x[*f.segment]), words.of(error, order));
}

/// The advice for a motion that a generator makes from its velocity, acceleration and jerk.
std::string motion_advice(const Finding& f, std::size_t order, const Words& words) {
  return fmt::format("lower the {} of the motion to at most {}, or raise the limit",
                     coefficients[order], words.limit(std::abs(f.limit), order));
}

/// The advice for a table from a file.
std::string table_advice(const Finding& f, std::size_t order, double length, const Words& words) {
  const double slower = std::pow(std::abs(f.value / f.limit), 1.0 / static_cast<double>(order));
  return fmt::format("slow the whole motion down, from {} to at least {}, or raise the limit",
                     words.x(length), words.at_least(length * slower));
}

/// The advice for a limit of the position over time.
std::string position_advice(const Input& input, const Finding& f) {
  if (begins_beyond(std::get<Trajectory>(*input.curve), f))
    return "the motion begins outside the position range: move its start, or widen the range";
  if (!input.spec) return "shift or shorten the motion, or widen the range";
  if (!std::holds_alternative<Table>(input.spec->subject) || !input.spec->then.empty())
    return "move the target into the position range, or widen the range";
  const Trajectory& curve = std::get<Trajectory>(*input.curve);
  if (stretch_of(curve, input.labels, f, 0).at_end)
    return "move this point into the position range, or widen the range";
  return "the curve leaves the range between two points: lower the velocities of these points";
}

std::string over_time(const Input& input, const Finding& f, std::size_t order) {
  const Words words{input.labels};
  const Table& table = input.table.table;
  if (!input.spec) return table_advice(f, order, table.end() - table.start(), words);
  if (input.plan || input.overlap) return f.advice;
  const bool filled = input.spec->document.places.contains("velocities");
  if (std::holds_alternative<TimeTableSpec>(input.spec->subject) || filled)
    return "give the segment more time, or raise the limit";
  if (!std::holds_alternative<Table>(input.spec->subject) || !input.spec->then.empty())
    return motion_advice(f, order, words);
  if (std::string text = rounding_advice(f, order, input); !text.empty()) return text;
  const Trajectory& curve = std::get<Trajectory>(*input.curve);
  return points_advice(f, order, stretch_of(curve, input.labels, f, order), words,
                       input.limits.velocity);
}

}  // namespace

void advise_on_limits(const Input& input, Report& report) {
  if (input.labels.over_master) {
    if (input.spec) return design_detail::advise_on_cam(input, report);
    for (Finding& f : report.findings)
      if (order_of(f, OverMaster::names) > 0)
        f.advice = "change the spec from which the table was made, or raise the limit";
    return;
  }
  for (Finding& f : report.findings) {
    if (const std::size_t order = order_of(f, OverTime::names); order > 0)
      f.advice = over_time(input, f, order);
    else if (f.broken && f.segment && f.rule.name().starts_with("position"))
      f.advice = position_advice(input, f);
  }
}

namespace {

bool is_position_limit(const Finding& f) {
  return f.broken && f.segment &&
         (f.rule == "limit/position_max" || f.rule == "limit/position_min");
}

/// The advice for a free shape that leaves the range of the position. The reason may be an end of its
/// segment, at the limit, where the slave moves outwards.
std::string shape_advice(const Finding& f, const CamSpec& given, const Cam& cam,
                         const Words& words) {
  const std::size_t i = std::min(*f.segment, given.segments.size() - 1);
  const double x0 = i == 0 ? given.start.master : given.segments[i - 1].end.master;
  const double x1 = given.segments[i].end.master;
  const double sign = f.value > f.limit ? 1 : -1;
  const double stroke = extrema(cam, 0).max.value - extrema(cam, 0).min.value;
  for (const auto& [x, side, outwards] :
       {std::tuple{x0, Side::right, sign}, {x1, Side::left, -sign}}) {
    const Jet at = cam.jet(x, side);
    if (std::abs(at[0] - f.limit) > rest * stroke ||
        !(outwards * at[1] > rest * stroke / (x1 - x0)))
      continue;
    return fmt::format(
        "the range ends where the slave still moves outwards: at {} it is at the limit {} and has "
        "{} "
        "{}, so every shape leaves the range. Move this knot inwards, let the slave rest there, or "
        "widen the range",
        words.x(x), words.of(f.limit, 0), OverMaster::names[1], words.of(at[1], 1));
  }
  return "every shape that keeps the other limits leaves the range: raise these limits, move the "
         "ends "
         "of the segment inwards, or widen the range";
}

}  // namespace

void advise_on_limits(const CamSpec& given, const CamSpec& made, const Labels& labels,
                      Report& report) {
  const CamDesign cam = design(made);
  std::set<std::tuple<std::string, std::size_t>> seen;  // one finding of the position a segment
  std::erase_if(report.findings, [&](const Finding& f) {
    return is_position_limit(f) && !seen.emplace(f.rule.text(), *f.segment).second;
  });
  for (Finding& f : report.findings)
    if (is_position_limit(f)) f.advice = shape_advice(f, given, cam.cam, {labels});
  for (Finding& f : report.findings)
    if (const std::size_t order = order_of(f, OverMaster::names); order > 0)
      f.advice = cam_advice(f, order, stretch_of(cam, given, f, order), {labels});
}

std::string impossible_limit(const CamSpec& given, const CamSpec& made, const Labels& labels,
                             const Report& report) {
  const CamDesign cam = design(made);
  for (const Finding& f : report.findings) {
    const std::size_t order = order_of(f, OverMaster::names);
    if (order == 0) continue;
    std::string text = impossible(f, order, stretch_of(cam, given, f, order), {labels},
                                  "segment " + labels.segment_of(f));
    if (!text.empty()) return text;
  }
  return "";
}

}  // namespace jounce
