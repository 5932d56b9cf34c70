// SPDX-License-Identifier: Apache-2.0
// Optimization of specs.
#include "jounce/study/optimum.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "jounce/base/file.hpp"

#include "python/src/bind.hpp"
#include "python/src/design.hpp"
#include "python/src/report.hpp"

namespace jounce::python {

using namespace py::literals;

namespace {

/// The optimum of a spec, beside the given spec.
struct Improvement {
  SpecOptimum best;
  std::string text;    ///< for people
  std::string json;    ///< all numbers
  std::string broken;  ///< findings of a check that the result breaks; empty: none
  std::string name;    ///< name of the file
};

Improvement improved(const Spec& given, const std::optional<Spec>& drive,
                     const OptimumProgress& progress) {
  Improvement result;
  result.best = drive ? optimum_against(given, *drive, progress) : optimum_of(given, progress);
  result.name = given.document.name;
  result.text = result.best.text;
  result.json = result.best.json;
  if (!result.best.spec) return result;
  const Spec optimized = parse_spec(*result.best.spec, given.document.name);
  result.text += improvement_text(given, optimized);
  result.json = improvement_json(result.best, given, optimized);
  result.broken = broken_checks(optimized);
  return result;
}

Improvement optimize_spec(const py::object& source, const py::object& progress,
                          const std::optional<double>& seconds, const py::object& against) {
  Watch watch(progress);
  const Input input = input_of_argument(source);
  Spec spec = spec_of(input, "spec");
  std::optional<Spec> drive;
  if (!against.is_none()) {
    drive = read_spec(py::cast<std::string>(py::module_::import("os").attr("fspath")(against)));
    if (!drive->drive)
      throw drive->document.located(
          InputError("drive", "", "is missing: `against` needs a [drive]"));
  }
  const Improvement result = [&] {
    const py::gil_scoped_release release;
    prepare_optimum(spec, seconds);
    return improved(spec, drive,
                    [&](double done, const std::string& step) { return watch(done, step); });
  }();
  watch.rethrow();
  return result;
}

const std::string& usable_spec(const Improvement& result) {
  if (!result.best.spec)
    throw InputError("optimum", "", "has no spec: the best result breaks a limit");
  if (!result.broken.empty())
    throw InputError("optimum", "", "breaks these checks: " + result.broken);
  return *result.best.spec;
}

}  // namespace

void bind_optimum(py::module_& m) {
  py::class_<Improvement>(m, "Optimum", "The best values of everything that a spec leaves free.")
      .def_property_readonly(
          "ok", [](const Improvement& o) { return o.best.spec.has_value() && o.broken.empty(); },
          "True if the result keeps all limits and passes the check.")
      .def_property_readonly(
          "spec", [](const Improvement& o) { return o.best.spec; },
          "Text of the spec with the best values, otherwise unchanged; None: a limit is broken.")
      .def_property_readonly(
          "design",
          [](const Improvement& o) {
            const std::string& text = usable_spec(o);
            return py::module_::import("jounce").attr("parse")(text, o.name);
          },
          "The Design of the optimized spec. Raises InputError if the result is not usable.")
      .def_property_readonly(
          "data", [](const Improvement& o) { return from_json(o.json); },
          R"(All numbers as a dict: "status", "reason", "objectives" with bounds and gaps, "active", ...)")
      .def_property_readonly(
          "status", [](const Improvement& o) -> py::object { return from_json(o.json)["status"]; },
          R"("optimal", "converged", "stalled", "cancelled" or "infeasible".)")
      .def(
          "write",
          [](const Improvement& o, const std::filesystem::path& path) {
            require_other_file(o.name, path.string(), "path");
            write_file(path.string(), usable_spec(o));
          },
          "path"_a,
          "Writes the optimized spec. Raises InputError if the result is not usable, or if the "
          "path is "
          "that of the input.")
      .def(py::pickle(
          [](const Improvement& o) {
            return py::make_tuple(o.best.text, o.best.json, o.best.spec, o.text, o.json, o.broken,
                                  o.name);
          },
          [](const py::tuple& s) {
            const auto text = [&](std::size_t i) { return s[i].cast<std::string>(); };
            return Improvement{{text(0), text(1), s[2].cast<std::optional<std::string>>()},
                               text(3),
                               text(4),
                               text(5),
                               text(6)};
          }))
      .def("__str__", [](const Improvement& o) { return o.text; })
      .def("__repr__", [](const Improvement& o) {
        return shown("Optimum",
                     {{"status", "'" + py::cast<std::string>(from_json(o.json)["status"]) + "'"},
                      {"ok", o.best.spec && o.broken.empty() ? "True" : "False"}});
      });
  m.def("optimize", optimize_spec, "spec"_a, py::kw_only(), "progress"_a = py::none(),
        "seconds"_a = py::none(), "against"_a = py::none(),
        R"(Optimizes everything that a spec leaves free, within its limits, and returns an Optimum.

spec: a Design, or the path of a spec. progress: called with (done, step), the share of the work from 0 to 1
and the name
of the step; if it returns False, the optimizer stops with the best result so far. Ctrl-C raises KeyboardInterrupt.
seconds: stop after this time. against: path of the spec of a drive, for free shapes. The GIL is released.)");
}

}  // namespace jounce::python
