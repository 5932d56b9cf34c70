// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/path_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/units.hpp"
#include "jounce/path/path_length.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/report/report_text.hpp"

namespace jounce {
namespace {

using Json = nlohmann::ordered_json;

constexpr double no_loss = 1e-9;  ///< share of the duration

constexpr std::size_t places_for_people = 10;
constexpr std::array corner_names{"stop",      "deviation", "distance",
                                  "curvature", "velocity",  "average"};
constexpr std::array note_names{"none",   "turns_back", "short_sides",
                                "slower", "steps",      "no_distance"};

/// Units along the path.
struct Along {
  std::string length, time, velocity;
};
Along units_along(const Spec& spec) {
  const Units& units = spec.units;
  return {units.position, units.x, rate_unit(units.position, units.x, 1)};
}

double degrees(double angle) {
  return angle * 180 / std::numbers::pi;
}

std::string times_text(const PathSummary& s, const Along& units) {
  return fmt::format(
      "{0} {2} for {1} {3}, {4} {5} on average\n"
      "with a stop at each corner: {6} {2}; proven lower bound on this path, without jerk limits: "
      "{7} {2}\n",
      rounded(s.duration), rounded(s.length), units.time, units.length,
      rounded(s.length / s.duration), units.velocity, rounded(s.stop_duration),
      rounded(s.lower_bound));
}

std::string override_text(const PathSummary& s, const Along& units) {
  if (!s.played) return "";
  return fmt::format("{} {} under the override; all other numbers are without it\n",
                     rounded(*s.played), units.time);
}

std::string costs_text(const PathSummary& s, const Along& units) {
  std::string text =
      fmt::format("duration: {} {} at full speed", rounded(s.cost.at_full_speed), units.time);
  for (std::size_t k = 0; k < loss_causes; ++k) {
    const auto cause = static_cast<LossCause>(k);
    const auto count = std::count_if(s.cost.losses.begin(), s.cost.losses.end(),
                                     [&](const SpeedLoss& loss) { return loss.cause == cause; });
    const double sum = s.cost.of(cause);
    if (count == 0 || sum <= no_loss * s.duration) continue;
    const std::string times = count == 1 ? "" : fmt::format(" ({} places)", count);
    text += fmt::format(" + {} {} {}{}", rounded(sum), units.time, name(cause), times);
  }
  return text + "\n";
}

std::string corner_text(const CornerRecord& corner, const Along& units) {
  std::string text = fmt::format("turns {} deg", rounded(degrees(corner.angle)));
  if (corner.trim > 0)
    text += fmt::format(", deviation {} {}, trim {} {}", rounded(corner.deviation), units.length,
                        rounded(corner.trim), units.length);
  return text;
}

/// Indices of the losses, in descending order of the loss.
std::vector<std::size_t> by_loss(const std::vector<SpeedLoss>& losses) {
  std::vector<std::size_t> order(losses.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return losses[a].loss > losses[b].loss; });
  return order;
}

std::string places_text(const PathSummary& s, const Along& units) {
  const auto& losses = s.cost.losses;
  const std::size_t shown = std::min(places_for_people, losses.size());
  std::string text =
      fmt::format("the most expensive of {}:\n{:>8}  {:>11}  {:<7} {:>12} {:>16}\n",
                  counted(losses.size(), "place"), "line", "cost [" + units.time + "]", "cause",
                  "at [" + units.length + "]", "speed [" + units.velocity + "]");
  const std::vector<std::size_t> order = by_loss(losses);
  for (std::size_t k = 0; k < shown; ++k) {
    const SpeedLoss& loss = losses[order[k]];
    text += fmt::format("{:>8}  {:>11}  {:<7} {:>12} {:>16}", loss.line, rounded(loss.loss),
                        name(loss.cause), rounded(loss.where), rounded(loss.velocity));
    if (loss.corner) text += "  " + corner_text(s.corners[*loss.corner], units);
    text += '\n';
  }
  return text;
}

constexpr auto many_short_lines = 20;  ///< corners

/// One line for each kind of note: the number of notes, and the first one in words.
std::string notes_text(const PathSummary& s, const Along& units) {
  std::string text;
  for (std::size_t k = 1; k < note_names.size(); ++k) {
    const auto has = [&](const CornerRecord& c) { return c.note == static_cast<JunctionNote>(k); };
    const auto first = std::find_if(s.corners.begin(), s.corners.end(), has);
    if (first == s.corners.end()) continue;
    const auto count = std::count_if(first, s.corners.end(), has);
    text += fmt::format("warning: line {}: {}", first->line, explain(*first, units.length));
    if (count > 1) text += fmt::format(" This warning applies to {} places.", count);
    if (count >= many_short_lines && first->note == JunctionNote::short_sides)
      text +=
          " For many short lines, use corner = { average = 0.02 } in [path], with your tolerance.";
    text += '\n';
  }
  return text;
}

/// Distance of the joints from the kinematics.
std::string fit_text(const MapFit& fit, const Along& units) {
  if (fit.pieces == 0) return "joints: exact, linear in the axes\n";
  const std::string text = fmt::format("joints: within {} of the kinematics by {} polynomials",
                                       rounded(fit.error), fit.pieces);
  if (fit.proven) return text + " (proven)\n";
  return text + fmt::format(": sampled, not proven, in steps of at most {} {}\n",
                            rounded(fit.sample_step), units.length);
}

Json json_of(const MapFit& fit) {
  Json object{{"error", fit.error}, {"proven", fit.proven}, {"pieces", fit.pieces}};
  if (!fit.proven) object["sample_step"] = fit.sample_step;
  return object;
}

Json json_of(const CornerRecord& corner) {
  Json object{{"line", corner.line},
              {"where", corner.where},
              {"angle", degrees(corner.angle)},
              {"asked", corner_names[static_cast<std::size_t>(corner.asked)]},
              {"value", corner.value},
              {"stop", corner.stop},
              {"trim", corner.trim},
              {"deviation", corner.deviation},
              {"one_sided", corner.one_sided},
              {"curvature", corner.curvature},
              {"velocity", corner.velocity}};
  if (corner.note != JunctionNote::none) {
    object["note"] = note_names[static_cast<std::size_t>(corner.note)];
    object["text"] = corner.text;
  }
  return object;
}

Json json_of(const SpeedLoss& loss) {
  return {{"line", loss.line},   {"cause", name(loss.cause)}, {"cost", loss.loss},
          {"where", loss.where}, {"time", loss.time},         {"velocity", loss.velocity}};
}

Json json_of(const EventPlace& place, const Spec& spec) {
  Json object{{"line", place.event.line},
              {"word", place.event.word},
              {"where", place.where},
              {"time", place.time}};
  for (std::size_t i = 0; i < spec.axes.size(); ++i)
    object["position"][spec.axes[i].name] = place.position[i];
  return object;
}

}  // namespace

std::string path_text(const Spec& spec, const PathSummary& s) {
  const Along units = units_along(spec);
  const Labels labels{spec.units, false, {}};
  std::string text = times_text(s, units) + override_text(s, units) + costs_text(s, units) + "\n" +
                     places_text(s, units);
  const auto moving = std::count_if(s.corners.begin(), s.corners.end(),
                                    [](const CornerRecord& c) { return !c.stop && c.trim > 0; });
  const auto stops = std::count_if(s.corners.begin(), s.corners.end(),
                                   [](const CornerRecord& c) { return c.stop; });
  const auto straight = static_cast<std::ptrdiff_t>(s.corners.size()) - moving - stops;
  text += fmt::format("\n{}: {} rounded, {}{}\n", counted(s.corners.size(), "corner"), moving,
                      counted(static_cast<std::size_t>(stops), "stop"),
                      straight > 0 ? fmt::format(", {} straight on", straight) : "");
  text += notes_text(s, units);
  if (s.fit) text += fit_text(*s.fit, units);
  if (!s.events.empty())
    text +=
        fmt::format("{} events of M, H, S and T words: --json has their places\n", s.events.size());
  if (!s.along.findings.empty()) text += "along the path: " + one_line(s.along, labels) + "\n";
  return text;
}

std::string path_json(const Spec& spec, const PathSummary& s) {
  const Along units = units_along(spec);
  const Labels labels{spec.units, false, {}};
  Json costs{{"at_full_speed", s.cost.at_full_speed}};
  for (std::size_t k = 0; k < loss_causes; ++k)
    costs[name(static_cast<LossCause>(k))] = s.cost.of(static_cast<LossCause>(k));
  Json places = Json::array();
  for (const std::size_t i : by_loss(s.cost.losses)) places.push_back(json_of(s.cost.losses[i]));
  Json corners = Json::array();
  for (const CornerRecord& corner : s.corners) corners.push_back(json_of(corner));
  Json events = Json::array();
  for (const EventPlace& place : s.events) events.push_back(json_of(place, spec));
  Json document{{"unit", units.length},
                {"time_unit", units.time},
                {"duration", s.duration},
                {"stop_duration", s.stop_duration},
                {"lower_bound", s.lower_bound},
                {"length", s.length},
                {"costs", std::move(costs)},
                {"places", std::move(places)},
                {"corners", std::move(corners)},
                {"events", std::move(events)},
                {"along", Json::parse(to_json(s.along, labels))}};
  if (s.played) document["played"] = *s.played;
  if (s.fit) document["joints"] = json_of(*s.fit);
  return document.dump();
}

std::string path_difference(const Spec& spec, const Plan& before, const Plan& after) {
  const Along units = units_along(spec);
  const double faster = before.duration() - after.duration();
  const double now = PathLength(after).whole();
  const double then = PathLength(before).whole();
  if (faster == 0 && now == then)
    return fmt::format("path: {} {} and {} {} long, as before\n", rounded(after.duration()),
                       units.time, rounded(now), units.length);
  return fmt::format("path: {} {} instead of {} {}: {} {} {}; {} {} long instead of {} {}\n",
                     rounded(after.duration()), units.time, rounded(before.duration()), units.time,
                     rounded(std::abs(faster)), units.time, faster >= 0 ? "less" : "more",
                     rounded(now), units.length, rounded(then), units.length);
}

std::string path_bound(const Spec& spec, const Plan& plan) {
  const double bound = lower_bound(plan);
  return fmt::format(
      "proven lower bound on this path, without jerk limits: {} {}; the duration is {} times this "
      "bound\n",
      rounded(bound), spec.units.x, rounded(plan.duration() / bound));
}

std::string overlap_text(const Spec& spec, const Overlapped& motion) {
  const Along units = units_along(spec);
  std::string text =
      fmt::format("{0} {2} with overlap; with a stop at each corner: {1} {2}\n",
                  rounded(motion.duration), rounded(motion.stop_duration), units.time);
  text += fmt::format("{:>8} {:>12} {:>13} {:>16} {:>16}\n", "line", "at [" + units.time + "]",
                      "overlap [" + units.time + "]", "deviation [" + units.length + "]",
                      "from lines [" + units.length + "]");
  for (const OverlapRecord& c : motion.corners)
    text += fmt::format("{:>8} {:>12} {:>13} {:>16} {:>16}\n", c.line, rounded(c.time),
                        rounded(c.overlap), rounded(c.deviation), rounded(c.one_sided));
  return text;
}

std::string overlap_json(const Spec& spec, const Overlapped& motion) {
  const Along units = units_along(spec);
  Json corners = Json::array();
  for (const OverlapRecord& c : motion.corners)
    corners.push_back({{"line", c.line},
                       {"time", c.time},
                       {"overlap", c.overlap},
                       {"deviation", c.deviation},
                       {"one_sided", c.one_sided}});
  return Json{{"unit", units.length},
              {"time_unit", units.time},
              {"duration", motion.duration},
              {"stop_duration", motion.stop_duration},
              {"corners", std::move(corners)}}
      .dump();
}

}  // namespace jounce
