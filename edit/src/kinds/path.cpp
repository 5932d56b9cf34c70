// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <variant>

#include <fmt/format.h>

#include "jounce/spec/spec.hpp"

#include "edit/src/kinds/kinds.hpp"
#include "edit/src/kinds/path_ends.hpp"

namespace jounce::edit_detail {
namespace {

/// A point of a command: the list of numbers `key`, moved by `shift` from the text to the plane.
Json at(const Editable& editable, const std::string& key, const Point& shift, std::size_t axes) {
  Json all = Json::array();
  for (std::size_t a = 0; a < axes; ++a) {
    const std::string element = fmt::format("{}[{}]", key, a + 1);
    const TextNumber* number = editable.find(element);
    if (number == nullptr) return nullptr;
    all.push_back(editable.coordinate(number->value + shift[a], element));
  }
  return all;
}

}  // namespace

std::vector<Point> ends_of(const Program& program) {
  std::vector<Point> ends;
  Point last = program.start();
  for (const Program::Command& command : program.commands()) {
    switch (command.kind) {
      case Program::Kind::line:
        for (std::size_t a = 0; a < program.axes(); ++a)
          last[a] = program.numbers()[command.data + a];
        break;
      case Program::Kind::arc:
        last = program.arcs()[command.data].to;
        break;
      case Program::Kind::curve:
        last = program.curves()[command.data].to;
        break;
      case Program::Kind::dwell:
        break;
    }
    ends.push_back(last);
  }
  return ends;
}

Point shift_of(const Editable& editable, const std::string& row, const Point& from,
               const Point& end, std::size_t axes) {
  Point shift{};
  for (std::size_t a = 0; a < axes; ++a) {
    const TextNumber* to = editable.find(fmt::format("{}.to[{}]", row, a + 1));
    if (to != nullptr)
      shift[a] = end[a] - to->value;
    else if (editable.line(row + ".relative") > 0)
      shift[a] = from[a];
  }
  return shift;
}

void add_path(Editable& editable) {
  const auto* path = std::get_if<PathSpec>(&editable.spec().subject);
  if (path == nullptr) return;
  const std::size_t axes = path->program.axes();
  const std::vector<Point> ends = ends_of(path->program);
  if (axes < 2 || editable.count("command") != ends.size()) return;  // records or a G-code program
  std::vector<std::string> columns;
  std::vector<std::string> heads;
  for (const char* key : {"to", "center", "via"})
    for (std::size_t a = 0; a < axes; ++a) {
      columns.push_back(fmt::format("{}[{}]", key, a + 1));
      heads.push_back(fmt::format("{} {}", key, editable.spec().axes[a].name));
    }
  for (const char* key : {"radius", "angle", "time", "velocity"}) {
    columns.emplace_back(key);
    heads.emplace_back(key);
  }
  editable.add_points({"command", "Commands", "command", columns, heads});
  Point from = path->program.start();
  if (Json start = at(editable, "path.start", {}, axes); !start.is_null())
    editable.add_plane_handle("start", std::move(start));
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const std::string row = fmt::format("command[{}]", i + 1);
    const std::string label = fmt::format("command {}", i + 1);
    const Point shift = shift_of(editable, row, from, ends[i], axes);
    const auto add = [&](const std::string& what, const std::string& key, bool end,
                         bool corner = false) {
      Json place = at(editable, key, shift, axes);
      if (place.is_null()) return;
      Json& handle = editable.add_plane_handle(label + what, std::move(place));
      handle["before"] = i + 1;  // the number of the command
      if (end && ends.size() > 1) handle["remove"] = {{"do", "remove"}, {"row", row}};
      if (!end) handle["small"] = true;
      if (corner) handle["corner"] = true;  // a corner of the polygon of a spline
    };
    add("", row + ".to", true);
    add(": center", row + ".center", false);
    add(": via", row + ".via", false);
    const std::size_t points = editable.count(row + ".point");
    for (std::size_t k = 1; k <= points; ++k)
      add(fmt::format(": point {}", k), fmt::format("{}.point[{}].to", row, k), false, true);
    from = ends[i];
  }
  editable.permit_plane_insert();
}

}  // namespace jounce::edit_detail
