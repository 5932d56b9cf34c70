// SPDX-License-Identifier: Apache-2.0
// Specs and table files, with their curves, tables and findings.
#include <pybind11/stl.h>

#include "jounce/design/detail/axes.hpp"
#include "jounce/design/detail/file_check.hpp"
#include "jounce/design/detail/reference.hpp"
#include "jounce/design/key_figures.hpp"
#include "jounce/design/over_time.hpp"

#include "python/src/bind.hpp"
#include "python/src/design.hpp"
#include "python/src/report.hpp"
#include "python/src/table.hpp"

namespace jounce::python {

using namespace py::literals;

Input input_of_argument(const py::object& source) {
  if (py::isinstance<Design>(source)) return source.cast<const Design&>().input;
  if (py::isinstance<NamedTable>(source))
    return input_of(source.cast<const NamedTable&>().file, "table");
  const auto path = py::cast<std::string>(py::module_::import("os").attr("fspath")(source));
  const py::gil_scoped_release release;
  return only_axis(read_inputs(path), path);
}

const Spec& spec_of(const Input& input, const char* what) {
  if (!input.spec) throw InputError(what, input.name, "needs a spec: this is a table");
  return *input.spec;
}

py::object from_json(const std::string& text) {
  return py::module_::import("json").attr("loads")(text);
}

namespace {

std::vector<Design> designs(std::vector<Input> inputs, const std::string& path,
                            const std::string& axis) {
  std::vector<Design> all;
  for (Input& input : axes_named(std::move(inputs), axis, path))
    all.push_back({std::move(input), path});
  return all;
}

std::vector<Design> read_all(const std::string& path, const std::string& machine,
                             const std::string& axis, bool decimal_comma) {
  return designs(machine.empty() ? read_inputs(path, decimal_comma) : gcode_inputs(path, machine),
                 path, axis);
}

Design read_one(const std::string& path, const std::string& machine, const std::string& axis,
                bool decimal_comma) {
  std::vector<Input> inputs;
  for (Design& design : read_all(path, machine, axis, decimal_comma))
    inputs.push_back(std::move(design.input));
  return {only_axis(std::move(inputs), path), path};
}

std::vector<Design> parse_all(const std::string& text, const std::string& name) {
  return designs(
      is_finished_table(text) ? table_inputs(text, name) : inputs_of(parse_spec(text, name), name),
      name, "");
}

Design parse_one(const std::string& text, const std::string& name, const std::string& axis) {
  std::vector<Input> inputs;
  for (Design& design : parse_all(text, name)) inputs.push_back(std::move(design.input));
  return {only_axis(axes_named(std::move(inputs), axis, name), name), name};
}

std::string kind_of(const Design& design) {
  return design.input.spec ? spec_kind(design.input.spec->document.text) : "table";
}

NamedReport checked_design(const Design& design, int continuity,
                           const std::optional<Limits>& limits) {
  Input input = design.input;
  if (limits) input.limits = *limits;
  return {axis_report(input, continuity), input.labels};
}

std::vector<NamedFinding> findings_of(const Design& design) {
  return checked_design(design, 1, std::nullopt).findings();
}

py::object curve_of(const Design& design) {
  return std::visit([](const auto& curve) { return py::cast(curve); }, *design.input.curve);
}

std::vector<KeyFigure> figures_of(const Design& design, const std::vector<std::string>& names) {
  return assess(spec_of(design.input, "figures"), names).figures;
}

void bind_figures(py::module_& m) {
  py::class_<KeyFigure>(m, "KeyFigure", "A key figure of a design.")
      .def_readonly("name", &KeyFigure::name, R"("peak velocity", "duration", "peak torque", ...)")
      .def_readonly("value", &KeyFigure::value, "Value, in `unit`.")
      .def_readonly("unit", &KeyFigure::unit, "Unit; empty for a pure number.")
      .def_readonly("limit", &KeyFigure::limit, "Upper limit in the spec, or None.")
      .def("__repr__", [](const KeyFigure& f) {
        return shown("KeyFigure", {{"name", "'" + f.name + "'"},
                                   {"value", shown(f.value)},
                                   {"unit", "'" + f.unit + "'"}});
      });
}

/// The text of a spec, from which another process makes the design again.
py::tuple design_state(const Design& design) {
  const bool is_own = design.input.spec && design.input.spec->document.name == design.path;
  if (!is_own)
    throw py::type_error("cannot pickle this Design: load " + design.path +
                         " in the other process, or pickle its table, curve or report");
  return py::make_tuple(design.input.spec->document.text, design.path, design.input.axis);
}

Design design_of_state(const py::tuple& state) {
  return parse_one(state[0].cast<std::string>(), state[1].cast<std::string>(),
                   state[2].cast<std::string>());
}

void bind_design(py::module_& m) {
  const auto release = py::call_guard<py::gil_scoped_release>();
  py::class_<Design>(
      m, "Design",
      R"(One axis of a spec with its exact curve, its table and its findings; or a table file.

Make one with load() or parse().)")
      .def_property_readonly(
          "name", [](const Design& d) { return d.input.name; }, "Name of the spec, or of the file.")
      .def_property_readonly(
          "axis", [](const Design& d) { return d.input.axis; },
          "Name of the axis if there are several.")
      .def_property_readonly(
          "kind", kind_of, R"(Kind of the spec: "cam", "move", "path", ...; "table" for a table.)")
      .def_property_readonly(
          "path", [](const Design& d) { return d.path; }, "Path of the file.")
      .def_property_readonly(
          "text",
          [](const Design& d) {
            return d.input.spec ? std::optional(d.input.spec->document.text) : std::nullopt;
          },
          "Text of the spec; None for a table.")
      .def_property_readonly("curve", curve_of, "The exact curve: a Cam or a Trajectory.")
      .def_property_readonly(
          "table",
          [](const Design& d) {
            return NamedTable{d.input.table, d.input.error};
          },
          "The table for a controller, with its certified error.")
      .def_property_readonly(
          "limits", [](const Design& d) { return d.input.limits; }, "Limits of the spec.")
      .def_property_readonly(
          "x_unit", [](const Design& d) { return d.input.labels.units.x; },
          "Unit of the time or of the master.")
      .def_property_readonly(
          "position_unit", [](const Design& d) { return d.input.labels.units.position; },
          "Unit of the position.")
      .def(
          "unit_of",
          [](const Design& d, const std::string& quantity) {
            return d.input.labels.unit_of(quantity);
          },
          "quantity"_a, R"(Returns the unit of "position", "geo_velocity", "acceleration", ...)")
      .def_property_readonly(
          "segments", [](const Design& d) { return d.input.labels.segments; },
          "Name of the segment to which each piece of the curve belongs; may be empty.")
      .def_property_readonly("findings", findings_of,
                             "The findings of check(), the broken ones first.", release)
      .def(
          "check", checked_design, "continuity"_a = 1, py::kw_only(), "limits"_a = py::none(),
          release,
          R"(Checks the limits and the continuity exactly, like `jounce check`, and returns a Report.

continuity: highest derivative that must be continuous, 0 to 3. limits: Limits in place of those of the spec.)")
      .def(
          "figures", figures_of, "names"_a = std::vector<std::string>{}, release,
          R"(Returns the key figures as a list of KeyFigure: peaks, rms values, duration, figures of the drive.

names: only these. A drive is simulated if one of its figures is requested, or all are. Raises InputError for a
table.)")
      .def(
          "over_time",
          [](const Design& d) {
            return Design{over_time(d.input), d.path};
          },
          release,
          "Returns the slave of a cam as a motion over time, for the [master] of the spec.")
      .def_property_readonly(
          "master", [](const Design& d) { return master_of(d.input); },
          "Motion of the cam's master over seconds. Raises InputError if there is no [master].")
      .def(py::pickle([](const Design& d) { return design_state(d); },
                      [](const py::tuple& state) { return design_of_state(state); }))
      .def("__repr__", [](const Design& d) {
        return shown("Design",
                     {{"name", "'" + d.input.name + "'"}, {"kind", "'" + kind_of(d) + "'"}});
      });
}

std::string path_of(const py::object& path) {
  return py::cast<std::string>(py::module_::import("os").attr("fspath")(path));
}

template <class Read>
auto without_gil(const Read& read) {
  const py::gil_scoped_release release;
  return read();
}

}  // namespace

void bind_designs(py::module_& m) {
  bind_figures(m);
  bind_design(m);
  m.def(
      "load",
      [](const py::object& path, const std::string& axis, const std::string& machine,
         bool decimal_comma) {
        const std::string file = path_of(path);
        return without_gil([&] { return read_one(file, machine, axis, decimal_comma); });
      },
      "path"_a, py::kw_only(), "axis"_a = "", "machine"_a = "", "decimal_comma"_a = false,
      R"(Reads a spec, a table, or a table in the format of a controller, and returns its Design.

axis: for a file with several axes, the name of one. machine: for a G-code program, the path spec of the machine.
decimal_comma: reads 0,5 as 0.5 in a controller's table. Raises InputError with file, line, column, key, value
and rule.)");
  m.def(
      "load_axes",
      [](const py::object& path, const std::string& machine, bool decimal_comma) {
        const std::string file = path_of(path);
        return without_gil([&] { return read_all(file, machine, "", decimal_comma); });
      },
      "path"_a, py::kw_only(), "machine"_a = "", "decimal_comma"_a = false,
      "Like load(), for a file with any number of axes: returns a list of Design.");
  m.def("parse", parse_one, "text"_a, "name"_a = "spec.toml", py::kw_only(), "axis"_a = "",
        py::call_guard<py::gil_scoped_release>(),
        "Makes the Design of a spec or a table from its text. `name` is the name of the file in "
        "errors.");
  m.def("parse_axes", parse_all, "text"_a, "name"_a = "spec.toml",
        py::call_guard<py::gil_scoped_release>(),
        "Like parse(), for a text with any number of axes: returns a list of Design.");
}

}  // namespace jounce::python
