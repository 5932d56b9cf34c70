// SPDX-License-Identifier: Apache-2.0
// Commands and tables for an axis of an executor.
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>

#include <pybind11/stl.h>

#include "jounce/machine/detail/outcome_text.hpp"
#include "jounce/machine/play_plan.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/message/wire.hpp"
#include "jounce/stream/security/key.hpp"
#include "jounce/stream/sender/client.hpp"
#include "jounce/stream/sender/operate.hpp"
#include "jounce/stream/transport/open_transport.hpp"

#include "python/src/advice.hpp"
#include "python/src/bind.hpp"
#include "python/src/design.hpp"
#include "python/src/numpy/column.hpp"
#include "python/src/report.hpp"
#include "python/src/table.hpp"

namespace jounce::python {

using namespace py::literals;

namespace {

/// True if the time of a call has passed.
bool is_late(StreamError error) {
  return error == StreamError::out_of_time || error == StreamError::no_answer ||
         error == StreamError::command_timeout;
}

/// The reason as a word: of the axis, such as "position_limit", or of the executor, such as "busy"; "" if
/// the call was not rejected.
std::string word_of(const CallOutcome& outcome) {
  if (outcome.refusal == wire::Refusal::none) return "";
  const bool of_axis = outcome.refusal == wire::Refusal::axis && outcome.cause != 0;
  return of_axis ? name(static_cast<Cause>(outcome.cause)) : wire::name(outcome.refusal);
}

/// The reason in words, without the remedies of an axis: they are commands of the program jounce.
std::string words_of(const CallOutcome& outcome, const std::string& axis) {
  constexpr std::string_view who = "axis: ";
  if (outcome.refusal != wire::Refusal::axis || !outcome.reason.starts_with(who))
    return with_arguments(reason_text(outcome, axis));
  const std::string reason = outcome.reason.substr(who.size());
  return reason.substr(0, reason.find(": send `jounce "));
}

void require_ok(const CallOutcome& outcome, const std::string& axis) {
  if (outcome.ok()) return;
  const std::string text = axis + ": " + name(outcome.error) + ": " + words_of(outcome, axis);
  const char* const type = is_late(outcome.error) ? "AxisTimeout" : "AxisError";
  const py::object error =
      from_package("_errors", type)(text, name(outcome.error), word_of(outcome), outcome.cause);
  PyErr_SetObject(py::type::handle_of(error).ptr(), error.ptr());
  throw py::error_already_set();
}

/// A Client with its links. Several threads may use it: one call at a time.
class AxisClient {
 public:
  AxisClient(std::string axis, std::string url, const std::string& key, double patience)
      : axis_(std::move(axis)), url_(std::move(url)) {
    if (!key.empty()) key_ = read_key(key);
    require_positive("patience", patience);
    link_ = open_transport(url_);
    client_.emplace(*link_, axis_, ClientOptions{.key = key_, .patience = nanos(patience)});
    status_link_ = open_transport(url_);
    status_link_->subscribe(wire::channel(axis_, wire::Lane::status), 1);
  }

  [[nodiscard]] const std::string& axis() const { return axis_; }
  [[nodiscard]] const std::string& url() const { return url_; }

  /// Calls the client without the GIL. Raises AxisError if the axis rejects the call.
  template <class Call>
  void call(const Call& call) {
    const CallOutcome outcome = [&] {
      const py::gil_scoped_release release;
      const std::lock_guard lock(mutex_);
      return call(*client_);
    }();
    require_ok(outcome, axis_);
  }

  wire::Status status(double timeout) {
    const auto message = [&] {
      const py::gil_scoped_release release;
      const std::lock_guard lock(mutex_);
      return next_status(*status_link_, axis_, nanos(timeout), key_);
    }();
    if (!message)
      require_ok({StreamError::no_answer,
                  {},
                  0,
                  "no status arrived within " + number(timeout) +
                      " s: check the name, the url, "
                      "and that the executor runs"},
                 axis_);
    return std::get<wire::Status>(message->body);
  }

  /// Ctrl-C stops the axis. Between two messages, other threads may call the client.
  std::string wait_for_rest(double timeout) {
    using namespace std::chrono_literals;
    Watch watch{py::none()};
    const RestOutcome outcome = [&] {
      const py::gil_scoped_release release;
      std::unique_lock lock(mutex_);
      const auto interrupted = [&] {
        lock.unlock();
        std::this_thread::sleep_for(1ms);
        const bool goes_on = watch(0, "");
        lock.lock();
        return !goes_on;
      };
      return await_rest(*status_link_, axis_, *client_,
                        {.patience = nanos(timeout), .cancelled = interrupted, .key = key_});
    }();
    watch.rethrow();
    require_ok(outcome, axis_);
    return name(*outcome.state);
  }

  /// After an exception, the session is left to its timeout: the axis must not move on without its program.
  void leave(bool failed) {
    const py::gil_scoped_release release;
    const std::lock_guard lock(mutex_);
    if (failed)
      client_->abandon();
    else
      static_cast<void>(client_->release());  // without an answer, the session ends by itself
  }

  void stream(const py::object& source, const std::optional<NamedTable>& master, bool live,
              bool wait, double timeout, const py::object& progress) {
    const Input input = input_of_argument(source);
    PlayOptions play{.live = live, .master = {}};
    if (master) play.master = master->file;
    StreamPlan plan = stream_plan(axis_, input, play);
    plan.await = wait;
    Watch watch(progress);
    StreamOptions options;
    options.key = key_;
    options.total = nanos(timeout);
    StreamProgress now;
    options.progress = [&](const StreamProgress& p) { now = p; };
    bool cancelled = false;
    options.cancelled = [&] {
      const double done =
          now.chunks == 0 ? 0 : static_cast<double>(now.arrived) / static_cast<double>(now.chunks);
      return cancelled = !watch(done, name(now.stage));
    };
    const CallOutcome outcome = [&]() -> CallOutcome {
      const py::gil_scoped_release release;
      const std::lock_guard lock(mutex_);
      if (client_->session() != 0)
        if (CallOutcome alive = client_->beat(); alive.error == StreamError::stopped) return alive;
      static_cast<void>(client_->release());  // the stream has a session of its own
      const auto link = open_transport(url_);
      CallOutcome streamed = stream_tables(*link, plan, options);
      if (streamed.ok()) client_->adopt_motion();
      return streamed;
    }();
    watch.rethrow();
    require_ok(outcome, axis_);
    if (cancelled) throw InputError("progress", "False", "has stopped the motion");
  }

 private:
  std::string axis_, url_;
  std::optional<wire::Key> key_;
  std::unique_ptr<Transport> link_, status_link_;
  std::optional<Client> client_;
  std::mutex mutex_;
};

using Number = std::optional<double>;

MoveDynamics dynamics(Number velocity, Number acceleration, Number deceleration, Number jerk) {
  return {velocity.value_or(as_configured), acceleration.value_or(as_configured),
          deceleration.value_or(as_configured), jerk.value_or(as_configured)};
}

/// A command with a number and dynamics.
template <class Send>
auto with_dynamics(const Send& send) {
  return [send](AxisClient& self, double number, Number velocity, Number acceleration,
                Number deceleration, Number jerk) {
    self.call([&](Client& client) {
      return send(client, number, dynamics(velocity, acceleration, deceleration, jerk));
    });
  };
}

/// A command without arguments.
template <class Send>
auto plain(const Send& send) {
  return [send](AxisClient& self) { self.call(send); };
}

void bind_status(py::module_& m) {
  using S = wire::Status;
  py::class_<S>(m, "Status", "Status of an axis. Positions in its unit u, NaN if unknown.")
      .def_property_readonly(
          "state", [](const S& s) { return name(s.state); },
          R"(State of PLCopen: "standstill", "discrete_motion", "error_stop", ...)")
      .def_readonly("tick", &S::tick, "Number of the tick.")
      .def_property_readonly(
          "cycle", [](const S& s) { return static_cast<double>(s.cycle_ns) * 1e-9; },
          "Duration of a tick, s.")
      .def_readonly("position", &S::slave_position, "Commanded position, u.")
      .def_readonly("velocity", &S::slave_velocity, "Commanded velocity, u/s.")
      .def_readonly("master_position", &S::master_position, "Position of the master, m.")
      .def_readonly("actual_position", &S::actual_position, "Actual position of the drive, u.")
      .def_readonly("following_error", &S::following_error, "Commanded minus actual position, u.")
      .def_readonly("override", &S::override_, "Override factor.")
      .def_readonly("homed", &S::homed, "True if the axis was homed.")
      .def_readonly("held", &S::held, "True if a motion is held.")
      .def_readonly("finished", &S::finished, "Number of motions that reached their end.")
      .def_readonly("stopped", &S::stopped, "Number of motions that a stop brought to rest.")
      .def_readonly("fault", &S::last_error, "Number of the cause of the fault; 0: none.")
      .def_readonly("reason", &S::reason,
                    "Number of the cause that ended the last motion early; 0: it reached its end.")
      .def_property_readonly(
          "unit", [](const S& s) { return s.units.position; }, "Unit of the axis; may be empty.")
      .def("__repr__", [](const S& s) {
        return shown("Status", {{"state", std::string("'") + name(s.state) + "'"},
                                {"position", shown(s.slave_position)},
                                {"velocity", shown(s.slave_velocity)}});
      });
}

void bind_power(py::class_<AxisClient>& c) {
  c.def("enable", plain([](Client& k) { return k.enable(); }), "Enables the drive (MC_Power).")
      .def("disable", plain([](Client& k) { return k.disable(); }), "Disables the drive.")
      .def("reset", plain([](Client& k) { return k.reset(); }), "Resets a fault (MC_Reset).")
      .def("hold", plain([](Client& k) { return k.hold(); }), "Holds the motion (feed hold).")
      .def("resume", plain([](Client& k) { return k.resume(); }), "Resumes a held motion.")
      .def("cam_out", plain([](Client& k) { return k.cam_out(); }),
           "Ends the coupling to a cam (MC_CamOut).")
      .def("gear_out", plain([](Client& k) { return k.gear_out(); }),
           "Ends the coupling to a gear (MC_GearOut).")
      .def(
          "stop",
          [](AxisClient& self, bool abort) {
            self.call([&](Client& k) {
              return k.stop(abort ? wire::StopMode::abort : wire::StopMode::stop);
            });
          },
          py::kw_only(), "abort"_a = false,
          "Stops the axis and ends its motion; abort: as fast as the axis can.")
      .def("release", plain([](Client& k) { return k.release(); }),
           "Ends the session. A motion continues.")
      .def(
          "home",
          [](AxisClient& self, double position) {
            self.call([&](Client& k) {
              return k.command(
                  command::Home{.offset = position, .method = command::Home::without_motion});
            });
          },
          "position"_a,
          "Homes at the present position without motion: assigns this value (u) to it.")
      .def(
          "set_position",
          [](AxisClient& self, double position, bool relative) {
            self.call([&](Client& k) {
              return k.command(command::SetPosition{.position = position, .relative = relative});
            });
          },
          "position"_a, py::kw_only(), "relative"_a = false,
          "Assigns a value (u) to the present position, or adds it (MC_SetPosition).")
      .def(
          "override",
          [](AxisClient& self, double factor) {
            self.call([&](Client& k) { return k.command(command::Override{factor}); });
          },
          "factor"_a, "Sets the override, 0 to 2 (MC_SetOverride).");
}

void bind_motion(py::class_<AxisClient>& c) {
  const auto bind = [&](const char* name, const char* number, const auto& send, const char* doc) {
    c.def(name, with_dynamics(send), py::arg(number), py::kw_only(), "velocity"_a = py::none(),
          "acceleration"_a = py::none(), "deceleration"_a = py::none(), "jerk"_a = py::none(), doc);
  };
  bind(
      "move_relative", "distance",
      [](Client& k, double x, const MoveDynamics& d) {
        return k.command(command::MoveRelative{.distance = x, .dynamics = d});
      },
      "Moves by a distance (u) (MC_MoveRelative). Dynamics as for move_absolute().");
  bind(
      "move_additive", "distance",
      [](Client& k, double x, const MoveDynamics& d) {
        return k.command(command::MoveAdditive{.distance = x, .dynamics = d});
      },
      "Moves the present target by a distance (u) (MC_MoveAdditive). Dynamics as for "
      "move_absolute().");
  bind(
      "move_superimposed", "distance",
      [](Client& k, double x, const MoveDynamics& d) {
        return k.command(command::MoveSuperimposed{.distance = x, .dynamics = d});
      },
      "Adds a move by a distance (u) to the present motion (MC_MoveSuperimposed).");
  c.def(
      "move_absolute",
      [](AxisClient& self, double position, Number velocity, Number acceleration,
         Number deceleration, Number jerk, int direction) {
        self.call([&](Client& k) {
          return k.command(command::MoveAbsolute{
              .position = position,
              .dynamics = dynamics(velocity, acceleration, deceleration, jerk),
              .direction = static_cast<Direction>(direction)});
        });
      },
      "position"_a, py::kw_only(), "velocity"_a = py::none(), "acceleration"_a = py::none(),
      "deceleration"_a = py::none(), "jerk"_a = py::none(), "direction"_a = 0,
      R"(Moves to a position (u) (MC_MoveAbsolute). Returns when the axis has accepted the command.

velocity (u/s), acceleration and deceleration (u/s^2), jerk (u/s^3): as configured by default. direction, on a modulo
axis: 1 or -1; 0: the shorter way.)");
  c.def(
      "move_velocity",
      [](AxisClient& self, double velocity, Number acceleration, Number deceleration, Number jerk) {
        self.call([&](Client& k) {
          return k.command(command::MoveVelocity{
              .velocity = velocity, .dynamics = dynamics({}, acceleration, deceleration, jerk)});
        });
      },
      "velocity"_a, py::kw_only(), "acceleration"_a = py::none(), "deceleration"_a = py::none(),
      "jerk"_a = py::none(),
      "Moves at a signed velocity (u/s) until the next command (MC_MoveVelocity).");
  c.def(
      "halt",
      [](AxisClient& self, Number deceleration, Number jerk) {
        self.call([&](Client& k) {
          return k.command(command::Halt{dynamics({}, {}, deceleration, jerk)});
        });
      },
      py::kw_only(), "deceleration"_a = py::none(), "jerk"_a = py::none(),
      "Brings the axis to rest (MC_Halt).");
  c.def(
      "gear_in",
      [](AxisClient& self, std::int32_t numerator, std::int32_t denominator) {
        self.call([&](Client& k) {
          return k.command(command::GearIn{.numerator = numerator, .denominator = denominator});
        });
      },
      "numerator"_a, "denominator"_a, "Couples the axis to its master by a ratio (MC_GearIn).");
}

}  // namespace

void bind_stream(py::module_& m) {
  bind_status(m);
  py::class_<AxisClient> c(m, "Client",
                           R"(Sends commands and tables to one axis of an executor (`jounce run`).

    with jounce.Client("feeder") as axis:
        axis.enable()
        axis.move_absolute(120, velocity=200)
        axis.wait_for_rest()
        axis.stream("cam.toml")

A call returns when the axis has accepted the command, and raises AxisError if the axis rejects it, or AxisTimeout if
no answer arrives.

The first call opens a session: the client owns the axis. Without a call for one second, the session ends, and a motion
in progress is stopped: call wait_for_rest() while the axis moves. If an operator stops the axis, or the end of the
session stops a motion, the next call has no effect and raises AxisError with `error` "stopped", once; the call after it
opens a new session. The end of the `with` block releases the session, and a motion continues. If an exception ends the
block, the session is not released: a motion in progress is stopped after one second.

Every call releases the GIL. Several threads may use a client: one call at a time.)");
  c.def(
       py::init<std::string, std::string, const std::string&, double>(), "axis"_a, py::kw_only(),
       "url"_a = "udpm://239.255.76.67:7667", "key"_a = "", "patience"_a = 2.0,
       R"(axis: its name. url: "udpm://GROUP:PORT" is LCM multicast on this machine, "?ttl=1" on its network;
"unix://FOLDER"
needs no network. key: file with the key of the executor. patience: greatest duration of a call, s.)")
      .def_property_readonly("axis", &AxisClient::axis, "Name of the axis.")
      .def_property_readonly("url", &AxisClient::url, "Address of the executor.")
      .def("__enter__", [](const py::object& self) { return self; })
      .def("__exit__",
           [](AxisClient& self, const py::args& exception) {
             self.leave(!exception.empty() && !exception[0].is_none());
           })
      .def("status", &AxisClient::status, "timeout"_a = 2.0,
           "Waits for the next status of the axis, for at most `timeout` s.")
      .def(
          "wait_for_rest", &AxisClient::wait_for_rest, "timeout"_a = 60.0,
          R"(Waits until the axis is at rest, and returns its state: "standstill", "disabled" or "error_stop".

Raises AxisError with `error` "stopped" if the motion was cut short: by a stop of another program, a fault, or missing
heartbeats. The text states why and where. Keeps the session alive. Raises AxisTimeout after `timeout` s, and AxisError
("contact_lost") if no status arrives for two seconds. Ctrl-C stops the axis and raises KeyboardInterrupt.)")
      .def(
          "stream", &AxisClient::stream, "source"_a, py::kw_only(), "master"_a = py::none(),
          "live"_a = false, "wait"_a = true, "timeout"_a = 60.0, "progress"_a = py::none(),
          R"(Sends the tables of a motion; the axis starts when they have arrived and their hashes match.

source: a Design, a Table in s, or the path of a file. master: for a cam table, a Table of its master over
time. live: the
cam follows the live master of the axis. wait: returns when the motion has begun, otherwise when the start is
accepted.
progress: called with (done, stage). If it returns False, or after Ctrl-C, the axis stops, and InputError or
KeyboardInterrupt is raised.)")
      .def("__repr__", [](const AxisClient& k) {
        return shown("Client", {{"axis", "'" + k.axis() + "'"}, {"url", "'" + k.url() + "'"}});
      });
  bind_power(c);
  bind_motion(c);
}

}  // namespace jounce::python
