// SPDX-License-Identifier: Apache-2.0
#include "jounce/report/detail/messages.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/detail/nearest.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/report/rules.hpp"

namespace jounce {
namespace {

/// All groups, in the order of their first message.
std::vector<std::string> groups_of(const std::vector<Message>& all) {
  std::vector<std::string> groups;
  for (const Message& one : all)
    if (std::find(groups.begin(), groups.end(), one.group) == groups.end())
      groups.push_back(one.group);
  return groups;
}

/// A text for a cell of a Markdown table.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, 1, '\\');
  return text;
}

/// The number and the name, if there are any.
std::string title_of(const Message& one) {
  return one.code + (one.code.empty() || one.name.empty() ? "" : " ") + one.name;
}

/// True for a rule of a family that names a quantity, with a word that is none: "limit/velocityy".
bool names_other_quantity(const std::string& code) {
  const RuleInfo* const rule = rule_info(code);
  const std::size_t slash = code.find('/');
  if (rule == nullptr || slash == std::string::npos || code == rule->rule) return false;
  const std::vector<std::string> known = quantities_of(rule->rule);
  const std::string word = code.substr(slash + 1);
  return !known.empty() && word.find(' ') == std::string::npos &&
         std::find(known.begin(), known.end(), word) == known.end();
}

}  // namespace

std::string messages_markdown(const std::vector<Message>& all) {
  std::string text =
      "# Messages\n\nThe numbers and names that an axis, an executor, the stream and a check "
      "report. "
      "`jounce explain NAME` prints one\n"
      "of them. It also explains the errors of controllers for cams and gears "
      "([their table](../cam/errors.md)).\n"
      "`jounce explain --markdown` prints this page.\n";
  std::vector<Message> own;
  std::copy_if(all.begin(), all.end(), std::back_inserter(own),
               [](const Message& one) { return !one.is_foreign; });
  for (const std::string& group : groups_of(own)) {
    text += fmt::format(
        "\n## {}\n\n| no. | name | what happened | what to do |\n|---|---|---|---|\n", group);
    for (const Message& one : own)
      if (one.group == group)
        text += fmt::format("| {} | {} | {} | {} |\n", one.code,
                            one.code.empty() ? "`" + one.name + "`" : one.name, cell(one.meaning),
                            cell(one.remedy));
  }
  return text;
}

std::string messages_json(const std::vector<Message>& all) {
  nlohmann::ordered_json document = nlohmann::ordered_json::array();
  for (const Message& one : all)
    document.push_back({{"group", one.group},
                        {"code", one.code},
                        {"name", one.name},
                        {"meaning", one.meaning},
                        {"remedy", one.remedy}});
  return document.dump();
}

std::string messages_text(const std::vector<Message>& all) {
  std::string text;
  for (const Message& one : all)
    text += fmt::format("{} ({})\n  {}\n  {}: {}\n", title_of(one), one.group, one.meaning,
                        one.is_foreign ? "In Jounce" : "What to do", one.remedy);
  return text;
}

std::string messages_list(const std::vector<Message>& all) {
  std::string text;
  for (const std::string& group : groups_of(all)) {
    text += fmt::format("{}:\n", group);
    std::size_t width = 0;
    for (const Message& one : all)
      if (one.group == group) width = std::max(width, one.name.size());
    for (const Message& one : all)
      if (one.group == group)
        text += fmt::format("  {:>6} {:<{}} {}\n", one.code, one.name, width, one.meaning);
  }
  return text;
}

std::vector<std::string> message_names(const std::vector<Message>& all) {
  std::vector<std::string> names;
  for (const Message& message : all)
    if (!message.name.empty()) names.push_back(message.name);
  return names;
}

std::vector<Message> messages_named(const std::vector<Message>& all, const std::string& code) {
  std::vector<Message> found;
  const RuleInfo* const rule = names_other_quantity(code) ? nullptr : rule_info(code);
  const std::string name = rule != nullptr ? rule->rule : code;
  for (const Message& one : all)
    if (one.code == code || one.name == name) found.push_back(one);
  if (!found.empty()) return found;
  std::vector<std::string> names;
  for (const Message& one : all) {
    names.push_back(one.name);
    // Rules of one meaning are listed as one: "limit/*".
    if (!one.name.ends_with("/*")) continue;
    const std::string family = one.name.substr(0, one.name.size() - 1);
    const std::vector<std::string> quantities = quantities_of(one.name);
    for (const std::string& quantity : quantities) names.push_back(family + quantity);
    if (quantities.empty()) names.push_back(family + code.substr(code.find('/') + 1));
  }
  const std::string meant = nearest(code, names);
  throw InputError(
      "code", code,
      "is not the number or name of a message: " +
          (meant.empty() ? "`jounce explain` lists them all" : "did you mean " + meant + "?"));
}

}  // namespace jounce
