// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/exchange/exchange.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "jounce/base/detail/csv.hpp"
#include "jounce/base/detail/listed.hpp"
#include "jounce/base/detail/printable.hpp"
#include "jounce/base/units.hpp"
#include "jounce/io/detail/table_parts.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "controllers/src/exchange/formats.hpp"

namespace jounce {
namespace {

constexpr std::array note_keys{"master", "position", "outside", "knots", "sha256"};

/// Units and policy outside, from the comments.
void take_notes(const controllers_detail::Exchanged& read, const controllers_detail::Place& place,
                TableFile& file, Extrapolation& outside) {
  for (const auto& [key, target] :
       {std::pair{"master", &file.units.x}, {"position", &file.units.position}})
    if (const auto note = read.notes.find(key); note != read.notes.end()) {
      *target = note->second.value;
      if (!is_unit(*target)) place.fail(note->second.line, key, *target, "is not a known unit");
      if (target == &file.units.position && !is_position_unit(*target))
        place.fail(note->second.line, key, *target, "is not a unit of position");
    }
  if (const auto note = read.notes.find("outside"); note != read.notes.end())
    outside = io_detail::choice(note->second.value, std::span(io_detail::policies),
                                [&](const std::string& value, const std::string& rule) {
                                  place.fail(note->second.line, "outside", value, rule);
                                });
}

void require_whole(const controllers_detail::Exchanged& read,
                   const controllers_detail::Place& place, const TableFile& file) {
  const std::size_t knots = file.table.size();
  if (const auto note = read.notes.find("knots");
      note != read.notes.end() && note->second.value != std::to_string(knots))
    place.fail(
        note->second.line, "knots", note->second.value,
        "the number of knots in the file is " + std::to_string(knots) + ": is the file complete?");
  const auto note = read.notes.find("sha256");
  if (note == read.notes.end()) return;
  const std::string actual = hex(content_hash(file.table, file.units));
  if (note->second.value != actual)
    place.fail(note->second.line, "sha256", note->second.value,
               "does not match the content, whose hash is " + actual +
                   ": the file was changed after Jounce wrote it; to accept it, remove this line");
}

Table table_of(controllers_detail::Exchanged& read, Domain axis, Extrapolation outside,
               const controllers_detail::Place& place) {
  try {
    return Table(axis, read.rule, outside, std::move(read.columns));
  } catch (const InputError& error) {
    const bool of_a_knot = error.key().starts_with("knot[");
    const std::size_t knot = of_a_knot ? std::stoul(error.key().substr(5)) : 0;
    throw error.at(place.name(), knot == 0 ? 0 : read.lines[knot - 1]);
  }
}

ExchangeTable cam_of(controllers_detail::Exchanged& read, Domain axis,
                     const controllers_detail::Place& place) {
  Extrapolation outside = Extrapolation::hold;
  if (read.repeats && !read.columns.p.empty())
    outside = read.columns.p.front() == read.columns.p.back() ? Extrapolation::wrap
                                                              : Extrapolation::advance;
  TableFile file{
      Table(axis, Interpolation::linear, outside, {{0, 1}, {0, 1}, {}, {}}), read.units, {}};
  take_notes(read, place, file, outside);
  file.table = table_of(read, axis, outside, place);
  require_whole(read, place, file);
  return {read.name, std::move(file), std::move(read.unread)};
}

/// Lines of one of several cams: the comments above its last knot and below the cam before.
std::vector<controllers_detail::Line> own_lines(
    const controllers_detail::Exchanged& cam, const std::vector<controllers_detail::Exchanged>& all,
    const std::vector<controllers_detail::Line>& lines) {
  int from = 0;
  for (const controllers_detail::Exchanged& other : all)
    if (other.lines.back() < cam.lines.front()) from = std::max(from, other.lines.back());
  std::vector<controllers_detail::Line> own;
  for (const controllers_detail::Line& line : lines)
    if (line.number > from && line.number < cam.lines.back()) own.push_back(line);
  return own;
}

std::vector<ExchangeTable> cams_of(std::vector<controllers_detail::Exchanged> all, Domain axis,
                                   const std::vector<controllers_detail::Line>& lines,
                                   const controllers_detail::Place& place) {
  for (const controllers_detail::Exchanged& cam : all)
    if (cam.lines.empty())
      place.fail(lines.front().number, cam.name, "", "has no knots: is the file complete?");
  for (controllers_detail::Exchanged& cam : all)
    cam.notes = controllers_detail::notes_of(all.size() == 1 ? lines : own_lines(cam, all, lines));
  std::vector<ExchangeTable> cams;
  for (controllers_detail::Exchanged& cam : all) cams.push_back(cam_of(cam, axis, place));
  return cams;
}

/// Controllers hold counts in 32 bits.
void require_counts(const ExchangeFormat& format, const Columns& c) {
  constexpr double most = std::numeric_limits<std::int32_t>::max();
  const auto require = [&](Numbers numbers, const char* key, const std::vector<double>& column) {
    if (numbers != Numbers::whole) return;
    for (const double value : column)
      if (!(std::abs(value) <= most && value == std::round(value)))
        throw InputError(key, value, "must be a whole number of counts, of at most 32 bits");
  };
  require(format.x, "master", c.x);
  require(format.p, "position", c.p);
  require(format.p, "velocity", c.v);
}

void require_rest(const ExchangeFormat& format, const Columns& c) {
  double peak = 0;
  for (const double v : c.v) peak = std::max(peak, std::abs(v));
  for (const double v : {c.v.front(), c.v.back()})
    if (std::abs(v) > profiles_detail::rounded_input * peak)
      throw InputError("velocity", v,
                       std::string("must be 0 at both ends: a motion of the format ") +
                           format.name + " begins and ends at rest");
}

}  // namespace

namespace controllers_detail {

std::string_view trimmed(std::string_view text) {
  constexpr const char* white = " \t\r";
  const auto first = text.find_first_not_of(white);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(white) - first + 1);
}

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> all;
  for (int number = 1; !text.empty(); ++number) {
    const auto end = text.find('\n');
    const std::string_view line = trimmed(text.substr(0, end));
    if (!line.empty()) all.push_back({number, line});
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return all;
}

int line_at(const std::string& text, std::ptrdiff_t offset) {
  const auto end = text.begin() + std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(text));
  return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

bool is_comment(std::string_view line) {
  return line.starts_with('#') || line.starts_with("//");
}

Notes notes_of(const std::vector<Line>& lines) {
  Notes notes;
  for (const auto& [number, text] : lines) {
    if (!is_comment(text)) continue;
    const std::string_view words = trimmed(text.substr(
        text.find_first_not_of("#/") == text.npos ? text.size() : text.find_first_not_of("#/")));
    const auto colon = words.find(": ");
    const std::string key(words.substr(0, colon));
    if (colon != words.npos &&
        std::find(note_keys.begin(), note_keys.end(), key) != note_keys.end())
      notes[key] = {std::string(trimmed(words.substr(colon + 2))), number};
  }
  return notes;
}

std::string notes_text(const TableFile& file, const std::string& mark) {
  std::string text;
  const auto line = [&](const char* key, const std::string& value) {
    if (!value.empty()) text += mark + " " + key + ": " + value + "\n";
  };
  line("master", file.units.x);
  line("position", file.units.position);
  line("outside", jounce::name(file.table.outside()));
  line("knots", std::to_string(file.table.size()));
  line("sha256", hex(content_hash(file.table, file.units)));
  return text;
}

void Place::fail(int line, const std::string& key, std::string_view value,
                 const std::string& rule) const {
  throw InputError(key, printable(value), rule).at(name_, line);
}

double Place::number(int line, const std::string& key, std::string_view text) const {
  if (const auto value = csv_number(text)) return *value;
  std::string point(text);
  std::replace(point.begin(), point.end(), ',', '.');
  const auto value = csv_number(point);
  if (value && decimal_comma_) return *value;
  fail(line, key, '"' + std::string(text) + '"',
       value ? "has a decimal comma: write " + point +
                   ", or convert the file with `jounce convert --decimal-comma`"
             : "must be a finite number");
}

}  // namespace controllers_detail

namespace {

/// The names of the formats for motions over time, as a list: "ros, xps, zaber or ...".
std::string time_formats() {
  std::vector<std::string> names;
  for (const ExchangeFormat* format : exchange_formats())
    if (format->axis == Domain::time) names.emplace_back(format->name);
  const std::string last = names.back();
  names.pop_back();
  return listed(names) + " or " + last;
}

}  // namespace

void require_axis(const ExchangeFormat& format, const Table& table) {
  if (table.axis() == format.axis) return;
  throw InputError(
      "format", format.name,
      table.axis() == Domain::time
          ? "is for cams, over a master; this table is over time: choose the format " +
                time_formats()
          : std::string("is for motions over time; this table is a cam: give a spec with "
                        "[master], and convert it with --over time"));
}

std::string exchange_text(const ExchangeFormat& format, const TableFile& file) {
  const std::string wanted = std::string("the format ") + format.name;
  require_axis(format, file.table);
  if (file.table.rule() != rule_of(format))
    throw InputError("rule", name(file.table.rule()),
                     wanted + " needs a " + name(rule_of(format)) + " table");
  const std::size_t knots = file.table.size();
  if (knots < format.fewest)
    throw InputError(
        "knots", std::to_string(knots),
        "must be at least " + std::to_string(format.fewest) + ": " + format.limits_from);
  if (knots > format.most)
    throw InputError("knots", std::to_string(knots),
                     "must be at most " + std::to_string(format.most) + ": " + format.limits_from +
                         ". Give a tolerance, or fewer intervals");
  require_counts(format, file.table.columns());
  if (format.rests) require_rest(format, file.table.columns());
  return controllers_detail::row_of(format).write(file);
}

std::vector<ExchangeTable> parse_exchange_tables(const std::string& text, const std::string& name,
                                                 bool decimal_comma) {
  const controllers_detail::Place place(name, decimal_comma);
  const ExchangeFormat* const format = exchange_format_of_text(text, name);
  if (format == nullptr) place.fail(1, "", "", "is not a cam table in a known format");
  const controllers_detail::FormatRow& row = controllers_detail::row_of(*format);
  if (row.read == nullptr) place.fail(1, "", "", row.unreadable);
  return cams_of(row.read(text, place), format->axis, controllers_detail::lines_of(text), place);
}

TableFile parse_exchange(const std::string& text, const std::string& name, bool decimal_comma) {
  std::vector<ExchangeTable> cams = parse_exchange_tables(text, name, decimal_comma);
  if (cams.size() == 1) return std::move(cams.front().file);
  throw InputError(
      "", "",
      "contains several cams; choose one with --axis: " + listed(cams, &ExchangeTable::name))
      .at(name, 1);
}

}  // namespace jounce
