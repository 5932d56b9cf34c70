// SPDX-License-Identifier: Apache-2.0
#include "web/src/word_order.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "jounce/profiles/error.hpp"

namespace jounce::web {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* held_option = "hold-to-run";

std::string given_text(const json& value, const std::string& key) {
  if (!value.is_string()) throw InputError(key, value.dump(), "must be a string");
  return value.get<std::string>();
}

const char* quantity_word(Quantity quantity) {
  switch (quantity) {
    case Quantity::none:
      break;
    case Quantity::position:
      return "position";
    case Quantity::velocity:
      return "velocity";
    case Quantity::acceleration:
      return "acceleration";
    case Quantity::jerk:
      return "jerk";
    case Quantity::master:
      return "master";
    case Quantity::time:
      return "time";
    case Quantity::master_velocity:
      return "master velocity";
    case Quantity::master_acceleration:
      return "master acceleration";
    case Quantity::master_jerk:
      return "master jerk";
  }
  return "";
}

}  // namespace

WordOrder read_word_order(std::string_view text) {
  const json object = json::parse(text, nullptr, false);
  if (!object.is_object()) throw InputError("command", "", "must be a JSON object");
  WordOrder order;
  for (const auto& [key, value] : object.items()) {
    if (key == "axis")
      order.axis = given_text(value, key);
    else if (key == "what")
      order.words.what = given_text(value, key);
    else if (key == "value")
      order.words.value = given_text(value, key);
    else if (key == "options" && value.is_object())
      for (const auto& [name, given] : value.items())
        order.words.options[name] = given_text(given, name);
    else if (key == "flags" && value.is_array())
      for (const auto& name : value) order.words.flags[given_text(name, key)] = true;
    else if (key == "options" || key == "flags")
      throw InputError(key, value.dump(),
                       key == "options" ? "must be an object: {\"velocity\": \"20\"}"
                                        : "must be a list of names: [\"buffered\"]");
    else
      throw InputError(key, value.dump(),
                       "is not a member of a command: its members are the texts axis, what and "
                       "value, the object options and the list flags");
  }
  const auto& known = command_words();
  if (std::find(known.begin(), known.end(), order.words.what) == known.end())
    throw InputError("what", order.words.what, "is not a command: GET /commands lists them");
  if (const auto at = order.words.options.find("at"); at != order.words.options.end())
    throw InputError("at", at->second,
                     "does not apply to a page, whose commands take effect at once: leave it out");
  if (order.words.flags.contains(held_option))
    throw InputError(held_option, "", "needs heartbeats: use the jog buttons");
  require_taken(order.words);
  return order;
}

std::string word_orders_json() {
  ordered_json all = ordered_json::array();
  for (const std::string& word : command_words()) {
    ordered_json options = ordered_json::array();
    for (const CommandOption& option : options_of(word)) {
      if (option.name == held_option) continue;
      ordered_json kind = "text";
      if (option.form == OptionForm::flag) kind = "flag";
      if (option.form == OptionForm::coordinates) kind = "coordinates";
      if (!option.choices.empty()) kind = option.choices;
      options.push_back({{"name", option.name},
                         {"help", option.help},
                         {"quantity", quantity_word(option.quantity)},
                         {"kind", std::move(kind)}});
      if (option.name == "blend")
        options.push_back({{"name", "buffered"},
                           {"help", "begin when the present motion has ended"},
                           {"quantity", ""},
                           {"kind", "flag"}});
    }
    all.push_back({{"word", word}, {"group", is_of_groups(word)}, {"options", std::move(options)}});
  }
  return all.dump();
}

}  // namespace jounce::web
