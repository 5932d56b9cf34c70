// SPDX-License-Identifier: Apache-2.0
#include <optional>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "jounce/base/file.hpp"
#include "jounce/pvt/reduce.hpp"

#include "python/src/bind.hpp"
#include "python/src/numpy/column.hpp"
#include "python/src/report.hpp"
#include "python/src/table.hpp"
#include "python/src/words.hpp"

namespace jounce::python {

using namespace py::literals;

namespace {

std::vector<double> column(const char* key, const Doubles& array) {
  if (array.ndim() != 1) throw InputError(key, "", "must be an array with one axis");
  return {array.data(), array.data() + array.size()};
}

NamedTable made_table(const Doubles& x, const Doubles& position,
                      const std::optional<Doubles>& velocity,
                      const std::optional<Doubles>& acceleration, Domain domain,
                      Extrapolation outside, std::string x_unit, std::string position_unit) {
  Columns columns{column("x", x), column("position", position), {}, {}};
  if (velocity) columns.v = column("velocity", *velocity);
  if (acceleration) columns.a = column("acceleration", *acceleration);
  const Interpolation rule = acceleration ? Interpolation::quintic_hermite
                             : velocity   ? Interpolation::cubic_hermite
                                          : Interpolation::linear;
  return {{Table(domain, rule, outside, std::move(columns)),
           {std::move(x_unit), std::move(position_unit)},
           {"", "", made_by()}}};
}

py::object column_view(const py::object& self, std::vector<double> Columns::*member) {
  const std::vector<double>& values = self.cast<const NamedTable&>().file.table.columns().*member;
  if (values.empty()) return py::none();
  return view(values, self);
}

void require_inside(const Table& table, const Reader& x, std::size_t size) {
  if (table.outside() != Extrapolation::refuse) return;
  for (std::size_t i = 0; i < size; ++i)
    if (!(x[i] >= table.start() && x[i] <= table.end()))
      throw InputError("x", x[i],
                       "must be from " + number(table.start()) + " to " + number(table.end()));
}

template <class Over>
py::object table_point(const Table& table, Broadcast& all, const Reader& x) {
  if (all.is_scalar()) return point_of<Over>(table.jet(x[0]));
  return points_of<Over>(all.shape(), all.size(), [&](std::size_t i) { return table.jet(x[i]); });
}

py::object table_at(const NamedTable& self, const Column& x) {
  const Table& table = self.file.table;
  Broadcast all({&x});
  const Reader places = all.read(x);
  require_inside(table, places, all.size());
  return table.axis() == Domain::time ? table_point<OverTime>(table, all, places)
                                      : table_point<OverMaster>(table, all, places);
}

py::tuple sampled_table(const NamedTable& self, double step) {
  const Table& table = self.file.table;
  const py::array_t<double> x = taken(instants(table.start(), table.end(), step));
  Column places;
  places.array = Doubles(x);
  return py::make_tuple(x, table_at(self, places));
}

py::object table_curve(const NamedTable& self) {
  const Table& table = self.file.table;
  return table.axis() == Domain::time ? py::cast(table.curve<OverTime>())
                                      : py::cast(table.curve<OverMaster>());
}

std::string text_of(const TableFile& file, const std::string& format) {
  if (format == "csv") return to_csv(file);
  if (format == "json") return to_json(file);
  throw InputError("format", format, "must be one of csv, json");
}

std::string table_repr(const NamedTable& self) {
  const Table& table = self.file.table;
  return shown("Table", {{"knots", std::to_string(table.size())},
                         {"rule", std::string("'") + name(table.rule()) + "'"},
                         {"domain", std::string("'") + name(table.axis()) + "'"},
                         {"start", shown(table.start())},
                         {"end", shown(table.end())}});
}

std::string content_of(const NamedTable& t) {
  return hex(content_hash(t.file.table, t.file.units));
}

/// A column as an array of its own, which pickle stores as bytes.
py::array_t<double> copied(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::tuple table_state(const NamedTable& t) {
  const auto& [x, p, v, a] = t.file.table.columns();
  const Provenance& from = t.file.provenance;
  const auto& e = t.error;
  return py::make_tuple(t.file.table.axis(), t.file.table.rule(), t.file.table.outside(),
                        py::make_tuple(copied(x), copied(p), copied(v), copied(a)),
                        py::make_tuple(t.file.units.x, t.file.units.position),
                        py::make_tuple(from.spec, from.spec_sha256, from.made_by),
                        e ? py::make_tuple(e->position, e->where, e->velocity) : py::tuple());
}

NamedTable table_of_state(const py::tuple& state) {
  const auto columns = state[3].cast<std::array<std::vector<double>, 4>>();
  const auto units = state[4].cast<std::array<std::string, 2>>();
  const auto from = state[5].cast<std::array<std::string, 3>>();
  NamedTable table{
      {Table(state[0].cast<Domain>(), state[1].cast<Interpolation>(),
             state[2].cast<Extrapolation>(), {columns[0], columns[1], columns[2], columns[3]}),
       {units[0], units[1]},
       {from[0], from[1], from[2]}}};
  const auto error = state[6].cast<py::tuple>();
  if (error.empty()) return table;
  table.error = SampleError{};
  table.error->position = error[0].cast<double>();
  table.error->where = error[1].cast<double>();
  table.error->velocity = error[2].cast<double>();
  return table;
}

void bind_table(py::module_& m) {
  py::class_<SampleError>(m, "TableError",
                          "The certified greatest error of a table against its exact curve.")
      .def_readonly("position", &SampleError::position,
                    "Greatest difference of the position, u: exact, not sampled.")
      .def_readonly("where", &SampleError::where, "Its place: time (s) or master position (m).")
      .def_readonly("velocity", &SampleError::velocity,
                    "Greatest difference of the first derivative.")
      .def("__repr__", [](const SampleError& e) {
        return shown("TableError", {{"position", shown(e.position)}, {"where", shown(e.where)}});
      });
  py::class_<NamedTable>(
      m, "Table", R"(An immutable table: knots in columns, and the interpolation between them.

Without a velocity, the interpolation is linear; with one, it is cubic ("cubic_hermite", PVT); with an acceleration,
quintic ("quintic_hermite", PVA or XYVA).)")
      .def(
          py::init(&made_table), "x"_a, "position"_a, "velocity"_a = py::none(),
          "acceleration"_a = py::none(), py::kw_only(), "domain"_a = Domain::time,
          "outside"_a = Extrapolation::hold, "x_unit"_a = "", "position_unit"_a = "",
          R"(x: time (s), or master position with domain="master". velocity, acceleration: derivatives with
respect to x.

`outside` is "refuse", "hold", "wrap" or "advance". Raises InputError for columns that do not make a table.)")
      .def_property_readonly(
          "x", [](const py::object& self) { return column_view(self, &Columns::x); },
          "Times or master positions: a read-only view without a copy.")
      .def_property_readonly(
          "position", [](const py::object& self) { return column_view(self, &Columns::p); },
          "Positions: a read-only view without a copy.")
      .def_property_readonly(
          "velocity", [](const py::object& self) { return column_view(self, &Columns::v); },
          "First derivatives: a read-only view without a copy; None if the rule needs none.")
      .def_property_readonly(
          "acceleration", [](const py::object& self) { return column_view(self, &Columns::a); },
          "Second derivatives: a read-only view without a copy; None if the rule needs none.")
      .def_property_readonly(
          "rule", [](const NamedTable& t) { return t.file.table.rule(); },
          R"("linear", "cubic_hermite" or "quintic_hermite".)")
      .def_property_readonly(
          "domain", [](const NamedTable& t) { return t.file.table.axis(); },
          R"("time" or "master".)")
      .def_property_readonly(
          "outside", [](const NamedTable& t) { return t.file.table.outside(); },
          R"(Policy outside the table: "refuse", "hold", "wrap" or "advance".)")
      .def_property_readonly(
          "x_unit", [](const NamedTable& t) { return t.file.units.x; }, "Unit of x; may be empty.")
      .def_property_readonly(
          "position_unit", [](const NamedTable& t) { return t.file.units.position; },
          "Unit of the position; may be empty.")
      .def_property_readonly("hash", content_of,
                             "SHA-256 of the content: the same in CSV, in JSON and on the wire.")
      .def_readonly("error", &NamedTable::error,
                    "Certified error against its curve, as a TableError; None if unknown.")
      .def_property_readonly("curve", table_curve,
                             "The same polynomials as a Trajectory or Cam, for exact checks.")
      .def("__len__", [](const NamedTable& t) { return t.file.table.size(); })
      .def(
          "__eq__",
          [](const NamedTable& t, const py::object& other) {
            return py::isinstance<NamedTable>(other) &&
                   content_of(t) == content_of(other.cast<const NamedTable&>());
          },
          "other"_a, "True if the tables have the same hash.")
      .def(
          "__hash__", [](const NamedTable& t) { return py::hash(py::str(content_of(t))); },
          "Returns the hash of the content.")
      .def(py::pickle([](const NamedTable& t) { return table_state(t); },
                      [](const py::tuple& state) { return table_of_state(state); }))
      .def(
          "__call__",
          [](const NamedTable& t, const Column& x) -> py::object {
            return table_at(t, x).attr("position");
          },
          "x"_a, "Returns the position at x: a number, or an array of the shape of x.")
      .def("at", table_at, "x"_a,
           "Returns the position and three derivatives at x, as a Motion (over time) or a Transfer "
           "(over a master).")
      .def("sample", sampled_table, "step"_a,
           "Returns the places start, start + step, ... and the end, and the motion there, as "
           "(places, motion).")
      .def(
          "text",
          [](const NamedTable& t, const std::string& format) { return text_of(t.file, format); },
          "format"_a = "csv", R"(Returns the content of a table file: "csv" or "json".)")
      .def(
          "write",
          [](const NamedTable& t, const std::filesystem::path& path) {
            write_table(path.string(), t.file);
          },
          "path"_a,
          R"(Writes a table file: JSON, LCM log or MCAP if the path ends in ".json", ".lcmlog" or ".mcap", otherwise
CSV. The whole file or nothing.

Raises InputError if a unit is missing, and OSError.)")
      .def("__repr__", table_repr);
  m.def(
      "read_table",
      [](const std::filesystem::path& path) { return NamedTable{read_table(path.string())}; },
      "path"_a,
      "Reads a table file of Jounce: CSV, JSON, LCM log or MCAP. Raises InputError with its place "
      "for a wrong file.");
  m.def(
      "parse_table",
      [](const std::string& text, const std::string& name) {
        return NamedTable{parse_table(text, name)};
      },
      "text"_a, "name"_a = "table",
      "Reads a table from the text of a file. `name` is its name in errors.");
}

NamedTable file_of(Sampled made, const std::string& x_unit, const std::string& position_unit) {
  return {{std::move(made.table), {x_unit, position_unit}, {"", "", made_by()}}, made.error};
}

template <class Over>
Sampled sampled(const Curve<Over>& f, Interpolation rule, const std::optional<double>& tolerance,
                const std::optional<std::size_t>& intervals,
                const std::optional<std::vector<double>>& knots) {
  if (int{tolerance.has_value()} + int{intervals.has_value()} + int{knots.has_value()} > 1)
    throw InputError("tolerance", "", "give only one of tolerance, intervals and knots");
  if (intervals) return sample(f, rule, *intervals);
  if (knots) return sample(f, rule, *knots);
  if (tolerance) return sample_within(f, rule, *tolerance);
  return sample(f, rule, std::vector(f.breaks().begin(), f.breaks().end()));
}

template <class Over>
void bind_sampling(py::module_& m, const char* name) {
  auto c = py::reinterpret_borrow<py::class_<Curve<Over>>>(m.attr(name));
  c.def(
       "table",
       [](const Curve<Over>& f, Interpolation rule, const std::optional<double>& tolerance,
          const std::optional<std::size_t>& intervals,
          const std::optional<std::vector<double>>& knots, const std::string& x_unit,
          const std::string& position_unit) {
         return file_of(sampled(f, rule, tolerance, intervals, knots), x_unit, position_unit);
       },
       "rule"_a = Interpolation::quintic_hermite, py::kw_only(), "tolerance"_a = py::none(),
       "intervals"_a = py::none(), "knots"_a = py::none(), "x_unit"_a = "", "position_unit"_a = "",
       py::call_guard<py::gil_scoped_release>(),
       R"(Returns a table of this curve, with its certified error.

By default the knots are the breaks. `tolerance` (u): as few equal intervals in each segment as keep the error.
`intervals`: so many equal intervals. `knots`: these places.)")
      .def(
          "reduced_table",
          [](const Curve<Over>& f, Interpolation rule, const std::optional<double>& tolerance,
             const std::optional<double>& velocity_tolerance,
             const std::optional<std::size_t>& most, double spacing, double x_step, double p_step,
             double v_step, const std::string& x_unit, const std::string& position_unit) {
            const Target target{.rule = rule,
                                .quadratic = false,
                                .tolerance = tolerance,
                                .velocity_tolerance = velocity_tolerance,
                                .most = most,
                                .spacing = spacing,
                                .x_step = x_step,
                                .p_step = p_step,
                                .v_step = v_step};
            return file_of(reduced(f, target), x_unit, position_unit);
          },
          "rule"_a = Interpolation::cubic_hermite, py::kw_only(), "tolerance"_a = py::none(),
          "velocity_tolerance"_a = py::none(), "most"_a = py::none(), "spacing"_a = 0.0,
          "x_step"_a = 0.0, "p_step"_a = 0.0, "v_step"_a = 0.0, "x_unit"_a = "",
          "position_unit"_a = "", py::call_guard<py::gil_scoped_release>(),
          R"(Returns the table with the fewest knots that a controller can hold, with its certified error.

`tolerance` (u), `velocity_tolerance`: permitted errors. `most`: number of knots; without a tolerance, the
table with the
smallest error. `spacing`: least distance of knots. `x_step`, `p_step`, `v_step`: knots at multiples of these,
such as 1
ms or 1 pulse; 0: anywhere.)");
}

}  // namespace

void bind_tables(py::module_& m) {
  bind_table(m);
  bind_sampling<OverTime>(m, "Trajectory");
  bind_sampling<OverMaster>(m, "Cam");
}

}  // namespace jounce::python
