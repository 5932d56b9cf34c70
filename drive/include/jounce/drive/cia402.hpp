// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/profiles/error.hpp"

namespace jounce {

/// CiA 402 (IEC 61800-7-201 and -301) in the mode cyclic synchronous position, as functions of
/// process data. These functions are the part of a bus adapter that is between an axis and its
/// drive; they do not depend on the bus.
///
///     const Cia402Status s = *status_of(inputs.statusword);
///     outputs.controlword = controlword(s.state, {.operate = true});     // one step nearer
///     outputs.target_position = *counts.of(position);                    // 0x607A

/// The states of the drive's state machine (CiA 402).
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
inline constexpr int cia402_states = 8;  ///< number of states

/// Returns the name of a state: "operation enabled", ...
const char* name(Cia402State state);

/// Content of the statusword, object 0x6041.
struct Cia402Status {
  Cia402State state = Cia402State::not_ready_to_switch_on;  ///< state of the drive
  bool internal_limit = false;   ///< bit 11: a limit inside the drive is active
  bool follows = false;          ///< bit 12: the drive follows the target position
  bool following_error = false;  ///< bit 13: the following error exceeds the drive's own window
};

/// Returns the content of a statusword; nullopt if its bits do not correspond to a state.
std::optional<Cia402Status> status_of(std::uint16_t statusword);
/// Returns the statusword with this content. Its other bits show a drive that has its supply
/// voltage and permits remote control.
std::uint16_t statusword(const Cia402Status& status);

/// Request of the controller to the drive.
struct Cia402Wish {
  bool operate = false;    ///< true: to operation enabled; false: stop, then power off
  bool hold_back = false;  ///< true: do not go from `switched on` to `operation enabled`
  bool reset = false;      ///< true: reset the fault (rising edge of the bit)
  bool standing = false;   ///< true: the axis is at rest, so a quick stop may end
};

/// Returns the controlword, object 0x6040, that brings the drive from this state one transition
/// nearer to the request. To leave the state operation enabled, the drive stops by its quick stop
/// (transition 11); at rest, its power is switched off.
std::uint16_t controlword(Cia402State state, const Cia402Wish& wish);

/// Events inside a drive. Numbers are the transitions of CiA 402.
struct Cia402Events {
  bool initialised = false;    ///< the self-test has passed (1)
  bool fault = false;          ///< a fault has occurred (13)
  bool reaction_done = false;  ///< the reaction to the fault is complete (14)
  bool stopped = false;        ///< the quick stop has come to rest (12)
};

/// Returns the state of a drive after a controlword: steps the state machine of the drive. `before`
/// is the previous controlword. The transitions are 0 to 15 of the standard. Transition 16, from
/// quick stop back to operation, is omitted, as the standard recommends.
Cia402State next(Cia402State state, std::uint16_t controlword, std::uint16_t before,
                 const Cia402Events& events);

/// Converts between positions in u, the unit of the axis, and the increments of a drive. Increments
/// are integers, and wrap at 32 bits.
class Increments {
 public:
  /// Sets the scale: one turn has `per_rev` increments and `position_per_rev` u. If `reversed` is
  /// true, the drive counts in the opposite direction. Throws InputError unless both numbers are >
  /// 0 and `per_rev` is an integer below 2^31.
  Increments(double per_rev, double position_per_rev, bool reversed = false);

  /// Returns the nearest integer number of increments; ties are rounded away from 0. The exact
  /// quotient is rounded once. Returns nullopt if the magnitude of the number is 2^52 or more, or
  /// if the position is NaN.
  [[nodiscard]] std::optional<std::int64_t> of(double position) const noexcept;
  /// Returns the position of this number of increments, u.
  [[nodiscard]] double position(double increments) const noexcept {
    return increments * position_per_rev_ / per_rev_;
  }

  /// Returns the value for object 0x607A: the low 32 bits.
  static std::int32_t wrapped(std::int64_t increments) noexcept {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(increments));
  }
  /// Returns the integer nearest to `near` that has these low 32 bits.
  static std::int64_t unwrapped(std::int32_t low, std::int64_t near) noexcept;

 private:
  double per_rev_;  // negative: reversed
  double position_per_rev_;
};

}  // namespace jounce
