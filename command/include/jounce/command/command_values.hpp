// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "jounce/command/commands.hpp"
#include "jounce/command/field.hpp"

namespace jounce {

/// The fields of a command as numbers, in their order, as the wire and the record have them. A flag
/// is 0 or 1, an enumerator its number; the rest is 0.
using CommandValues = std::array<double, most_fields>;

CommandValues values_of(const ClientCommand& command);

/// Error of the values of a command, as a sentence that names the field; empty: none.
std::string contradiction(CommandKind kind, const CommandValues& values);
std::string contradiction(const ClientCommand& command);

/// The command with these values; they must not contradict its fields.
ClientCommand command_of(CommandKind kind, const CommandValues& values);

/// The command with the defaults of its fields. Throws InputError for a kind that no client sends.
ClientCommand command_of(CommandKind kind);

/// The range of a field in words, as documentation: "0 or 1"; empty: any finite number.
const char* words(FieldRange range);

}  // namespace jounce
