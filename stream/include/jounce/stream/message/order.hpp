// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>

/// A command to an axis other than playing tables: the function blocks of PLCopen as one message.
///
///     constexpr auto kind = OrderKind::move_absolute;
///     Order{.kind = kind, .value = values(kind, {120, 200})};   // to 120 mm at 200 mm/s
///
/// The kind defines the meaning of each `value`; unused values are 0. u: the unit of the axis's
/// position, m: that of its master. A velocity, acceleration, deceleration or jerk is greater than
/// 0; NaN: the axis uses its configured limit. The velocity of move_velocity has a sign, and 0 is
/// rest.
namespace jounce::wire {

/// The values are in brackets, in their order.
enum class OrderKind : std::int8_t {
  enable = 0,          ///< []
  disable = 1,         ///< []
  reset = 2,           ///< [] clears a fault
  set_position = 3,    ///< [position u, 1: relative] without motion
  home = 4,            ///< [offset u, method of CiA 402, search velocity, index velocity,
                       ///< acceleration, timeout s, distance u]; method 0, NaN: as configured
  hold = 5,            ///< [] to rest on the path
  resume = 6,          ///< [] continues the motion
  override_ = 7,       ///< [velocity factor 0...2]
  move_absolute = 8,   ///< [position u, velocity, acceleration, deceleration, jerk, direction,
                       ///< buffer mode]
  move_relative = 9,   ///< [distance u, velocity, acceleration, deceleration, jerk, buffer mode]
  move_additive = 10,  ///< [distance u, velocity, acceleration, deceleration, jerk]
  move_superimposed = 11,  ///< [distance u, velocity difference, acceleration, deceleration, jerk]
  move_velocity = 12,  ///< [velocity u/s, signed; acceleration, deceleration, jerk, buffer mode,
                       ///< 1: hold to run]
  halt = 13,           ///< [deceleration, jerk]
  gear_in = 14,        ///< [numerator, denominator, acceleration, deceleration, jerk]
  gear_in_pos = 15,    ///< [numerator, denominator, master sync position m, slave sync position
                       ///< u, master start distance m, 1: avoid reversal]
  gear_out = 16,       ///< []
  cam_out = 17,        ///< []
  queue_switch = 18,   ///< [queue, bank] the other bank continues at the end of this one
  queue_clear = 19,    ///< [queue, bank, seq from which its messages count again]
  queue_end = 20,      ///< [queue] no more rows will come: the last one ends the stream
  start = 21,          ///< [] plays the axis's own table from its beginning
};
inline constexpr int order_kinds = 22;

struct Order {
  std::int32_t command = 0;  ///< see Arm
  OrderKind kind = OrderKind::enable;
  std::int64_t at = -1;  ///< tick; -1: the next one
  std::array<double, 8> value{};
};

/// "enable", "move_absolute", "override", ...
const char* name(OrderKind kind);

/// Number of used values.
std::size_t arity(OrderKind kind);

/// The values of an order of this kind. Omitted values at the end get their defaults: NaN for a
/// velocity, acceleration, deceleration, jerk, or a time or distance of home; otherwise 0.
std::array<double, 8> values(OrderKind kind, std::initializer_list<double> given);

/// Error of an order, as a sentence that names the value; empty: none. Rules: every value is
/// finite, magnitudes > 0 or NaN, home's offset any number or NaN, a flag is 0 or 1, a buffer mode
/// 0 to 5 (PLCopen: aborting, buffered, blending low, previous, next, high), a direction -1, 0 or
/// 1, an override 0 to 2, a denominator is not 0, both numbers of a ratio are integers, unused
/// values are 0.
std::string contradiction(const Order& order);

/// True if the motion runs only while its session sends heartbeats: a hold-to-run jog.
constexpr bool holds_to_run(OrderKind kind, const std::array<double, 8>& value) {
  return kind == OrderKind::move_velocity && value[5] == 1;
}

/// True if an operator may send it without owning the axis: it changes the timing of the motion,
/// not the motion.
constexpr bool is_operators(OrderKind kind) {
  return kind == OrderKind::hold || kind == OrderKind::resume || kind == OrderKind::override_;
}

}  // namespace jounce::wire
