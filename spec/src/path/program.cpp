// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "jounce/base/file.hpp"
#include "jounce/io/detail/records.hpp"
#include "jounce/io/points.hpp"
#include "jounce/path/rotary.hpp"

#include "spec/src/path/parts.hpp"
#include "spec/src/toml/point_file.hpp"

namespace jounce::spec_detail {
namespace {

const std::vector<std::string> feed_times{"min", "s"};
constexpr const char* one_of_two = ": give one of the two";

/// The columns of points have names in lower case.
std::string column_of(std::string axis) {
  for (char& c : axis) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return axis;
}

std::vector<std::string> columns_of(TomlReader& top, const PathAxes& axes) {
  std::vector<std::string> columns{"velocity"};
  for (const std::string& name : axes.names) {
    for (const std::string& other : columns)
      if (other == column_of(name))
        top.fail("points", "",
                 "is not possible: the column of axis " + name + " would be " + other +
                     ", the name of another column: rename the axis");
    columns.push_back(column_of(name));
  }
  return columns;
}

/// The points in the units of the axes.
std::vector<Point> positions_of(const Points& points, const PathAxes& axes) {
  std::vector<Point> all(points.size(), Point{});
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto column = points.in_unit(column_of(axes.names[i]), axes.position_units[i]);
    for (std::size_t k = 0; k < all.size(); ++k)
      all[k][i] = k > 0 ? shortest_way(all[k - 1][i], column[k], axes.modulo[i]) : column[k];
  }
  return all;
}

/// Lines through the points of a file; the first point is the start. A column "velocity" contains
/// the feed of the line that ends at the point.
Program program_of(const Points& points, const PathAxes& axes, PathSettings settings) {
  const std::vector<Point> positions = positions_of(points, axes);
  std::vector<double> feeds;
  if (points.find("velocity") != nullptr) feeds = points.in_unit("velocity", axes.unit(1));
  if (points.size() < 2)
    throw InputError("", "", "is the only point of the file: a path needs at least two")
        .at(points.document, static_cast<int>(points.lines.front()));
  Program program(axes.size(), positions.front(), axes.path_axes);
  for (std::size_t k = 1; k < positions.size(); ++k) {
    const int line = static_cast<int>(points.lines[k]);
    if (!feeds.empty()) settings.velocity = feeds[k];
    if (!(settings.velocity > 0))
      throw points.error(k, "velocity", settings.velocity, axes.unit(1), "must be greater than 0");
    program.set(settings);
    program.line(positions[k], line);
  }
  return program;
}

/// Reads G54 = [x, y, ...], or a table with the keys of [frame].
Frame read_frame_of(TomlReader& gcode, const char* key, const PathAxes& axes) {
  if (!gcode.is_table(key)) return {.offset = read_position(gcode, key, axes, {})};
  return read_frame(*gcode.optional_table(key), axes);
}

/// Reads records of MoveSequence; RoundDiameter is the least diameter of a corner.
void read_records(TomlReader records, const PathAxes& axes, PathSpec& path) {
  const std::string file = records.text("file", "FILE.csv");
  if (const auto diameter = records.optional_positive("round_diameter", axes.unit(0))) {
    path.machine.settings.corner = Corner::curvature;
    path.machine.settings.value = 2 / *diameter;
  }
  records.finish();
  const std::string full =
      (std::filesystem::path(records.document().name).parent_path() / file).string();
  const Points points = records.file_of("file", full, [&] { return jounce::read_points(full); });
  path.source = points.document;
  path.program = record_program(points, path.machine, {axes.unit(1), axes.unit(2)});
}

/// Reads [gcode]; returns the name of the program file, or "".
std::string read_gcode_table(TomlReader& top, const PathAxes& axes, GcodeMachine& machine) {
  auto gcode = top.optional_table("gcode");
  if (!gcode) return "";
  for (const char* other : {"command", "points", "records", "frame"})
    if (top.has(other))
      top.fail("gcode", "", std::string("cannot be combined with ") + other + one_of_two);
  if (const auto v = gcode->optional_positive("rapid", axes.unit(1))) machine.rapid = *v;
  if (const auto time = gcode->optional_choice("feed_time", feed_times))
    machine.feed_time = *time == 0 ? 60 : 1;
  std::size_t k = 0;
  for (const char* key : {"G54", "G55", "G56", "G57", "G58", "G59"}) {
    gcode->may_have(key);
    if (gcode->has(key)) machine.frames[k] = read_frame_of(*gcode, key, axes);
    ++k;
  }
  const std::string file = gcode->optional_text("file").value_or("");
  gcode->finish();
  if (file.empty()) return "";
  return (std::filesystem::path(top.document().name).parent_path() / file).string();
}

/// After a placeholder or a wrong command, the positions are unknown: an error of the geometry of a
/// later command may only follow from it.
void read_commands(TomlReader& top, const PathAxes& axes, PathSettings settings, Program& program) {
  const std::size_t before = top.placeholders();
  bool lost = false;
  top.for_each("command", [&](TomlReader& command) {
    try {
      read_path_command(command, axes, settings, program);
    } catch (const InputError& error) {
      const bool of_geometry = error.document().empty();
      const bool follows = of_geometry && (lost || top.placeholders() != before);
      lost = true;
      if (!follows) throw;
    }
  });
}

}  // namespace

void read_program(TomlReader& top, const PathAxes& axes, const PathSettings& settings,
                  PathSpec& path) {
  if (const std::string file = read_gcode_table(top, axes, path.machine); !file.empty()) {
    const TomlReader gcode = top.table("gcode");
    set_gcode(path, gcode.file_of("file", file, [&] { return read_file(file); }), file);
  } else if (auto records = top.optional_table("records")) {
    for (const char* other : {"command", "points"})
      if (top.has(other))
        top.fail("records", "", std::string("cannot be combined with ") + other + one_of_two);
    read_records(std::move(*records), axes, path);
  } else if (top.has("points")) {
    const auto points = read_point_file(top, "command", columns_of(top, axes));
    path.source = points->document;
    path.program = program_of(*points, axes, settings);
  } else {
    read_commands(top, axes, settings, path.program);
  }
  if (auto frame = top.optional_table("frame")) {
    const int line = frame->line();
    try {
      path.program = placed(read_frame(std::move(*frame), axes), path.program);
    } catch (const InputError& error) {
      if (!error.document().empty()) throw;
      throw InputError("frame." + error.key(), error.value(), error.rule())
          .at(top.document().name, line);
    }
  }
}

}  // namespace jounce::spec_detail

namespace jounce {

void set_gcode(PathSpec& path, std::string_view text, const std::string& document) {
  if (const auto commands = path.program.commands(); !commands.empty())
    throw InputError("--machine", path.source,
                     "already has a motion, at line " + std::to_string(commands.front().line) +
                         ": the spec of a machine must have no [[command]], points, records or "
                         "gcode.file");
  GcodeProgram made = parse_gcode(text, document, path.machine);
  const auto commands = made.program.commands();
  const bool moves = std::any_of(commands.begin(), commands.end(), [](const auto& command) {
    return command.kind != Program::Kind::dwell;
  });
  if (!moves)
    throw InputError("program", "",
                     "moves no axis: add at least one G0, G1, G2 or G3 with a position")
        .at(document, 1);
  path.program = std::move(made.program);
  path.events = std::move(made.events);
  path.rapids = std::move(made.rapids);
  path.source = document;
}

namespace {

/// The M and H words of a G-code program; T and S words, and the end of the program, have no effect.
std::vector<ProgramWord> words_of(const PathSpec& path) {
  std::vector<ProgramWord> words;
  for (const GcodeEvent& event : path.events) {
    const char letter = event.word.front();
    if (letter != 'M' && letter != 'H') continue;
    const bool output = letter == 'H';
    const double most = output ? ProgramWord::most_outputs : ProgramWord::most_m_word;
    if (std::abs(event.number) > most)
      throw InputError(event.word, "",
                       "has a number above " + std::to_string(static_cast<int>(most)) +
                           ", the greatest of " + (output ? "an output" : "an M word"))
          .at(path.source, event.line);
    words.push_back({.kind = output ? ProgramWord::Kind::output : ProgramWord::Kind::m_word,
                     .number = static_cast<std::int32_t>(event.number),
                     .line = event.line,
                     .command = event.command});
  }
  return words;
}

}  // namespace

LimitedProgram limited_program(PathSpec path) {
  std::vector<ProgramWord> words = words_of(path);
  return {.program = std::move(path.program),
          .limits = std::move(path.limits),
          .names = {},
          .words = std::move(words)};
}

}  // namespace jounce
