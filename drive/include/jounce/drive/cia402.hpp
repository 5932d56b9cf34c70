// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

namespace jounce {

/// CiA 402 (IEC 61800-7-201 and -301), cyclic synchronous position, as functions of process data:
/// the part of a bus adapter between an axis and its drive. It is independent of the bus.
///
///     const Cia402Status s = status_of(inputs.statusword);
///     outputs.controlword = controlword(s.state, {.operate = true});     // one step nearer
///     outputs.target_position = *counts.of(position);                    // 0x607A

/// The states of the drive's state machine.
enum class Cia402State : std::uint8_t {
  not_ready_to_switch_on,
  switch_on_disabled,
  ready_to_switch_on,
  switched_on,
  operation_enabled,
  quick_stop_active,
  fault_reaction_active,
  fault,
};
inline constexpr int cia402_states = 8;

/// "operation enabled", ...
const char* name(Cia402State state);

/// The state in the statusword, 0x6041.
struct Cia402Status {
  Cia402State state = Cia402State::not_ready_to_switch_on;
  bool internal_limit = false;   ///< bit 11: a limit inside the drive is active
  bool follows = false;          ///< bit 12: the drive follows the target position
  bool following_error = false;  ///< bit 13: following error beyond the drive's own window
};

/// Returns nullopt for bits that belong to no state.
std::optional<Cia402Status> status_of(std::uint16_t statusword);
/// Returns the statusword of this state, as set by a drive with voltage and remote control.
std::uint16_t statusword(const Cia402Status& status);

/// The request of the controller to the drive.
struct Cia402Wish {
  bool operate = false;    ///< operation enabled; otherwise: stopped, without voltage
  bool hold_back = false;  ///< not yet beyond switched on
  bool reset = false;      ///< fault reset: rising edge of its bit
  bool standing = false;   ///< it is at rest: quick stop may end
};

/// Returns the controlword, 0x6040, that leads from a state one transition nearer to the request.
/// On the way down, an operating drive stops by its quick stop (transition 11) and loses its
/// voltage at rest.
std::uint16_t controlword(Cia402State state, const Cia402Wish& wish);

/// Events inside a drive.
struct Cia402Events {
  bool initialised = false;    ///< self-test passed (transition 1)
  bool fault = false;          ///< (13)
  bool reaction_done = false;  ///< (14)
  bool stopped = false;        ///< a quick stop has come to rest (12)
};

/// The drive's side: returns the state after one controlword; `before` is the previous one.
/// Transitions 0 to 15 of the standard; it omits 16, from quick stop back to operation, as the
/// standard recommends.
Cia402State next(Cia402State state, std::uint16_t controlword, std::uint16_t before,
                 const Cia402Events& events);

/// Conversion between positions in u and a drive's increments, which are integers and wrap at 32
/// bits.
class Increments {
 public:
  /// `per_rev` increments and `position_per_rev` u make a turn; `reversed`: the drive counts in the
  /// opposite direction. Throws InputError unless both are > 0 and `per_rev` is an integer below
  /// 2^31.
  Increments(double per_rev, double position_per_rev, bool reversed = false);

  /// Returns the nearest integer number of increments, ties away from 0: rounded once, from the
  /// exact quotient of the two numbers. Returns nullopt if it is beyond 2^52, or if the position is
  /// NaN.
  [[nodiscard]] std::optional<std::int64_t> of(double position) const noexcept;
  /// Position in u.
  [[nodiscard]] double position(double increments) const noexcept {
    return increments * position_per_rev_ / per_rev_;
  }

  /// The value of 0x607A: the low 32 bits.
  static std::int32_t wrapped(std::int64_t increments) noexcept {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(increments));
  }
  /// Returns the integer nearest to `near` with these low 32 bits.
  static std::int64_t unwrapped(std::int32_t low, std::int64_t near) noexcept;

 private:
  double per_rev_;  // negative: reversed
  double position_per_rev_;
};

}  // namespace jounce
