// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "jounce/base/hash.hpp"
#include "jounce/command/commands.hpp"
#include "jounce/command/detail/command_table.hpp"

/// Commands in words, as in `jounce order`: "move --to 120mm --velocity 200mm/s". command_table.hpp
/// defines the words and units, machine/src/operate/order_options.cpp the options.
///
///     const CommandWords words{.what = "move", .options = {{"to", "120mm"}}};
///     require_taken(words);
///     send_command(*link, "feeder", command_of(words, units));
namespace jounce {

/// The words after the name of the executor.
struct CommandWords {
  std::string what = {};   ///< the command: "move"
  std::string value = {};  ///< value of the command; "": not given
  /// Options with a value, by their name without dashes; "": not given.
  std::map<std::string, std::string> options = {};
  std::map<std::string, bool> flags = {};  ///< options without a value, by name without dashes
  /// True: set_values() made the coordinates from arguments such as "x=10mm", so messages must not
  /// name their option.
  bool typed_coordinates = false;
};

/// Returns the words of all commands: "enable", "move", ...
const std::vector<std::string>& command_words();
/// Returns the rule for a word that is no command, if another order of the words or another verb is
/// probably meant: "is a verb of its own: did you mean jounce stop feeder?". Otherwise returns "".
/// `name`: the name of the executor, as given.
std::string meant_command(const std::string& name, const std::string& word);
/// Returns the rule for the name of a single axis in an order with coordinates, with the order of an
/// axis in its place: "is a single axis, without coordinates: name a group, or send `jounce order
/// feeder jog 20`".
std::string rule_of_axis(const std::string& name, const CommandWords& words);

/// Form in which the text of an option gives a value.
enum class OptionForm : std::uint8_t {
  flag,           ///< no text
  number,         ///< "120mm"
  whole,          ///< "3"
  factor,         ///< "50%" or "0.5"
  ratio,          ///< "3:2"
  direction,      ///< one of the choices: "positive"
  blend,          ///< one of the choices: "low"
  edge,           ///< "rising", "falling" or "both"
  trigger_input,  ///< "1" to "4", "home" or "index"
  coordinates,    ///< "10mm,5mm"
};

/// An option of `jounce order`, which is a field of one or more commands.
struct CommandOption {
  std::string name = {};                  ///< name without dashes
  std::string help = {};                  ///< help text
  OptionForm form = OptionForm::number;   ///< form in which its text gives the value
  Quantity quantity = Quantity::none;     ///< physical quantity
  std::vector<std::string> choices = {};  ///< permitted words; empty: a number or a list
};
/// Returns the options of a word; its value has the name "VALUE". A word with the option "blend"
/// also takes the flag "buffered".
std::vector<CommandOption> options_of(const std::string& word);
/// True if only a group executes the word.
bool is_of_groups(const std::string& word);
/// Returns all options, each one once. The options of "move" come first.
std::vector<CommandOption> command_options();

/// Throws InputError for a value or an option that the command does not have, for options that
/// exclude each other, and if the command needs one of several options and none of them is given.
/// The key of the error is "VALUE", or the option with its dashes ("--to").
void require_taken(const CommandWords& words);

/// Returns the options in `words` whose number equals `value` to six digits: "--deceleration".
/// `units`: units of the axis. The value of the command itself has no option.
std::vector<std::string> options_with(const CommandWords& words, Quantity quantity, double value,
                                      const Units& units);

/// Returns the kind of the command; `words` must satisfy require_taken().
CommandKind kind_of(const CommandWords& words);

/// Throws InputError if `seconds` (the duration of a jog) is given for a command other than `jog
/// --hold-to-run`, which would ignore it.
void require_held(const CommandWords& words, const std::string& seconds);

/// Sets the value of the command from the arguments after it. Arguments such as "x=10mm", "y=5mm"
/// are the coordinates of a command of a group, by the names of its axes. Throws InputError for
/// several other values, and for coordinates of a command without coordinates.
void set_values(CommandWords& words, const std::vector<std::string>& values);
/// True if the words name axes of a group: "--to x=10mm".
bool names_axes(const CommandWords& words);
/// True if the words give coordinates of a group, by name or in the order of its axes.
bool has_coordinates(const CommandWords& words);

/// Returns the command, with its values converted to the units of the axis; `words` must satisfy
/// require_taken(). `axes`: for words that name axes, the axes of the group, in the order of
/// coordinates. `coordinate_units`: their units, in the same order; empty: all have the unit of the
/// axis. Throws InputError for an invalid or missing value, and for an unknown name.
ClientCommand command_of(const CommandWords& words, const Units& units,
                         const std::vector<std::string>& axes = {},
                         const std::vector<std::string>& coordinate_units = {});

}  // namespace jounce
