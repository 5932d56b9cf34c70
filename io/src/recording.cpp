// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/recording.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/base/detail/listed.hpp"
#include "jounce/base/units.hpp"
#include "jounce/io/points.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

const std::vector<std::string> known_columns{"time",   "command", "feedback", "velocity",
                                             "torque", "current", "load"};

/// The columns that a recording needs, and a header with their names.
std::string needed_columns(const std::string& position) {
  const std::string unit = position.empty() ? "" : " [" + position + "]";
  return "A recording needs time, command, and at least one of feedback, velocity, torque, current "
         "and load. Name the columns in the header, with units, such as time [s],command" +
         unit + ",feedback" + unit;
}

Points points_of(const std::string& path, const std::string& position) {
  try {
    Points points = read_points(path);
    points.name_columns(known_columns);
    return points;
  } catch (const InputError& error) {
    if (error.key() != "header") throw;
    throw InputError(error.key(), error.value(), error.rule() + ". " + needed_columns(position))
        .at(error.document(), error.line(), error.column());
  }
}

void require_columns(const Points& points, const std::string& position) {
  const auto required = known_columns.begin() + 2;
  const auto has = [&](const std::string& name) { return points.find(name) != nullptr; };
  const auto missing = std::find_if_not(known_columns.begin(), required, has);
  if (missing == required && std::any_of(required, known_columns.end(), has)) return;
  throw InputError("column \"" + *missing + '"', "",
                   "is missing: the columns of the file are " +
                       listed(points.columns, &PointColumn::name) + ". " + needed_columns(position))
      .at(points.document, static_cast<int>(points.header));
}

void require_ascending(const Points& points, const std::vector<double>& time) {
  for (std::size_t i = 1; i < time.size(); ++i)
    if (!(time[i] > time[i - 1]))
      throw points.error(i, "time", time[i], "s",
                         "must be greater than " + number(time[i - 1]) + " s, the previous row");
}

/// A column whose squares can be summed.
std::vector<double> column(const Points& points, const char* name, const std::string& unit) {
  std::vector<double> values = points.in_unit(name, unit);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!(std::abs(values[i]) < 1e100))
      throw points.error(i, name, values[i], unit, "must be below 1e100 in magnitude");
  return values;
}

std::vector<double> torques(const Points& points, const Drive& drive) {
  if (points.find("torque") != nullptr) return column(points, "torque", "N m");
  if (points.find("current") == nullptr) return {};
  if (drive.motor.torque_constant == 0)
    throw InputError("current", "",
                     "needs motor.torque_constant in the drive: add it, or remove this column")
        .at(points.document, 1);
  std::vector<double> values = column(points, "current", "A");
  for (double& value : values) value *= drive.motor.torque_constant;
  return values;
}

}  // namespace

Recording read_recording(const std::string& path, const Drive& drive, const std::string& position) {
  const Points points = points_of(path, position);
  require_columns(points, position);
  const auto optional = [&](const char* name, const std::string& unit) {
    return points.find(name) == nullptr ? std::vector<double>{} : column(points, name, unit);
  };
  Recording recording;
  recording.time = column(points, "time", "s");
  if (recording.time.size() < 4)
    throw InputError(
        "time", "",
        "needs at least four rows; the number of rows is " + std::to_string(recording.time.size()))
        .at(points.document);
  require_ascending(points, recording.time);
  recording.command = column(points, "command", position);
  recording.position = optional("feedback", position);
  recording.velocity = optional("velocity", rate_unit(position, "s", 1));
  recording.torque = torques(points, drive);
  recording.load = optional("load", position);
  return recording;
}

}  // namespace jounce
