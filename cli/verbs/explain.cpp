// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <memory>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/nearest.hpp"
#include "jounce/command/causes.hpp"
#include "jounce/controllers/controller_errors.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/report/rules.hpp"
#include "jounce/stream/message/refusals.hpp"

#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct ExplainArguments {
  std::string code;
  bool markdown = false;
  bool json = false;
};

/// A message that the program prints, or an error of a controller.
struct Message {
  std::string group;
  std::string code;
  std::string name;
  std::string meaning;
  std::string
      remedy;  ///< next step; for an error of a controller, the answer of Jounce in its place
  bool is_foreign = false;
};

/// The group of a Cause. Each group has a block of numbers.
const char* group_of(Cause cause) {
  if (is_fault(cause)) return "Faults of an axis";
  if (cause >= Cause::stopped) return "Why a motion ended";
  if (cause >= Cause::bad_table && cause <= Cause::not_in_sync)
    return "Tables that an axis rejects";
  return "Commands that an axis rejects";
}

std::vector<Message> all_messages() {
  std::vector<Message> all;
  for (const CauseInfo& one : all_causes())
    if (one.cause != Cause::none)
      all.push_back({group_of(one.cause), std::to_string(static_cast<int>(one.cause)), one.name,
                     one.meaning, one.remedy});
  for (const wire::RefusalInfo& one : wire::all_refusals())
    if (one.refusal != wire::Refusal::none)
      all.push_back({"Refusals of the stream", std::to_string(static_cast<int>(one.refusal)),
                     one.name, one.meaning, one.remedy});
  for (const RuleInfo& one : all_rules())
    all.push_back({"Findings of a check", "", one.rule, one.meaning, one.remedy});
  for (const ControllerError& one : controller_errors()) {
    const std::string here = one.here == std::string("none") ? "does not occur" : one.here;
    all.push_back({std::string("Errors of ") + one.controller + " for a cam", code_text(one), "",
                   one.meaning, here + ": " + one.how, true});
  }
  return all;
}

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

void print_markdown(const std::vector<Message>& all) {
  fmt::print(
      "# Messages\n\nAll numbers and names that an axis, an executor and the stream report. "
      "`jounce explain NAME`\n"
      "prints one of them, also the errors of controllers for cams ([their "
      "table](../cam/errors.md)).\n"
      "`jounce explain --markdown` prints this page.\n");
  std::vector<Message> own;
  std::copy_if(all.begin(), all.end(), std::back_inserter(own),
               [](const Message& one) { return !one.is_foreign; });
  for (const std::string& group : groups_of(own)) {
    fmt::print("\n## {}\n\n| no. | name | what happened | what to do |\n|---|---|---|---|\n",
               group);
    for (const Message& one : own)
      if (one.group == group)
        fmt::print("| {} | {} | {} | {} |\n", one.code,
                   one.code.empty() ? "`" + one.name + "`" : one.name, cell(one.meaning),
                   cell(one.remedy));
  }
}

void print_json(const std::vector<Message>& all) {
  nlohmann::ordered_json document = nlohmann::ordered_json::array();
  for (const Message& one : all)
    document.push_back({{"group", one.group},
                        {"code", one.code},
                        {"name", one.name},
                        {"meaning", one.meaning},
                        {"remedy", one.remedy}});
  fmt::print("{}\n", document.dump(1));
}

/// The number and the name, if there are any.
std::string title_of(const Message& one) {
  return one.code + (one.code.empty() || one.name.empty() ? "" : " ") + one.name;
}

void print_text(const std::vector<Message>& all) {
  for (const Message& one : all)
    fmt::print("{} ({})\n  {}\n  {}: {}\n", title_of(one), one.group, one.meaning,
               one.is_foreign ? "In Jounce" : "What to do", one.remedy);
}

void print_list(const std::vector<Message>& all) {
  for (const std::string& group : groups_of(all)) {
    fmt::print("{}:\n", group);
    for (const Message& one : all)
      if (one.group == group) fmt::print("  {:>6} {:<20} {}\n", one.code, one.name, one.meaning);
  }
}

/// The messages with this number or name.
std::vector<Message> matching(const std::vector<Message>& all, const std::string& code) {
  std::vector<Message> found;
  const RuleInfo* const rule = rule_info(code);
  const std::string name = rule != nullptr ? rule->rule : code;
  for (const Message& one : all)
    if (one.code == code || one.name == name) found.push_back(one);
  if (!found.empty()) return found;
  std::vector<std::string> names;
  for (const Message& one : all) names.push_back(one.name);
  const std::string meant = nearest(code, names);
  throw InputError(
      "CODE", code,
      "is not the number or name of a message: " +
          (meant.empty() ? "`jounce explain` lists all" : "did you mean " + meant + "?"));
}

int run_explain(const ExplainArguments& options) {
  const std::vector<Message> all = all_messages();
  const auto chosen = options.code.empty() ? all : matching(all, options.code);
  if (options.json)
    print_json(chosen);
  else if (options.markdown)
    print_markdown(chosen);
  else if (options.code.empty())
    print_list(chosen);
  else
    print_text(chosen);
  return fine;
}

}  // namespace

void add_explain(CommandLine& line) {
  const auto options = std::make_shared<ExplainArguments>();
  const Verb verb =
      line.verb("explain", "Explain a fault, a rejection, a finding, or an error of a controller",
                "jounce explain following_error");
  verb.option("CODE", options->code,
              "Number or name, as in a message, a log or a status; or the rule of a finding");
  verb.flag("--markdown", options->markdown, "All as a page (docs/reference/messages.md)");
  verb.flag("--json", options->json, "As JSON");
  verb.work([options] { return run_explain(*options); });
}

}  // namespace jounce::cli
