// SPDX-License-Identifier: Apache-2.0
#include "web/src/page_command.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "jounce/command/command_values.hpp"
#include "jounce/command/detail/command_table.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/operate.hpp"

namespace jounce::web {
namespace {

using nlohmann::json;

/// A word of the page. Its command has its defaults, but for its first field, which is the value.
struct Word {
  std::string_view what;
  CommandKind kind;
  bool takes_value = false;
  bool takes_hold = false;
};

constexpr std::array words{Word{"hold", CommandKind::hold},
                           Word{"resume", CommandKind::resume},
                           Word{"override", CommandKind::override_, true},
                           Word{"enable", CommandKind::enable},
                           Word{"disable", CommandKind::disable},
                           Word{"reset", CommandKind::reset},
                           Word{"move", CommandKind::move_absolute, true},
                           Word{"jog", CommandKind::move_velocity, true, true},
                           Word{"release", CommandKind::halt, false, true}};

const Word* word_of(std::string_view what) {
  const auto* const at =
      std::find_if(words.begin(), words.end(), [&](const Word& word) { return word.what == what; });
  return at == words.end() ? nullptr : at;
}

std::string text_of(const json& object, const char* key) {
  const auto at = object.find(key);
  if (at == object.end() || !at->is_string())
    throw InputError(key, at == object.end() ? "" : at->dump(), "must be a string");
  return at->get<std::string>();
}

/// Integers of a browser are exact up to 2^53.
std::int64_t hold_of(const json& object) {
  constexpr std::int64_t most = std::int64_t{1} << 53U;
  const auto at = object.find("hold");
  const bool whole = at != object.end() && at->is_number_integer() &&
                     at->get<double>() <= static_cast<double>(most);
  if (!whole || at->get<std::int64_t>() <= 0)
    throw InputError("hold", at == object.end() ? "" : at->dump(),
                     "must be the number of a jog, 1 to 2^53");
  return at->get<std::int64_t>();
}

double value_of(const json& object) {
  const auto at = object.find("value");
  if (at == object.end() || !at->is_number())
    throw InputError("value", at == object.end() ? "" : at->dump(), "must be a number");
  return at->get<double>();
}

CommandValues values_of(const PageCommand& command, const Word& word) {
  CommandValues values = jounce::values_of(command_of(word.kind));
  if (word.takes_value) values[0] = command.value;
  return values;
}

}  // namespace

PageCommand read_command(std::string_view text) {
  const json object = json::parse(text, nullptr, false);
  if (!object.is_object()) throw InputError("order", "", "must be a JSON object");
  for (const auto& [key, value] : object.items())
    if (key != "axis" && key != "what" && key != "value" && key != "hold")
      throw InputError(key, value.dump(),
                       "is not a key of a command: the keys are axis, what, value, hold");
  PageCommand command{.axis = text_of(object, "axis"), .what = text_of(object, "what")};
  const Word* const word = word_of(command.what);
  if (word == nullptr && command.what != "stop")
    throw InputError(
        "what", command.what,
        "must be stop, hold, resume, override, enable, disable, reset, move, jog or release");
  const bool takes_hold = word != nullptr && word->takes_hold;
  if (!takes_hold && object.contains("hold"))
    throw InputError("hold", object["hold"].dump(),
                     "does not apply to " + command.what + ": leave it out");
  if (takes_hold) command.hold = hold_of(object);
  const bool takes_value = word != nullptr && word->takes_value;
  if (!takes_value && object.contains("value"))
    throw InputError("value", object["value"].dump(),
                     "does not apply to " + command.what + ": leave it out");
  if (!takes_value) return command;
  command.value = value_of(object);
  if (const std::string rule = contradiction(word->kind, values_of(command, *word)); !rule.empty())
    throw InputError("value", object["value"].dump(), rule);
  return command;
}

CallOutcome give(Transport& link, const PageCommand& command, const std::optional<wire::Key>& key) {
  const std::string& axis = command.axis;
  const Word* const word = word_of(command.what);
  if (word == nullptr)
    return outcome_of(operator_command(link, axis, wire::Stop{.mode = wire::StopMode::stop},
                                       std::chrono::seconds(2), key),
                      axis);
  return send_command(link, axis, command_of(word->kind, values_of(command, *word)), -1, key);
}

}  // namespace jounce::web
