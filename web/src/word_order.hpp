// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "jounce/machine/detail/command_words.hpp"

namespace jounce::web {

/// A command in the words of `jounce order`: {"axis": "plotter", "what": "move-linear", "value": "",
/// "options": {"to": "10mm,5mm"}, "flags": ["buffered"]}.
struct WordOrder {
  std::string axis{};    ///< name of the axis or group
  CommandWords words{};  ///< the words behind it
};

/// Reads a command from JSON. Throws InputError for JSON that is not such an object, for an unknown
/// word, and for a value or an option that the command does not have. Rejects hold-to-run, which
/// needs heartbeats: see Jogs.
WordOrder read_word_order(std::string_view json);

/// Returns all commands as JSON: [{"word", "group", "options": [{"name", "help", "quantity",
/// "kind"}]}]. The option "VALUE" is the value. `kind`: "text", "coordinates", "flag", or a list of
/// words.
std::string word_orders_json();

}  // namespace jounce::web
