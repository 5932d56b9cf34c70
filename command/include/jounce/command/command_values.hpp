// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "jounce/command/commands.hpp"
#include "jounce/command/field.hpp"

namespace jounce {

/// The fields of a command as numbers, in the order of the wire and of the record of an executor. A
/// flag is 0 or 1; an enumeration value is its number. Entries after the last field are 0.
using CommandValues = std::array<double, most_fields>;

/// Returns the fields of a command.
CommandValues values_of(const ClientCommand& command);

/// A field of a command that other fields of the same command forbid.
struct FieldConflict {
  std::size_t field = 0;  ///< number of the field in the command, from 0
  std::string rule = {};  ///< rule that it breaks: "cannot be combined with position"
  std::optional<std::size_t> missing = {};  ///< number of a field that must be given with it;
                                            ///< nullopt: none is missing
};

/// Returns the name of a field for a message.
using FieldName = std::function<std::string(const Field&)>;

/// Returns the first conflict between the fields of a command; nullopt if they suit each other.
/// `given`: the fields that the sender gives, in the order of the wire. `name` returns the name of
/// a field in the rule.
std::optional<FieldConflict> field_conflict(CommandKind kind, const std::bitset<most_fields>& given,
                                            const FieldName& name);

/// Returns the first error in the values of a command, as a sentence with the name of the field; ""
/// if the values are valid. A conflict between fields is also an error; a field that has its
/// default value counts as not given. In a ClientCommand, any NaN except as_configured is an error.
std::string contradiction(CommandKind kind, const CommandValues& values);
std::string contradiction(const ClientCommand& command);

/// Returns the command with these values. Requires that contradiction() returns "".
ClientCommand command_of(CommandKind kind, const CommandValues& values);

/// Returns the command of this kind with the defaults of its fields. Throws InputError for a kind
/// that clients do not send.
ClientCommand command_of(CommandKind kind);

/// Returns the rule that a value breaks: "must be 0 or 1"; "" if the range permits the value.
std::string broken_rule(const FieldRange& range, double value);

}  // namespace jounce
