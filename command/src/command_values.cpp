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

/// The number of a field of the command C among its fields.
template <class C, class Member>
std::size_t number_of(Member C::*member) {
  C command{};
  std::size_t i = 0;
  std::size_t found = 0;
  command::each_field(command, [&](const Field& /*field*/, const auto& each) {
    if (static_cast<const void*>(&each) == &(command.*member)) found = i;
    ++i;
  });
  return found;
}

/// The fields whose value is not the default of the command.
std::bitset<most_fields> given_in(CommandKind kind, const CommandValues& values) {
  const CommandValues defaults = values_of(command_of(kind));
  std::bitset<most_fields> given;
  for (std::size_t i = 0; i < values.size(); ++i)
    given[i] = values[i] != defaults[i] && !(std::isnan(values[i]) && std::isnan(defaults[i]));
  return given;
}

/// Rejects more than one of the fields of a command.
std::optional<FieldConflict> more_than_one(const Fields& fields,
                                           const std::bitset<most_fields>& given,
                                           const FieldName& name) {
  if (given.count() < 2) return std::nullopt;
  std::size_t first = 0;
  while (!given[first]) ++first;
  std::size_t second = first + 1;
  while (!given[second]) ++second;
  std::string all;
  for (const Field& field : fields) all += (all.empty() ? "" : ", ") + name(field);
  return FieldConflict{
      second, "cannot be combined with " + name(fields[first]) + ": give at most one of " + all,
      std::nullopt};
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

std::optional<FieldConflict> field_conflict(CommandKind kind, const std::bitset<most_fields>& given,
                                            const FieldName& name) {
  const Fields& fields = info(kind).fields;
  if (kind == CommandKind::cut) return more_than_one(fields, given, name);
  if (kind != CommandKind::change_velocity) return std::nullopt;
  const std::size_t position = number_of(&command::ChangeVelocity::position);
  const std::size_t direction = number_of(&command::ChangeVelocity::direction);
  if (!given[direction] || given[position]) return std::nullopt;
  return FieldConflict{direction, "has no effect without " + name(fields[position]), position};
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
  const FieldName name = [](const Field& field) { return std::string(field.name); };
  if (about.number < 0) return "";
  const auto conflict = field_conflict(kind, given_in(kind, values), name);
  if (!conflict) return "";
  return name(about.fields[conflict->field]) + " " + conflict->rule +
         (conflict->missing ? ": give the " + name(about.fields[*conflict->missing]) : "");
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
