// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "jounce/stream/message/message.hpp"

/// Conversions between the field types of messages and the generated types.
namespace jounce::wire {

// The numbers on the wire are the values of the enumerators.
static_assert(static_cast<int>(Domain::time) == 0 && static_cast<int>(Domain::master) == 1);
static_assert(static_cast<int>(Interpolation::linear) == 0 &&
              static_cast<int>(Interpolation::cubic_hermite) == 1 &&
              static_cast<int>(Interpolation::quintic_hermite) == 2);
static_assert(static_cast<int>(Extrapolation::refuse) == 0 &&
              static_cast<int>(Extrapolation::hold) == 1 &&
              static_cast<int>(Extrapolation::wrap) == 2 &&
              static_cast<int>(Extrapolation::advance) == 3);

template <class Enum>
constexpr int last_of = 0;
template <>
inline constexpr int last_of<Domain> = static_cast<int>(Domain::master);
template <>
inline constexpr int last_of<Interpolation> = static_cast<int>(Interpolation::quintic_hermite);
template <>
inline constexpr int last_of<Extrapolation> = static_cast<int>(Extrapolation::advance);
template <>
inline constexpr int last_of<StartMode> = static_cast<int>(StartMode::ramp_in_distance);
template <>
inline constexpr int last_of<ArmMode> = static_cast<int>(ArmMode::path);
template <>
inline constexpr int last_of<StopMode> = static_cast<int>(StopMode::abort);
template <>
inline constexpr int last_of<Refusal> = refusals - 1;
template <>
inline constexpr int last_of<Outcome> = static_cast<int>(Outcome::refused);
template <>
inline constexpr int last_of<State> = static_cast<int>(states) - 1;
template <>
inline constexpr int last_of<Next> = static_cast<int>(Next::waiting);

template <>
inline constexpr int last_of<StartAt> = static_cast<int>(StartAt::master_position);
template <>
inline constexpr int last_of<StartOutcome> = static_cast<int>(StartOutcome::dropped);
template <>
inline constexpr int last_of<GearState> = static_cast<int>(GearState::in_cam);
template <>
inline constexpr int last_of<CamEnd> = static_cast<int>(CamEnd::extend);
template <>
inline constexpr int last_of<Progress> = static_cast<int>(Progress::broken);
template <>
inline constexpr int last_of<QueueMode> = static_cast<int>(QueueMode::dynamic);
template <>
inline constexpr int last_of<QueueEvent> = static_cast<int>(QueueEvent::pass);
template <>
inline constexpr int last_of<EventKind> = static_cast<int>(EventKind::table_begin);

template <class Enum>
inline constexpr int first_of = 0;
template <>
inline constexpr int first_of<QueueEvent> = static_cast<int>(QueueEvent::start);

template <class Enum>
std::int8_t number_of(Enum value) {
  return static_cast<std::int8_t>(value);
}

template <class Enum>
bool get_enum(std::int8_t number, Enum& value) {
  if (number < first_of<Enum> || number > last_of<Enum>) return false;
  value = static_cast<Enum>(number);
  return true;
}

inline bool get_flag(std::int8_t number, bool& value) {
  value = number == 1;
  return number == 0 || number == 1;
}

inline bool get_count(std::int32_t number, std::uint32_t& count) {
  count = static_cast<std::uint32_t>(number);
  return number >= 0;
}

inline bool get_command(std::int32_t number, std::int32_t& command) {
  command = number;
  return number >= 1;
}

template <std::size_t N>
void put_bytes(const std::array<std::uint8_t, N>& from, std::uint8_t (&to)[N]) {
  std::copy(from.begin(), from.end(), to);
}

template <std::size_t N>
bool get_bytes(const std::uint8_t (&from)[N], std::array<std::uint8_t, N>& to) {
  std::copy(from, from + N, to.begin());
  return true;
}

inline bool get_bank(std::int8_t number, std::uint8_t& bank) {
  bank = static_cast<std::uint8_t>(number);
  return number == 0 || number == 1;
}

/// True for +0 only. Each message thus has only one encoding.
inline bool is_zero(double value) {
  return std::bit_cast<std::uint64_t>(value) == 0;
}

/// Returns a count for the wire, which has 31 bits. Throws InputError for a greater one.
std::int32_t put_count(const char* key, std::uint32_t count);

/// Writes text as bytes, filled up with zeros. It must fit into `size` bytes with a final zero.
void put_text(std::string_view text, std::uint8_t* bytes, std::size_t size);

/// The reverse of put_text(). Returns false for a byte other than zero after the first zero, and
/// for a control character.
bool get_text(const std::uint8_t* bytes, std::size_t size, std::string& text);

/// Throws InputError for a unit that does not fit, or has control characters.
void put_unit(const char* key, const std::string& unit, std::uint8_t* bytes);

}  // namespace jounce::wire
