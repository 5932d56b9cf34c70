// SPDX-License-Identifier: Apache-2.0
// Setpoints in each cycle, for a number of axes that is known at run time.
#include "jounce/profiles/online/online.hpp"

#include <optional>

#include <pybind11/stl.h>

#include "python/src/bind.hpp"
#include "python/src/moves.hpp"
#include "python/src/readers.hpp"
#include "python/src/report.hpp"
#include "python/src/words.hpp"

namespace jounce::python {

using namespace py::literals;

namespace {

MoveGoal goal_of(const std::string& word) {
  if (word == "state") return MoveGoal::state;
  if (word == "moving") return MoveGoal::moving;
  throw InputError("goal", word, "must be one of state, moving");
}

/// OnlineGenerator with a number of axes that is known at run time.
class Online {
 public:
  Online(std::size_t axes, Sync sync)
      : axes_(axes), moves_(axes), next_(axes), rests_(axes), sync_(sync) {
    if (axes == 0) throw InputError("axes", 0.0, "must be at least 1");
  }

  [[nodiscard]] std::size_t size() const { return axes_.size(); }

  void set_state(const StateColumns& state) {
    for_each_state(state, "state",
                   [](auto& axis, const MotionState& to) { return axis.set_state(to); });
  }
  void set_target(const StateColumns& target, const std::string& goal) {
    for_each_state(target, "target", [kind = goal_of(goal)](auto& axis, const MotionState& to) {
      return axis.set_target(kind, to);
    });
  }
  void set_velocity(const Column& velocity) {
    for_each_state({{}, velocity, {}}, "velocity", [](auto& axis, const MotionState& to) {
      return axis.set_target(MoveGoal::velocity, to);
    });
  }
  void set_bounds(const BoundsColumns& bounds) {
    const StateColumns none;
    Broadcast all = broadcast_moves(none, none, bounds);
    require_fit(all, "bounds");
    const MoveReaders readers(all, none, none, bounds);
    for (std::size_t k = 0; k < size(); ++k)
      require_ok(axes_[k].set_bounds(readers.bounds(all.size() == 1 ? 0 : k)), k, "bounds");
  }
  void set_enabled(std::size_t axis, bool enabled) { axes_.at(axis).set_enabled(enabled); }
  void set_tolerance(double position, double velocity) {
    for (auto& axis : axes_) axis.set_tolerance(position, velocity);
  }

  OnlineStep step(double dt) {
    require_not_negative("dt", dt);
    return step_unchecked(dt);
  }

  /// Steps until all axes are at their goals, or `most` times. Returns (t, Motion).
  py::tuple run(double dt, std::size_t most) {
    require_positive("dt", dt);
    std::vector<double> times;
    std::vector<Jet> jets;
    {
      const py::gil_scoped_release release;
      for (bool arrived = false; !arrived && times.size() < most;) {
        arrived = step_unchecked(dt).arrived;
        times.push_back(static_cast<double>(times.size() + 1) * dt);
        for (const auto& axis : axes_) jets.push_back(jet(axis.now()));
      }
    }
    const Broadcast::Shape shape{static_cast<py::ssize_t>(times.size()),
                                 static_cast<py::ssize_t>(size())};
    return py::make_tuple(
        taken(std::move(times)),
        points_of<OverTime>(shape, jets.size(), [&](std::size_t i) { return jets[i]; }));
  }

  [[nodiscard]] py::object motion() const {
    return points_of<OverTime>({static_cast<py::ssize_t>(size())}, size(),
                               [&](std::size_t k) { return jet(axes_[k].now()); });
  }
  [[nodiscard]] double remaining() const {
    double t = 0;
    for (const auto& axis : axes_) t = std::max(t, axis.remaining());
    return t;
  }

 private:
  static Jet jet(const Motion& now) {
    return {now.position, now.velocity, now.acceleration, now.jerk};
  }

  OnlineStep step_unchecked(double dt) {
    return profiles_detail::OnlineGroup{axes_, moves_, next_, rests_, sync_, 0, false}.step(dt);
  }

  void require_fit(const Broadcast& all, const char* key) const {
    const auto axes = static_cast<py::ssize_t>(size());
    if (all.is_scalar() || all.shape() == Broadcast::Shape{axes} ||
        all.shape() == Broadcast::Shape{1})
      return;
    throw InputError(key, "",
                     "must have one value for all axes, or one for each of the " +
                         std::to_string(axes) + " axes");
  }
  static void require_ok(MoveStatus status, std::size_t axis, const char* key) {
    if (status != MoveStatus::ok)
      raise_move_error(
          status, std::string(key) + " of axis " + std::to_string(axis) + ": " + explain(status));
  }

  template <class Set>
  void for_each_state(const StateColumns& state, const char* key, const Set& set) {
    Broadcast all({&state.position, &state.velocity, &state.acceleration});
    require_fit(all, key);
    const Reader p = all.read(state.position), v = all.read(state.velocity),
                 a = all.read(state.acceleration);
    const auto at = [&](const Reader& reader, std::size_t k) {
      return reader[all.size() == 1 ? 0 : k];
    };
    for (std::size_t k = 0; k < size(); ++k)
      require_ok(set(axes_[k], MotionState{at(p, k), at(v, k), at(a, k)}), k, key);
  }

  std::vector<profiles_detail::OnlineAxis> axes_;
  std::vector<AxisMove> moves_;
  std::vector<Profile> next_, rests_;
  Sync sync_;
};

}  // namespace

void bind_online(py::module_& m) {
  py::class_<OnlineStep>(m, "OnlineStep", "Result of OnlineGenerator.step().")
      .def_property_readonly(
          "status", [](const OnlineStep& s) { return word(s.status); },
          R"("ok", or the reason why an axis cannot move to its goal.)")
      .def_readonly("axis", &OnlineStep::axis, "The first axis with this status, if it is not ok.")
      .def_readonly("arrived", &OnlineStep::arrived, "True if every enabled axis is at its goal.")
      .def_readonly("planned", &OnlineStep::planned, "True if a motion was planned in this step.")
      .def("__repr__", [](const OnlineStep& s) {
        return shown("OnlineStep", {{"status", std::string("'") + word(s.status) + "'"},
                                    {"arrived", s.arrived ? "True" : "False"}});
      });
  py::class_<Online>(m, "OnlineGenerator",
                     R"(Generator of setpoints for several axes, called once in each cycle.

Targets and bounds may change at any time. Every axis begins at rest at position 0, and takes part once it has bounds.
Arguments are numbers for all axes, or arrays with one value for each axis. One thread uses an object at a time.)")
      .def(
          py::init<std::size_t, Sync>(), "axes"_a, py::kw_only(), "sync"_a = Sync::none,
          R"(`sync`: "none", "time", "phase", "time_if_moving" or "phase_or_time", see synchronize().)")
      .def("__len__", &Online::size)
      .def("set_bounds", &Online::set_bounds, "bounds"_a,
           "Sets the bounds. Raises MoveError for invalid ones.")
      .def("set_state", &Online::set_state, "state"_a, "Sets the present state: u, u/s, u/s^2.")
      .def(
          "set_target", &Online::set_target, "target"_a, py::kw_only(), "goal"_a = "state",
          R"(Sets the target: a position at rest (u), or a State. With goal="moving", the target keeps its
velocity.)")
      .def("set_velocity", &Online::set_velocity, "velocity"_a,
           "Sets a velocity (u/s) as the goal, at any position.")
      .def("set_enabled", &Online::set_enabled, "axis"_a, "enabled"_a,
           "Enables or disables an axis. A disabled axis comes to rest as fast as possible.")
      .def("set_tolerance", &Online::set_tolerance, "position"_a, "velocity"_a = 0.0,
           "Sets the change of a target (u, u/s) up to which the present motion continues.")
      .def("step", &Online::step, "dt"_a,
           "Advances all axes by dt (s), and plans motions if necessary.")
      .def("run", &Online::run, "dt"_a, py::kw_only(), "most"_a = 1000000,
           R"(Steps until all axes are at their goals, or `most` times, in one loop without the GIL.

Returns (t, motion): the times from now (s), and a Motion whose arrays have a row for each step and a column for each
axis.)")
      .def_property_readonly("motion", &Online::motion, "Present setpoints, as a Motion of arrays.")
      .def_property_readonly("remaining", &Online::remaining,
                             "Time until the last axis reaches its goal, s.")
      .def("__repr__", [](const Online& o) {
        return shown("OnlineGenerator",
                     {{"axes", std::to_string(o.size())}, {"remaining", shown(o.remaining())}});
      });
}

}  // namespace jounce::python
