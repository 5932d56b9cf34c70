// SPDX-License-Identifier: Apache-2.0
#include "jounce/command/command_values.hpp"

#include <cmath>
#include <type_traits>

#include "jounce/command/detail/command_table.hpp"
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
    const auto& [field, quantity, range] = about.fields[i];
    const std::string rule = broken_rule(range, values[i]);
    if (rule.empty()) continue;
    const bool has_default = range.may_be_nan && !std::isinf(values[i]);
    return field + (" " + rule) +
           (has_default ? "; leave it out to use the limit of the axis" : "");
  }
  const FieldName name = [](const Field& field) { return std::string(field.name); };
  if (about.number < 0) return "";
  const auto conflict = field_conflict(kind, given_in(kind, values), name);
  if (!conflict) return "";
  return name(about.fields[conflict->field]) + " " + conflict->rule +
         (conflict->missing ? ": give the " + name(about.fields[*conflict->missing]) : "");
}

std::string contradiction(const ClientCommand& command) {
  const CommandKind kind = kind_of(command);
  const CommandValues values = values_of(command);
  const Fields& fields = info(kind).fields;
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (std::isnan(values[i]) && !is_as_configured(values[i]))
      return fields[i].name + std::string(" must be a number, but is NaN") +
             (fields[i].range.may_be_nan ? "; leave it out, or give as_configured" : "");
  return contradiction(kind, values);
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

std::string broken_rule(const FieldRange& range, double value) {
  if (range.may_be_nan && std::isnan(value)) return "";
  if (!std::isfinite(value)) return "must be finite";
  if (range.not_zero && value == 0 && range.least < 0) return "must not be 0";
  const bool permitted = value >= range.least && value <= range.most &&
                         !(range.not_zero && value == 0) &&
                         !(range.whole && value != std::trunc(value));
  return permitted ? "" : std::string("must be ") + range.words;
}

}  // namespace jounce
