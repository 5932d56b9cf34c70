// SPDX-License-Identifier: Apache-2.0
#include <optional>

#include <pybind11/stl.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/report/rules.hpp"

#include "python/src/bind.hpp"
#include "python/src/report.hpp"
#include "python/src/values.hpp"

namespace jounce::python {

using namespace py::literals;

std::string shown(double value) {
  return six_digits(value);
}

std::string shown(const std::string& name,
                  const std::vector<std::pair<std::string, std::string>>& members) {
  std::string text = name + "(";
  for (const auto& [key, value] : members) {
    if (text.back() != '(') text += ", ";
    text += key + "=" + value;
  }
  return text + ")";
}

std::vector<NamedFinding> NamedReport::findings() const {
  std::vector<NamedFinding> all;
  for (const Finding& f : report.findings)
    all.push_back({f, labels.segment_of(f), labels.unit_of(f), sentence(f, labels)});
  return all;
}

namespace {

const char* severity_name(const Finding& f) {
  switch (f.severity) {
    case Severity::required:
      return "required";
    case Severity::warning:
      return "warning";
    case Severity::note:
      break;
  }
  return "note";
}

std::string limits_text(const Limits& limits) {
  std::vector<std::pair<std::string, std::string>> members;
  for (const auto& [name, value] : {std::pair{"position_min", limits.position_min},
                                    {"position_max", limits.position_max},
                                    {"velocity", limits.velocity},
                                    {"acceleration", limits.acceleration},
                                    {"jerk", limits.jerk}})
    if (value) members.emplace_back(name, shown(*value));
  return shown("Limits", members);
}

void bind_limits(py::module_& m) {
  py::class_<Limits> c(m, "Limits", R"(Limits of an axis for a check.

The rates are magnitudes > 0: u/s, u/s^2, u/s^3; for a cam u/m, u/m^2, u/m^3 with the master's unit m. A limit that is
None does not apply.)");
  add_value(
      c,
      [](const Limits& l) {
        return py::make_tuple(l.position_min, l.position_max, l.velocity, l.acceleration, l.jerk);
      },
      [](const py::tuple& members) {
        using Number = std::optional<double>;
        return Limits{members[0].cast<Number>(), members[1].cast<Number>(),
                      members[2].cast<Number>(), members[3].cast<Number>(),
                      members[4].cast<Number>()};
      });
  c.def(py::init([](std::optional<double> velocity, std::optional<double> acceleration,
                    std::optional<double> jerk, std::optional<double> position_min,
                    std::optional<double> position_max) {
          const Limits limits{position_min, position_max, velocity, acceleration, jerk};
          require_valid(limits);
          return limits;
        }),
        py::kw_only(), "velocity"_a = py::none(), "acceleration"_a = py::none(),
        "jerk"_a = py::none(), "position_min"_a = py::none(), "position_max"_a = py::none(),
        "Raises InputError if a limit is not finite, a limit of a rate is not positive, or min "
        "> max.")
      .def_readonly("position_min", &Limits::position_min, "u, or None")
      .def_readonly("position_max", &Limits::position_max, "u, or None")
      .def_readonly("velocity", &Limits::velocity, "u/s (cam: u/m), or None")
      .def_readonly("acceleration", &Limits::acceleration, "u/s^2 (cam: u/m^2), or None")
      .def_readonly("jerk", &Limits::jerk, "u/s^3 (cam: u/m^3), or None")
      .def("__repr__", limits_text);
}

void bind_ranges(py::module_& m) {
  py::class_<Extremum>(m, "Extremum", "An extreme value of a curve and its place.")
      .def_readonly("value", &Extremum::value, "Value, in the unit of the quantity.")
      .def_readonly("where", &Extremum::where, "Time (s) or master position (m).")
      .def_property_readonly(
          "side", [](const Extremum& e) { return e.side == Side::right ? "right" : "left"; },
          R"(Side from which the value is approached: "right" or "left". They differ at a step only.)")
      .def("__repr__", [](const Extremum& e) {
        return shown("Extremum", {{"value", shown(e.value)}, {"where", shown(e.where)}});
      });
  py::class_<Range>(m, "Range", "The least and the greatest value of a quantity.")
      .def_readonly("min", &Range::min, "The least value.")
      .def_readonly("max", &Range::max, "The greatest value.")
      .def_property_readonly("peak", &Range::peak, "The one of larger magnitude.")
      .def("__repr__", [](const Range& r) {
        return shown("Range", {{"min", shown(r.min.value)}, {"max", shown(r.max.value)}});
      });
  py::class_<Jump>(m, "Jump", "A step of a derivative.")
      .def_readonly("step", &Jump::step, "Right limit minus left limit.")
      .def_readonly("where", &Jump::where, "Time (s) or master position (m).")
      .def("__repr__", [](const Jump& j) {
        return shown("Jump", {{"step", shown(j.step)}, {"where", shown(j.where)}});
      });
}

py::tuple finding_state(const Finding& f) {
  return py::make_tuple(f.rule.text(), f.axis, f.quantity, f.where, f.value, f.limit, f.margin,
                        f.broken, f.segment, f.advice, f.unit, f.where_unit,
                        static_cast<int>(f.severity), f.has_limit);
}

Finding finding_of_state(const py::tuple& s) {
  Finding f;
  f.rule = Rule(s[0].cast<std::string>());
  f.axis = s[1].cast<std::string>();
  f.quantity = s[2].cast<std::string>();
  f.where = s[3].cast<double>();
  f.value = s[4].cast<double>();
  f.limit = s[5].cast<double>();
  f.margin = s[6].cast<double>();
  f.broken = s[7].cast<bool>();
  f.segment = s[8].cast<std::optional<std::size_t>>();
  f.advice = s[9].cast<std::string>();
  f.unit = s[10].cast<std::string>();
  f.where_unit = s[11].cast<std::string>();
  f.severity = static_cast<Severity>(s[12].cast<int>());
  f.has_limit = s[13].cast<bool>();
  return f;
}

py::tuple report_state(const NamedReport& r) {
  py::list findings;
  for (const Finding& f : r.report.findings) findings.append(finding_state(f));
  return py::make_tuple(findings, r.labels.units.x, r.labels.units.position, r.labels.over_master,
                        r.labels.segments);
}

NamedReport report_of_state(const py::tuple& s) {
  NamedReport r;
  for (const py::handle f : s[0])
    r.report.findings.push_back(finding_of_state(f.cast<py::tuple>()));
  r.labels = {{s[1].cast<std::string>(), s[2].cast<std::string>()},
              s[3].cast<bool>(),
              s[4].cast<std::vector<std::string>>()};
  return r;
}

void bind_findings(py::module_& m) {
  py::class_<NamedFinding>(
      m, "Finding", "One result of a check: a quantity at its worst place, against its limit.")
      .def_property_readonly(
          "rule", [](const NamedFinding& f) { return f.finding.rule.text(); },
          R"(Stable identifier of the rule: "limit/velocity", "continuity/position", ... See explain().)")
      .def_property_readonly(
          "quantity", [](const NamedFinding& f) { return f.finding.quantity; },
          R"("velocity", "torque", ...)")
      .def_property_readonly(
          "axis", [](const NamedFinding& f) { return f.finding.axis; },
          "Name of the axis; may be empty.")
      .def_property_readonly(
          "where", [](const NamedFinding& f) { return f.finding.where; },
          "Time (s) or master position (m).")
      .def_property_readonly(
          "where_unit", [](const NamedFinding& f) { return f.finding.where_unit; },
          "Unit of `where`; empty: that of the time or the master.")
      .def_property_readonly(
          "value", [](const NamedFinding& f) { return f.finding.value; },
          "Value at this place, in `unit`.")
      .def_property_readonly(
          "limit",
          [](const NamedFinding& f) {
            return f.finding.has_limit ? std::optional(f.finding.limit) : std::nullopt;
          },
          "Permitted value with the sign of `value`, in `unit`; None: no limit.")
      .def_property_readonly(
          "margin",
          [](const NamedFinding& f) {
            return f.finding.has_limit ? std::optional(f.finding.margin) : std::nullopt;
          },
          "Distance to the limit as a share of the limit; negative: broken; None: no limit.")
      .def_readonly("unit", &NamedFinding::unit, "Unit of value and limit; may be empty.")
      .def_property_readonly(
          "broken", [](const NamedFinding& f) { return f.finding.broken; },
          "True if the rule is broken.")
      .def_property_readonly(
          "severity", [](const NamedFinding& f) { return severity_name(f.finding); },
          R"("required", "warning" or "note".)")
      .def_property_readonly(
          "segment", [](const NamedFinding& f) { return f.finding.segment; },
          "Index of the segment of the curve, from 0; None: no segment.")
      .def_readonly("segment_name", &NamedFinding::segment_name,
                    "Number and name in the spec; may be empty.")
      .def_property_readonly(
          "advice", [](const NamedFinding& f) { return f.finding.advice; }, "Remedy; may be empty.")
      .def(py::pickle(
          [](const NamedFinding& f) {
            return py::make_tuple(finding_state(f.finding), f.segment_name, f.unit, f.text);
          },
          [](const py::tuple& s) {
            return NamedFinding{finding_of_state(s[0].cast<py::tuple>()), s[1].cast<std::string>(),
                                s[2].cast<std::string>(), s[3].cast<std::string>()};
          }))
      .def("__str__", [](const NamedFinding& f) { return f.text; })
      .def("__repr__", [](const NamedFinding& f) {
        return "Finding('" + f.finding.rule.text() + "': " + f.text + ")";
      });

  py::class_<NamedReport>(m, "Report",
                          R"(Result of a check: a sequence of findings, the broken ones first.

A check raises no exception for a broken limit. A report is true if no finding is broken, like `ok`.
`print(report)` prints the findings as `jounce check` does.)")
      .def_property_readonly(
          "ok", [](const NamedReport& r) { return r.report.ok(); }, "True if no finding is broken.")
      .def_property_readonly("findings", &NamedReport::findings,
                             "All findings, the broken ones first.")
      .def_property_readonly(
          "broken",
          [](const NamedReport& r) {
            std::vector<NamedFinding> broken = r.findings();
            std::erase_if(broken, [](const NamedFinding& f) { return !f.finding.broken; });
            return broken;
          },
          "The broken findings.")
      .def_property_readonly(
          "warnings", [](const NamedReport& r) { return r.report.warnings(); },
          "Number of warnings.")
      .def(py::pickle([](const NamedReport& r) { return report_state(r); },
                      [](const py::tuple& s) { return report_of_state(s); }))
      .def("__len__", [](const NamedReport& r) { return r.report.findings.size(); })
      .def("__iter__", [](const NamedReport& r) { return py::iter(py::cast(r.findings())); })
      .def(
          "__getitem__",
          [](const NamedReport& r, const py::object& index) -> py::object {
            return py::cast(r.findings())[index];
          },
          "index"_a, "Returns one Finding, or a list for a slice.")
      .def("__bool__", [](const NamedReport& r) { return r.report.ok(); })
      .def("__str__",
           [](const NamedReport& r) {
             return full_text(r.report, r.labels, r.report.findings.size());
           })
      .def("__repr__", [](const NamedReport& r) {
        return shown("Report", {{"ok", r.report.ok() ? "True" : "False"},
                                {"findings", std::to_string(r.report.findings.size())},
                                {"broken", std::to_string(r.report.broken())}});
      });

  m.def(
      "explain",
      [](const std::string& rule) -> std::optional<std::pair<std::string, std::string>> {
        const RuleInfo* info = rule_info(rule);
        if (info == nullptr) return std::nullopt;
        return std::pair<std::string, std::string>{info->meaning, info->remedy};
      },
      "rule"_a,
      "Returns the meaning of a rule and the remedy, as two sentences; None for an unknown rule.");
}

}  // namespace

void bind_reports(py::module_& m) {
  bind_limits(m);
  bind_ranges(m);
  bind_findings(m);
}

}  // namespace jounce::python
