// SPDX-License-Identifier: Apache-2.0
// Gears: cams of a slave that follows its master by a ratio.
#include <optional>

#include <pybind11/stl.h>

#include "jounce/design/detail/law_guide.hpp"
#include "jounce/gear/gear_course.hpp"
#include "jounce/gear/gear_in_pos.hpp"
#include "jounce/profiles/error.hpp"

#include "python/src/bind.hpp"
#include "python/src/report.hpp"
#include "python/src/values.hpp"

namespace jounce::python {

using namespace py::literals;

namespace {

void bind_change(py::module_& m) {
  py::class_<RatioChange> c(m, "GearChange", R"(A clutch: the ratio of a gear changes.

at (m): master position where the change begins. ratio (u/m): the new ratio, of any sign; 0 stops the slave. distance
(m): length of the change; 0: at once, so the slave's velocity steps. law: "line", or a law from rest to rest.)");
  add_value(
      c,
      [](const RatioChange& r) { return py::make_tuple(r.at, r.ratio, r.distance, name(r.law)); },
      [](const py::tuple& members) {
        return RatioChange{members[0].cast<double>(), members[1].cast<double>(),
                           members[2].cast<double>(), law_of(members[3].cast<std::string>())};
      });
  c.def(py::init([](double at, double ratio, double distance, const std::string& law) {
          return RatioChange{at, ratio, distance, law_of(law)};
        }),
        "at"_a, "ratio"_a, "distance"_a = 0.0, py::kw_only(), "law"_a = name(Law::line))
      .def_readonly("at", &RatioChange::at, "Begin of the change, m.")
      .def_readonly("ratio", &RatioChange::ratio, "The new ratio, u/m.")
      .def_readonly("distance", &RatioChange::distance, "Length of the change, m.")
      .def_property_readonly(
          "law", [](const RatioChange& r) { return name(r.law); }, "Word of the law.")
      .def("__repr__", [](const RatioChange& r) {
        return shown(
            "GearChange",
            {{"at", shown(r.at)}, {"ratio", shown(r.ratio)}, {"distance", shown(r.distance)}});
      });
}

void bind_shift(py::module_& m) {
  py::class_<PhaseShift> c(m, "GearShift",
                           R"(A phase shift: a move of the slave relative to its gear.

at (m): where the shift begins. shift (u): its distance, of any sign. distance (m): length of the shift, > 0. law: any
law from rest to rest.)");
  add_value(
      c, [](const PhaseShift& s) { return py::make_tuple(s.at, s.shift, s.distance, name(s.law)); },
      [](const py::tuple& members) {
        return PhaseShift{members[0].cast<double>(), members[1].cast<double>(),
                          members[2].cast<double>(), law_of(members[3].cast<std::string>())};
      });
  c.def(py::init([](double at, double shift, double distance, const std::string& law) {
          return PhaseShift{at, shift, distance, law_of(law)};
        }),
        "at"_a, "shift"_a, "distance"_a, py::kw_only(), "law"_a = name(Law::poly345))
      .def_readonly("at", &PhaseShift::at, "Begin of the shift, m.")
      .def_readonly("shift", &PhaseShift::shift, "Distance, u.")
      .def_readonly("distance", &PhaseShift::distance, "Length of the shift, m.")
      .def_property_readonly(
          "law", [](const PhaseShift& s) { return name(s.law); }, "Word of the law.")
      .def("__repr__", [](const PhaseShift& s) {
        return shown(
            "GearShift",
            {{"at", shown(s.at)}, {"shift", shown(s.shift)}, {"distance", shown(s.distance)}});
      });
}

Cam engaged_in_position(std::int64_t numerator, std::int64_t denominator, double master_sync,
                        double slave_sync, double start_distance, double master_start,
                        double master_end, double slave_start, bool avoid_reversal,
                        std::optional<double> slave_period, const std::string& law) {
  const GearInPos gear = gear_in_pos({.numerator = numerator,
                                      .denominator = denominator,
                                      .master_sync_position = master_sync,
                                      .slave_sync_position = slave_sync,
                                      .master_start_distance = start_distance,
                                      .slave_start = slave_start,
                                      .avoid_reversal = avoid_reversal,
                                      .slave_period = slave_period,
                                      .law = law_of(law)});
  if (!gear) throw InputError("start_distance", start_distance, explain(gear.status));
  return sync_cam(gear, master_start, master_end).cam;
}

}  // namespace

void bind_gears(py::module_& m) {
  bind_change(m);
  bind_shift(m);
  m.def(
      "gear",
      [](std::vector<RatioChange> changes, double master_end, double master_start,
         double slave_start, double ratio, std::vector<PhaseShift> shifts) {
        return gear_course({.master_start = master_start,
                            .master_end = master_end,
                            .slave_start = slave_start,
                            .ratio = ratio,
                            .changes = std::move(changes),
                            .shifts = std::move(shifts)})
            .cam;
      },
      "changes"_a, py::kw_only(), "master_end"_a, "master_start"_a = 0.0, "slave_start"_a = 0.0,
      "ratio"_a = 0.0, "shifts"_a = std::vector<PhaseShift>{},
      R"(Returns the exact Cam of a gear with changes of its ratio and phase shifts (MC_GearIn, MC_Phasing).

changes: GearChange objects in order, from master_start to master_end (m). slave_start (u): slave position at
master_start. ratio (u/m): the ratio before the first change; 0: the slave stands still. Raises InputError, with a key
such as "change[2].at", for changes that overlap or leave the course.)");
  m.def("gear_in_pos", engaged_in_position, "numerator"_a, "denominator"_a = 1, py::kw_only(),
        "master_sync"_a, "slave_sync"_a, "start_distance"_a, "master_start"_a, "master_end"_a,
        "slave_start"_a = 0.0, "avoid_reversal"_a = false, "slave_period"_a = py::none(),
        "law"_a = name(Law::quintic),
        R"(Returns the exact Cam of a slave that engages with a gear at a position (MC_GearInPos).

The gear has the ratio numerator / denominator (u/m). From start_distance (m) before master_sync (m) on, the slave moves
from slave_start to slave_sync (u), and arrives in step with the gear. The cam goes from master_start to master_end (m).
avoid_reversal: raises InputError if the slave would reverse; with a slave_period (u), the slave then moves up to five
turns further.)");
}

}  // namespace jounce::python
