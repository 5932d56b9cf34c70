// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

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

/// Permitted values of a field.
struct FieldRange {
  double least = -std::numeric_limits<double>::infinity();  ///< least value
  double most = std::numeric_limits<double>::infinity();    ///< greatest value
  bool whole = false;                                       ///< true: whole numbers only
  bool not_zero = false;                                    ///< true: 0 is not permitted
  bool may_be_nan = false;  ///< true: NaN means that the sender does not give the value
  const char* words = "";   ///< the range in words: "0 or 1"; "": any finite number
};

/// Ranges that several fields have in common.
namespace ranges {

inline constexpr FieldRange finite{};
inline constexpr FieldRange nonzero{.not_zero = true};
inline constexpr FieldRange given{.may_be_nan = true, .words = "or NaN"};
inline constexpr FieldRange coordinate{.may_be_nan = true, .words = "NaN: not given"};
inline constexpr FieldRange positive{
    .least = 0, .not_zero = true, .may_be_nan = true, .words = "greater than 0"};
inline constexpr FieldRange not_negative{.least = 0, .words = "0 or more"};
inline constexpr FieldRange flag{.least = 0, .most = 1, .whole = true, .words = "0 or 1"};
inline constexpr FieldRange factor{.least = 0, .most = 2, .words = "0 to 2"};
inline constexpr FieldRange share{
    .least = 0, .most = 1, .not_zero = true, .words = "greater than 0 and at most 1"};
inline constexpr FieldRange direction{.least = -1, .most = 1, .whole = true, .words = "-1, 0 or 1"};
inline constexpr FieldRange whole{.least = -2147483647,
                                  .most = 2147483647,
                                  .whole = true,
                                  .words = "a whole number from -2147483647 to 2147483647"};
inline constexpr FieldRange whole_nonzero{.least = whole.least,
                                          .most = whole.most,
                                          .whole = true,
                                          .not_zero = true,
                                          .words = whole.words};
inline constexpr FieldRange count{
    .least = 0, .most = 2147483647, .whole = true, .words = "a whole number from 0 to 2147483647"};

}  // namespace ranges

/// One field of a command.
struct Field {
  const char* name = "";               ///< name in messages: "search velocity"
  Quantity quantity = Quantity::none;  ///< physical quantity
  FieldRange range = {};               ///< permitted values
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

inline constexpr Field velocity{"velocity", Quantity::velocity, ranges::positive};
inline constexpr Field acceleration{"acceleration", Quantity::acceleration, ranges::positive};
inline constexpr Field deceleration{"deceleration", Quantity::acceleration, ranges::positive};
inline constexpr Field jerk{"jerk", Quantity::jerk, ranges::positive};
inline constexpr Field buffer_mode{
    "buffer mode", Quantity::none, {.least = 0, .most = 5, .whole = true, .words = "0 to 5"}};
inline constexpr Field hold_to_run{"hold to run", Quantity::none, ranges::flag};
inline constexpr Field numerator{"numerator", Quantity::none, ranges::whole};
inline constexpr Field denominator{"denominator", Quantity::none, ranges::whole_nonzero};
inline constexpr Field queue{"queue", Quantity::none, ranges::count};
inline constexpr Field bank{"bank", Quantity::none, ranges::flag};

}  // namespace jounce::command
