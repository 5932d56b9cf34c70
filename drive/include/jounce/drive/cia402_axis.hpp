// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/drive/cia402.hpp"
#include "jounce/drive/drive.hpp"

namespace jounce {

/// Process data from the executor to a drive, of one cycle.
struct Cia402Outputs {
  std::uint16_t controlword = 0;     ///< 0x6040
  std::int8_t mode = 8;              ///< 0x6060: cyclic synchronous position
  std::int32_t target_position = 0;  ///< 0x607A, increments
};

/// Process data from the drive to the executor.
struct Cia402Inputs {
  std::uint16_t statusword = 0;      ///< 0x6041
  std::int8_t mode = 0;              ///< 0x6061
  std::int32_t position_actual = 0;  ///< 0x6064, increments
  std::int32_t velocity_actual = 0;  ///< 0x606C, increments/s
  std::int16_t torque_actual = 0;    ///< 0x6077, 1/1000 of the rated torque
};

struct Cia402Config {
  double increments_per_rev = 0;  ///< integer, > 0
  double position_per_rev = 0;    ///< u/rev, > 0
  bool reversed = false;          ///< the drive counts opposite to the axis
  /// u, >= 0: a drive does not switch to operation while its setpoint is further than this from its
  /// position; 0: a hundredth of a turn.
  double window = 0;
};

/// Connects an axis with a drive in cyclic synchronous position, as process data: a bus adapter
/// only transmits these.
///
///     Cia402Axis axis({.increments_per_rev = 131072, .position_per_rev = 10});
///     feedback = axis.feedback(inputs);                  // first
///     outputs = axis.command(setpoint, inputs);          // of the same cycle
///
/// The drive moves up and down through its states by one transition a cycle (controlword()). Until
/// it is in operation, its target is its present position, so that nothing jumps at the transition;
/// it waits in switched on while the setpoint is beyond the window. A setpoint that is NaN, or
/// beyond the range of increments, leaves the target unchanged.
///
/// ready: operation enabled, in mode 8, target followed (bit 12). fault: fault, or its reaction. A
/// reset holds bit 7 until the drive has left its fault, for at most `reset_cycles`.
///
/// The position is that of the drive's counter, unwrapped from its first value.
class Cia402Axis {
 public:
  static constexpr int reset_cycles = 100;

  /// Throws InputError like Increments, and for a bad window.
  explicit Cia402Axis(const Cia402Config& config);

  [[nodiscard]] Feedback feedback(const Cia402Inputs& inputs) noexcept;
  [[nodiscard]] Cia402Outputs command(const DriveSetpoint& setpoint,
                                      const Cia402Inputs& inputs) noexcept;

 private:
  Increments increments_;
  double window_;
  bool seen_ = false;
  std::int64_t actual_ = 0;  // increments
  std::int64_t target_ = 0;
  int resetting_ = 0;  // cycles left
};

}  // namespace jounce
