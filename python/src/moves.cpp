// SPDX-License-Identifier: Apache-2.0
#include "python/src/moves.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <type_traits>

#include <pybind11/stl.h>

#include "jounce/io/table_file.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/profiles/moves/explain.hpp"
#include "jounce/profiles/moves/fourth_order.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "python/src/bind.hpp"
#include "python/src/report.hpp"
#include "python/src/words.hpp"

namespace jounce::python {

using namespace py::literals;

namespace {

double one_number(const Column& column, const std::string& key) {
  if (column.is_array()) throw InputError(key, "", "must be one number here, not an array");
  return column.value;
}

}  // namespace

MotionState one(const StateColumns& state, const char* key) {
  const std::string name = key;
  return {one_number(state.position, name + ".position"),
          one_number(state.velocity, name + ".velocity"),
          one_number(state.acceleration, name + ".acceleration")};
}

Bounds BoundsColumns::one() const {
  return {one_number(velocity_min, "bounds.velocity_min"),
          one_number(velocity_max, "bounds.velocity"),
          one_number(acceleration_min, "bounds.acceleration_min"),
          one_number(acceleration_max, "bounds.acceleration"),
          one_number(jerk_min, "bounds.jerk_min"),
          one_number(jerk_max, "bounds.jerk"),
          one_number(position_min, "bounds.position_min"),
          one_number(position_max, "bounds.position_max")};
}

const char* word(MoveStatus status) {
  switch (status) {
    case MoveStatus::ok:
      return "ok";
    case MoveStatus::not_finite:
      return "not_finite";
    case MoveStatus::invalid_bounds:
      return "invalid_bounds";
    case MoveStatus::target_outside:
      return "target_outside";
    case MoveStatus::target_unreachable:
      return "target_unreachable";
    case MoveStatus::position_limit:
      return "position_limit";
    case MoveStatus::too_short:
      return "too_short";
    case MoveStatus::blocked:
      return "blocked";
    case MoveStatus::not_straight:
      return "not_straight";
    case MoveStatus::wrong_size:
      break;
  }
  return "wrong_size";
}

void raise_move_error(MoveStatus status, const std::string& text) {
  const py::object error = from_package("_errors", "MoveError")(text, word(status));
  PyErr_SetObject(py::type::handle_of(error).ptr(), error.ptr());
  throw py::error_already_set();
}

namespace {

Column negated(const Column& column) {
  if (!column.is_array()) return -column.value;
  Column result;
  result.array = Doubles(column.array->attr("__neg__")());
  return result;
}

/// Throws InputError unless `holds` is true for each number of a bound.
template <class Holds>
void require_each(const char* key, const Column& column, const char* rule, const Holds& holds) {
  if (!column.is_array()) {
    if (!holds(column.value)) throw InputError(key, column.value, rule);
    return;
  }
  const double* const all = column.array->data();
  for (py::ssize_t i = 0; i < column.array->size(); ++i)
    if (!holds(all[i])) throw InputError(key + ("[" + std::to_string(i) + "]"), all[i], rule);
}

void require_bounds(const BoundsColumns& b) {
  for (const auto& [key, column] : {std::pair{"velocity", &b.velocity_max},
                                    {"acceleration", &b.acceleration_max},
                                    {"jerk", &b.jerk_max}})
    require_each(key, *column, "must be greater than 0", [](double x) { return x > 0; });
  for (const auto& [key, column] : {std::pair{"velocity_min", &b.velocity_min},
                                    {"acceleration_min", &b.acceleration_min},
                                    {"jerk_min", &b.jerk_min}})
    require_each(key, *column, "must be less than 0", [](double x) { return x < 0; });
  for (const auto& [key, column] :
       {std::pair{"position_min", &b.position_min}, {"position_max", &b.position_max}})
    require_each(key, *column, "must be a number", [](double x) { return !std::isnan(x); });
}

BoundsColumns made_bounds(const Column& velocity, const Column& acceleration, const Column& jerk,
                          const std::optional<Column>& velocity_min,
                          const std::optional<Column>& acceleration_min,
                          const std::optional<Column>& jerk_min, const Column& position_min,
                          const Column& position_max) {
  BoundsColumns bounds{velocity_min ? *velocity_min : negated(velocity),
                       velocity,
                       acceleration_min ? *acceleration_min : negated(acceleration),
                       acceleration,
                       jerk_min ? *jerk_min : negated(jerk),
                       jerk,
                       position_min,
                       position_max};
  require_bounds(bounds);
  return bounds;
}

Limits limits_of_one(const BoundsColumns& columns) {
  return limits_of(columns.one());
}

std::string column_text(const Column& column) {
  return column.is_array() ? "array" : shown(column.value);
}

std::string bounds_text(const BoundsColumns& b) {
  std::vector<std::pair<std::string, std::string>> members;
  const auto add = [&](const char* key, const Column& column, double none) {
    if (column.is_array() || column.value != none) members.emplace_back(key, column_text(column));
  };
  const auto add_pair = [&](const std::string& key, const Column& low, const Column& high) {
    add(key.c_str(), high, Bounds::none);
    if (low.is_array() || high.is_array() || low.value != -high.value)
      members.emplace_back(key + "_min", column_text(low));
  };
  add_pair("velocity", b.velocity_min, b.velocity_max);
  add_pair("acceleration", b.acceleration_min, b.acceleration_max);
  add_pair("jerk", b.jerk_min, b.jerk_max);
  add("position_min", b.position_min, -Bounds::none);
  add("position_max", b.position_max, Bounds::none);
  return shown("Bounds", members);
}

std::array<Column BoundsColumns::*, 8> bound_members() {
  using B = BoundsColumns;
  return {&B::velocity_min, &B::velocity_max, &B::acceleration_min, &B::acceleration_max,
          &B::jerk_min,     &B::jerk_max,     &B::position_min,     &B::position_max};
}

bool same_bounds(const BoundsColumns& bounds, const py::object& other) {
  if (!py::isinstance<BoundsColumns>(other)) return false;
  const auto& second = other.cast<const BoundsColumns&>();
  const py::object equal = py::module_::import("numpy").attr("array_equal");
  for (const auto member : bound_members())
    if (!equal(bounds.*member, second.*member).cast<bool>()) return false;
  return true;
}

py::tuple bounds_state(const BoundsColumns& bounds) {
  py::list members;
  for (const auto member : bound_members()) members.append(bounds.*member);
  return py::tuple(members);
}

BoundsColumns bounds_of_state(const py::tuple& state) {
  BoundsColumns bounds;
  std::size_t i = 0;
  for (const auto member : bound_members()) bounds.*member = state[i++].cast<Column>();
  return bounds;
}

void bind_bounds(py::module_& m) {
  py::class_<BoundsColumns>(m, "Bounds",
                            R"(Bounds of a move: numbers, or arrays with one value for each move.

A bound of a rate is a magnitude for both directions: u/s, u/s^2, u/s^3. With `velocity_min`, `acceleration_min` and
`jerk_min` (< 0), the negative direction has its own. An omitted bound does not apply: without a jerk, the
acceleration steps; without an acceleration, the velocity steps. Positions are in u. Raises InputError for a bound of a
rate that is not greater than 0, for a minimum that is not less than 0, and for NaN.)")
      .def(py::init(&made_bounds), "velocity"_a = Bounds::none, "acceleration"_a = Bounds::none,
           "jerk"_a = Bounds::none, py::kw_only(), "velocity_min"_a = py::none(),
           "acceleration_min"_a = py::none(), "jerk_min"_a = py::none(),
           "position_min"_a = -Bounds::none, "position_max"_a = Bounds::none)
      .def_readonly("velocity", &BoundsColumns::velocity_max, "Greatest velocity, u/s.")
      .def_readonly("velocity_min", &BoundsColumns::velocity_min, "Least velocity, u/s, < 0.")
      .def_readonly("acceleration", &BoundsColumns::acceleration_max,
                    "Greatest acceleration, u/s^2.")
      .def_readonly("acceleration_min", &BoundsColumns::acceleration_min,
                    "Least acceleration, u/s^2, < 0.")
      .def_readonly("jerk", &BoundsColumns::jerk_max, "Greatest jerk, u/s^3.")
      .def_readonly("jerk_min", &BoundsColumns::jerk_min, "Least jerk, u/s^3, < 0.")
      .def_readonly("position_min", &BoundsColumns::position_min, "Least position, u.")
      .def_readonly("position_max", &BoundsColumns::position_max, "Greatest position, u.")
      .def_property_readonly(
          "limits", limits_of_one,
          "The same bounds as Limits for a check. Raises InputError for bounds that are not equal "
          "in both directions, and for arrays.")
      .def("__eq__", same_bounds, "other"_a, "True if all members are equal.")
      .def(
          "__hash__", [](const BoundsColumns& b) { return py::hash(bounds_state(b)); },
          "Returns the hash of the members. Raises TypeError for arrays.")
      .def(py::pickle([](const BoundsColumns& b) { return bounds_state(b); },
                      [](const py::tuple& state) { return bounds_of_state(state); }))
      .def("__repr__", bounds_text);
}

py::object motion_at(const Profile& move, const Column& t) {
  if (!t.is_array()) {
    return point_of<OverTime>(jet_at(move, t.value));
  }
  Broadcast all({&t});
  const Reader times = all.read(t);
  return points_of<OverTime>(all.shape(), all.size(),
                             [&](std::size_t i) { return jet_at(move, times[i]); });
}

py::tuple sampled_move(const Profile& move, double step, bool uniform) {
  std::vector<double> places = instants(0, move.duration(), step);
  // Only the last place may be no multiple: the move holds its end until the next one.
  if (uniform && places.size() > 1) places.back() = static_cast<double>(places.size() - 1) * step;
  const py::array_t<double> t = taken(std::move(places));
  Column column;
  column.array = Doubles(t);
  return py::make_tuple(t, motion_at(move, column));
}

py::list phases_of(const Profile& move) {
  py::list phases;
  for (std::size_t i = 0; i < move.phases(); ++i)
    phases.append(py::make_tuple(move.phase(i).duration, move.phase(i).value));
  return phases;
}

Profile checked_move(const MoveResult& move, const std::string& text) {
  if (!move) raise_move_error(move.status, text);
  return move.profile;
}

Profile changed_velocity(const StateColumns& start, double velocity, const BoundsColumns& bounds,
                         double acceleration) {
  const MotionState from = one(start, "start");
  const MoveResult move = move_velocity(from, velocity, bounds.one(), acceleration);
  return checked_move(move, explain(move.status));
}

/// The possible durations of a move, with the place of an error.
Durations possible(const StateColumns& start, const StateColumns& target,
                   const BoundsColumns& bounds) {
  const MotionState from = one(start, "start"), to = one(target, "target");
  const Durations all = durations(from, to, bounds.one());
  if (all.status != MoveStatus::ok)
    raise_move_error(all.status, explain(all.status, from, to, bounds.one()));
  return all;
}

void bind_generators(py::module_& m) {
  m.def(
      "move_velocity", changed_velocity, "start"_a, "velocity"_a, "bounds"_a, py::kw_only(),
      "acceleration"_a = 0.0,
      R"(Returns the fastest change to a velocity (u/s), at any position, as a Move (MC_MoveVelocity).

`acceleration` (u/s^2) is that at the end. Raises MoveError if no such move exists.)");
  m.def(
      "stop",
      [](const StateColumns& start, const BoundsColumns& bounds) {
        return changed_velocity(start, 0, bounds, 0);
      },
      "start"_a, "bounds"_a, "Returns the fastest stop, as a Move (MC_Halt).");
  py::class_<Durations>(m, "Durations", "The possible durations of a move between two states.")
      .def_readonly("minimum", &Durations::minimum, "The least duration, s.")
      .def_property_readonly(
          "blocked",
          [](const Durations& d) {
            std::vector<std::pair<double, double>> blocked;
            for (std::size_t i = 0; i < d.count; ++i)
              blocked.emplace_back(d.blocked[i].from, d.blocked[i].to);
            return blocked;
          },
          "Open intervals of durations (s) that are not possible.")
      .def("allows", &Durations::allows, "duration"_a,
           "True if a move of this duration (s) exists.")
      .def("at_least", &Durations::at_least, "duration"_a,
           "Returns the least possible duration that is not below the given one, s.")
      .def("__repr__", [](const Durations& d) {
        return shown("Durations", {{"minimum", shown(d.minimum)}});
      });
  m.def("durations", possible, "start"_a, "target"_a, "bounds"_a,
        "Returns the possible durations of move_to() with these arguments. Raises MoveError if no "
        "move exists.");
  m.def(
      "trapezoid",
      [](double start, double target, double velocity, double acceleration, double deceleration) {
        return trapezoid({start, target, velocity, acceleration, deceleration});
      },
      "start"_a, "target"_a, py::kw_only(), "velocity"_a, "acceleration"_a, "deceleration"_a = 0.0,
      R"(Returns the time-optimal move with trapezoidal velocity, from rest to rest, as a Move.

u, u/s, u/s^2. Deceleration 0: the same as the acceleration. Raises InputError for a value out of range.)");
  m.def(
      "s_curve",
      [](double start, double target, double velocity, double acceleration, double jerk,
         double deceleration, double deceleration_jerk) {
        return s_curve(
            {start, target, velocity, acceleration, deceleration, jerk, deceleration_jerk});
      },
      "start"_a, "target"_a, py::kw_only(), "velocity"_a, "acceleration"_a, "jerk"_a,
      "deceleration"_a = 0.0, "deceleration_jerk"_a = 0.0,
      R"(Returns the time-optimal S-curve of up to seven phases, from rest to rest, as a Move.

u, u/s, u/s^2, u/s^3. `deceleration` and `deceleration_jerk` apply while the axis slows down; 0: the same as while it
speeds up. Raises InputError for a value out of range.)");
  m.def(
      "fourth_order",
      [](double start, double target, double velocity, double acceleration, double jerk,
         double jounce) {
        return fourth_order({start, target, velocity, acceleration, jerk, jounce});
      },
      "start"_a, "target"_a, py::kw_only(), "velocity"_a, "acceleration"_a, "jerk"_a, "jounce"_a,
      R"(Returns a move with continuous jerk, from rest to rest, as a Trajectory of up to 15 phases.

u, u/s, u/s^2, u/s^3, u/s^4 (jounce: the derivative of the jerk). Raises InputError for a value out of range.)");
}

}  // namespace

/// The bytes of a move, to the last bit, for processes with the same version of Jounce.
py::tuple move_state(const Profile& move) {
  static_assert(std::is_trivially_copyable_v<Profile>);
  std::string bytes(sizeof move, '\0');
  std::memcpy(bytes.data(), &move, sizeof move);
  return py::make_tuple(made_by(), py::bytes(bytes));
}

Profile move_of_state(const py::tuple& state) {
  const auto version = state[0].cast<std::string>();
  const auto bytes = state[1].cast<std::string>();
  Profile move;
  if (version != made_by() || bytes.size() != sizeof move)
    throw InputError("pickle", version, "must be a move of this version, " + made_by());
  std::memcpy(&move, bytes.data(), sizeof move);
  return move;
}

void bind_move(py::module_& m) {
  py::class_<Profile>(m, "Move", R"(A move of one axis over time, with constant jerk in each phase.

Outside [0, duration], the state at the nearer end applies, with jerk 0.)")
      .def_property_readonly("duration", &Profile::duration,
                             "Duration, s: the sum of the phases. `curve.end` is rounded once for "
                             "each joint, so it can differ in the last digit.")
      .def_property_readonly(
          "start", [](const Profile& move) { return state_of(move.start()); }, "State at 0 s.")
      .def_property_readonly(
          "end", [](const Profile& move) { return state_of(move.end()); },
          "State at the end, exactly the target.")
      .def_property_readonly("order", &Profile::order,
                             "Order of the highest derivative: 3 jerk, 2 acceleration, 1 velocity.")
      .def_property_readonly("phases", phases_of,
                             "List of (duration in s, constant value of the highest derivative).")
      .def(
          "__call__",
          [](const Profile& move, const Column& t) -> py::object {
            return motion_at(move, t).attr("position");
          },
          "t"_a, "Returns the position (u) at t (s): a number, or an array of the shape of t.")
      .def("at", motion_at, "t"_a,
           R"(Returns position, velocity, acceleration and jerk at t (s), as a Motion.

The members are numbers, or arrays of the shape of t: u, u/s, u/s^2, u/s^3.)")
      .def(
          "sample", sampled_move, "step"_a, py::kw_only(), "uniform"_a = false,
          R"(Returns the times 0, step, 2 step, ... and the end (s), and the motion there, as (t, motion).

With `uniform`, all times are multiples of the step: the last one is at or after the end, where the move
holds its last position.)")
      .def_property_readonly("curve", &Profile::curve,
                             "The same motion as a Trajectory, for exact extrema, checks and "
                             "tables. Raises InputError "
                             "for a move of duration 0.")
      .def(
          "check",
          [](const Profile& move, const Limits& limits) {
            return NamedReport{check(move.curve(), limits)};
          },
          "limits"_a, "Compares the exact extrema with the limits, and returns a Report.")
      .def(py::pickle([](const Profile& move) { return move_state(move); },
                      [](const py::tuple& state) { return move_of_state(state); }))
      .def("__repr__", [](const Profile& move) {
        return shown("Move", {{"duration", shown(move.duration())},
                              {"start", shown(move.start().position)},
                              {"end", shown(move.end().position)},
                              {"phases", std::to_string(move.phases())}});
      });
}

void bind_moves(py::module_& m) {
  bind_bounds(m);
  bind_move(m);
  bind_batches(m);
  bind_generators(m);
}

}  // namespace jounce::python
