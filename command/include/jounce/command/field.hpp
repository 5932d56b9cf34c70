// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace jounce {

/// Quantity of a field, for its unit: u of the axis, m of its master.
enum class Quantity : std::uint8_t {
  none,
  position,      ///< u
  velocity,      ///< u/s
  acceleration,  ///< u/s^2
  jerk,          ///< u/s^3
  master,        ///< m
  time,          ///< s
};

/// FieldRange of a field. rule_of() has the words.
enum class FieldRange : std::uint8_t {
  finite,         ///< any finite number
  given,          ///< the same, or NaN: as configured
  positive,       ///< > 0, or NaN: as configured
  flag,           ///< 0 or 1
  direction,      ///< -1, 0 or 1
  factor,         ///< 0 to 2
  buffer_mode,    ///< 0 to 5
  whole,          ///< a whole number of 31 bits and a sign
  whole_nonzero,  ///< the same, not 0
  count,          ///< a whole number of 31 bits, 0 or more
};

/// A field of a command.
struct Field {
  const char* name = "";  ///< "search velocity"
  Quantity quantity = Quantity::none;
  FieldRange range = FieldRange::finite;
  const char* option = "";  ///< option of `jounce order`, without dashes; "VALUE"
  const char* help = "";    ///< help of that option
};

inline constexpr std::size_t most_fields = 8;  ///< number of fields, at most

/// The fields of a command, in the order of the wire.
struct Fields {
  std::array<Field, most_fields> field{};
  std::size_t count = 0;

  [[nodiscard]] constexpr std::size_t size() const { return count; }
  [[nodiscard]] constexpr const Field* begin() const { return field.data(); }
  [[nodiscard]] constexpr const Field* end() const { return field.data() + count; }
  constexpr const Field& operator[](std::size_t i) const { return field[i]; }
};

}  // namespace jounce

/// Fields that several commands have.
namespace jounce::command {

inline constexpr Field velocity{"velocity", Quantity::velocity, FieldRange::positive, "velocity",
                                "Greatest velocity of the move; default, also of the next three "
                                "options: the limit of the axis"};
inline constexpr Field acceleration{"acceleration", Quantity::acceleration, FieldRange::positive,
                                    "acceleration", "Acceleration"};
inline constexpr Field deceleration{"deceleration", Quantity::acceleration, FieldRange::positive,
                                    "deceleration", "Deceleration"};
inline constexpr Field jerk{"jerk", Quantity::jerk, FieldRange::positive, "jerk", "Jerk"};
inline constexpr Field buffer_mode{
    "buffer mode", Quantity::none, FieldRange::buffer_mode, "blend",
    "move --to, --by and jog: pass the target of the present move without a stop, at the velocity "
    "of: low (the lower one), previous (that move), next (this move), high (the higher one)"};
inline constexpr Field numerator{"numerator", Quantity::none, FieldRange::whole, "VALUE"};
inline constexpr Field denominator{"denominator", Quantity::none, FieldRange::whole_nonzero,
                                   "VALUE"};
inline constexpr Field queue{"queue", Quantity::none, FieldRange::count};
inline constexpr Field bank{"bank", Quantity::none, FieldRange::flag};

}  // namespace jounce::command
