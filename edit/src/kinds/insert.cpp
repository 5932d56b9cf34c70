// SPDX-License-Identifier: Apache-2.0
#include "edit/src/kinds/insert.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "jounce/profiles/error.hpp"
#include "jounce/spec/detail/text_numbers.hpp"

#include "edit/src/cam_change.hpp"
#include "edit/src/editable.hpp"
#include "edit/src/kinds/passing.hpp"
#include "edit/src/kinds/path_ends.hpp"

namespace jounce::edit_detail {
namespace {

/// A spec of the text with its motion.
struct Source {
  Spec spec;
  std::vector<Input> axes;
  Editable editable;

  Source(const std::string& path, const std::string& text)
      : spec(parse_spec(text, path)), axes(inputs_of(spec, path)), editable(spec, axes) {}

  [[nodiscard]] const std::string& text() const { return spec.document.text; }
  [[nodiscard]] Jet at(double x) const {
    return std::visit([&](const auto& f) { return f.jet(x); }, *axes.front().curve);
  }
};

[[noreturn]] void refuse() {
  throw InputError("do", "insert", "does not apply to this motion: insert the point in the text");
}

/// A list whose points have a place x and values on the curve.
struct List {
  std::string key;
  std::string x;
  std::array<std::string, 4> values;  ///< keys of the value and its derivatives; "": none
  double origin = 0;                  ///< place of x = 0
  double origin_value = 0;            ///< position of value 0
};

/// Inserts a point like its neighbors: with the values that they have.
std::string with_point_in(const Source& source, const List& list, double x) {
  const std::size_t n = source.editable.count(list.key);
  std::size_t at = 0;
  const auto row = [&](std::size_t i) { return fmt::format("{}[{}].", list.key, i + 1); };
  for (; at < n; ++at) {
    const TextNumber* place = source.editable.find(row(at) + list.x);
    if (place == nullptr) refuse();
    if (place->value + list.origin == x) throw InputError("at", x, "is the place of a point");
    if (place->value + list.origin > x) break;
  }
  const Jet jet = source.at(x);
  const std::string like = row(at < n ? at : n - 1);
  std::vector<std::string> entries{entry_text(list.x, x - list.origin)};
  for (std::size_t order = 0; order < list.values.size(); ++order)
    if (!list.values[order].empty() && source.editable.find(like + list.values[order]) != nullptr)
      entries.push_back(
          entry_text(list.values[order], jet[order] - (order == 0 ? list.origin_value : 0)));
  return with_row(source.text(), list.key, at, entries);
}

std::string with_cam_point(const Source& source, const CamSpec& cam, double x,
                           const std::string& path) {
  for (std::size_t i = 0; i < cam.segments.size(); ++i) {
    if (x >= cam.segments[i].end.master || cam.segments[i].points.empty()) continue;
    const double start = i == 0 ? cam.start.master : cam.segments[i - 1].end.master;
    if (x <= start) break;
    return with_point_in(source,
                         {fmt::format("segment[{}].points", i + 1),
                          "master",
                          {"slave", "geo_velocity", "geo_acceleration", "geo_jerk"}},
                         x);
  }
  const Json change{{"do", "split"}, {"master", x}};
  return changed_cam(path, source.text(), JsonReader("change", change.dump()))->text;
}

std::string with_via_point(const Source& source, const AxesSpec& spec, double x) {
  const std::vector<double> times = passing_times(source.editable.curves(), spec.points);
  const auto after = std::upper_bound(times.begin(), times.end(), x);
  if (after == times.begin() || after == times.end() || *(after - 1) == x)
    throw InputError("at", x, "must be between two points");
  std::vector<double> place;
  for (const LazyCurve::Any* curve : source.editable.curves())
    place.push_back(position_at(*curve, x));
  return with_row(source.text(), "point", static_cast<std::size_t>(after - times.begin()),
                  {entry_text("position", place)});
}

std::string with_follow_point(const Source& source, const FollowPart& follow, double x) {
  List list{"point", "master", {"slave", "ratio", "", ""}};
  const auto* tables = std::get_if<FollowSpec>(&follow.slave);
  if (tables == nullptr) return with_point_in(source, list, x);
  const bool one = source.editable.count("segment") > 0;
  for (std::size_t k = 0; k < tables->tables.size(); ++k) {
    const FollowTable& table = tables->tables[k];
    if (table.segments.empty()) break;
    list.key = one ? "segment" : fmt::format("follow.table[{}].segment", k + 1);
    list.values = {"slave", "", "", ""};
    const PtPoint& end = table.segments.back();
    if (x < list.origin + end.x) {
      const TextNumber* last =
          source.editable.find(fmt::format("{}[{}].master", list.key, table.segments.size()));
      if (last == nullptr || last->value != end.x) refuse();  // increments
      return with_point_in(source, list, x);
    }
    if (table.loops != 1) break;
    list.origin += end.x;
    list.origin_value += end.position;
  }
  refuse();
}

}  // namespace

std::string with_point(const std::string& path, const std::string& text, double x) {
  const Source source(path, text);
  const auto [start, end] = std::visit([](const auto& f) { return std::pair(f.start(), f.end()); },
                                       *source.axes.front().curve);
  if (!(x > start && x < end)) throw InputError("at", x, "must be inside the motion");
  const auto& subject = source.spec.subject;
  if (const auto* cam = std::get_if<CamSpec>(&subject))
    return with_cam_point(source, *cam, x, path);
  if (std::holds_alternative<Table>(subject))
    return with_point_in(source, {"knot", "time", {"position", "velocity", "acceleration", ""}}, x);
  if (const auto* axes = std::get_if<AxesSpec>(&subject); axes != nullptr && !axes->points.empty())
    return with_via_point(source, *axes, x);
  if (const auto* table = std::get_if<TimeTableSpec>(&subject)) {
    const auto* pt = std::get_if<PtSpec>(table);
    if (pt == nullptr || source.editable.count("point") == 0) refuse();
    const std::string last = fmt::format("point[{}].time", pt->points.size());
    const TextNumber* number = source.editable.find(last);
    if (number == nullptr || number->value != pt->points.back().x) refuse();  // increments
    return with_point_in(source, {"point", "time", {"position", "", "", ""}}, x);
  }
  if (const auto* sync = std::get_if<SyncSpec>(&subject))
    if (const auto* follow = std::get_if<FollowPart>(sync))
      return with_follow_point(source, *follow, x);
  refuse();
}

std::string with_plane_point(const std::string& path, const std::string& text, std::size_t before,
                             const std::vector<double>& place) {
  const Spec spec = parse_spec(text, path);
  const Editable editable(spec, {});
  const auto* axes = std::get_if<AxesSpec>(&spec.subject);
  const auto* commands = std::get_if<PathSpec>(&spec.subject);
  const std::string list = commands != nullptr ? "command" : "point";
  const std::size_t n = editable.count(list);
  const std::size_t size = commands != nullptr ? commands->program.axes()
                           : axes != nullptr   ? axes->axes.size()
                                               : 0;
  if (size < 2 || n == 0) refuse();
  if (place.size() != size)
    throw InputError("place", std::to_string(place.size()) + " numbers",
                     fmt::format("must have {}, one for each axis", size));
  if (before > n)
    throw InputError("before", std::to_string(before), fmt::format("must be 1 to {}", n));
  if (commands == nullptr) return with_row(text, list, before - 1, {entry_text("position", place)});
  const std::string row = fmt::format("command[{}]", before);
  const Program::Command& command = commands->program.commands()[before - 1];
  if (command.kind != Program::Kind::line || editable.line(row + ".relative") > 0)
    throw InputError("before", std::to_string(before),
                     "must be a line whose end is not relative: insert the point in the text");
  const std::vector<Point> ends = ends_of(commands->program);
  const Point& from = before == 1 ? commands->program.start() : ends[before - 2];
  const Point shift = shift_of(editable, row, from, ends[before - 1], size);
  std::vector<double> to = place;
  for (std::size_t a = 0; a < size; ++a) to[a] -= shift[a];
  return with_row(text, list, before - 1, {"type = \"line\"", entry_text("to", to)});
}

}  // namespace jounce::edit_detail
