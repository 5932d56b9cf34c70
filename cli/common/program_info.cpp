// SPDX-License-Identifier: Apache-2.0
#include "cli/common/program_info.hpp"

#include <sstream>

#include <CLI/CLI.hpp>

namespace jounce::cli {
namespace {

OptionInfo option_info(const CLI::Option& option, const WordsOfOptions& words) {
  OptionInfo info;
  info.help = option.get_description();
  info.default_value = option.get_default_str();
  info.required = option.get_required();
  info.repeated = option.get_items_expected_max() > 1;
  for (const std::string& name : option.get_snames()) info.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) info.names.push_back("--" + name);
  if (option.get_positional()) info.names = {option.get_name(true)};
  if (option.get_items_expected_max() > 0)
    info.value = option.get_type_name() == "number" ? OptionValue::number : OptionValue::text;
  for (const auto* other : option.get_needs()) info.needs.push_back(other->get_name());
  for (const auto* other : option.get_excludes()) info.excludes.push_back(other->get_name());
  if (const auto found = words.find(&option); found != words.end()) info.words = found->second;
  return info;
}

/// The examples of the footer of a verb: its lines after "Example:".
std::vector<std::string> examples_of(const CLI::App& verb) {
  std::vector<std::string> lines;
  std::istringstream footer(verb.get_footer());
  std::string line;
  std::getline(footer, line);
  while (std::getline(footer, line)) lines.push_back(line.substr(2));
  return lines;
}

}  // namespace

ProgramInfo program_info(const CLI::App& app, const WordsOfOptions& words) {
  ProgramInfo info{.name = app.get_name(),
                   .description = app.get_description(),
                   .notes = notes,
                   .exit_statuses = exit_statuses,
                   .options = {},
                   .verbs = {}};
  for (const auto* option : app.get_options()) info.options.push_back(option_info(*option, words));
  for (const auto* verb : app.get_subcommands({})) {
    if (verb->get_group().empty()) continue;
    VerbInfo& added = info.verbs.emplace_back(
        VerbInfo{verb->get_name(), verb->get_description(), examples_of(*verb), {}, {}});
    for (const auto* option : verb->get_options())
      if (!option->get_group().empty())
        (option->get_positional() ? added.positionals : added.options)
            .push_back(option_info(*option, words));
  }
  return info;
}

}  // namespace jounce::cli
