// SPDX-License-Identifier: Apache-2.0
// Cams in code: segments with motion laws.
#include <algorithm>
#include <cmath>
#include <optional>

#include <pybind11/stl.h>

#include "jounce/cam/design/characteristics.hpp"
#include "jounce/cam/design/design.hpp"
#include "jounce/design/detail/law_guide.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "python/src/bind.hpp"
#include "python/src/report.hpp"
#include "python/src/values.hpp"
#include "python/src/words.hpp"

namespace jounce::python {

using namespace py::literals;

namespace {

using Number = std::optional<double>;

CamSegment segment(const std::string& law, double master, double slave, Number geo_velocity,
                   Number geo_acceleration, std::string name, Number inflection, Number straight,
                   std::optional<std::array<double, 3>> shares, std::vector<CamPoint> points) {
  return {.law = law_of(law),
          .end = {master, slave, geo_velocity, geo_acceleration},
          .name = std::move(name),
          .form = {inflection, straight, shares},
          .points = std::move(points)};
}

/// Throws InputError for a periodic cam that is open.
void require_closed(const std::vector<CamSegment>& segments, const CamKnot& start) {
  if (segments.empty()) return;  // design() reports it
  const double end = segments.back().end.slave;
  const double near =
      profiles_detail::rounded_input * std::max(std::abs(end), std::abs(start.slave));
  if (std::abs(end - start.slave) <= near) return;
  throw InputError(
      "segment[" + std::to_string(segments.size()) + "].end.slave", end,
      "must be " + number(start.slave) +
          ", the slave position at the start, because the cam is periodic; if the slave "
          "advances in each period, give slave_period");
}

Cam designed(std::vector<CamSegment> segments, const CamKnot& start, bool periodic,
             Number slave_period) {
  if (periodic && !slave_period) require_closed(segments, start);
  return design({start, std::move(segments), periodic, slave_period}).cam;
}

CamKnot knot_of(const std::pair<double, double>& place) {
  return {place.first, place.second, {}, {}};
}

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const LawInfo& law : all_laws()) names.emplace_back(law.name);
  return names;
}

py::tuple members_of(const CamKnot& k) {
  return py::make_tuple(k.master, k.slave, k.geo_velocity, k.geo_acceleration);
}

CamKnot knot_of_members(const py::tuple& members) {
  return {members[0].cast<double>(), members[1].cast<double>(), members[2].cast<Number>(),
          members[3].cast<Number>()};
}

py::tuple members_of(const CamPoint& p) {
  return py::make_tuple(p.master, p.slave, p.geo_velocity, p.geo_acceleration, p.geo_jerk,
                        p.tolerance);
}

CamPoint point_of_members(const py::tuple& members) {
  return {members[0].cast<double>(), members[1].cast<Number>(), members[2].cast<Number>(),
          members[3].cast<Number>(), members[4].cast<Number>(), members[5].cast<double>()};
}

py::tuple members_of(const CamSegment& s) {
  py::list points;
  for (const CamPoint& point : s.points) points.append(members_of(point));
  return py::make_tuple(
      name(s.law), members_of(s.end), s.name, s.form.inflection, s.form.straight,
      s.form.shares ? py::object(py::tuple(py::cast(*s.form.shares))) : py::object(py::none()),
      py::tuple(points));
}

CamSegment segment_of_members(const py::tuple& members) {
  std::vector<CamPoint> points;
  for (const py::handle& point : members[6].cast<py::tuple>())
    points.push_back(point_of_members(point.cast<py::tuple>()));
  const CamKnot end = knot_of_members(members[1].cast<py::tuple>());
  return segment(members[0].cast<std::string>(), end.master, end.slave, end.geo_velocity,
                 end.geo_acceleration, members[2].cast<std::string>(), members[3].cast<Number>(),
                 members[4].cast<Number>(), members[5].cast<std::optional<std::array<double, 3>>>(),
                 std::move(points));
}

void bind_inputs(py::module_& m) {
  py::class_<CamKnot> knot(m, "CamKnot", R"(The joint of two segments of a cam, or one of its ends.

u is the slave's unit, m the master's. An omitted derivative follows from the adjacent laws; if they leave it
free, it is
zero.)");
  add_value(
      knot, [](const CamKnot& k) { return members_of(k); }, knot_of_members);
  knot.def(py::init([](double master, double slave, Number geo_velocity, Number geo_acceleration) {
             return CamKnot{master, slave, geo_velocity, geo_acceleration};
           }),
           "master"_a, "slave"_a, py::kw_only(), "geo_velocity"_a = py::none(),
           "geo_acceleration"_a = py::none())
      .def_readonly("master", &CamKnot::master, "Master position, m.")
      .def_readonly("slave", &CamKnot::slave, "Slave position, u.")
      .def_readonly("geo_velocity", &CamKnot::geo_velocity, "u/m, or None.")
      .def_readonly("geo_acceleration", &CamKnot::geo_acceleration, "u/m^2, or None.")
      .def("__repr__", [](const CamKnot& k) {
        return shown("CamKnot", {{"master", shown(k.master)}, {"slave", shown(k.slave)}});
      });
  py::class_<CamPoint> point(m, "CamPoint",
                             R"(A condition inside a segment, for the laws through points.

"cubic_spline" and "quintic_spline" take positions; "polynomial" and "hermite" take derivatives as well.)");
  add_value(
      point, [](const CamPoint& p) { return members_of(p); }, point_of_members);
  point
      .def(py::init([](double master, Number slave, Number geo_velocity, Number geo_acceleration,
                       Number geo_jerk, double tolerance) {
             return CamPoint{master, slave, geo_velocity, geo_acceleration, geo_jerk, tolerance};
           }),
           "master"_a, "slave"_a = py::none(), py::kw_only(), "geo_velocity"_a = py::none(),
           "geo_acceleration"_a = py::none(), "geo_jerk"_a = py::none(), "tolerance"_a = 0.0,
           "m, u, u/m, u/m^2, u/m^3. tolerance (u): permitted deviation, for quintic_spline only.")
      .def_readonly("master", &CamPoint::master, "Master position, m.")
      .def_readonly("slave", &CamPoint::slave, "Slave position, u, or None.")
      .def("__repr__", [](const CamPoint& p) {
        return shown("CamPoint",
                     {{"master", shown(p.master)}, {"slave", p.slave ? shown(*p.slave) : "None"}});
      });
  py::class_<CamSegment> part(m, "CamSegment",
                              R"(One segment of a cam: its motion law and the knot at its end.

It begins at the end of the previous segment. laws() lists the laws.)");
  add_value(
      part, [](const CamSegment& s) { return members_of(s); }, segment_of_members);
  part.def(
          py::init(&segment), "law"_a, "master"_a, "slave"_a, py::kw_only(),
          "geo_velocity"_a = py::none(), "geo_acceleration"_a = py::none(), "name"_a = "",
          "inflection"_a = py::none(), "straight"_a = py::none(), "shares"_a = py::none(),
          "points"_a = std::vector<CamPoint>{},
          R"(law: "quintic", "modified_sine", "dwell", "line", ... master (m), slave (u): the end of the segment.

inflection, straight, shares: shape parameters of some laws. Raises InputError for an unknown law, with the
nearest name.)")
      .def_property_readonly(
          "law", [](const CamSegment& s) { return name(s.law); }, "Word of the law.")
      .def_readonly("end", &CamSegment::end, "Knot at its end.")
      .def_readonly("name", &CamSegment::name, "Name in reports; may be empty.")
      .def("__repr__", [](const CamSegment& s) {
        return shown("CamSegment", {{"law", std::string("'") + name(s.law) + "'"},
                                    {"master", shown(s.end.master)},
                                    {"slave", shown(s.end.slave)}});
      });
}

void bind_characteristics(py::module_& m) {
  py::class_<Characteristics>(
      m, "Characteristics",
      R"(Characteristic values of a rise with stroke h over length b (VDI 2143).

At master speed w: velocity cv h w / b, acceleration ca h (w / b)^2, jerk cj h (w / b)^3. Infinite where a derivative
steps.)")
      .def_readonly("stroke", &Characteristics::stroke, "h, u, signed.")
      .def_readonly("length", &Characteristics::length, "b, m.")
      .def_property_readonly(
          "cv", [](const Characteristics& c) { return c.cv.value; }, "Peak of the velocity.")
      .def_property_readonly(
          "ca", [](const Characteristics& c) { return c.ca.value; },
          "Peak of the acceleration in the direction of the stroke.")
      .def_property_readonly(
          "ca_star", [](const Characteristics& c) { return c.ca_star.value; },
          "Peak of the acceleration against it.")
      .def_property_readonly(
          "cj", [](const Characteristics& c) { return c.cj.value; }, "Peak of the jerk.")
      .def_property_readonly(
          "cm", [](const Characteristics& c) { return c.cm.value; },
          "Peak of velocity times acceleration: dynamic torque.")
      .def_readonly("rms", &Characteristics::rms, "Root mean square of the acceleration.")
      .def("__repr__", [](const Characteristics& c) {
        return shown(
            "Characteristics",
            {{"cv", shown(c.cv.value)}, {"ca", shown(c.ca.value)}, {"cj", shown(c.cj.value)}});
      });
  m.def(
      "characteristics", [](const std::string& law) { return characteristics(law_of(law)); },
      "law"_a, "Returns the characteristic values of a law. Raises InputError for an unknown law.");
  m.def(
      "characteristics", [](const Cam& cam) { return characteristics(cam); }, "cam"_a,
      "Returns the characteristic values of a cam, taken as one rise.");
}

}  // namespace

void bind_cams(py::module_& m) {
  bind_inputs(m);
  bind_characteristics(m);
  m.def("laws", law_names,
        "Returns the names of all motion laws. `docs/laws.md` is the guide to them.");
  m.def(
      "design_cam",
      [](std::vector<CamSegment> segments, const std::pair<double, double>& start, bool periodic,
         Number slave_period) {
        return designed(std::move(segments), knot_of(start), periodic, slave_period);
      },
      "segments"_a, py::kw_only(), "start"_a = std::pair(0.0, 0.0), "periodic"_a = false,
      "slave_period"_a = py::none(),
      R"(Makes the exact cam of a list of segments.

start: (master, slave), or a CamKnot. periodic: the cam repeats, and its last knot equals the first one. slave_period
(u): period of a rotary slave, which then advances in each period. Raises InputError, with a key such as
"segment[2].end.master", for a cam that is not possible.)");
  m.def("design_cam", designed, "segments"_a, py::kw_only(), "start"_a, "periodic"_a = false,
        "slave_period"_a = py::none());
}

}  // namespace jounce::python
