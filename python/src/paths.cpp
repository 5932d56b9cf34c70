// SPDX-License-Identifier: Apache-2.0
// Paths of several axes: specs of kind "path" and G-code programs.
#include <cmath>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "jounce/design/detail/file_check.hpp"

#include "python/src/bind.hpp"
#include "python/src/design.hpp"
#include "python/src/numpy/column.hpp"
#include "python/src/report.hpp"
#include "python/src/words.hpp"

namespace jounce::python {

using namespace py::literals;

namespace {

/// A planned path: its axes, with the motion of each over time.
struct PathMotion {
  std::vector<Design> axes;

  [[nodiscard]] const Trajectory& curve(std::size_t axis) const {
    return std::get<Trajectory>(*axes[axis].input.curve);
  }
  [[nodiscard]] double duration() const { return curve(0).end(); }
};

PathMotion path_of(std::vector<Input> inputs, const std::string& path) {
  const Spec* const spec = inputs.front().spec ? &*inputs.front().spec : nullptr;
  if (spec == nullptr || !std::holds_alternative<PathSpec>(spec->subject))
    throw InputError("path", path,
                     "must be a spec of kind \"path\", or a G-code program: use "
                     "load() for any other file");
  PathMotion motion;
  for (Input& input : inputs) motion.axes.push_back({std::move(input), path});
  return motion;
}

PathMotion planned(const std::filesystem::path& file, const std::filesystem::path& machine) {
  const std::string path = file.string();
  return path_of(machine.empty() ? read_inputs(path) : gcode_inputs(path, machine.string()), path);
}

PathMotion planned_text(const std::string& text, const std::string& name) {
  return path_of(inputs_of(parse_spec(text, name), name), name);
}

FileCheck check_of(const PathMotion& path, std::vector<Input>& axes) {
  std::vector<Report> reports;
  for (const Design& axis : path.axes) {
    reports.push_back(axis_report(axis.input));
    axes.push_back(axis.input);
  }
  return file_check(axes, std::move(reports));
}

/// The motion of all axes: the shape of t, and one more axis for those of the machine.
py::object path_motion_at(const PathMotion& path, const Column& t) {
  Broadcast all({&t});
  const Reader times = all.read(t);
  Broadcast::Shape shape = all.shape();
  shape.push_back(static_cast<py::ssize_t>(path.axes.size()));
  const std::size_t n = path.axes.size();
  std::vector<const Trajectory*> curves;
  for (std::size_t i = 0; i < n; ++i) curves.push_back(&path.curve(i));
  return points_of<OverTime>(shape, all.size() * n, [&](std::size_t k) {
    const double at = times[k / n];
    const Side side = at == curves[k % n]->end() ? Side::left : Side::right;
    return std::isnan(at) ? Jet{at, at, at, at} : curves[k % n]->jet(at, side);
  });
}

py::tuple sampled_path(const PathMotion& path, double step) {
  const py::array_t<double> t = taken(instants(0, path.duration(), step));
  Column column;
  column.array = Doubles(t);
  return py::make_tuple(t, path_motion_at(path, column));
}

std::vector<std::string> names_of(const PathMotion& path) {
  std::vector<std::string> names;
  for (const Design& axis : path.axes) names.push_back(axis.input.axis);
  return names;
}

}  // namespace

void bind_paths(py::module_& m) {
  py::class_<PathMotion>(
      m, "Path", R"(A planned path of several axes over time: corners, look-ahead and limits.

Make one with plan_path() or parse_path(). In each array, the last axis is that of the machine's axes.)")
      .def_property_readonly("axes", names_of, "Names of the axes, in the order of the arrays.")
      .def_readonly("designs", &PathMotion::axes,
                    "A Design for each axis: its exact curve, its table and its limits.")
      .def_property_readonly("duration", &PathMotion::duration,
                             "Duration, in the unit of time of the spec: s by default.")
      .def(
          "at", path_motion_at, "t"_a,
          R"(Returns the motion of all axes at t (s), as a Motion of arrays of the shape of t and (axes,).

u, u/s, u/s^2, u/s^3, each in the unit of its axis. Outside [0, duration], the axes rest at the nearer end.)")
      .def(
          "sample", sampled_path, "step"_a,
          R"(Returns the times 0, step, 2 step, ... and the end (s), and the motion there, as (t, motion).

Each array has a row for each time and a column for each axis.)")
      .def_property_readonly(
          "ok",
          [](const PathMotion& path) {
            std::vector<Input> axes;
            return check_of(path, axes).ok();
          },
          "True if no limit of an axis or of the path is broken.")
      .def_property_readonly(
          "reports",
          [](const PathMotion& path) {
            std::vector<NamedReport> reports;
            for (const Design& axis : path.axes)
              reports.push_back({axis_report(axis.input), axis.input.labels});
            return reports;
          },
          "A Report for each axis.")
      .def_property_readonly(
          "data",
          [](const PathMotion& path) {
            std::vector<Input> axes;
            const FileCheck check = check_of(path, axes);
            return from_json(file_check_json(check, axes));
          },
          R"(All results of `jounce check` as a dict: "path" has lengths, times, corners and events.)")
      .def("__len__", [](const PathMotion& path) { return path.axes.size(); })
      .def("__repr__", [](const PathMotion& path) {
        std::string axes;
        for (const std::string& name : names_of(path)) axes += (axes.empty() ? "" : ", ") + name;
        return shown("Path", {{"axes", "[" + axes + "]"}, {"duration", shown(path.duration())}});
      });
  m.def(
      "plan_path", planned, "path"_a, py::kw_only(), "machine"_a = "",
      py::call_guard<py::gil_scoped_release>(),
      R"(Plans the path of a file: a spec of kind "path", or a G-code program with `machine`, the spec of its axes.

Raises InputError with file, line, key and rule.)");
  m.def("parse_path", planned_text, "text"_a, "name"_a = "spec.toml",
        py::call_guard<py::gil_scoped_release>(),
        "Plans the path of the text of a spec. `name` is its name in errors.");
}

}  // namespace jounce::python
