// SPDX-License-Identifier: Apache-2.0
#include "executor/src/group/group_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "jounce/base/document.hpp"
#include "jounce/profiles/detail/six_digits.hpp"

namespace jounce {
namespace {

std::string valued(double number, const std::string& unit) {
  return six_digits(number) + (unit.empty() ? "" : " " + unit);
}

/// The unit of the coordinates of commands.
const std::string& unit_of(const ExecutorGroup& group) {
  return group.kinematics ? group.kinematics->unit : group.unit;
}

/// Keys of the errors of a path that are options of `jounce order`: corner_distance is
/// "--corner-distance".
constexpr std::array option_keys{
    "to",   "by",   "via",       "center",          "radius",   "clockwise",    "turns",
    "fast", "axis", "deviation", "corner_distance", "velocity", "acceleration", "deceleration",
    "jerk", "zyz",  "along",     "offset",          "rotation", "blend"};

/// The option or argument for a key; "" for another key.
std::string option_of(std::string key) {
  if (key == "VALUE") return key;
  if (std::find(option_keys.begin(), option_keys.end(), key) == option_keys.end()) return "";
  std::replace(key.begin(), key.end(), '_', '-');
  return "--" + key;
}

/// The key of the library for a coordinate of the end of a command.
std::string to_key(std::size_t axis) {
  return "to[" + std::to_string(axis + 1) + "]";
}

}  // namespace

std::string reason_of(const InputError& plain, const ExecutorGroup& group) {
  const std::vector<std::string>& axes = group.coordinates();
  const std::string& unit = unit_of(group);
  const std::vector<std::string> units = group.coordinate_units();
  Document document;
  for (std::size_t i = 0; i < axes.size(); ++i) document.units[to_key(i)] = units[i];
  constexpr std::array lengths{"center", "radius", "deviation", "corner_distance"};
  const bool is_length = std::find(lengths.begin(), lengths.end(), plain.key()) != lengths.end();
  if (is_length) document.units[plain.key()] = unit;
  const InputError error = document.located(plain);
  const auto sentence = [&](const std::string& name) {
    return name + (error.value().empty() ? "" : " = " + error.value()) + ": " + error.rule();
  };
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (error.key() == to_key(i)) return sentence(axes[i]);
  if (const std::string option = option_of(error.key()); !option.empty()) return sentence(option);
  return error.key() + (error.value().empty() ? "" : " " + error.value()) + " " + error.rule();
}

std::string end_of_range(const JogEnd& end, const ExecutorGroup& group) {
  const std::vector<std::string> units = end.of_joint ? group.units : group.coordinate_units();
  return valued(end.limit, end.index < units.size() ? units[end.index] : group.unit);
}

std::string text_of(const JogEnd& end, const ExecutorGroup& group) {
  std::string text = "the jog ends at";
  const std::vector<std::string>& names = group.coordinates();
  const std::vector<std::string> units = group.coordinate_units();
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? " " : ", ") + names[i] + " = " + valued(end.place[i], units[i]);
  const std::string& axis = end.of_joint ? group.names[end.index] : names[end.index];
  if (end.cause == Cause::range_end)
    return text + ": there, " + axis + " reaches the end of its position range, " +
           end_of_range(end, group);
  if (end.cause == Cause::reach_end) return text + ": there, the reach of the joints ends";
  if (end.cause == Cause::singular_end)
    return text + ", before a singular position: there, " + axis +
           " limits the jog to 1 % of its velocity";
  return "";
}

std::string velocity_note(const PathCommands& commands, const GroupSpace& space,
                          const ExecutorGroup& group, bool fast) {
  const std::vector<std::string> units = group.coordinate_units();
  const std::string& axis_unit = units[commands.moves_only_follower().value_or(0)];
  const std::string unit = (axis_unit.empty() ? "u" : axis_unit) + "/s";
  if (const auto lowered = fast ? std::nullopt : commands.lowered_velocity(space))
    return "the limits lower the velocity from " + six_digits(lowered->commanded) + " " + unit +
           (lowered->everywhere ? " to " : " to at most ") + six_digits(lowered->permitted) + " " +
           unit;
  const double given = commands.commanded_velocity();
  if (axis_unit != units.front() && std::isfinite(given))
    return "only followers move, so the velocity is " + valued(given, unit);
  return "";
}

std::string dropped_text(std::size_t commands) {
  return std::to_string(commands) +
         (commands == 1 ? " command was dropped" : " commands were dropped");
}

}  // namespace jounce
