// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "jounce/base/hash.hpp"
#include "jounce/command/command_table.hpp"
#include "jounce/command/commands.hpp"

// The words of `jounce order`: which options each takes, and the command that they make. All of it
// comes from the table of the commands.
namespace jounce::cli {

/// The words after the name of the executor. An option is named without its dashes.
struct OrderWords {
  std::string what;
  std::string value;
  std::map<std::string, std::string> options;  ///< texts; empty: not given
  std::map<std::string, bool> flags;
};

/// "enable", "move", ...: in the order of the help.
const std::vector<std::string>& order_words();

/// An option of `jounce order`, from a field of a command.
struct OrderOption {
  std::string name;  ///< without dashes
  std::string help;
  FieldRange range = FieldRange::finite;  ///< flag: it has no text
};
/// Each once, in the order of the help.
std::vector<OrderOption> order_options();

/// Throws InputError for a value or an option that the word does not take.
void require_taken(const OrderWords& words);

/// The command, with its values in the units of the axis. Throws InputError for a value.
ClientCommand command_of(const OrderWords& words, const Units& units);

}  // namespace jounce::cli
