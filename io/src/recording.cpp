// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/recording.hpp"

#include <cmath>

#include "jounce/base/units.hpp"
#include "jounce/io/points.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

const std::vector<std::string> known_columns{"time",   "command", "feedback", "velocity",
                                             "torque", "current", "load"};

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
  Points points = read_points(path);
  points.name_columns(known_columns);
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
  if (recording.position.empty() && recording.velocity.empty() && recording.torque.empty() &&
      recording.load.empty())
    throw InputError("feedback", "",
                     "is missing: a recording needs feedback, velocity, torque, current or load")
        .at(points.document, 1);
  return recording;
}

}  // namespace jounce
