// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "jounce/command/cause.hpp"
#include "jounce/profiles/curve/jet.hpp"
#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

struct AxisConfig;

/// The commanded point at one instant.
struct Setpoint {
  double master = 0;           ///< m; 0 without a master
  double master_velocity = 0;  ///< m/s
  Jet slave{};                 ///< position and its derivatives by time: u, u/s, u/s^2, u/s^3
};

inline MotionState state_of(const Setpoint& setpoint) noexcept {
  return {setpoint.slave[0], setpoint.slave[1], setpoint.slave[2]};
}

/// One instant of the cycle; input of a movement.
struct Moment {
  double t = 0;     ///< s: the movement's own time, see Course
  double dt = 0;    ///< s since the previous step: more than a period if ticks were skipped
  Jet master = {};  ///< the axis's live master: m, m/s, ...; NaN: none, or lost
};

/// Independent variable of a movement; it determines how the axis holds, slows and stops it.
enum class Course : std::uint8_t {
  path,  ///< its own time: the axis slows that time, down to standstill, and the setpoint never
         ///< leaves the path. `t` is path time: bit for bit ticks * period at full speed
  live,  ///< a master in free motion: the axis leaves it by a move of its own from its present
         ///< state. `t` is the time since the movement began
};

/// Progress of a movement.
enum class Progress : std::uint8_t {
  waiting,   ///< for its master, or an event: the slave is at rest
  engaging,  ///< approaches its coupled position: ramp, clutch
  running,   ///< a path is played, a slave is in gear, in sync
  starving,  ///< buffer underrun: the available path ends; the axis stops
  done,      ///< it has ended; its last setpoint is at rest
  broken,    ///< it cannot continue: see cause(); it repeats its last setpoint
};

/// The greatest magnitudes of a path, u/s, u/s^2, u/s^3: input of the stop on it.
struct Peaks {
  double velocity = 0;
  double acceleration = 0;
  double jerk = 0;
  double velocity_step = 0;  ///< u/s, the largest sum of its steps within one tick; 0: smooth
};

/// A motion of an axis. It is constructed and checked outside the cyclic thread; the cyclic thread
/// steps it:
///
///     if (const Cause no = movement.begin(state, now); no != Cause::none) refuse(no);
///     while (movement.progress() < Progress::done) setpoint = movement.at(now);
///
/// begin() and at() do not allocate, free, lock, log or throw. Moments ascend.
class Movement {
 public:
  explicit Movement(std::uint64_t id, Course course) : id_(id), course_(course) {}
  virtual ~Movement() = default;
  Movement(const Movement&) = delete;
  Movement& operator=(const Movement&) = delete;

  [[nodiscard]] std::uint64_t id() const noexcept { return id_; }
  [[nodiscard]] Course course() const noexcept { return course_; }

  /// Begins the movement now, from the state `axis`. none: it begins, and at() returns its first
  /// point.
  virtual Cause begin(const MotionState& axis, const Moment& now) noexcept = 0;
  virtual Setpoint at(const Moment& now) noexcept = 0;

  [[nodiscard]] virtual Progress progress() const noexcept = 0;
  [[nodiscard]] virtual Cause cause() const noexcept { return Cause::none; }

  /// Sets the number of the last available row, for rows that arrive during play. The axis calls it
  /// at the beginning of every tick (Inputs::rows).
  virtual void see(std::uint64_t /*number*/) noexcept {}

  /// True if its positions are absolute, not relative to the position of the axis.
  [[nodiscard]] virtual bool absolute() const noexcept { return true; }

  /// Refusal of the movement for a start in the state `from`; checked when it is armed.
  [[nodiscard]] virtual std::optional<Refusal> admit(const AxisConfig& /*config*/,
                                                     const MotionState& /*from*/) const noexcept {
    return std::nullopt;
  }
  /// True if the axis is a slave: synchronized_motion, not discrete_motion.
  [[nodiscard]] virtual bool synchronized() const noexcept { return course_ == Course::live; }

  /// For a path: its available length in s of its own time; infinite if it repeats.
  [[nodiscard]] virtual double known() const noexcept { return 0; }
  /// For a path: its peaks. For a live movement: the greatest magnitudes that an engagement at this
  /// moment would add to the motion of its master.
  [[nodiscard]] virtual Peaks peaks() const noexcept { return {}; }
  /// For a path: the sign of its first motion; 0: no motion, or unknown.
  [[nodiscard]] virtual int direction() const noexcept { return 0; }
  /// For a path: true if more rows will arrive. The axis stops on it, with the fault `underrun`,
  /// before the available part is shorter than the stop. The result is the same as with `starving`,
  /// but the axis computes it.
  [[nodiscard]] virtual bool growing() const noexcept { return false; }
  /// For a path: true if its available part stays within the range of its admission. If false, the
  /// axis checks before every setpoint that it can still stop within its limits.
  [[nodiscard]] virtual bool bounded() const noexcept { return true; }
  /// u, the required position of the axis after begin() returned start_position; NaN: unknown.
  [[nodiscard]] virtual double place() const noexcept {
    return std::numeric_limits<double>::quiet_NaN();
  }
  /// For a live movement: true if the axis keeps the velocity at its end; otherwise the axis comes
  /// to rest.
  [[nodiscard]] virtual bool keeps_velocity() const noexcept { return false; }
  /// For a live movement: true if it has passes.
  [[nodiscard]] virtual bool passes() const noexcept { return false; }
  /// For a live movement: the instant, after its previous moment and up to `now`, at which a pass
  /// ends; nullopt if none ends.
  [[nodiscard]] virtual std::optional<Moment> pass_end(const Moment& /*now*/) const noexcept {
    return std::nullopt;
  }
  /// For a path: the length of a pass in s of its own time; 0 if it has no passes.
  [[nodiscard]] virtual double pass() const noexcept { return 0; }
  /// For a path: the state at the end of a pass, at which a swap takes place; nullopt if it has no
  /// passes.
  [[nodiscard]] virtual std::optional<MotionState> end() const noexcept { return std::nullopt; }

 private:
  std::uint64_t id_;
  Course course_;
};

}  // namespace jounce
