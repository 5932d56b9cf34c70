// SPDX-License-Identifier: Apache-2.0
// Several axes, via points and queues.
#include <cmath>
#include <limits>
#include <optional>

#include <pybind11/stl.h>

#include "jounce/profiles/moves/explain.hpp"
#include "jounce/profiles/sequences/queue.hpp"
#include "jounce/profiles/sequences/synchronize.hpp"
#include "jounce/profiles/sequences/via.hpp"

#include "python/src/bind.hpp"
#include "python/src/moves.hpp"
#include "python/src/readers.hpp"
#include "python/src/report.hpp"
#include "python/src/values.hpp"
#include "python/src/words.hpp"

namespace jounce::python {

using namespace py::literals;

namespace {

/// Plans the groups: the last axis of the shape is that of the machine's axes.
Moves planned_groups(const Broadcast& all, const MoveReaders& readers, Sync sync,
                     double minimum_duration, std::size_t threads,
                     std::vector<Synchronized>& results) {
  const py::gil_scoped_release release;
  const auto axes = static_cast<std::size_t>(all.shape().back());
  const auto profiles = std::make_shared<std::vector<Profile>>(all.size());
  Moves moves(all.shape(), all.size(), [profiles](std::size_t i) { return (*profiles)[i]; });
  if (axes == 0) return moves;
  results.resize(all.size() / axes);
  in_parts(results.size(), threads, [&](std::size_t first, std::size_t last) {
    std::vector<AxisMove> group(axes);
    for (std::size_t g = first; g < last; ++g) {
      for (std::size_t k = 0; k < axes; ++k)
        group[k] = {.from = readers.from(g * axes + k),
                    .to = readers.to(g * axes + k),
                    .bounds = readers.bounds(g * axes + k),
                    .goal = MoveGoal::state,
                    .enabled = true,
                    .under_way = nullptr};
      results[g] =
          synchronize(group, sync, std::span(*profiles).subspan(g * axes, axes), minimum_duration);
      for (std::size_t k = g * axes; k < (g + 1) * axes; ++k)
        moves.set(k, results[g].status, (*profiles)[k].duration());
    }
  });
  return moves;
}

Moves groups(const StateColumns& start, const StateColumns& target, const BoundsColumns& bounds,
             Sync sync, double minimum_duration, std::optional<py::ssize_t> threads) {
  Broadcast all = broadcast_moves(start, target, bounds);
  if (all.is_scalar())
    throw InputError("start", "", "must be an array with one value for each axis");
  if (!(minimum_duration >= 0 && std::isfinite(minimum_duration)))
    throw InputError("minimum_duration", minimum_duration, "must be >= 0");
  std::vector<Synchronized> results;
  const MoveReaders readers(all, start, target, bounds);
  Moves moves = planned_groups(all, readers, sync, minimum_duration, threads_of(threads), results);
  if (moves.shape().size() == 1 && !results.empty() && results.front().status != MoveStatus::ok) {
    const Synchronized& result = results.front();
    raise_move_error(result.status,
                     "axis " + std::to_string(result.axis) + ": " +
                         explain(result.status, readers.from(result.axis), readers.to(result.axis),
                                 readers.bounds(result.axis)));
  }
  return moves;
}

std::vector<double> row(const Doubles& points, py::ssize_t i) {
  return {points.data(i, 0), points.data(i, 0) + points.shape(1)};
}

ViaSpec via_spec(const Doubles& points, const BoundsColumns& bounds,
                 const std::optional<std::vector<double>>& start,
                 const std::optional<std::vector<double>>& end, const Limits& norm) {
  if (points.ndim() != 2)
    throw InputError("points", "",
                     "must be an array with a row for each point and a column for each axis");
  ViaSpec spec;
  const auto axes = static_cast<std::size_t>(points.shape(1));
  Column wide;
  wide.array = Doubles(static_cast<py::ssize_t>(axes));
  const StateColumns none{wide, {}, {}};
  Broadcast all = broadcast_moves(none, none, bounds);
  if (all.shape().size() != 1 || all.size() != axes)
    throw InputError("bounds", "", "must have one value for all axes, or one for each axis");
  const MoveReaders readers(all, none, none, bounds);
  for (std::size_t k = 0; k < axes; ++k) spec.axes.push_back(readers.bounds(k));
  for (py::ssize_t i = 0; i < points.shape(0); ++i) spec.points.push_back(row(points, i));
  if (start) spec.start.velocity = *start;
  if (end) spec.end.velocity = *end;
  spec.norm = norm;
  return spec;
}

py::array_t<double> knot_rates(const ViaMotion& motion, std::vector<double> ViaKnot::*rates) {
  py::array_t<double> all({motion.knots.size(), motion.axes.size()});
  auto out = all.mutable_unchecked<2>();
  for (std::size_t i = 0; i < motion.knots.size(); ++i)
    for (std::size_t k = 0; k < motion.axes.size(); ++k)
      out(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k)) = (motion.knots[i].*rates)[k];
  return all;
}

void bind_via(py::module_& m) {
  py::class_<ViaMotion>(m, "ViaMotion",
                        "A motion of one or more axes through points, without a stop at them.")
      .def_readonly("axes", &ViaMotion::axes,
                    "A Trajectory for each axis, all over the same time from 0 s.")
      .def_property_readonly(
          "times",
          [](const ViaMotion& motion) {
            std::vector<double> times;
            for (const ViaKnot& knot : motion.knots) times.push_back(knot.time);
            return taken(std::move(times));
          },
          "Times at which the axes pass the points, s.")
      .def_property_readonly(
          "velocity",
          [](const ViaMotion& motion) { return knot_rates(motion, &ViaKnot::velocity); },
          "Velocities at the points (u/s): a row for each point, a column for each axis.")
      .def_property_readonly(
          "acceleration",
          [](const ViaMotion& motion) { return knot_rates(motion, &ViaKnot::acceleration); },
          "Accelerations at the points (u/s^2), like `velocity`.")
      .def_readonly("duration", &ViaMotion::duration, "Duration, s.")
      .def_readonly("stopping_duration", &ViaMotion::stopping_duration,
                    "Duration of the same motion with a stop at every inner point, s.")
      .def_readonly("stops", &ViaMotion::stops,
                    "True if no motion better than stopping at every point was found.")
      .def("__repr__", [](const ViaMotion& motion) {
        return shown("ViaMotion", {{"duration", shown(motion.duration)},
                                   {"points", std::to_string(motion.knots.size())},
                                   {"axes", std::to_string(motion.axes.size())}});
      });
  m.def(
      "via",
      [](const Doubles& points, const BoundsColumns& bounds,
         const std::optional<std::vector<double>>& start,
         const std::optional<std::vector<double>>& end, const Limits& norm) {
        const ViaSpec spec = via_spec(points, bounds, start, end, norm);
        const py::gil_scoped_release release;
        return via(spec);
      },
      "points"_a, "bounds"_a, py::kw_only(), "start_velocity"_a = py::none(),
      "end_velocity"_a = py::none(), "norm"_a = Limits{},
      R"(Plans a motion through points without a stop at them, within the bounds of each axis.

points (u): a row for each point, a column for each axis. bounds: one for all axes, or arrays with a value for
each axis.
The velocities at the ends (u/s) are 0 by default. `norm` limits the length of the vector of all axes. Several axes: a
local optimum, never longer than with stops. Raises InputError if no such motion was found.)");
}

QueuedCommand command(MotionCommand what, double velocity, double acceleration, double deceleration,
                      double jerk, BufferMode mode, std::optional<double> issued) {
  return {what, {velocity, acceleration, deceleration, jerk, 0}, mode, issued};
}

template <class Move>
auto moving() {
  return [](double number, double velocity, double acceleration, double deceleration, double jerk,
            BufferMode mode, std::optional<double> issued) {
    return command(Move{number}, velocity, acceleration, deceleration, jerk, mode, issued);
  };
}

const char* command_name(const MotionCommand& what) {
  constexpr std::array names{"move_absolute", "move_relative", "move_velocity", "halt", "dwell"};
  return names[what.index()];
}

py::tuple members_of_command(const QueuedCommand& c) {
  const double number = std::visit(
      [](const auto& what) -> double {
        using What = std::decay_t<decltype(what)>;
        if constexpr (std::is_same_v<What, MoveAbsolute>) return what.position;
        if constexpr (std::is_same_v<What, MoveRelative>) return what.distance;
        if constexpr (std::is_same_v<What, MoveVelocity>) return what.direction;
        if constexpr (std::is_same_v<What, Dwell>) return what.time;
        return 0;
      },
      c.command);
  const Dynamics& d = c.dynamics;
  return py::make_tuple(c.command.index(), number, d.velocity, d.acceleration, d.deceleration,
                        d.jerk, c.mode, c.issued);
}

QueuedCommand command_of(const py::tuple& members) {
  const auto number = members[1].cast<double>();
  const std::array<MotionCommand, 5> all{MoveAbsolute{number}, MoveRelative{number},
                                         MoveVelocity{number < 0 ? -1 : 1}, Halt{}, Dwell{number}};
  return command(all.at(members[0].cast<std::size_t>()), members[2].cast<double>(),
                 members[3].cast<double>(), members[4].cast<double>(), members[5].cast<double>(),
                 members[6].cast<BufferMode>(), members[7].cast<std::optional<double>>());
}

void bind_commands(py::module_& m) {
  const auto buffered = BufferMode::buffered;
  py::class_<QueuedCommand> bound(
      m, "Command",
      R"(A command in a queue() of one axis, with its dynamics (PLCopen).

velocity (u/s) and acceleration (u/s^2) are > 0; deceleration 0: the same as the acceleration; jerk (u/s^3) 0: not
limited. `mode` is "aborting", "buffered", "blending_low", "blending_previous", "blending_next" or "blending_high".
`issued` (s) is the time of an aborting command.)");
  add_value(bound, members_of_command, command_of);
  bound
      .def_static("move_absolute", moving<MoveAbsolute>(), "position"_a, py::kw_only(),
                  "velocity"_a, "acceleration"_a, "deceleration"_a = 0.0, "jerk"_a = 0.0,
                  "mode"_a = buffered, "issued"_a = py::none(), "A move to a position (u).")
      .def_static("move_relative", moving<MoveRelative>(), "distance"_a, py::kw_only(),
                  "velocity"_a, "acceleration"_a, "deceleration"_a = 0.0, "jerk"_a = 0.0,
                  "mode"_a = buffered, "issued"_a = py::none(),
                  "A move by a distance (u) from the target of the previous command.")
      .def_static(
          "move_velocity",
          [](double velocity, double acceleration, double deceleration, double jerk,
             BufferMode mode, std::optional<double> issued) {
            return command(MoveVelocity{velocity < 0 ? -1 : 1}, std::abs(velocity), acceleration,
                           deceleration, jerk, mode, issued);
          },
          "velocity"_a, py::kw_only(), "acceleration"_a, "deceleration"_a = 0.0, "jerk"_a = 0.0,
          "mode"_a = buffered, "issued"_a = py::none(), "A change to a signed velocity (u/s).")
      .def_static(
          "halt",
          [](double acceleration, double deceleration, double jerk, BufferMode mode,
             std::optional<double> issued) {
            return command(Halt{}, 1, acceleration, deceleration, jerk, mode, issued);
          },
          py::kw_only(), "acceleration"_a, "deceleration"_a = 0.0, "jerk"_a = 0.0,
          "mode"_a = buffered, "issued"_a = py::none(), "A stop at any position.")
      .def_static(
          "dwell",
          [](double time) {
            return QueuedCommand{Dwell{time}, {}, BufferMode::buffered, {}};
          },
          "time"_a, "A wait of `time` seconds.")
      .def_property_readonly(
          "name", [](const QueuedCommand& c) { return command_name(c.command); },
          R"("move_absolute", "halt", ...)")
      .def("__repr__", [](const QueuedCommand& c) {
        return std::string("Command.") + command_name(c.command) + "(...)";
      });
}

void bind_queue(py::module_& m) {
  py::class_<CommandRecord>(m, "CommandRecord", "Result of one command of a queue.")
      .def_readonly("begin", &CommandRecord::begin, "Begin, s.")
      .def_readonly("end", &CommandRecord::end, "End, s.")
      .def_readonly("target", &CommandRecord::target,
                    "End position, u; of an aborted command the intended one.")
      .def_readonly("planned", &CommandRecord::planned,
                    "Velocity at the end that the next mode requires, u/s.")
      .def_readonly("reached", &CommandRecord::reached, "Velocity at the end, u/s.")
      .def_property_readonly(
          "aborted", [](const CommandRecord& r) { return r.state == CommandState::aborted; },
          "True if another command aborted it.")
      .def("__repr__", [](const CommandRecord& r) {
        return shown(
            "CommandRecord",
            {{"begin", shown(r.begin)}, {"end", shown(r.end)}, {"target", shown(r.target)}});
      });
  py::class_<QueuedMotion>(m, "QueuedMotion", "A queue of commands, planned as one motion.")
      .def_readonly("curve", &QueuedMotion::trajectory, "The motion, from 0 s.")
      .def_readonly("commands", &QueuedMotion::commands, "A CommandRecord for each command.")
      .def_property_readonly(
          "end", [](const QueuedMotion& q) { return state_of(q.end); }, "State at the end.")
      .def("__repr__", [](const QueuedMotion& q) {
        return shown("QueuedMotion", {{"duration", shown(q.trajectory.length())},
                                      {"commands", std::to_string(q.commands.size())}});
      });
  m.def(
      "queue",
      [](std::vector<QueuedCommand> commands, const StateColumns& start) {
        const QueueSpec spec{one(start, "start"), std::move(commands)};
        const py::gil_scoped_release release;
        return queue(spec);
      },
      "commands"_a, "start"_a = py::float_(0.0),
      R"(Plans buffered, blended and aborting commands of one axis as one motion (PLCopen, Part 1).

Raises InputError for a command that is out of range; its key counts commands from 1.)");
}

}  // namespace

void bind_sequences(py::module_& m) {
  m.def(
      "synchronize", groups, "start"_a, "target"_a, "bounds"_a, py::kw_only(),
      "sync"_a = Sync::time, "minimum_duration"_a = 0.0, "threads"_a = py::none(),
      R"(Plans moves of several axes that belong together. The last axis of the arrays is that of the machine's axes.

start, target: positions at rest (u), or State, with arrays of the shape (axes,) for one group of axes, or
(..., axes) for many groups, which are planned in one loop without the GIL. `sync`: "time" (all arrive at the same
instant), "phase" (and stay on a straight line), "none", "time_if_moving" or "phase_or_time". Every duration is at least
`minimum_duration` (s); with "time_if_moving", this does not apply to an axis whose target is at rest. `threads`:
greatest number of threads for many groups; None: one for each core.

Returns Moves of that shape. For one group, MoveError is raised if there is no common motion; for many, its durations
are NaN.)");
  bind_via(m);
  bind_commands(m);
  bind_queue(m);
}

}  // namespace jounce::python
