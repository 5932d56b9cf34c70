// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "jounce/machine/detail/message_catalog.hpp"
#include "jounce/report/detail/messages.hpp"

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
    print_json(messages_json(chosen));
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
              "Number or name, as in a message, a log or a status; or the rule of a finding")
      .completed_by([] { return message_names(all_messages()); });
  const Option markdown = verb.flag("--markdown", options->markdown,
                                    "Print all as a page (docs/reference/messages.md)");
  verb.flag("--json", options->json, "As JSON").excludes({markdown});
  verb.work([options] { return run_explain(*options); });
}

}  // namespace jounce::cli
