// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/recording.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "jounce/base/detail/csv.hpp"
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

/// The columns of a tick log that a recording needs, as indices; nullopt: the file is no tick log.
struct TickColumns {
  std::size_t state = 0, time = 0, position = 0, actual = 0;
  std::optional<std::size_t> torque = {};
};

std::optional<TickColumns> tick_columns(const std::vector<std::string_view>& header,
                                        const std::string& path) {
  const auto find = [&](std::string_view wanted) -> std::optional<std::size_t> {
    for (std::size_t k = 0; k < header.size(); ++k)
      if (header[k].substr(0, header[k].find(' ')) == wanted) return k;
    return std::nullopt;
  };
  const auto state = find("state");
  const auto time = find("time");
  const auto position = find("position");
  if (header.empty() || header[0] != "tick" || !state || !time || !position) return std::nullopt;
  const auto actual = find("actual");
  if (!actual)
    throw InputError("column \"actual\"", "",
                     "is missing: this log contains only setpoints. Use an axis with a [drive], "
                     "record its run with `jounce run --record run.lcmlog`, and list it with "
                     "`jounce replay run.lcmlog --csv run.csv`")
        .at(path, 1);
  return TickColumns{*state, *time, *position, *actual, find("torque")};
}

std::string unit_in(std::string_view cell) {
  const auto at = cell.find(' ');
  return at == std::string_view::npos ? "" : std::string(cell.substr(at));
}

/// Returns the text of a tick log with feedback (`jounce replay --csv`) as that of a recording. A
/// drive follows a setpoint from its tick on, and reports its response in the next tick. So each
/// row has the feedback of the next tick. A row without it, or of a disabled axis, becomes an empty
/// line: the other rows keep their lines. The torque of a tick is a share of `rated`, N m. Returns
/// the text of another file as it is.
std::string as_recording(const std::string& text, const std::string& path, double rated) {
  std::istringstream lines(text);
  std::string line;
  if (!std::getline(lines, line)) return text;
  const auto header = csv_cells(line);
  const auto at = tick_columns(header, path);
  if (!at) return text;
  const bool torque = at->torque && rated > 0;
  std::string recording = "time [s],command" + unit_in(header[at->position]) + ",feedback" +
                          unit_in(header[at->actual]) + (torque ? ",torque [N m]" : "") + "\n";
  const std::size_t width = header.size();
  std::string setpoint;                // time and command of the row before
  std::optional<double> tick_of_next;  // tick of the next row, if none is missing
  while (std::getline(lines, line)) {
    const auto cells = csv_cells(line);
    const bool complete = cells.size() == width && cells[at->state] != "disabled";
    const auto tick = complete ? csv_number(cells[0]) : std::nullopt;
    const auto actual = complete ? csv_number(cells[at->actual]) : std::nullopt;
    const auto share = complete && torque ? csv_number(cells[*at->torque]) : std::nullopt;
    if (tick && tick == tick_of_next && actual && (share || !torque)) {
      recording += setpoint + ',' + std::string(cells[at->actual]);
      if (torque) recording += ',' + number(*share * rated);
    }
    recording += '\n';
    tick_of_next = tick ? std::optional(*tick + 1) : std::nullopt;
    if (complete) setpoint = std::string(cells[at->time]) + ',' + std::string(cells[at->position]);
  }
  return recording;
}

Points points_of(const std::string& path, const std::string& position, double rated) {
  try {
    Points points = parse_points(as_recording(point_file_bytes(path), path, rated), path);
    points.name_columns(known_columns);
    return points;
  } catch (const InputError& error) {
    const bool is_known =
        std::find(known_columns.begin(), known_columns.end(), error.key()) != known_columns.end();
    if (is_known || error.key().empty() || error.line() == 0 || error.key().starts_with("column"))
      throw;
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
  const Motor& motor = drive.motor;
  const double rated = motor.rated_torque > 0 ? motor.rated_torque : motor.torque_limit;
  const Points points = points_of(path, position, rated);
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
