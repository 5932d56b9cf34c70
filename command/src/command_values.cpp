// SPDX-License-Identifier: Apache-2.0
#include "jounce/command/command_values.hpp"

#include <cmath>
#include <type_traits>

#include "jounce/command/command_table.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

template <class Member>
void set(Member& member, double value) {
  if constexpr (std::is_enum_v<Member>)
    member = static_cast<Member>(static_cast<int>(value));
  else if constexpr (std::is_same_v<Member, bool>)
    member = value == 1;
  else
    member = static_cast<Member>(value);
}

/// True if the value is a whole number of 31 bits and a sign.
bool is_whole(double value) {
  return std::abs(value) <= 2147483647 && value == std::trunc(value);
}

/// The rule that the value violates; empty: none.
const char* broken(FieldRange range, double value) {
  const bool may_be_left_out = range == FieldRange::positive || range == FieldRange::given ||
                               range == FieldRange::coordinate;
  if (may_be_left_out && std::isnan(value)) return "";
  if (!std::isfinite(value)) return "must be finite";
  const auto rule = [](bool kept, const char* words) { return kept ? "" : words; };
  switch (range) {
    case FieldRange::finite:
    case FieldRange::given:
    case FieldRange::coordinate:
      return "";
    case FieldRange::positive:
      return rule(value > 0, "must be greater than 0; leave it out to use the limit of the axis");
    case FieldRange::flag:
      return rule(value == 0 || value == 1, "must be 0 or 1");
    case FieldRange::direction:
      return rule(std::abs(value) == 1 || value == 0, "must be -1, 0 or 1");
    case FieldRange::factor:
      return rule(value >= 0 && value <= 2, "must be 0 to 2");
    case FieldRange::buffer_mode:
      return rule(is_whole(value) && value >= 0 && value <= 5, "must be 0 to 5");
    case FieldRange::path_buffer:
      return rule(is_whole(value) && value >= 0 && value <= 6, "must be 0 to 6");
    case FieldRange::whole:
      return rule(is_whole(value), "must be a whole number from -2147483647 to 2147483647");
    case FieldRange::whole_nonzero:
      return value == 0 ? "must not be 0" : broken(FieldRange::whole, value);
    case FieldRange::trigger_input:
      return rule(is_whole(value) && value >= 1 && value <= probe_inputs, "must be 1 to 6");
    case FieldRange::trigger_edge:
      return rule(is_whole(value) && value >= 0 && value <= 2, "must be 0 to 2");
    case FieldRange::not_negative:
      return rule(value >= 0, "must be 0 or more");
    case FieldRange::share:
      return rule(value > 0 && value <= 1, "must be greater than 0 and at most 1");
    case FieldRange::count:
      break;
  }
  return rule(is_whole(value) && value >= 0, "must be a whole number from 0 to 2147483647");
}

}  // namespace

CommandValues values_of(const ClientCommand& command) {
  CommandValues values{};
  std::size_t i = 0;
  const auto put = [&](const Field& /*field*/, const auto& member) {
    values[i++] = static_cast<double>(member);
  };
  std::visit([&](const auto& each) { command::each_field(each, put); }, command);
  return values;
}

std::string contradiction(CommandKind kind, const CommandValues& values) {
  const CommandInfo& about = info(kind);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i >= about.fields.size() && values[i] != 0)
      return std::string(about.name) + " takes " + std::to_string(about.fields.size()) +
             " values at most";
    if (i >= about.fields.size()) continue;
    const char* const rule = broken(about.fields[i].range, values[i]);
    if (*rule != 0) return std::string(about.fields[i].name) + " " + rule;
  }
  return "";
}

std::string contradiction(const ClientCommand& command) {
  return contradiction(kind_of(command), values_of(command));
}

ClientCommand command_of(CommandKind kind) {
  const auto command = made<ClientCommand>(kind);
  if (!command) throw InputError("command", name(kind), "is not a command of a client");
  return *command;
}

ClientCommand command_of(CommandKind kind, const CommandValues& values) {
  ClientCommand command = command_of(kind);
  std::size_t i = 0;
  const auto get = [&](const Field& /*field*/, auto& member) { set(member, values[i++]); };
  std::visit([&](auto& each) { command::each_field(each, get); }, command);
  return command;
}

const char* words(FieldRange range) {
  switch (range) {
    case FieldRange::finite:
      break;
    case FieldRange::given:
      return "or NaN";
    case FieldRange::coordinate:
      return "NaN: not given";
    case FieldRange::positive:
      return "> 0";
    case FieldRange::flag:
      return "0 or 1";
    case FieldRange::direction:
      return "-1, 0 or 1";
    case FieldRange::factor:
      return "0 to 2";
    case FieldRange::buffer_mode:
      return "0 to 5";
    case FieldRange::path_buffer:
      return "0 to 6";
    case FieldRange::whole:
      return "whole";
    case FieldRange::whole_nonzero:
      return "whole, not 0";
    case FieldRange::count:
      return "whole, 0 or more";
    case FieldRange::trigger_input:
      return "1 to 6";
    case FieldRange::trigger_edge:
      return "0, 1 or 2";
    case FieldRange::not_negative:
      return "0 or more";
    case FieldRange::share:
      return "> 0, at most 1";
  }
  return "";
}

}  // namespace jounce
