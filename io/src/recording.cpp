// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/recording.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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
  std::size_t state = 0, time = 0, position = 0, velocity = 0, acceleration = 0, error = 0;
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
  const auto velocity = find("velocity");
  const auto acceleration = find("acceleration");
  if (header.empty() || header[0] != "tick" || !state || !time || !position || !velocity ||
      !acceleration)
    return std::nullopt;
  const auto error = find("following_error");
  if (!error || !find("actual"))
    throw InputError("column \"actual\"", "",
                     "is missing: this log contains only setpoints. Use an axis with a [drive], "
                     "record its run with `jounce run --record run.lcmlog`, and list it with "
                     "`jounce replay run.lcmlog --csv run.csv`")
        .at(path, 1);
  return TickColumns{*state, *time, *position, *velocity, *acceleration, *error, find("torque")};
}

std::string unit_in(std::string_view cell) {
  const auto at = cell.find(' ');
  return at == std::string_view::npos ? "" : std::string(cell.substr(at));
}

/// The text of a recording, and the setpoints of a tick log as a text of points; "": another file.
struct RecordingText {
  std::string recording = {};
  std::string setpoints = {};
};

/// The rows of a tick log as those of a recording. A drive follows a setpoint from its tick on, and
/// reports its response in the next tick. So each sample has the following error and the torque of
/// the next tick. The log changes its coordinate with a set-position at standstill, which a drive does
/// not see: all rows are in the coordinate of the first one.
class TickRows {
 public:
  /// The torque of a tick is a share of `rated`, N m.
  TickRows(const std::vector<std::string_view>& header, const TickColumns& at, double rated)
      : at_(at), width_(header.size()), rated_(rated), torque_(at.torque && rated > 0) {
    const std::string unit = unit_in(header[at.position]);
    recording_head_ =
        "time [s],command" + unit + ",feedback" + unit + (torque_ ? ",torque [N m]" : "") + "\n";
    setpoint_head_ = "time [s],command" + unit + ",velocity" + unit_in(header[at.velocity]) +
                     ",acceleration" + unit_in(header[at.acceleration]) + "\n";
  }

  void add(const std::string& line) {
    const auto cells = csv_cells(line);
    samples_ += '\n';
    const auto row = cells.size() == width_ ? row_of(cells) : std::nullopt;
    if (!row) return end_section();
    if (!last_) begin_section();
    if (last_ && stands(*last_) && stands(*row)) shift_ += last_->position - row->position;
    if (last_ && row->tick == last_->tick + 1 && std::isfinite(row->error + row->torque)) {
      samples_.pop_back();
      samples_ += setpoint_ + ',' + number(command_ - row->error);
      if (torque_) samples_ += ',' + number(row->torque * rated_);
      samples_ += '\n';
      ++rows_;
    }
    last_ = row;
    command_ = row->position + shift_;
    setpoint_ = std::string(cells[at_.time]) + ',' + number(command_);
    setpoints_ += setpoint_ + ',' + std::string(cells[at_.velocity]) + ',' +
                  std::string(cells[at_.acceleration]) + '\n';
  }

  /// The longest section of enabled ticks. The lines of the other rows are empty.
  RecordingText text() {
    end_section();
    return {recording_head_ + longest_samples_, setpoint_head_ + longest_setpoints_};
  }

 private:
  struct Row {
    double tick, position, velocity, acceleration, error, torque;
  };

  static bool stands(const Row& row) { return row.velocity == 0 && row.acceleration == 0; }

  /// nullopt: the axis is disabled, or a setpoint is not a number. Error and torque can be NaN.
  [[nodiscard]] std::optional<Row> row_of(const std::vector<std::string_view>& cells) const {
    if (cells[at_.state] == "disabled") return std::nullopt;
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const auto tick = csv_number(cells[0]), position = csv_number(cells[at_.position]),
               velocity = csv_number(cells[at_.velocity]),
               acceleration = csv_number(cells[at_.acceleration]);
    if (!tick || !position || !velocity || !acceleration) return std::nullopt;
    const double error = csv_number(cells[at_.error]).value_or(unknown);
    const double torque = torque_ ? csv_number(cells[*at_.torque]).value_or(unknown) : 0;
    return Row{*tick, *position, *velocity, *acceleration, error, torque};
  }

  void begin_section() {
    const auto lines = std::count(samples_.begin(), samples_.end(), '\n');
    samples_.assign(static_cast<std::size_t>(lines), '\n');
    setpoints_.clear();
    rows_ = 0;
    shift_ = 0;
  }

  void end_section() {
    if (last_ && rows_ > most_rows_) {
      most_rows_ = rows_;
      longest_samples_ = samples_;
      longest_setpoints_ = setpoints_;
    }
    last_.reset();
  }

  TickColumns at_;
  std::size_t width_;
  double rated_;
  bool torque_;
  std::string recording_head_ = {}, setpoint_head_ = {};
  std::string samples_ = {},
              setpoints_ = {};  // the present section; samples_ has the lines before it, too
  std::size_t rows_ = 0, most_rows_ = 0;
  std::string longest_samples_ = {}, longest_setpoints_ = {};
  std::optional<Row> last_ = {};  // the row before, of the same section
  std::string setpoint_ = {};     // its time and command
  double command_ = 0;
  double shift_ = 0;  // from the coordinate of the log to the one of its first row
};

/// Returns a tick log with feedback (`jounce replay --csv`) as a recording, and the text of another
/// file as it is.
RecordingText as_recording(const std::string& text, const std::string& path, double rated) {
  std::istringstream lines(text);
  std::string line;
  if (!std::getline(lines, line)) return {text};
  const std::string head = line;
  const auto header = csv_cells(head);
  const auto at = tick_columns(header, path);
  if (!at) return {text};
  TickRows rows(header, *at, rated);
  while (std::getline(lines, line)) rows.add(line);
  return rows.text();
}

Points points_of(const std::string& text, const std::string& path, const std::string& position) {
  try {
    Points points = parse_points(text, path);
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

std::vector<RecordedSetpoint> setpoints_of(const std::string& text, const std::string& path,
                                           const std::string& position) {
  if (text.empty()) return {};
  const Points points = parse_points(text, path);
  const auto time = column(points, "time", "s");
  const auto at = column(points, "command", position);
  const auto velocity = column(points, "velocity", rate_unit(position, "s", 1));
  const auto acceleration = column(points, "acceleration", rate_unit(position, "s", 2));
  if (velocity.front() != 0 || acceleration.front() != 0)
    throw InputError("velocity", number(velocity.front()) + " " + rate_unit(position, "s", 1),
                     "must be 0, with acceleration 0, in the first tick: the recording must begin "
                     "at standstill. List more ticks of the record: increase or omit --last")
        .at(path, 2);
  std::vector<RecordedSetpoint> all;
  all.reserve(time.size());
  for (std::size_t i = 0; i < time.size(); ++i)
    all.push_back({time[i], at[i], velocity[i], acceleration[i]});
  return all;
}

}  // namespace

Recording read_recording(const std::string& path, const Drive& drive, const std::string& position) {
  const Motor& motor = drive.motor;
  const double rated = motor.rated_torque > 0 ? motor.rated_torque : motor.torque_limit;
  const RecordingText text = as_recording(point_file_bytes(path), path, rated);
  const Points points = points_of(text.recording, path, position);
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
  recording.setpoints = setpoints_of(text.setpoints, path, position);
  return recording;
}

}  // namespace jounce
