// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "jounce/axis/profile_event.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/profiles/curve/jet.hpp"
#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

struct AxisConfig;
class LiveCuts;

/// The commanded point of an axis at one instant. Units: u is the unit of the axis, m the unit of
/// its master.
struct Setpoint {
  double master = 0;           ///< position of the master, m; 0 without a master
  double master_velocity = 0;  ///< velocity of the master, m/s
  Jet slave{};  ///< position and its derivatives with respect to time: u, u/s, u/s^2, u/s^3
};

/// Returns the position, velocity and acceleration of the slave.
inline MotionState state_of(const Setpoint& setpoint) noexcept {
  return {setpoint.slave[0], setpoint.slave[1], setpoint.slave[2]};
}

/// One instant of the cycle: the input of a movement.
struct Moment {
  double t = 0;     ///< time of the movement, s; see Course
  double dt = 0;    ///< time since the previous step, s: more than a period if ticks were skipped
  Jet master = {};  ///< live master of the axis: m, m/s, ...; NaN: no master, or lost
  Jet second = {};  ///< second live master of the axis, like `master`
  /// At a start: the ratio at which the axis follows its master up to now, u/m; 0: it does not.
  double ratio = 0;
};

/// Independent variable of a movement. It determines how the axis holds, slows down and stops the
/// movement.
enum class Course : std::uint8_t {
  /// The movement's own time: the movement is a path. The axis can pass this time faster or slower,
  /// or stop it, without leaving the path. `t` is path time; at rate 1 it is exactly ticks *
  /// period.
  path,
  /// A master that moves freely. To stop, the axis leaves the movement and plans a move from its
  /// present state. `t` is the time since the movement began.
  live,
};

/// Progress of a movement.
enum class Progress : std::uint8_t {
  waiting,   ///< waits for its master or an event: the slave is at rest
  engaging,  ///< approaches its coupled position: ramp, clutch
  running,   ///< a path is played, or a slave is in gear or in sync
  starving,  ///< buffer underrun: the available rows end, and the axis stops
  done,      ///< has ended; the last setpoint is at rest
  broken,    ///< cannot continue (see Movement::cause()); repeats the last setpoint
};

/// The greatest magnitudes of a path. The axis computes the stop on the path from them.
struct Peaks {
  double velocity = 0;      ///< u/s
  double acceleration = 0;  ///< u/s^2
  double jerk = 0;          ///< u/s^3
  /// Largest sum of the velocity steps within one tick, u/s; 0: no steps.
  double velocity_step = 0;

  friend bool operator==(const Peaks&, const Peaks&) = default;
};

/// An output that a path switches at a time of the path.
struct PathSwitch {
  double time = 0;  ///< s of path time
  int output = 1;   ///< 1 to 32
  bool on = false;  ///< true: the output goes on
};

/// The place on the path of a group.
struct PathPlace {
  double length = 0;    ///< u, along the path of the tool from the start of the path
  double velocity = 0;  ///< u/s, at rate 1
};

/// A motion that an axis plays. It is made and checked outside the cyclic thread; the cyclic thread
/// steps it:
///
///     if (const Cause no = movement.begin(state, now); no != Cause::none) refuse(no);
///     while (movement.progress() < Progress::done) setpoint = movement.at(now);
///
/// begin() and at() do not allocate, free, lock, log or throw. Call them with ascending moments.
class Movement {
 public:
  /// `id`: id of the motion in Tick::job.
  explicit Movement(std::uint64_t id, Course course) : id_(id), course_(course) {}
  virtual ~Movement() = default;
  Movement(const Movement&) = delete;
  Movement& operator=(const Movement&) = delete;

  /// Id of the motion in Tick::job.
  [[nodiscard]] std::uint64_t id() const noexcept { return id_; }
  /// Independent variable of the movement.
  [[nodiscard]] Course course() const noexcept { return course_; }

  /// Begins the movement at `now`, from the state `axis` of the axis. Returns the reason why the
  /// movement cannot begin, or Cause::none. After Cause::none, the next at() returns the first
  /// point.
  virtual Cause begin(const MotionState& axis, const Moment& now) noexcept = 0;
  /// Returns the setpoint at `now`. Call once a tick.
  virtual Setpoint at(const Moment& now) noexcept = 0;

  /// Progress after the last at().
  [[nodiscard]] virtual Progress progress() const noexcept = 0;
  /// Reason for Progress::broken; otherwise none.
  [[nodiscard]] virtual Cause cause() const noexcept { return Cause::none; }

  /// Sets the number of the last change of the FIFOs that is visible in this tick
  /// (HandedOver::number), for rows that arrive during play. The axis calls this function at the
  /// beginning of every tick (Inputs::rows).
  virtual void see(std::uint64_t /*number*/) noexcept {}

  /// True if the positions of the movement are absolute; false if they are relative to the position
  /// of the axis at the start.
  [[nodiscard]] virtual bool absolute() const noexcept { return true; }

  /// Checks the movement against an axis in the state `from`, when the axis arms the movement.
  /// Returns nullopt, or the reason to reject the movement.
  [[nodiscard]] virtual std::optional<Refusal> admit(const AxisConfig& /*config*/,
                                                     const MotionState& /*from*/) const noexcept {
    return std::nullopt;
  }
  /// True if the axis is in the state synchronized_motion during the movement, not discrete_motion.
  [[nodiscard]] virtual bool synchronized() const noexcept { return course_ == Course::live; }

  /// For a path: its available length, s of path time; infinite if it repeats.
  [[nodiscard]] virtual double known() const noexcept { return 0; }
  /// For a path: its greatest magnitudes. For a live movement: the greatest magnitudes by which the
  /// slave, if it engaged at this moment, would exceed the motion that it gets from its master.
  [[nodiscard]] virtual Peaks peaks() const noexcept { return {}; }
  /// For a path: the sign of its first motion, -1 or 1; 0: no motion, or unknown.
  [[nodiscard]] virtual int direction() const noexcept { return 0; }
  /// For a path: true if more rows will arrive. The axis then begins to stop on the path, with the
  /// fault `underrun`, as soon as the available part is only just long enough for the stop.
  [[nodiscard]] virtual bool growing() const noexcept { return false; }
  /// For a path: true if its available part stays within the range that was checked at arming. If
  /// false, the axis checks before every setpoint that it can still stop within its limits.
  [[nodiscard]] virtual bool bounded() const noexcept { return true; }
  /// After begin() returned Cause::start_position or Cause::cutter_away: the required position of
  /// the axis, u; NaN: unknown.
  [[nodiscard]] virtual double place() const noexcept {
    return std::numeric_limits<double>::quiet_NaN();
  }
  /// For a gear: the velocity of the engaged slave divided by the velocity of the master, u/m; for
  /// any other movement 0.
  [[nodiscard]] virtual double ratio() const noexcept { return 0; }
  /// For a live movement: the greatest magnitudes that the slave needs at the moment `start`, after
  /// begin(), if its master keeps its velocity. The axis rejects a start that needs more than its
  /// limits. By default, the velocity of a gear that is engaged.
  [[nodiscard]] virtual Peaks demand(const Moment& start) const noexcept {
    return {.velocity = std::abs(ratio() * start.master[1])};
  }
  /// For a live movement that begins in step with its master: the first setpoint at `now`, after
  /// begin(). nullopt: the movement continues from the state of the axis. The axis rejects a start
  /// whose first setpoint would cause a fault.
  [[nodiscard]] virtual std::optional<MotionState> first_setpoint(
      const Moment& /*now*/) const noexcept {
    return std::nullopt;
  }
  /// For a live movement: the greatest magnitudes of the first three derivatives of the slave with
  /// respect to its master, u/m, u/m^2, u/m^3, which limit a phase shift (phase_player.hpp).
  [[nodiscard]] virtual std::array<double, 3> slopes() const noexcept {
    return {std::abs(ratio()), 0, 0};
  }
  /// For a live movement: true if the axis keeps its velocity when the movement ends; false if it
  /// comes to rest.
  [[nodiscard]] virtual bool keeps_velocity() const noexcept { return false; }
  /// For a live movement: true if it plays a table in passes (a pass is one run of a table).
  [[nodiscard]] virtual bool passes() const noexcept { return false; }
  /// For a live movement: the instant, after the previous moment and up to `now`, at which a pass
  /// ends; nullopt if no pass ends.
  [[nodiscard]] virtual std::optional<Moment> pass_end(const Moment& /*now*/) const noexcept {
    return std::nullopt;
  }
  /// For follow tables: the events between the last at() and the at() before it. Their `t` is the
  /// time of the movement. A cam reports its passes by pass_end().
  [[nodiscard]] virtual std::span<const ProfileEvent> events() const noexcept { return {}; }
  /// For a plan of cuts: the plan; otherwise null.
  [[nodiscard]] virtual LiveCuts* cuts() noexcept { return nullptr; }
  /// For a path: the length of one run of its table (a pass), s of path time; 0 for a stream of
  /// rows.
  [[nodiscard]] virtual double pass() const noexcept { return 0; }
  /// For the path of a group: the setpoints of its axes at the last at(), or at its start, at the
  /// original speed. Empty for any other movement.
  [[nodiscard]] virtual std::span<const Jet> parts() const noexcept { return {}; }
  /// For the path of a group: the outputs that it switches from the path time `from` to before
  /// `to`, s, in ascending order of time; up to its end, if `to` is its end or later.
  [[nodiscard]] virtual std::span<const PathSwitch> switches(double /*from*/,
                                                             double /*to*/) const noexcept {
    return {};
  }
  /// For the path of a group: its place at a path time, s.
  [[nodiscard]] virtual PathPlace along(double /*time*/) const noexcept { return {}; }
  /// For the path of a group: the greatest rate, from 1 to 2, that its axes permit.
  [[nodiscard]] virtual double highest_rate() const noexcept { return 2; }
  /// For the path of a group: the greatest slope of the rate, 1/s, that its axes permit for rates
  /// up to `highest` (rate_slope() in path_clock.hpp).
  [[nodiscard]] virtual double rate_slope(double /*highest*/) const noexcept {
    return std::numeric_limits<double>::infinity();
  }
  /// For a path: the state at the end of a pass, where another path can take over; nullopt if no
  /// other path can take over.
  [[nodiscard]] virtual std::optional<MotionState> end() const noexcept { return std::nullopt; }

 private:
  std::uint64_t id_;
  Course course_;
};

}  // namespace jounce
