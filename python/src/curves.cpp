// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include <pybind11/stl.h>

#include "jounce/profiles/curve/between.hpp"
#include "jounce/profiles/curve/composed.hpp"
#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/profiles/sequences/retime.hpp"
#include "jounce/profiles/vibration/moving_average.hpp"
#include "jounce/profiles/vibration/shaper.hpp"
#include "jounce/pvt/table.hpp"
#include "jounce/validate/witness.hpp"

#include "python/src/bind.hpp"
#include "python/src/numpy/column.hpp"
#include "python/src/report.hpp"
#include "python/src/values.hpp"
#include "python/src/words.hpp"

namespace jounce::python {

using namespace py::literals;

namespace {

template <class Over>
constexpr bool over_master = std::is_same_v<Over, OverMaster>;

template <class Over>
NamedReport named(Report report) {
  return {std::move(report), Labels{.units = {}, .over_master = over_master<Over>, .segments = {}}};
}

/// Throws InputError for a place outside a curve that refuses it: in C++ this is an error of the caller.
template <class Over>
void require_inside(const Curve<Over>& f, const Reader& x, std::size_t size) {
  if (f.outside() != Extrapolation::refuse) return;
  for (std::size_t i = 0; i < size; ++i)
    if (!(x[i] >= f.start() && x[i] <= f.end()))
      throw InputError("x", x[i],
                       "must be from " + number(f.start()) + " to " + number(f.end()) +
                           ", or give the curve a policy with outside()");
}

template <class Over>
py::object value_at(const Curve<Over>& f, const Column& x, Side side) {
  Broadcast all({&x});
  const Reader places = all.read(x);
  require_inside(f, places, all.size());
  if (all.is_scalar()) return py::float_(f.jet(x.value, side)[0]);
  return values_of(all.shape(), all.size(),
                   [&](std::size_t i) { return f.jet(places[i], side)[0]; });
}

template <class Over>
py::object point_at(const Curve<Over>& f, const Column& x, Side side) {
  Broadcast all({&x});
  const Reader places = all.read(x);
  require_inside(f, places, all.size());
  if (all.is_scalar()) return point_of<Over>(f.jet(x.value, side));
  return points_of<Over>(all.shape(), all.size(),
                         [&](std::size_t i) { return f.jet(places[i], side); });
}

template <class Over>
py::tuple sampled(const Curve<Over>& f, double step) {
  std::vector<double> places = instants(f.start(), f.end(), step);
  const std::size_t size = places.size();
  py::array_t<double> x = taken(std::move(places));
  const double* const at = x.data();
  return py::make_tuple(
      x, points_of<Over>({static_cast<py::ssize_t>(size)}, size, [&, end = f.end()](std::size_t i) {
        return f.jet(at[i], at[i] == end ? Side::left : Side::right);
      }));
}

template <class Over>
std::string curve_text(const Curve<Over>& f) {
  return shown(over_master<Over> ? "Cam" : "Trajectory",
               {{"start", shown(f.start())},
                {"end", shown(f.end())},
                {"segments", std::to_string(f.segments().size())},
                {"outside", std::string("'") + name(f.outside()) + "'"}});
}

template <class Over>
Curve<Over> joined(const std::vector<Curve<Over>>& parts) {
  if (parts.empty()) throw InputError("curves", "", "must have at least one curve");
  Curve<Over> all = parts.front();
  for (std::size_t i = 1; i < parts.size(); ++i) all = concatenated(all, parts[i]);
  return all;
}

Trajectory shaped_for(const Trajectory& f, double frequency, double damping, ShaperKind kind) {
  return shaped(f, shaper({.kind = kind, .mode = {frequency, damping}}));
}

/// Evaluation and properties, with the names of the variable in the docstrings.
template <class Over>
void bind_values(py::class_<Curve<Over>>& c) {
  using C = Curve<Over>;
  c.def_property_readonly("start", &C::start, "First time (s), or first master position (m).")
      .def_property_readonly("end", &C::end, "Last time (s), or last master position (m).")
      .def_property_readonly("length", &C::length, "Duration (s), or length over the master (m).")
      .def_property_readonly(
          "outside", [](const C& f) { return name(f.outside()); },
          R"(Policy outside [start, end]: "refuse", "hold", "wrap" or "advance".)")
      .def_property_readonly(
          "advance", &C::advance,
          R"(Change of the value over one period if `outside` is "advance"; otherwise 0.)")
      .def_property_readonly(
          "breaks",
          [](const py::object& self) { return view(self.cast<const C&>().breaks(), self); },
          "Start, joints of the segments, and end: a read-only view without a copy.")
      .def("__call__", value_at<Over>, "x"_a, "side"_a = Side::right,
           R"(Returns the position at x: a number, or an array of the shape of x.

At a step, `side` selects the limit: "right" (default) or "left". Raises InputError for a place outside a curve that
refuses it.)")
      .def(
          "at", point_at<Over>, "x"_a, "side"_a = Side::right,
          over_master<Over>
              ? R"(Returns position, geo_velocity, geo_acceleration and geo_jerk at x, as a Transfer.

The members are numbers, or arrays of the shape of x: u, u/m, u/m^2, u/m^3. See __call__ for `side` and the errors.)"
              : R"(Returns position, velocity, acceleration and jerk at x, as a Motion.

The members are numbers, or arrays of the shape of x: u, u/s, u/s^2, u/s^3. See __call__ for `side` and the errors.)")
      .def("sample", sampled<Over>, "step"_a,
           "Returns the places start, start + step, ... and the end, and the motion there, as "
           "(places, motion).")
      .def("__repr__", curve_text<Over>);
}

template <class Over>
void bind_algebra(py::class_<Curve<Over>>& c) {
  using C = Curve<Over>;
  c.def(
       "derivative", [](const C& f) { return derivative(f); },
       "Returns the first derivative, as a curve over the same variable.")
      .def(
          "integral", [](const C& f, double start_value) { return integral(f, start_value); },
          "start_value"_a = 0.0,
          "Returns the integral, which begins at start_value. Raises InputError above degree 11.")
      .def(
          "shifted", [](const C& f, double dx, double dy) { return shifted(f, dx, dy); },
          "dx"_a = 0.0, "dy"_a = 0.0,
          "Returns the curve moved by dx in its variable and by dy in value.")
      .def(
          "scaled",
          [](const C& f, double factor, double stretch) { return scaled(f, factor, stretch); },
          "factor"_a = 1.0, "stretch"_a = 1.0,
          "Returns the curve with its value multiplied by `factor`, and its variable by `stretch` "
          "> 0.")
      .def(
          "reversed", [](const C& f) { return reversed(f); },
          "Returns the curve backwards over the same interval.")
      .def(
          "repeated", [](const C& f, int times) { return repeated(f, times); }, "times"_a,
          "Returns the curve, repeated `times` >= 1 times.")
      .def(
          "between", [](const C& f, double from, double to) { return between(f, from, to); },
          "start"_a, "end"_a,
          "Returns the part over [start, end]. Outside the curve, its policy fills the part.")
      .def(
          "with_outside", [](const C& f, Extrapolation outside) { return with(f, outside); },
          "outside"_a,
          R"(Returns the curve with another policy outside: "refuse", "hold", "wrap" or "advance".)")
      .def(
          "__add__", [](const C& f, const C& g) { return sum(f, g); }, "other"_a,
          "Returns the sum of two curves over the same interval.")
      .def(
          "__sub__", [](const C& f, const C& g) { return sum(f, scaled(g, -1)); }, "other"_a,
          "Returns the difference of two curves over the same interval.")
      .def(
          "__mul__", [](const C& f, double factor) { return scaled(f, factor); }, "factor"_a,
          "Returns the curve with its value multiplied by the factor.")
      .def(
          "__rmul__", [](const C& f, double factor) { return scaled(f, factor); }, "factor"_a,
          "Returns the curve with its value multiplied by the factor.")
      .def(
          "__neg__", [](const C& f) { return scaled(f, -1); },
          "Returns the curve with its value multiplied by -1.")
      .def(
          "moving_average", [](const C& f, double window) { return moving_average(f, window); },
          "window"_a,
          R"(Returns the exact moving average over a window (s or m): a smoother motion, longer by the window.

The curve begins and ends at rest, or is periodic. Raises InputError otherwise.)");
}

template <class Over>
void bind_analysis(py::class_<Curve<Over>>& c) {
  using C = Curve<Over>;
  const auto release = py::call_guard<py::gil_scoped_release>();
  c.def(
       "extrema", [](const C& f, int order) { return extrema(f, valid_order(order)); }, "order"_a,
       release,
       R"(Returns the exact range of a derivative: order 0 is the value, 1 the velocity, up to 3.

Critical points are isolated, not sampled. At a step, both limits count.)")
      .def(
          "crossings",
          [](const C& f, int order, double level) {
            return crossings(f, valid_order(order), level);
          },
          "order"_a, "level"_a, release,
          "Returns every place where the derivative of this order (0: the value) equals `level`, "
          "ascending.")
      .def(
          "largest_jump", [](const C& f, int order) { return largest_jump(f, valid_order(order)); },
          "order"_a, release,
          "Returns the largest step of the derivative of this order (0: the value); 0 if there is "
          "none.")
      .def(
          "check", [](const C& f, const Limits& limits) { return named<Over>(check(f, limits)); },
          "limits"_a, release,
          R"(Compares the exact extrema with the limits, and returns a Report.

There is one finding for each segment and each limit that it breaks, and one for each limit that holds.)")
      .def(
          "check_continuity",
          [](const C& f, int order) {
            return named<Over>(check_continuity(f, valid_order(order)));
          },
          "order"_a, release,
          "Checks the continuity of the value and its derivatives up to this order (0 to 3).")
      .def(
          "witness", [](const C& f) { return named<Over>(witness(SignalView(f)).report); }, release,
          R"(Integrates the jerk three times with CVODES and compares the result with the curve.

Returns a Report with the relative differences of position, velocity and acceleration. The integration shares no code
with the curve.)");
}

void bind_trajectory(py::class_<Trajectory>& c) {
  c.def_static(
       "concatenated", [](const std::vector<Trajectory>& curves) { return joined(curves); },
       "curves"_a,
       "Returns the curves one after the other: each begins at the end of the previous one.")
      .def(
          "retimed", [](const Trajectory& f, const Limits& limits) { return retimed(f, limits); },
          "limits"_a, "Returns the same shape, as fast as the limits permit.")
      .def(
          "shaped", &shaped_for, "frequency"_a, py::kw_only(), "damping"_a = 0.0,
          "kind"_a = ShaperKind::zv,
          R"(Returns the motion behind an input shaper that suppresses a vibration (Hz, damping ratio).

`kind`: "zv" (half a period longer), "zvd" or "ei" (one period longer). The motion begins and ends at rest.)")
      .def(
          "residual_vibration",
          [](const Trajectory& f, double frequency, double damping) {
            return residual_vibration(f, Mode{frequency, damping});
          },
          "frequency"_a, "damping"_a = 0.0,
          "Returns the amplitude (u) of the vibration that the motion leaves in a mode (Hz, "
          "damping ratio).");
}

void bind_cam(py::class_<Cam>& c) {
  c.def_static(
       "concatenated", [](const std::vector<Cam>& curves) { return joined(curves); }, "curves"_a,
       "Returns the cams one after the other: each begins at the end of the previous one.")
      .def(
          "over_time",
          [](const Cam& cam, const Trajectory& master, double tolerance) {
            return composed_within(cam, master, tolerance).curve;
          },
          "master"_a, "tolerance"_a = 1e-9, py::call_guard<py::gil_scoped_release>(),
          R"(Returns the slave's motion over time, behind a master that moves as given.

Exact where a polynomial of degree 11 suffices; elsewhere within `tolerance` (u), certified.)");
}

py::tuple members_of(const Segment& f) {
  py::list c, sines;
  for (int i = 0; i <= f.degree; ++i) c.append(f.c[static_cast<std::size_t>(i)]);
  for (int i = 0; i < f.sines; ++i) {
    const SineTerm& sine = f.sine[static_cast<std::size_t>(i)];
    sines.append(py::make_tuple(sine.amplitude, sine.angle, sine.phase));
  }
  return py::make_tuple(f.length, py::tuple(c), py::tuple(sines));
}

Segment segment_of(const py::tuple& members) {
  Segment f;
  f.length = members[0].cast<double>();
  const auto c = members[1].cast<std::vector<double>>();
  f.degree = static_cast<int>(c.size()) - 1;
  std::copy_n(c.begin(), std::min(c.size(), f.c.size()), f.c.begin());
  for (const py::handle& each : members[2].cast<py::tuple>()) {
    const auto sine = each.cast<std::array<double, 3>>();
    f.sine.at(static_cast<std::size_t>(f.sines++)) = {sine[0], sine[1], sine[2]};
  }
  return f;
}

template <class Over>
py::tuple curve_state(const Curve<Over>& f) {
  py::list segments;
  for (const Segment& segment : f.segments()) segments.append(members_of(segment));
  return py::make_tuple(f.start(), f.outside(), py::tuple(segments));
}

template <class Over>
Curve<Over> curve_of_state(const py::tuple& state) {
  std::vector<Segment> segments;
  for (const py::handle& each : state[2].cast<py::tuple>())
    segments.push_back(segment_of(each.cast<py::tuple>()));
  return Curve<Over>(std::move(segments), state[0].cast<double>(), state[1].cast<Extrapolation>());
}

}  // namespace

void bind_curves(py::module_& m) {
  py::class_<Trajectory> trajectory(
      m, "Trajectory",
      R"(An immutable exact motion over time: segments of polynomials and sines.

`trajectory(t)` is the position, `trajectory.at(t)` all derivatives. Both take a number or an array.)");
  py::class_<Cam> cam(m, "Cam",
                      R"(An immutable exact cam: the slave's position over that of its master.

Make one with design_cam(), load() or Table.curve. `cam(x)` is the position, `cam.at(x)` all derivatives. Both take a
number or an array.)");
  add_value(trajectory, curve_state<OverTime>, curve_of_state<OverTime>);
  add_value(cam, curve_state<OverMaster>, curve_of_state<OverMaster>);
  bind_values(trajectory);
  bind_values(cam);
  bind_algebra(trajectory);
  bind_algebra(cam);
  bind_analysis(trajectory);
  bind_analysis(cam);
  bind_trajectory(trajectory);
  bind_cam(cam);
}

}  // namespace jounce::python
