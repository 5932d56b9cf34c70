// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "jounce/command/commands.hpp"

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

namespace command {

/// C is T, or const T.
template <class C, class T>
concept Of = std::same_as<std::remove_const_t<C>, T>;

inline constexpr Field velocity{
    "velocity", Quantity::velocity, FieldRange::positive, "velocity",
    "Greatest velocity of the move; default: the limit of the axis. The same holds for the next "
    "options"};
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

template <Of<RampDynamics> C, class F>
constexpr void each_field(C& c, F f) {
  f(acceleration, c.acceleration);
  f(deceleration, c.deceleration);
  f(jerk, c.jerk);
}

template <Of<StopDynamics> C, class F>
constexpr void each_field(C& c, F f) {
  f(deceleration, c.deceleration);
  f(jerk, c.jerk);
}

template <Of<MoveDynamics> C, class F>
constexpr void each_field(C& c, F f) {
  f(velocity, c.velocity);
  f(acceleration, c.acceleration);
  f(deceleration, c.deceleration);
  f(jerk, c.jerk);
}

/// A command without fields.
template <class C, class F>
requires std::is_empty_v<C>
constexpr void each_field(C& /*c*/, F /*f*/) {}

template <Of<SetPosition> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"position", Quantity::position, FieldRange::finite, "VALUE"}, c.position);
  f(Field{"relative", Quantity::none, FieldRange::flag, "relative",
          "set-position: the value is an offset"},
    c.relative);
}

template <Of<Home> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"offset", Quantity::position, FieldRange::given, "offset",
          "home: the position value of the home position; default: [homing] of the spec of the "
          "axis. The same holds for the next options"},
    c.offset);
  f(Field{"method", Quantity::none, FieldRange::count, "method", "home: method of CiA 402"},
    c.method);
  f(Field{"search velocity", Quantity::velocity, FieldRange::positive, "search-velocity",
          "home: velocity of the search for a switch"},
    c.search_velocity);
  f(Field{"index velocity", Quantity::velocity, FieldRange::positive, "index-velocity",
          "home: velocity of the search for the edge of the switch and the index"},
    c.index_velocity);
  f(acceleration, c.acceleration);
  f(Field{"timeout", Quantity::time, FieldRange::positive, "timeout",
          "home: fault after this time"},
    c.timeout);
  f(Field{"distance", Quantity::position, FieldRange::positive, "distance",
          "home: fault if one search is longer than this"},
    c.distance);
}

template <Of<Override> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"factor", Quantity::none, FieldRange::factor, "VALUE"}, c.factor);
}

template <Of<MoveAbsolute> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"position", Quantity::position, FieldRange::finite, "to", "Move to this position"},
    c.position);
  each_field(c.dynamics, f);
  f(Field{"direction", Quantity::none, FieldRange::direction, "direction",
          "Direction of a rotary axis with --to: shortest, positive, negative"},
    c.direction);
  f(buffer_mode, c.buffer);
}

template <Of<MoveRelative> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"distance", Quantity::position, FieldRange::finite, "by",
          "Move by this distance from the commanded position"},
    c.distance);
  each_field(c.dynamics, f);
  f(buffer_mode, c.buffer);
}

template <Of<MoveAdditive> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"distance", Quantity::position, FieldRange::finite, "add",
          "Move by this distance from the end position of the present motion"},
    c.distance);
  each_field(c.dynamics, f);
}

template <Of<MoveSuperimposed> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"distance", Quantity::position, FieldRange::finite, "on-top",
          "Move by this distance on top of the present motion"},
    c.distance);
  f(Field{"velocity difference", velocity.quantity, velocity.range, velocity.option, velocity.help},
    c.dynamics.velocity);
  f(acceleration, c.dynamics.acceleration);
  f(deceleration, c.dynamics.deceleration);
  f(jerk, c.dynamics.jerk);
}

template <Of<MoveVelocity> C, class F>
constexpr void each_field(C& c, F f) {
  f(Field{"velocity", Quantity::velocity, FieldRange::finite, "VALUE"}, c.velocity);
  each_field(c.dynamics, f);
  f(buffer_mode, c.buffer);
  f(Field{"hold to run", Quantity::none, FieldRange::flag, "hold-to-run",
          "jog only while this command runs: the axis stops when it ends, or sends no heartbeat "
          "for 0.2 s"},
    c.hold_to_run);
}

template <Of<Halt> C, class F>
constexpr void each_field(C& c, F f) {
  each_field(c.dynamics, f);
}

template <Of<GearIn> C, class F>
constexpr void each_field(C& c, F f) {
  f(numerator, c.numerator);
  f(denominator, c.denominator);
  each_field(c.dynamics, f);
}

template <Of<GearInPos> C, class F>
constexpr void each_field(C& c, F f) {
  f(numerator, c.numerator);
  f(denominator, c.denominator);
  f(Field{"master sync position", Quantity::master, FieldRange::finite, "master-sync",
          "gear-in-pos: master position from which both run in step"},
    c.master_sync_position);
  f(Field{"slave sync position", Quantity::position, FieldRange::finite, "slave-sync",
          "gear-in-pos: position of the axis there"},
    c.slave_sync_position);
  f(Field{"master start distance", Quantity::master, FieldRange::finite, "start-distance",
          "gear-in-pos: master distance before it, in which the axis engages"},
    c.master_start_distance);
  f(Field{"avoid reversal", Quantity::none, FieldRange::flag, "avoid-reversal",
          "gear-in-pos: reject a motion against the direction of the gear"},
    c.avoid_reversal);
}

template <Of<QueueSwitch> C, class F>
constexpr void each_field(C& c, F f) {
  f(queue, c.queue);
  f(bank, c.bank);
}

template <Of<QueueClear> C, class F>
constexpr void each_field(C& c, F f) {
  f(queue, c.queue);
  f(bank, c.bank);
  f(Field{"seq", Quantity::none, FieldRange::count}, c.seq);
}

template <Of<QueueEnd> C, class F>
constexpr void each_field(C& c, F f) {
  f(queue, c.queue);
}

}  // namespace command

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

template <class C>
constexpr Fields fields_of() {
  Fields all;
  C command{};
  command::each_field(
      command, [&](const Field& field, const auto& /*member*/) { all.field[all.count++] = field; });
  return all;
}

}  // namespace jounce
