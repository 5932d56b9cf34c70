// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "jounce/base/detail/csv.hpp"
#include "jounce/io/detail/points_text.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/pvt/pt.hpp"

#include "controllers/src/exchange/cells.hpp"
#include "controllers/src/exchange/formats.hpp"

// The calls that load and start a PT table or a follow table of a Googol controller (manual 7.4,
// 7.6), in C and in Structured Text: GT_PtData(axis, position, time, type, fifo) and
// GT_FollowData(axis, master, slave, type, fifo). Numbers count from the start of the table. A
// segment has a linear velocity, or ratio.
namespace jounce::controllers_detail {
namespace {

using profiles_detail::rounded_input;

/// Names of a mode, and syntax of a language.
struct Mode {
  const char* data;  ///< function that adds a segment
  const char* loop;  ///< function that sets the number of passes; 0: endless
  bool follows;      ///< true for the follow mode
};
constexpr Mode pt_mode{"GT_PtData", "GT_SetPtLoop", false};
constexpr Mode follow_mode{"GT_FollowData", "GT_SetFollowLoop", true};
struct Language {
  bool st;

  [[nodiscard]] std::string call(const std::string& function) const {
    return st ? "rtn := " + function + ";\n" : "  if ((rtn = " + function + ") != 0) return rtn;\n";
  }
  [[nodiscard]] std::string comment(const std::string& text) const {
    return st ? "(* " + text + " *)\n" : "/* " + text + " */\n";
  }
};

/// Segments of each FIFO: a small one by default, or a large one (GT_SetPtMemory, manual I-148;
/// GT_SetFollowMemory, I-138).
constexpr std::size_t small_pt_fifo = 32;
constexpr std::size_t small_follow_fifo = 16;

std::string set_up(const Mode& mode, const Language& in, std::size_t segments, bool repeating) {
  const std::string loop = repeating ? "0" : "1";
  if (!mode.follows)
    return in.call("GT_PrfPt(axis, 0)") +
           in.call("GT_SetPtMemory(axis, " + std::string(segments > small_pt_fifo ? "1" : "0") +
                   ")") +
           in.call("GT_PtClear(axis, 0)") + in.call("GT_SetPtLoop(axis, " + loop + ")");
  return in.call("GT_PrfFollow(axis, 0)") + in.call("GT_SetFollowMaster(axis, master)") +
         in.call("GT_SetFollowMemory(axis, " +
                 std::string(segments > small_follow_fifo ? "1" : "0") + ")") +
         in.call("GT_FollowClear(axis, 0)") + in.call("GT_SetFollowLoop(axis, " + loop + ")");
}

std::string program(const Mode& mode, const Language& in, const TableFile& file) {
  const std::vector<PtPoint> points = points_of(file.table);
  std::string text = in.comment(
      std::string(mode.follows ? "a follow table" : "a PT table") + " for Googol, by " + made_by() +
      ": " + (mode.follows ? "master pulses, slave pulses" : "pulses, ms") + ", from the start");
  text += in.comment(
      std::string("type: 0 normal, 1 even, 2 stop") +
      (mode.follows ? ", 3 continue. Direction 0: the slave follows both directions of the master"
                    : ""));
  if (!in.st)
    text += std::string(mode.follows ? "short start_follow(short axis, short master) {"
                                     : "short start_pt(short axis) {") +
            "\n  short rtn = 0;\n";
  text += set_up(mode, in, points.size(), repeats(file.table.outside()));
  for (const PtPoint& point : points) {
    const std::string x = whole_number(point.x), p = number(point.position);
    text +=
        in.call(std::string(mode.data) + "(axis, " + (mode.follows ? x + ", " + p : p + ", " + x) +
                ", " + std::to_string(static_cast<int>(point.type)) + ", 0)");
  }
  const std::string start = mode.follows ? "GT_FollowStart(" : "GT_PtStart(";
  text += in.call(start + (in.st ? "SHL(1, axis - 1)" : "1 << (axis - 1)") + ", 0)");
  return in.st ? text : text + "  return rtn;\n}\n";
}

/// A segment in a file.
struct Segment {
  PtPoint point;
  int line = 0;
};

std::optional<PtType> type_of(std::string_view word) {
  constexpr std::array words{"NORMAL", "EVEN", "STOP", "CONTINUE"};
  for (std::size_t i = 0; i < words.size(); ++i)
    if (word == std::to_string(i) || word == std::string("PT_SEGMENT_") + words[i] ||
        word == std::string("FOLLOW_SEGMENT_") + words[i])
      return static_cast<PtType>(i);
  return std::nullopt;
}

/// The cubic table of segments whose velocity does not step, or the linear one of even segments.
Exchanged table_of_segments(const Mode& mode, const std::string& name,
                            const std::vector<Segment>& segments, const Place& place) {
  Exchanged to{.name = name,
               .rule = Interpolation::linear,
               .units = {mode.follows ? "pulse" : "ms", "pulse"}};
  double x = 0, p = 0, v = 0;
  bool even = true;
  for (const Segment& each : segments) even = even && each.point.type == PtType::even;
  const auto add = [&](int line) {
    to.columns.x.push_back(x);
    to.columns.p.push_back(p);
    if (!even) to.columns.v.push_back(v);
    to.lines.push_back(line);
  };
  if (!even) to.rule = Interpolation::cubic_hermite;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto& [point, line] = segments[i];
    const double dx = point.x - x, dp = point.position - p;
    if (!(dx > 0))
      place.fail(line, mode.data, number(point.x),
                 "must be greater than " + number(x) + ", the end of the segment before");
    const double mean = dp / dx;
    const double from = point.type == PtType::even   ? mean
                        : point.type == PtType::stop ? 2 * mean
                                                     : v;
    if (i == 0 && point.type == PtType::continued)
      place.fail(line, mode.data, "type 3",
                 "continues another table: Jounce reads tables that begin at rest");
    if (!even && std::abs(from - v) > rounded_input * std::max(std::abs(from), std::abs(v)))
      place.fail(line, mode.data, number(from),
                 "is the velocity at which the segment begins, but the segment before ends at " +
                     number(v) + ": Jounce reads tables without a step of the velocity");
    if (i == 0) add(line);
    x = point.x;
    p = point.position;
    v = 2 * mean - from;
    add(line);
  }
  return to;
}

/// The text with blanks for its comments, as long and with the same lines.
std::string with_blank_comments(std::string text) {
  for (std::size_t at = 0; at + 1 < text.size(); ++at) {
    const std::string pair = text.substr(at, 2);
    const char* const closing = pair == "//"   ? "\n"
                                : pair == "/*" ? "*/"
                                : pair == "(*" ? "*)"
                                               : "";
    if (*closing == '\0') continue;
    const std::size_t found = text.find(closing, at + 2);
    const std::size_t end = found == text.npos ? text.size() : found + (pair == "//" ? 0 : 2);
    for (; at < end; ++at)
      if (text[at] != '\n') text[at] = ' ';
    --at;
  }
  return text;
}

/// The arguments of each call `name(...)` with its line.
std::vector<std::pair<std::vector<std::string_view>, int>> calls_of(std::string_view text,
                                                                    const std::string& name,
                                                                    const Place& place) {
  std::vector<std::pair<std::vector<std::string_view>, int>> calls;
  for (const Line& line : lines_of(text))
    for (auto at = line.text.find(name + "("); at != line.text.npos;
         at = line.text.find(name + "(", at + 1)) {
      const auto from = at + name.size() + 1, to = line.text.find(')', from);
      if (to == line.text.npos)
        place.fail(line.number, name, line.text,
                   "has no closing parenthesis: is the file complete?");
      calls.emplace_back(csv_cells(line.text.substr(from, to - from)), line.number);
    }
  return calls;
}

/// A number of a C program, which may have the suffix of its type: 1024L, 8192UL, 2.5f.
double number_of_c(const Place& place, int line, const std::string& key, std::string_view text) {
  const std::string_view digits = text.substr(0, text.find_last_not_of("fFlLuU") + 1);
  return place.number(line, key, digits.empty() || text.size() - digits.size() > 3 ? text : digits);
}

std::vector<Exchanged> read_program(const Mode& mode, const std::string& given,
                                    const Place& place) {
  const std::string text = with_blank_comments(given);
  std::map<std::string, std::vector<Segment>> tables;  // by axis and FIFO
  std::vector<std::string> names;
  for (const auto& [cells, line] : calls_of(text, mode.data, place)) {
    if (cells.size() < 3 || cells.size() > 5)
      place.fail(line, mode.data, std::to_string(cells.size()) + " arguments", "must have 3 to 5");
    const auto type = cells.size() > 3 ? type_of(trimmed(cells[3])) : PtType::normal;
    if (!type) place.fail(line, mode.data, trimmed(cells[3]), "must be a type of segment, 0 to 3");
    const std::string fifo(cells.size() > 4 ? trimmed(cells[4]) : "0");
    const std::string name = std::string(trimmed(cells[0])) + " fifo " + fifo;
    if (!tables.contains(name)) names.push_back(name);
    const double first = number_of_c(place, line, mode.data, trimmed(cells[1]));
    const double second = number_of_c(place, line, mode.data, trimmed(cells[2]));
    tables[name].push_back(
        {{mode.follows ? first : second, mode.follows ? second : first, *type}, line});
  }
  if (names.empty()) place.fail(1, mode.data, "", "is not called: is the file complete?");
  bool repeats = false;
  for (const auto& [cells, line] : calls_of(text, mode.loop, place))
    repeats = cells.size() == 2 && place.number(line, mode.loop, trimmed(cells[1])) < 1;
  std::vector<Exchanged> all;
  for (const std::string& name : names) {
    all.push_back(table_of_segments(mode, name, tables[name], place));
    all.back().repeats = repeats;
  }
  return all;
}

bool calls(const std::string& text, const Mode& mode, bool st) {
  return text.find(std::string(mode.data) + "(") != text.npos &&
         (text.find(":=") != text.npos) == st;
}

constexpr const char* pt_source = "Googol iDEABOX Pro manual 7.4, I-113 to I-120, I-148";
constexpr const char* follow_source = "Googol iDEABOX Pro manual 7.6, I-22 to I-30, I-136 to I-139";
constexpr const char* relative = "the table counts from the positions at its start";

}  // namespace

constinit const FormatRow googol_pt_format{
    .format = {.name = "googol-pt",
               .maker = "Googol, calls of a PT table in C",
               .knot = "a call `GT_PtData(axis, position, time, type, fifo)`",
               .source = pt_source,
               .extension = "",
               .join = KnotJoin::quadratic,
               .axis = Domain::time,
               .x_unit = "ms",
               .p = Numbers::counts,
               .x_step = 1,
               .keeps_units = true,
               .states_period = true,
               .most = 1025,
               .limits_from = "a FIFO holds at most 1024 segments",
               .not_kept = relative},
    .detects = [](const std::string& text) { return calls(text, pt_mode, false); },
    .read = [](const std::string& text,
               const Place& place) { return read_program(pt_mode, text, place); },
    .write = [](const TableFile& file) { return program(pt_mode, {false}, file); }};

constinit const FormatRow googol_pt_st_format{
    .format = {.name = "googol-pt-st",
               .maker = "Googol, calls of a PT table in Structured Text",
               .knot = "a call `GT_PtData(axis, position, time, type, fifo)`",
               .source = pt_source,
               .extension = "",
               .join = KnotJoin::quadratic,
               .axis = Domain::time,
               .x_unit = "ms",
               .p = Numbers::counts,
               .x_step = 1,
               .keeps_units = true,
               .states_period = true,
               .most = 1025,
               .limits_from = "a FIFO holds at most 1024 segments",
               .not_kept = relative},
    .detects = [](const std::string& text) { return calls(text, pt_mode, true); },
    .read = [](const std::string& text,
               const Place& place) { return read_program(pt_mode, text, place); },
    .write = [](const TableFile& file) { return program(pt_mode, {true}, file); }};

constinit const FormatRow googol_follow_format{
    .format = {.name = "googol-follow",
               .maker = "Googol, calls of a follow table in C",
               .knot = "a call `GT_FollowData(axis, master, slave, type, fifo)`",
               .source = follow_source,
               .extension = "",
               .join = KnotJoin::quadratic,
               .x = Numbers::whole,
               .p = Numbers::counts,
               .keeps_units = true,
               .states_period = true,
               .most = 513,
               .limits_from = "a FIFO holds at most 512 segments",
               .not_kept = relative},
    .detects = [](const std::string& text) { return calls(text, follow_mode, false); },
    .read = [](const std::string& text,
               const Place& place) { return read_program(follow_mode, text, place); },
    .write = [](const TableFile& file) { return program(follow_mode, {false}, file); }};

constinit const FormatRow googol_follow_st_format{
    .format = {.name = "googol-follow-st",
               .maker = "Googol, calls of a follow table in Structured Text",
               .knot = "a call `GT_FollowData(axis, master, slave, type, fifo)`",
               .source = follow_source,
               .extension = "",
               .join = KnotJoin::quadratic,
               .x = Numbers::whole,
               .p = Numbers::counts,
               .keeps_units = true,
               .states_period = true,
               .most = 513,
               .limits_from = "a FIFO holds at most 512 segments",
               .not_kept = relative},
    .detects = [](const std::string& text) { return calls(text, follow_mode, true); },
    .read = [](const std::string& text,
               const Place& place) { return read_program(follow_mode, text, place); },
    .write = [](const TableFile& file) { return program(follow_mode, {true}, file); }};

}  // namespace jounce::controllers_detail
