#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "jounce/cam/cam_switches.hpp"
#include "jounce/executor/job.hpp"

namespace jounce {

/// The PLCopen states that an axis which plays tables needs (PMC600 manual 4.1, nAxisState).
enum class State : std::uint8_t {
  disabled,
  standstill,
  discrete_motion,      ///< plays a table over time
  synchronized_motion,  ///< follows a cam over a virtual master
  stopping,             ///< slows down on the table's path
  error_stop,           ///< the setpoint is frozen until a reset
};
const char* name(State state);

/// What an axis is told. At most one command a tick.
struct Command {
  enum class Kind : std::uint8_t {
    none,
    enable,
    disable,
    arm,           ///< `job` becomes the one to be started; it replaces one that waits
    disarm,        ///< takes it back, unless its start was accepted
    start,         ///< what is armed, at tick `at`; -1: in the step that gets the command
    stop,          ///< on the path; disarms
    abort,         ///< freezes the setpoint: a fault
    reset,         ///< clears a fault
    set_position,  ///< the axis stands at `position` from now on; nothing moves
  };
  Kind kind = Kind::none;
  std::uint64_t id = 0;      ///< the sender's, handed back with the answer
  const Job* job = nullptr;  ///< must live until it is handed back
  std::int64_t at = -1;      ///< tick
  double position = 0;       ///< u
};

/// All that an axis says in one tick.
struct Tick {
  std::int64_t tick = 0;
  double time = 0;  ///< tick * period, s
  State state = State::disabled;
  double master = 0;           ///< m
  double master_velocity = 0;  ///< m/s
  double position = 0;         ///< commanded, u
  double velocity = 0;         ///< u/s
  double acceleration = 0;     ///< u/s^2
  std::uint64_t job = 0;       ///< the one that is played, 0: none
  std::uint64_t armed = 0;     ///< the one that waits for its start, 0: none
  bool waiting = false;        ///< a start was accepted for a later tick
  Cause fault = Cause::none;   ///< latched
  std::int64_t skipped = 0;    ///< ticks left out since the one before
  std::uint64_t finished = 0;  ///< motions so far that reached their end
  std::uint64_t stopped = 0;   ///< motions so far that a stop brought to rest
  SwitchStep switches{};  ///< outputs of the cam switches, and their edges since the tick before

  std::optional<Refusal> refused{};         ///< why this tick's command was not obeyed
  std::array<const Job*, 3> handed_back{};  ///< no longer needed by the axis
};

/// An axis as a pure state machine, stepped by ticks. It has no clock, and step() neither
/// allocates nor frees, locks, logs nor throws.
///
///     MotionAxis axis({.limits = {.velocity = 1000, .acceleration = 1e4}});
///     axis.step(0, {.kind = Command::Kind::enable});
///     axis.step(1, {.kind = Command::Kind::arm, .job = &job});
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
  Tick step(std::int64_t tick, const Command& command = {});

  [[nodiscard]] const AxisConfig& config() const { return config_; }
  [[nodiscard]] State state() const { return state_; }

 private:
  void obey(const Command& command);
  bool ready();
  void arm(const Job* job);
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

  void hand_back(const Job* job);
  void refuse(Cause cause, double value = 0, double limit = 0);
  [[nodiscard]] bool moving() const;
  [[nodiscard]] double seconds(std::int64_t ticks) const;

  AxisConfig config_;
  State state_ = State::disabled;
  std::int64_t last_tick_ = -1;
  const Job* active_ = nullptr;
  const Job* pending_ = nullptr;
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
