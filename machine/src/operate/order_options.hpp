// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "jounce/command/detail/command_table.hpp"
#include "jounce/command/field.hpp"
#include "jounce/machine/detail/command_words.hpp"

namespace jounce {

/// Name of the argument of a command in messages and in FieldOption::option.
inline constexpr const char* value_word = "VALUE";

/// The option of `jounce order` for a field of a command.
struct FieldOption {
  const char* command;    ///< name of the command; "": every command without an entry of its own
  const char* field;      ///< name of the field
  const char* option;     ///< name of the option without dashes, or "VALUE"
  OptionForm form;        ///< form in which the text gives the value
  const char* help = "";  ///< help text of the option
  /// Permitted values, if their words differ from those of the field, or if they are fewer.
  std::optional<FieldRange> range = std::nullopt;
  const char* reason = "";  ///< added to the rule that a value breaks
  const char* unit = "";    ///< unit of a number whose field has no physical quantity
};

/// Returns all entries, those of single commands first.
std::span<const FieldOption> field_options();

/// Returns the entry of a field. Throws std::out_of_range if the table has none.
const FieldOption& field_option(const CommandInfo& command, const Field& field);

}  // namespace jounce
