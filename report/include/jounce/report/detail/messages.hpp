// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/profiles/error.hpp"

/// A catalog of the messages of programs: faults, rejections, rules. `jounce explain` shows all of
/// them.
namespace jounce {

/// A message that a program can print, or an error of a controller.
struct Message {
  std::string group = {};    ///< heading of its group: "Faults of an axis"
  std::string code = {};     ///< number; may be empty
  std::string name = {};     ///< "following_error"; may be empty
  std::string meaning = {};  ///< one sentence: what happened
  std::string remedy = {};   ///< remedy; for an error of a controller, the equivalent in Jounce
  bool is_foreign = false;   ///< true for an error of a controller
};

/// Returns the messages with this number or name. If no message has it, throws InputError (key
/// "code") with the nearest name.
std::vector<Message> messages_named(const std::vector<Message>& all, const std::string& code);

/// Returns the names of the messages, without their numbers.
std::vector<std::string> message_names(const std::vector<Message>& all);

/// Returns number, name, meaning and remedy of each message as text.
std::string messages_text(const std::vector<Message>& messages);

/// Returns one line for each message, in groups.
std::string messages_list(const std::vector<Message>& messages);

/// Returns the messages as a JSON list, with meaning and remedy.
std::string messages_json(const std::vector<Message>& messages);

/// Returns a Markdown table for each group, without the errors of controllers.
std::string messages_markdown(const std::vector<Message>& messages);

}  // namespace jounce
