// SPDX-License-Identifier: Apache-2.0
#include "jounce/drive/cia402.hpp"

#include <array>
#include <cmath>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using enum Cia402State;

/// Bits 0 to 3, 5 and 6 of the statusword of a state (CiA 402-2, table "state coding").
struct Coding {
  Cia402State state;
  std::uint16_t mask;
  std::uint16_t value;
};
constexpr std::array<Coding, cia402_states> codings{{{not_ready_to_switch_on, 0x4f, 0x00},
                                                     {switch_on_disabled, 0x4f, 0x40},
                                                     {ready_to_switch_on, 0x6f, 0x21},
                                                     {switched_on, 0x6f, 0x23},
                                                     {operation_enabled, 0x6f, 0x27},
                                                     {quick_stop_active, 0x6f, 0x07},
                                                     {fault_reaction_active, 0x4f, 0x0f},
                                                     {fault, 0x4f, 0x08}}};

constexpr std::uint16_t voltage_enabled = 1U << 4U;
constexpr std::uint16_t remote = 1U << 9U;
constexpr std::uint16_t internal_limit = 1U << 11U;
constexpr std::uint16_t follows = 1U << 12U;
constexpr std::uint16_t following_error = 1U << 13U;

// Controlwords.
constexpr std::uint16_t disable_voltage = 0x00;
constexpr std::uint16_t quick_stop = 0x02;
constexpr std::uint16_t shutdown = 0x06;
constexpr std::uint16_t switch_on = 0x07;
constexpr std::uint16_t enable_operation = 0x0f;
constexpr std::uint16_t fault_reset = 0x80;

/// The command in a controlword: one of the five above, ignoring the other bits.
std::uint16_t command_of(std::uint16_t word) {
  if ((word & 0x02U) == 0) return disable_voltage;
  if ((word & 0x04U) == 0) return quick_stop;
  if ((word & 0x01U) == 0) return shutdown;
  return (word & 0x08U) == 0 ? switch_on : enable_operation;
}

Cia402State obeyed(Cia402State state, std::uint16_t command) {
  switch (state) {
    case switch_on_disabled:
      return command == shutdown ? ready_to_switch_on : state;  // 2
    case ready_to_switch_on:
      if (command <= quick_stop) return switch_on_disabled;  // 7
      return command == shutdown ? state : switched_on;      // 3
    case switched_on:
      if (command <= quick_stop) return switch_on_disabled;     // 10
      if (command == shutdown) return ready_to_switch_on;       // 6
      return command == switch_on ? state : operation_enabled;  // 4
    case operation_enabled:
      if (command == disable_voltage) return switch_on_disabled;  // 9
      if (command == quick_stop) return quick_stop_active;        // 11
      if (command == shutdown) return ready_to_switch_on;         // 8
      return command == switch_on ? switched_on : state;          // 5
    case quick_stop_active:
      return command == disable_voltage ? switch_on_disabled : state;  // 12
    default:
      return state;
  }
}

}  // namespace

const char* name(Cia402State state) {
  constexpr std::array<const char*, cia402_states> names{
      "not ready to switch on", "switch on disabled", "ready to switch on",    "switched on",
      "operation enabled",      "quick stop active",  "fault reaction active", "fault"};
  return names[static_cast<std::size_t>(state)];
}

std::optional<Cia402Status> status_of(std::uint16_t word) {
  for (const Coding& coding : codings)
    if ((word & coding.mask) == coding.value)
      return Cia402Status{.state = coding.state,
                          .internal_limit = (word & internal_limit) != 0,
                          .follows = (word & follows) != 0,
                          .following_error = (word & following_error) != 0};
  return std::nullopt;
}

std::uint16_t statusword(const Cia402Status& status) {
  unsigned word = codings[static_cast<std::size_t>(status.state)].value | remote;
  if (status.state != quick_stop_active) word |= 0x20U;  // bit 5 cleared: quick stop
  if (status.state != not_ready_to_switch_on) word |= voltage_enabled;
  if (status.internal_limit) word |= internal_limit;
  if (status.follows) word |= follows;
  if (status.following_error) word |= following_error;
  return static_cast<std::uint16_t>(word);
}

std::uint16_t controlword(Cia402State state, const Cia402Wish& wish) {
  if (state == fault) return wish.reset ? fault_reset : disable_voltage;
  if (state == quick_stop_active) return wish.standing ? disable_voltage : quick_stop;
  if (!wish.operate) return state == operation_enabled ? quick_stop : disable_voltage;
  switch (state) {
    case switch_on_disabled:
      return shutdown;
    case ready_to_switch_on:
      return switch_on;
    case switched_on:
      return wish.hold_back ? switch_on : enable_operation;
    case operation_enabled:
      return enable_operation;
    default:
      return disable_voltage;
  }
}

Cia402State next(Cia402State state, std::uint16_t word, std::uint16_t before,
                 const Cia402Events& events) {
  const bool failed = state == fault || state == fault_reaction_active;
  if (events.fault && !failed) return fault_reaction_active;                        // 13
  if (state == fault_reaction_active) return events.reaction_done ? fault : state;  // 14
  if (state == fault) {                                                             // 15
    const bool rises = (word & fault_reset) != 0 && (before & fault_reset) == 0;
    return rises && !events.fault ? switch_on_disabled : state;
  }
  if (state == not_ready_to_switch_on) return events.initialised ? switch_on_disabled : state;  // 1
  if (state == quick_stop_active && events.stopped) return switch_on_disabled;  // 12
  return obeyed(state, command_of(word));
}

// ---- increments ---------------------------------------------------------------------------------

Increments::Increments(double per_rev, double position_per_rev, bool reversed)
    : per_rev_(reversed ? -per_rev : per_rev), position_per_rev_(position_per_rev) {
  require_positive("increments_per_rev", per_rev);
  require_positive("position_per_rev", position_per_rev);
  if (per_rev != std::floor(per_rev) || per_rev >= 0x1p31)
    throw InputError("increments_per_rev", per_rev, "must be a whole number below 2147483648");
}

/// Let h + l = position * per_rev exactly and q the rounded quotient. The remainder, h - q
/// position_per_rev + l, shows whether q has to change by one.
std::optional<std::int64_t> Increments::of(double position) const noexcept {
  const double h = position * per_rev_;
  const double q = std::round(h / position_per_rev_);
  if (!(std::abs(q) < 0x1p52)) return std::nullopt;
  const double l = std::fma(position, per_rev_, -h);
  const double left = std::fma(-q, position_per_rev_, h) + l;
  const double half = position_per_rev_ / 2;
  auto whole = static_cast<std::int64_t>(q);
  if (left > half || (left == half && h > 0)) ++whole;
  if (left < -half || (left == -half && h < 0)) --whole;
  return whole;
}

std::int64_t Increments::unwrapped(std::int32_t low, std::int64_t near) noexcept {
  const auto step = static_cast<std::uint32_t>(low) - static_cast<std::uint32_t>(near);
  return near + static_cast<std::int32_t>(step);
}

}  // namespace jounce
