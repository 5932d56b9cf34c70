// SPDX-License-Identifier: Apache-2.0
#include "jounce/about/completion.hpp"

#include <memory>

#include <fmt/format.h>

#include "cli/common/verb.hpp"

namespace jounce::cli {

void add_completion(CommandLine& line) {
  const auto shell = std::make_shared<std::string>();
  const Verb verb = line.verb(
      "completion", "Print the script with which a shell completes verbs, options and values",
      "jounce completion bash > ~/.local/share/bash-completion/completions/jounce\n"
      "source <(jounce completion zsh)");
  verb.option("SHELL", *shell, "bash, fish or zsh").required().check(one_of(completion_shells()));
  verb.work([shell] {
    fmt::print("{}", completion_script(*shell));
    return fine;
  });
}

}  // namespace jounce::cli
