#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "jounce/cam/cam_switches.hpp"
#include "jounce/executor/axis_config.hpp"
#include "jounce/executor/command.hpp"
#include "jounce/executor/inputs.hpp"

namespace jounce {

/// The PLCopen states (PMC600 manual 4.1, nAxisState). The numbers are part of the wire format.
enum class State : std::uint8_t {
  disabled = 0,
  standstill = 1,
  discrete_motion = 2,      ///< a table over time, or a move to a target
  synchronized_motion = 3,  ///< follows a master
  stopping = 4,             ///< on its way to rest; nothing but a fault ends that
  error_stop = 5,           ///< at rest, or on its way there, until a reset
  continuous_motion = 6,    ///< at a velocity, until the next command
  homing = 7,               ///< for the one step in which `home` sets the position
};
inline constexpr std::size_t states = 8;
const char* name(State state);

/// All that an axis says in one tick.
struct Tick {
  std::int64_t tick = 0;
  double time = 0;  ///< tick * period, s
  State state = State::disabled;
  double master = 0;                   ///< m
  double master_velocity = 0;          ///< m/s
  double position = 0;                 ///< commanded, u
  double velocity = 0;                 ///< u/s
  double acceleration = 0;             ///< u/s^2
  std::uint64_t job = 0;               ///< the one that is played, 0: none
  std::uint64_t armed = 0;             ///< the one that waits for its start, 0: none
  bool waiting = false;                ///< a start was accepted for later
  Progress progress = Progress::done;  ///< of what is played
  Cause fault = Cause::none;           ///< latched
  std::int64_t skipped = 0;            ///< ticks left out since the one before
  std::uint64_t finished = 0;          ///< motions so far that reached their end
  std::uint64_t stopped = 0;           ///< motions so far that a stop brought to rest
  Cause reason = Cause::none;  ///< why the last motion ended: its fault, stopped, halted, ...
  double override_ = 1;        ///< factor that the axis was granted
  double rate = 1;             ///< of path time now
  bool power = false;          ///< the drive shall follow setpoints
  double offset = 0;           ///< u; set_position so far: the drive's position = position - offset
  double actual_position = std::numeric_limits<double>::quiet_NaN();  ///< u; NaN: not known
  double following_error = std::numeric_limits<double>::quiet_NaN();  ///< u: set - actual
  double torque = std::numeric_limits<double>::quiet_NaN();           ///< share of the rated one
  bool in_position = false;  ///< at rest, and the drive within the window for its time
  SwitchStep switches{};     ///< outputs of the cam switches, and their edges since the tick before

  std::optional<Refusal> refused{};              ///< why this tick's command was not obeyed
  std::array<const Movement*, 3> handed_back{};  ///< no longer needed by the axis
};

/// An axis as a pure state machine, stepped by ticks. It has no clock, and step() neither
/// allocates nor frees, locks, logs nor throws.
///
///     MotionAxis axis({.limits = {.velocity = 1000, .acceleration = 1e4}});
///     axis.step(0, {.kind = Command::Kind::enable});
///     axis.step(1, {.kind = Command::Kind::arm, .movement = &job});
///     axis.step(2, {.kind = Command::Kind::start});      // local time 0: the table's first point
///     Tick now = axis.step(3);                           // bit for bit job.at(0.001)
///
/// **Time** is the tick's number times the period: nothing accumulates. Ticks ascend; one that is
/// left out is left out of the motion too, which follows time.
///
/// **Slots.** One job is played, one is armed. An axis owns neither: each is handed back once, in
/// the tick after which the axis no longer looks at it.
///
/// **Cam switches** are stepped with what each tick says. A new position, or a new master when a
/// job starts, is a new place: outputs may change there, but nothing was passed. They work in every
/// state, also disabled and in a fault.
///
/// **Safety.** Arming admits the job against the limits, whatever its sender did. In motion, every
/// setpoint is compared with the velocity and position limits before it is given out. A fault
/// freezes the setpoint at its last value and stays until a reset: see Cause and docs/executor.md.
class MotionAxis {
 public:
  /// Throws InputError for a bad configuration, or bad switches.
  explicit MotionAxis(const AxisConfig& config, const AxisSwitches& switches = {});

  /// The point of this tick, after its command. `tick` must be greater than in the step before.
  Tick step(std::int64_t tick, const Command& command = {}, const Inputs& inputs = {});

  [[nodiscard]] const AxisConfig& config() const { return config_; }
  [[nodiscard]] State state() const { return state_; }

 private:
  void obey(const Command& command);
  bool ready();
  void arm(Movement* movement);
  void disarm();
  void start(std::int64_t at);
  void start_pending();
  void stop();
  void set_position(double position);

  void play();
  void slow_down(double t);
  void move_to(const Setpoint& point);
  void rest();
  void operate_switches();
  void fail(Cause cause);

  void hand_back(const Movement* movement);
  void refuse(Cause cause, double value = 0, double limit = 0);
  [[nodiscard]] bool moving() const;
  [[nodiscard]] double seconds(std::int64_t ticks) const;

  AxisConfig config_;
  State state_ = State::disabled;
  std::int64_t last_tick_ = -1;
  Movement* active_ = nullptr;
  Movement* pending_ = nullptr;
  std::int64_t start_at_ = -1;  // of the pending job; -1: no start was accepted
  std::int64_t origin_ = 0;     // tick of local time 0, or of the stop
  double stop_from_ = 0;        // local time at the stop, s
  double stop_length_ = 0;      // s
  bool has_switches_;
  bool has_master_ = false;  // since a cam was started; until the next table without one
  SwitchesOf switches_of_;
  CamSwitches switches_;
  Tick now_;
};

}  // namespace jounce
