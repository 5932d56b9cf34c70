// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <span>
#include <sstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "jounce/about/build_info.hpp"
#include "jounce/about/command_words.hpp"
#include "jounce/about/completion.hpp"
#include "jounce/base/detail/printable.hpp"
#include "jounce/profiles/error.hpp"

#include "cli/common/program_info.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

/// Help for people: a wide column, lines that fit, no type names in capitals. An option that takes a value shows its
/// default, or three dots.
class Help : public CLI::Formatter {
 public:
  Help() { column_width(column); }
  std::string make_option_opts(const CLI::Option* option) const override {
    if (option->get_positional() || option->get_items_expected_max() == 0) return "";
    if (option->get_default_str().empty()) return " ...";
    return " [" + option->get_default_str() + "]";
  }
  std::string make_option_desc(const CLI::Option* option) const override {
    const bool needed = option->get_required() && !option->get_positional();
    return wrapped((needed ? "Required. " : "") + option->get_description(), line - column);
  }
  std::string make_subcommand(const CLI::App* verb) const override {
    std::ostringstream out;
    CLI::detail::format_help(out, verb->get_name(), wrapped(verb->get_description(), line - column),
                             column);
    return out.str();
  }
  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override {
    std::string text = CLI::Formatter::make_help(app, std::move(name), mode);
    for (std::size_t at; (at = text.find("\n\n\n")) != std::string::npos;) text.erase(at, 1);
    return text;
  }

 private:
  static constexpr std::size_t column = 34, line = 104;
};

/// The names of the options of a verb or of the program, also of the hidden ones.
std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const auto* option : app.get_options()) {
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
    for (const auto& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

/// The error of the command line, with the nearest verb or option if there is one, and the command that lists all.
std::string complaint(const CLI::App& app, const CLI::ParseError& error,
                      std::span<const char* const> words, const ProgramInfo& program) {
  std::vector<std::string> verbs;
  for (const auto* verb : app.get_subcommands({})) verbs.push_back(verb->get_name());
  const std::string all = " (see jounce --help)";
  if (const std::string wrong = wrong_verb(words, verbs); !wrong.empty()) return wrong + all;
  const std::string given = words.front();
  const bool is_verb = given[0] != '-';
  const CLI::App& asked = is_verb ? *app.get_subcommand(given) : app;
  const std::string wrong = wrong_option(words, option_names(asked), program, is_verb ? given : "");
  const bool is_extra = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
  const auto* const verb = program.verb(given);
  return (wrong.empty() ? parser_sentence(error.what(), is_extra, words, verb) : wrong) +
         (is_verb ? " (see jounce " + given + " --help)" : all);
}

}  // namespace

CommandLine::CommandLine()
    : app_(std::make_unique<CLI::App>("Design, check, optimize, prove and play motion tables.",
                                      "jounce")) {
  app_->formatter(std::make_shared<Help>());
  CLI::Option* version = app_->set_version_flag("--version", "", "Print the version and the build");
  app_->add_flag("--json")
      ->description("With --version: as JSON")
      ->needs(version)
      ->disable_flag_override();
  app_->require_subcommand(1);
  std::vector<std::string> statuses;
  for (const auto& [status, meaning] : exit_statuses)
    statuses.push_back(fmt::format("{} {}", status, meaning));
  app_->footer(
      fmt::format("{}\nExit status: {}.\njounce VERB --help shows an example of each verb.", notes,
                  fmt::join(statuses, ", ")));
}

CommandLine::~CommandLine() = default;

ProgramInfo CommandLine::info() const {
  return program_info(*app_, words_);
}

Verb CommandLine::verb(const std::string& name, const std::string& description,
                       const std::string& examples) {
  CLI::App* verb = app_->add_subcommand(name, description);
  std::string lines = "Example:\n" + examples;
  for (std::size_t at = 0; (at = lines.find('\n', at)) != std::string::npos; at += 3)
    lines.insert(at + 1, "  ");
  verb->footer(lines);
  return {*verb, chosen_, words_};
}

int CommandLine::run(int argc, char** argv) {
  if (argc > 1 && argv[1] == std::string("__complete")) {  // asked by the scripts of the shells
    fmt::print("{}", completion_lines(complete(info(), {argv + 2, argv + argc})));
    return fine;
  }
  const std::span<const char* const> given(argv + 1, argv + argc);
  try {
    std::vector<std::string> words = meant_words(given);
    std::reverse(words.begin(), words.end());  // the order of the parser
    app_->parse(std::move(words));
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", app_->help());
    return fine;
  } catch (const CLI::CallForVersion&) {
    const bool json = app_->count("--json") > 0;
    fmt::print("{}", json ? build_json(build_info()) : build_text(build_info()));
    return fine;
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "jounce: {}\n", printable_lines(complaint(*app_, error, given, info())));
    return bad_input;
  }
  return chosen_();
}

}  // namespace jounce::cli
