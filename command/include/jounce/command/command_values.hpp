// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "jounce/command/commands.hpp"
#include "jounce/command/field.hpp"

namespace jounce {

/// The fields of a command as numbers, in the order of the wire and of the record of a run. A flag
/// is 0 or 1; an enumeration value is its number. Entries after the last field are 0.
using CommandValues = std::array<double, most_fields>;

/// Returns the fields of a command.
CommandValues values_of(const ClientCommand& command);

/// Returns the first error in the values of a command, as a sentence with the name of the field; ""
/// if the values are valid.
std::string contradiction(CommandKind kind, const CommandValues& values);
std::string contradiction(const ClientCommand& command);

/// Returns the command with these values. Requires that contradiction() returns "".
ClientCommand command_of(CommandKind kind, const CommandValues& values);

/// Returns the command of this kind with the defaults of its fields. Throws InputError for a kind
/// that clients do not send.
ClientCommand command_of(CommandKind kind);

/// Returns the range of a field in words, for the documentation: "0 or 1"; "" for any finite
/// number.
const char* words(FieldRange range);

}  // namespace jounce
