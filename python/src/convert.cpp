// SPDX-License-Identifier: Apache-2.0
// Tables in the formats of controllers.
#include "jounce/design/convert.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "jounce/base/file.hpp"
#include "jounce/controllers/table_target.hpp"

#include "python/src/bind.hpp"
#include "python/src/design.hpp"
#include "python/src/report.hpp"
#include "python/src/table.hpp"
#include "python/src/words.hpp"

namespace jounce::python {

using namespace py::literals;

namespace {

struct Result {
  NamedTable table;
  std::string text;                 ///< content of the file
  std::vector<std::string> losses;  ///< contents of the input that the file does not have
  std::string summary;
};

struct Wanted {
  std::string output, to, rule;
  TargetTexts target;
  std::size_t intervals = 0;
  Units units;
  bool periodic = false;
  bool allow_loss = false;
};

/// Returns the form. Throws InputError if neither a word nor the ending of the path determines it.
TableForm known_form(const std::string& to, const std::string& output) {
  const TableForm form = table_form(to, output);
  if (!to.empty() && form.format == nullptr && to != "csv" && to != "json" && to != "points")
    throw InputError("to", to, "must be csv, json, points or a name of formats()");
  if (to.empty() && !output.empty() && !has_known_ending(output))
    throw InputError("output", output,
                     "must end in one of " + known_endings() + "; or name the format with `to`");
  return form;
}

Result converted_input(const Input& input, const Wanted& wanted) {
  const TableForm form = known_form(wanted.to, wanted.output);
  const Interpolation rule = rule_for(
      form,
      wanted.rule.empty() ? std::nullopt : std::optional(from_word<Interpolation>(wanted.rule)),
      wanted.target.controller, input.table.table);
  Conversion conversion{.rule = rule,
                        .target = {},
                        .intervals = wanted.intervals,
                        .units = wanted.units,
                        .periodic = wanted.periodic,
                        .format = form.format};
  if (wanted.target.any())
    conversion.target =
        target_of(wanted.target, input.table.table.axis(), rule, input.labels.units);
  const Converted made = converted(input, conversion);
  if (!made.within_limit() && !wanted.allow_loss)
    throw InputError("tolerance", *made.limit,
                     "is less than the error of the format, " + number(made.error->position) +
                         ": give more knots, a greater tolerance, or allow_loss = True");
  if (!made.keeps() && !wanted.allow_loss)
    throw InputError("allow_loss", "False",
                     "does not permit this table, which exceeds a limit that the motion keeps: " +
                         sentence(made.exceeded.findings.front(), input.labels) +
                         ". Change the knots, or give allow_loss = True");
  const std::vector<std::string> losses = all_losses(input, form, made.file.table);
  return {{made.file, made.error},
          form_text(form, made.file),
          losses,
          conversion_text(input, made, form, losses)};
}

std::string quantity_text(const py::object& value) {
  return value.is_none() ? "" : py::cast<std::string>(py::str(value));
}

Result convert(const py::object& source, const std::filesystem::path& output, const std::string& to,
               const std::string& rule, const std::string& controller, const py::object& tolerance,
               const py::object& velocity_tolerance, const std::optional<std::size_t>& most,
               std::size_t intervals, const std::string& x_unit, const std::string& position_unit,
               bool periodic, const py::object& x_step, const py::object& p_step, bool allow_loss) {
  const Input input = input_of_argument(source);
  if (py::isinstance<py::str>(source))
    require_other_file(py::cast<std::string>(source), output.string(), "output");
  Wanted wanted{output.string(),         to,       rule,      {}, intervals,
                {x_unit, position_unit}, periodic, allow_loss};
  wanted.target.controller = controller;
  wanted.target.tolerance = quantity_text(tolerance);
  wanted.target.velocity_tolerance = quantity_text(velocity_tolerance);
  wanted.target.most = most;
  wanted.target.x_step = quantity_text(x_step);
  wanted.target.p_step = quantity_text(p_step);
  const py::gil_scoped_release release;
  Result result = converted_input(input, wanted);
  if (!output.empty()) write_file(output.string(), result.text);
  return result;
}

}  // namespace

void bind_convert(py::module_& m) {
  py::class_<Result>(
      m, "Conversion",
      "A converted table, its difference from the input, and everything that is lost.")
      .def_readonly("table", &Result::table, "The converted table, with its certified error.")
      .def_readonly("text", &Result::text, "Content of the file.")
      .def_readonly("losses", &Result::losses,
                    "Contents of the input that the file does not have, one phrase for each.")
      .def("__str__", [](const Result& r) { return r.summary; })
      .def("__repr__", [](const Result& r) {
        return shown("Conversion", {{"knots", std::to_string(r.table.file.table.size())},
                                    {"losses", std::to_string(r.losses.size())}});
      });
  m.def(
      "convert", convert, "source"_a, "output"_a = "", py::kw_only(), "to"_a = "", "rule"_a = "",
      "controller"_a = "", "tolerance"_a = py::none(), "velocity_tolerance"_a = py::none(),
      "most"_a = py::none(), "intervals"_a = 0, "x_unit"_a = "", "position_unit"_a = "",
      "periodic"_a = false, "x_step"_a = py::none(), "p_step"_a = py::none(),
      "allow_loss"_a = false,
      R"(Converts a table to a format, other knots, another interpolation or other units, and states the loss.

source: a Design, a Table, or the path of a file. output: path to write; empty: none. to: "csv", "json",
"points" or a name
of formats(); empty: by the ending of output. rule: "linear", "cubic_hermite" or "quintic_hermite". controller,
tolerance,
velocity_tolerance, most: new knots, as few as possible; a tolerance is a number (u) or a text with a unit,
such as "1 um".
intervals: new equal intervals. x_unit, position_unit: units of the result, or units that the file does not state.
periodic: the motion repeats, although the file does not state it. x_step, p_step: for a format in counts, the
size of a count of the first column and of the position, such as "0.001 mm". allow_loss: also for an error
above the tolerance (by default, a ten-thousandth of the stroke).)");
  m.def(
      "formats",
      [] {
        std::vector<std::pair<std::string, std::string>> all;
        for (const ExchangeFormat* format : exchange_formats())
          all.emplace_back(format->name, format->maker);
        return all;
      },
      "Returns the formats of controllers as a list of (name, maker).");
}

}  // namespace jounce::python
