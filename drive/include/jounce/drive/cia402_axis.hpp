// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "jounce/drive/cia402.hpp"
#include "jounce/drive/drive.hpp"

namespace jounce {

/// Process data of one cycle from the executor to a drive.
struct Cia402Outputs {
  std::uint16_t controlword = 0;     ///< 0x6040
  std::int8_t mode = 8;              ///< 0x6060; 8: cyclic synchronous position
  std::int32_t target_position = 0;  ///< 0x607A, increments
  std::uint16_t touch_probe = 0;     ///< 0x60B8, touch probe function
};

/// Number of captures in the process data: probe 1 rising and falling, probe 2 rising and falling.
inline constexpr int cia402_captures = 4;

/// Process data of one cycle from a drive to the executor.
struct Cia402Inputs {
  std::uint16_t statusword = 0;          ///< 0x6041
  std::int8_t mode = 0;                  ///< 0x6061
  std::int32_t position_actual = 0;      ///< 0x6064, increments
  std::int32_t velocity_actual = 0;      ///< 0x606C, increments/s
  std::int16_t torque_actual = 0;        ///< 0x6077, 1/1000 of the rated torque
  std::uint16_t touch_probe_status = 0;  ///< 0x60B9
  /// 0x60BA to 0x60BD: positions that the drive has latched, increments.
  std::array<std::int32_t, cia402_captures> touch_probe_position{};
  /// 0x60D5 to 0x60D8: numbers of captures so far; 0 in a drive that does not count them.
  std::array<std::uint16_t, cia402_captures> touch_probe_count{};
};

/// Scaling of a drive and its window for the transition to operation. u is the unit of the axis.
struct Cia402Config {
  double increments_per_rev = 0;  ///< increments in one turn of the motor, an integer > 0
  double position_per_rev = 0;    ///< travel of the axis in one turn of the motor, u, > 0
  bool reversed = false;          ///< true if the drive counts in the opposite direction
  /// Window around the drive's position, u, >= 0; 0: a hundredth of a turn. While the setpoint is
  /// outside the window, the drive does not go to operation enabled.
  double window = 0;
  /// Number of touch probe inputs of the drive, 0 to 2. They are the trigger inputs 1 and 2 of the
  /// axis.
  int touch_probes = 0;
};

/// Connects an axis to a drive in the mode cyclic synchronous position, by means of process data. A
/// bus adapter only has to transmit these data.
///
///     Cia402Axis axis({.increments_per_rev = 131072, .position_per_rev = 10});
///     feedback = axis.feedback(inputs);                  // first
///     outputs = axis.command(setpoint, inputs);          // of the same cycle
///
/// **States.** In each cycle, the drive makes at most one transition towards the request
/// (controlword()). Before the drive is in operation enabled, its target is its present position,
/// so that it does not jump at the transition. While the setpoint is outside the window, the drive
/// waits in the state switched on. If the setpoint is NaN, or exceeds the range of increments, the
/// target stays unchanged.
///
/// **Feedback.** `ready` means that the drive is in operation enabled, in mode 8, and follows the
/// target (bit 12). `fault` means that the drive is in a fault or in its reaction to a fault. The
/// position is the drive's counter, extended beyond 32 bits from its first value on.
///
/// **Touch probes.** Both edges of all probes are active all the time, in continuous mode. A
/// capture is new if its counter has changed, or if its bit in 0x60B9 has become 1. The capture has
/// the latched position and no time stamp. Without counters, a drive reports each edge once until
/// its bit is 0 again.
///
/// **Reset.** A reset has an effect only if the drive is in the state fault. Bit 7 then stays set
/// until the drive has left this state, but for at most `reset_cycles` cycles.
class Cia402Axis {
 public:
  static constexpr int reset_cycles = 100;  ///< greatest duration of a reset, cycles

  /// Throws InputError like Increments, and for an invalid window or number of touch probes.
  explicit Cia402Axis(const Cia402Config& config);

  /// Returns the feedback of this cycle from the inputs. Call before command(), once in each cycle.
  [[nodiscard]] Feedback feedback(const Cia402Inputs& inputs) noexcept;
  /// Returns the outputs of this cycle for a setpoint. Call once in each cycle.
  [[nodiscard]] Cia402Outputs command(const DriveSetpoint& setpoint,
                                      const Cia402Inputs& inputs) noexcept;

 private:
  void see_probes(const Cia402Inputs& inputs, Triggers& triggers) noexcept;

  Increments increments_;
  double window_;
  int probes_;
  std::uint16_t probe_status_ = 0;  // 0x60B9 in the previous cycle
  std::array<std::uint16_t, cia402_captures> probe_count_{};
  std::uint8_t probe_on_ = 0;  // states of the inputs, after their last edges
  bool seen_ = false;
  std::int64_t actual_ = 0;  // increments
  std::int64_t target_ = 0;
  int resetting_ = 0;  // cycles left
};

}  // namespace jounce
