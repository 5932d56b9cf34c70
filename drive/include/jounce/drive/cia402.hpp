// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

namespace jounce {

/// CiA 402 (IEC 61800-7-201 and -301), cyclic synchronous position, as functions of process data: what
/// an adapter to a bus needs between an axis and its drive. It is independent of the bus.
///
///     const Cia402Status s = status_of(inputs.statusword);
///     outputs.controlword = controlword(s.state, {.operate = true});     // one step nearer
///     outputs.target_position = *counts.of(position);                    // 0x607A

/// The states of the drive's machine.
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
  bool internal_limit = false;   ///< bit 11: a limit inside the drive acts
  bool follows = false;          ///< bit 12: the target position is obeyed, not ignored
  bool following_error = false;  ///< bit 13: the drive's own window was left
};

/// Nothing for bits that belong to no state.
std::optional<Cia402Status> status_of(std::uint16_t statusword);
/// The statusword of this state, as a drive with voltage and a remote control sets it.
std::uint16_t statusword(const Cia402Status& status);

/// The request of the other side of the drive.
struct Cia402Wish {
  bool operate = false;    ///< operation enabled; otherwise: stopped, without voltage
  bool hold_back = false;  ///< not beyond switched on as yet
  bool reset = false;      ///< fault reset: its bit rises
  bool standing = false;   ///< it has stopped: quick stop may end
};

/// The controlword, 0x6040, that leads from a state one transition nearer to the wish. On the way down
/// an operating drive is stopped by its quick stop (transition 11) and loses its voltage when it stands.
std::uint16_t controlword(Cia402State state, const Cia402Wish& wish);

/// Events inside a drive.
struct Cia402Events {
  bool initialised = false;    ///< self-test passed (transition 1)
  bool fault = false;          ///< (13)
  bool reaction_done = false;  ///< (14)
  bool stopped = false;        ///< a quick stop has come to rest (12)
};

/// The drive's side: the state after one controlword, `before` being the one before it. Transitions 0 to
/// 15 of the standard; 16, from quick stop back to operation, is not made, as the standard advises.
Cia402State next(Cia402State state, std::uint16_t controlword, std::uint16_t before,
                 const Cia402Events& events);

/// Positions in u and in a drive's increments, which are whole, and wrap at 32 bits.
class Increments {
 public:
  /// `per_rev` increments and `position_per_rev` u make a turn; `reversed`: the drive counts the other
  /// way. Throws InputError unless both are > 0 and `per_rev` is whole and below 2^31.
  Increments(double per_rev, double position_per_rev, bool reversed = false);

  /// The nearest whole number of increments, ties away from 0: rounded once, from the exact quotient
  /// of the two numbers. Nothing where it is beyond 2^52, or the position is none.
  [[nodiscard]] std::optional<std::int64_t> of(double position) const noexcept;
  /// u
  [[nodiscard]] double position(double increments) const noexcept {
    return increments * position_per_rev_ / per_rev_;
  }

  /// The value of 0x607A: the low 32 bits.
  static std::int32_t wrapped(std::int64_t increments) noexcept {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(increments));
  }
  /// The whole number nearest to `near` whose low 32 bits these are.
  static std::int64_t unwrapped(std::int32_t low, std::int64_t near) noexcept;

 private:
  double per_rev_;  // negative: reversed
  double position_per_rev_;
};

}  // namespace jounce
