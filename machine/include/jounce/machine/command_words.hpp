// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "jounce/base/hash.hpp"
#include "jounce/command/command_table.hpp"
#include "jounce/command/commands.hpp"

/// Commands in words, as `jounce order` takes them: "move --to 120mm --velocity 200mm/s". The
/// words, their options and units come from the table of the commands.
///
///     const CommandWords words{.what = "move", .options = {{"to", "120mm"}}};
///     require_taken(words);
///     send_command(*link, "feeder", command_of(words, units));
namespace jounce {

/// The words after the name of the executor. An option is named without its dashes.
struct CommandWords {
  std::string what;
  std::string value = {};
  std::map<std::string, std::string> options = {};  ///< texts; empty: not given
  std::map<std::string, bool> flags = {};
};

/// All words: "enable", "move", ...
const std::vector<std::string>& command_words();

/// An option of some words, from a field of their commands.
struct CommandOption {
  std::string name;  ///< without dashes
  std::string help;
  FieldRange range = FieldRange::finite;  ///< flag: it has no text
};
/// Each option once; those of "move" come first.
std::vector<CommandOption> command_options();

/// Throws InputError, with the option in dashes ("--to") or VALUE as key, for a value or an option
/// that the word does not take.
void require_taken(const CommandWords& words);

/// The command, with its values in the units of the axis. Throws InputError, as require_taken(),
/// for a bad or missing value.
ClientCommand command_of(const CommandWords& words, const Units& units);

}  // namespace jounce
