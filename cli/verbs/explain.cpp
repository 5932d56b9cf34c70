// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "jounce/command/causes.hpp"
#include "jounce/controllers/controller_errors.hpp"
#include "jounce/report/messages.hpp"
#include "jounce/report/rules.hpp"
#include "jounce/stream/message/refusals.hpp"

#include "cli/common/json.hpp"
#include "cli/common/option_names.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct ExplainArguments {
  std::string code;
  bool markdown = false;
  bool json = false;
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
    all.push_back({std::string("Errors of ") + one.controller + " for cams and gears",
                   code_text(one), "", one.meaning, here + ": " + one.how, true});
  }
  return all;
}

std::vector<Message> named(const std::vector<Message>& all, const std::string& code) {
  return under_option("CODE", [&] { return messages_named(all, code); });
}

int run_explain(const ExplainArguments& options) {
  const std::vector<Message> all = all_messages();
  if (options.code.empty() && !options.json) {
    fmt::print("{}", options.markdown ? messages_markdown(all) : messages_list(all));
    return fine;
  }
  const auto chosen = options.code.empty() ? all : named(all, options.code);
  if (options.json)
    print_json(Json::parse(messages_json(chosen)));
  else
    fmt::print("{}", options.markdown ? messages_markdown(chosen) : messages_text(chosen));
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
  verb.flag("--markdown", options->markdown, "Print all as a page (docs/reference/messages.md)");
  verb.flag("--json", options->json, "As JSON");
  verb.work([options] { return run_explain(*options); });
}

}  // namespace jounce::cli
