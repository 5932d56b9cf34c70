// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/report/comparison.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_sum;

using Json = nlohmann::ordered_json;
using Knot = KnotChange::Knot;

const std::array<const char*, 4>& names_of(const Comparison& c) {
  return c.labels.over_master ? OverMaster::names : OverTime::names;
}

std::string followed_by_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : text + " " + unit;
}

/// Two numbers for people, with enough digits to differ, at least six.
std::pair<std::string, std::string> apart(double a, double b) {
  std::string first = rounded(a);
  std::string second = rounded(b);
  for (int digits = 7; a != b && first == second && digits <= 17; ++digits) {
    first = fmt::format("{:.{}g}", a, digits);
    second = fmt::format("{:.{}g}", b, digits);
  }
  return {first, second};
}

/// "a", or "a -> b" if they differ by more than rounding. A value below the rounding counts as 0.
std::string arrow(double a, double b, const Change& change) {
  const double peak =
      std::max(std::abs(change.before.peak().value), std::abs(change.after.peak().value));
  for (double* value : {&a, &b})
    if (std::abs(*value) < rounded_sum * peak) *value = 0;
  if (std::abs(b - a) <= change.rounding) return rounded(b);
  const auto [before, after] = apart(a, b);
  return before + " -> " + after;
}

std::string quantity_line(const Comparison& c, std::size_t k) {
  const Change& change = c.changes[k];
  const char* name = names_of(c)[k];
  const std::string unit = c.labels.unit_of(std::string(name));
  std::string text = fmt::format("  {} {:<18}", c.beyond[k] ? '!' : ' ', name);
  if (change.none())
    text += "the same";
  else
    text +=
        fmt::format("differs by {} at {}", followed_by_unit(rounded(change.largest.value), unit),
                    followed_by_unit(rounded(change.largest.where), c.labels.units.x));
  return text + fmt::format("; min {}, max {}\n",
                            arrow(change.before.min.value, change.after.min.value, change),
                            arrow(change.before.max.value, change.after.max.value, change));
}

std::string name_of(const Knot& knot, const std::vector<std::string>& names) {
  const std::string text = "knot " + std::to_string(knot.index + 1);
  return knot.index < names.size() && !names[knot.index].empty()
             ? text + " (" + names[knot.index] + ")"
             : text;
}

std::string values_of(const Knot& knot, const Comparison& c) {
  return fmt::format("at {}, {} {}", followed_by_unit(rounded(knot.where), c.labels.units.x),
                     names_of(c)[0], rounded(knot.jet[0]));
}

std::string knot_line(const KnotChange& change, const Comparison& c) {
  if (!change.before)
    return fmt::format("  + {} {}\n", name_of(*change.after, c.knot_names_after),
                       values_of(*change.after, c));
  if (!change.after)
    return fmt::format("  - {} {}\n", name_of(*change.before, c.knot_names_before),
                       values_of(*change.before, c));
  const std::string before = name_of(*change.before, c.knot_names_before);
  const std::string after = name_of(*change.after, c.knot_names_after);
  std::string text = fmt::format("  ~ {} at ", before == after ? after : before + " -> " + after);
  const auto [from, to] = apart(change.before->where, change.after->where);
  text += followed_by_unit(change.moved ? from + " -> " + to : to, c.labels.units.x);
  for (std::size_t k = 0; k < change.changed.size(); ++k) {
    if (!change.changed[k]) continue;
    const auto [a, b] = apart(change.before->jet[k], change.after->jet[k]);
    text += fmt::format(", {} {} -> {}", names_of(c)[k], a, b);
  }
  return text + "\n";
}

std::string verdict(const Comparison& c) {
  const bool none = std::all_of(c.changes.begin(), c.changes.end(),
                                [](const Change& change) { return change.none(); });
  if (!c.equal()) return "they differ";
  return none ? "equal except for rounding" : "equal within the tolerance";
}

Json to_object(const Extremum& extremum) {
  return {{"value", extremum.value}, {"where", extremum.where}};
}

Json to_object(const Range& range) {
  return {{"min", to_object(range.min)}, {"max", to_object(range.max)}};
}

Json to_object(const Knot& knot, const Comparison& c, const std::vector<std::string>& names) {
  Json object{{"knot", knot.index + 1}, {"where", knot.where}};
  if (knot.index < names.size() && !names[knot.index].empty()) object["name"] = names[knot.index];
  for (std::size_t k = 0; k < 3; ++k) object[names_of(c)[k]] = knot.jet[k];
  return object;
}

Json to_object(const KnotChange& change, const Comparison& c) {
  Json object{{"what", !change.before  ? "added"
                       : !change.after ? "removed"
                       : change.moved  ? "moved"
                                       : "changed"}};
  if (change.before) object["before"] = to_object(*change.before, c, c.knot_names_before);
  if (change.after) object["after"] = to_object(*change.after, c, c.knot_names_after);
  return object;
}

}  // namespace

std::string to_text(const Comparison& c, std::size_t most, const std::string& besides) {
  std::string text = fmt::format("{} -> {}: {}{}\n", c.before, c.after, verdict(c),
                                 c.equal() && !besides.empty() ? ", but " + besides : "");
  for (std::size_t k = 0; k < c.changes.size(); ++k) text += quantity_line(c, k);
  for (const auto& [what, before, after] : c.remarks)
    text += fmt::format("  ! {}: {} -> {}\n", what, before.empty() ? "none" : before,
                        after.empty() ? "none" : after);
  for (std::size_t i = 0; i < std::min(most, c.knots.size()); ++i) text += knot_line(c.knots[i], c);
  if (c.knots.size() > most)
    text += fmt::format("  ... and {}\n", counted(c.knots.size() - most, "more knot"));
  return text;
}

std::string to_json(const Comparison& c) {
  Json changes = Json::object();
  for (std::size_t k = 0; k < c.changes.size(); ++k) {
    const Change& change = c.changes[k];
    const std::string name = names_of(c)[k];
    changes[name] = {{"unit", c.labels.unit_of(name)},  {"largest", to_object(change.largest)},
                     {"rounding", change.rounding},     {"none", change.none()},
                     {"beyond_tolerance", c.beyond[k]}, {"before", to_object(change.before)},
                     {"after", to_object(change.after)}};
  }
  Json knots = Json::array();
  for (const KnotChange& change : c.knots) knots.push_back(to_object(change, c));
  Json remarks = Json::array();
  for (const auto& [what, before, after] : c.remarks)
    remarks.push_back({{"what", what}, {"before", before}, {"after", after}});
  return Json{{"equal", c.equal()}, {"before", c.before},
              {"after", c.after},   {"axis_unit", c.labels.units.x},
              {"changes", changes}, {"knots", knots},
              {"remarks", remarks}}
      .dump();
}

}  // namespace jounce
