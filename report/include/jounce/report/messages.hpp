// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

/// A catalog of the messages of programs: fault numbers, refusals, rules. `jounce explain` collects
/// all of them.
namespace jounce {

/// A message that a program prints, or an error of a controller.
struct Message {
  std::string group;  ///< "Faults of an axis"
  std::string code;   ///< number; may be empty
  std::string name;   ///< "following_error"; may be empty
  std::string meaning;
  std::string
      remedy;  ///< next step; for an error of a controller, the answer of Jounce in its place
  bool is_foreign = false;  ///< an error of a controller
};

/// The messages with this number or name. Throws InputError (key "code"), with the nearest name, if
/// there is none.
std::vector<Message> messages_named(const std::vector<Message>& all, const std::string& code);

/// Number, name, meaning and remedy of each.
std::string messages_text(const std::vector<Message>& messages);

/// One line for each, by group.
std::string messages_list(const std::vector<Message>& messages);

/// The same as a JSON list, with meaning and remedy.
std::string messages_json(const std::vector<Message>& messages);

/// A table for each group in Markdown, without the errors of controllers.
std::string messages_markdown(const std::vector<Message>& messages);

}  // namespace jounce
