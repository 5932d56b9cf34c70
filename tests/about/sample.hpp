// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/about/program.hpp"

namespace jounce::about_test {

/// A program with two verbs, one option of each kind, and characters that are commands of roff.
inline ProgramInfo sample() {
  const auto formats = [] { return std::vector<std::string>{"json", "text", "junit"}; };
  const OptionInfo file{.names = {"FILE"},
                        .help = "Specs",
                        .value = OptionValue::text,
                        .required = true,
                        .repeated = true};
  return {
      .name = "tool",
      .description = "Check tables.",
      .notes = "Name files as arguments.",
      .exit_statuses = {{0, "success"}, {1, "a finding"}},
      .options = {{.names = {"--version"}, .help = "Print the version"}},
      .verbs = {{.name = "check",
                 .description = "Check limits",
                 .examples = {"tool check a.toml", ".b \\ 'c"},
                 .positionals = {file},
                 .options = {{.names = {"--format"},
                              .help = "Format",
                              .default_value = "text",
                              .value = OptionValue::text,
                              .words = formats},
                             {.names = {"--limit"},
                              .help = "Limit",
                              .value = OptionValue::text,
                              .repeated = true},
                             {.names = {"-n", "--count"},
                              .help = "'Count' of runs",
                              .value = OptionValue::number,
                              .required = true},
                             {.names = {"--strict"}, .help = "Strict"}}},
                {.name = "chart",
                 .description = "Draw",
                 .examples = {},
                 .positionals = {{.names = {"KIND"},
                                  .help = "Kind",
                                  .value = OptionValue::text,
                                  .required = false,
                                  .words = formats},
                                 {.names = {"OUT"}, .help = "File", .value = OptionValue::text}},
                 .options = {}}}};
}

}  // namespace jounce::about_test
