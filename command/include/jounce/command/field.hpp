// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace jounce {

/// Physical quantity of a field, which determines its unit: u is the unit of the axis, m the unit
/// of its master.
enum class Quantity : std::uint8_t {
  none,                 ///< a plain number
  position,             ///< u
  velocity,             ///< u/s
  acceleration,         ///< u/s^2
  jerk,                 ///< u/s^3
  master,               ///< m
  time,                 ///< s
  master_velocity,      ///< m/s
  master_acceleration,  ///< m/s^2
  master_jerk,          ///< m/s^3
};

/// Permitted values of a field. words() in command_values.hpp returns a description of each range.
enum class FieldRange : std::uint8_t {
  finite,         ///< any finite number
  given,          ///< any finite number; NaN: as configured
  coordinate,     ///< any finite number; NaN: not given
  positive,       ///< > 0; NaN: as configured
  flag,           ///< 0 or 1
  direction,      ///< -1, 0 or 1
  factor,         ///< 0 to 2
  buffer_mode,    ///< 0 to 5
  path_buffer,    ///< 0 to 6
  whole,          ///< a whole number from -2147483647 to 2147483647
  whole_nonzero,  ///< like whole, but not 0
  count,          ///< a whole number from 0 to 2147483647
  trigger_input,  ///< 1 to 6
  trigger_edge,   ///< 0 to 2
  not_negative,   ///< 0 or more
  share,          ///< > 0, at most 1
};

/// One field of a command.
struct Field {
  const char* name = "";                  ///< name in messages: "search velocity"
  Quantity quantity = Quantity::none;     ///< physical quantity
  FieldRange range = FieldRange::finite;  ///< permitted values
  /// Option of `jounce order` without dashes, or "VALUE" for its argument; "": none.
  const char* option = "";
  const char* help = "";  ///< help text of that option
};

inline constexpr std::size_t most_fields = 24;  ///< greatest number of fields of a command

/// The fields of a command, in the order of the wire. Behaves as a range.
struct Fields {
  std::array<Field, most_fields> field{};  ///< the fields, then empty ones
  std::size_t count = 0;                   ///< number of fields

  [[nodiscard]] constexpr std::size_t size() const { return count; }
  [[nodiscard]] constexpr const Field* begin() const { return field.data(); }
  [[nodiscard]] constexpr const Field* end() const { return field.data() + count; }
  constexpr const Field& operator[](std::size_t i) const { return field[i]; }
};

}  // namespace jounce

/// Fields that several commands have in common.
namespace jounce::command {

inline constexpr Field velocity{"velocity", Quantity::velocity, FieldRange::positive, "velocity",
                                "Greatest velocity of the move. This option and the next three "
                                "default to the limits of the axis"};
inline constexpr Field acceleration{"acceleration", Quantity::acceleration, FieldRange::positive,
                                    "acceleration", "Acceleration"};
inline constexpr Field deceleration{"deceleration", Quantity::acceleration, FieldRange::positive,
                                    "deceleration", "Deceleration"};
inline constexpr Field jerk{"jerk", Quantity::jerk, FieldRange::positive, "jerk", "Jerk"};
inline constexpr Field buffer_mode{
    "buffer mode", Quantity::none, FieldRange::buffer_mode, "blend",
    "move --to, --by, jog, and moves of a group: pass the target of the present move without a "
    "stop, at the velocity of low (the slower of the two moves), previous (the present move), next "
    "(this move) or high (the faster of the two moves); look-ahead (group: the highest velocity "
    "within the limits)"};
inline constexpr Field hold_to_run{
    "hold to run", Quantity::none, FieldRange::flag, "hold-to-run",
    "jog: move only while this command runs. The axis stops when the command ends, or sends no "
    "heartbeat for 0.2 s"};
inline constexpr Field numerator{"numerator", Quantity::none, FieldRange::whole, "VALUE"};
inline constexpr Field denominator{"denominator", Quantity::none, FieldRange::whole_nonzero,
                                   "VALUE"};
inline constexpr Field queue{"queue", Quantity::none, FieldRange::count};
inline constexpr Field bank{"bank", Quantity::none, FieldRange::flag};

}  // namespace jounce::command
