// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <span>
#include <sstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "jounce/about/build_info.hpp"
#include "jounce/about/completion.hpp"
#include "jounce/base/nearest.hpp"
#include "jounce/base/printable.hpp"
#include "jounce/profiles/error.hpp"

#include "cli/common/program_info.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

/// Breaks a text at its spaces into lines of at most `width` characters.
std::string wrapped(std::string text, std::size_t width) {
  for (std::size_t begin = 0; text.size() - begin > width;) {
    std::size_t at = text.rfind(' ', begin + width);
    if (at == std::string::npos || at <= begin) at = text.find(' ', begin);
    if (at == std::string::npos) break;
    text[at] = '\n';
    begin = at + 1;
  }
  return text;
}

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

/// True for "-x" and "--x"; false for "-" and for a negative number.
bool looks_like_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && (word[1] == '-' || std::isalpha(word[1]) != 0);
}

InputError empty_argument(const std::vector<std::string>& words, std::size_t i) {
  const bool named = i > 0 && looks_like_option(words[i - 1]);
  return {named ? words[i - 1] : "argument " + std::to_string(i + 1), "",
          "is empty: write a value, or leave it out if it is optional"};
}

/// The words in the order of the parser, last first. Rejects "--log=", which has no value: the parser would take the
/// next word. Turns -.5 into -0.5: the parser would take it for an option.
std::vector<std::string> meant(std::span<char*> given) {
  std::vector<std::string> words(given.begin(), given.end());
  const auto end = std::find(words.begin(), words.end(), "--");
  for (std::string& word : std::span(words.begin(), end)) {
    if (word.empty()) throw empty_argument(words, static_cast<std::size_t>(&word - words.data()));
    if (word.starts_with("--") && word.ends_with('='))
      throw InputError(word.substr(0, word.size() - 1), "", "has no value after =");
    if (word.size() > 2 && word.starts_with("-.") && std::isdigit(word[2]) != 0)
      word.insert(1, "0");
  }
  std::reverse(words.begin(), words.end());
  return words;
}

/// A sentence on the first word that looks like an option and is none; "" if there is none.
std::string stranger(const CLI::App& app, const std::string& owner, std::span<char*> words) {
  std::vector<std::string> options;
  for (const auto* option : app.get_options()) {
    for (const auto& name : option->get_lnames()) options.push_back("--" + name);
    for (const auto& name : option->get_snames()) options.push_back("-" + name);
  }
  for (const std::string word : words) {
    const std::string name = word.substr(0, word.find('='));
    if (!looks_like_option(name) ||
        std::find(options.begin(), options.end(), name) != options.end())
      continue;
    if ((name == "-o" || name == "--output") && app.get_option_no_throw("OUT") != nullptr)
      return "`" + name + "` is not an option of this verb: name the output as the second argument";
    const std::string near = name.size() > 2 ? nearest(name, options) : "";
    return "`" + name + "` is not an option of " + owner +
           (near.empty() ? "" : ": did you mean " + near + "?");
  }
  return "";
}

/// The parser's sentence, in the words of the other messages: what is missing, or one too many.
std::string words_of(const CLI::ParseError& error) {
  std::string text = error.what();
  if (const std::string excludes = " excludes "; text.find(excludes) != std::string::npos)
    return text.replace(text.find(excludes), excludes.size(), " cannot be combined with ");
  if (const auto most = text.find(": At Most 1 required"); most != std::string::npos)
    return text.substr(0, most) + " is given twice";
  const std::string valueless = ": 1 required value missing";
  if (text.ends_with(valueless))
    return text.substr(0, text.size() - valueless.size()) + " has no value after it";
  const std::string required = " is required";
  if (text.ends_with(required))
    return text.substr(0, text.size() - required.size()) + " is missing";
  if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::ExtrasError)) return text;
  const std::size_t colon = text.find(": ");
  return "`" + text.substr(colon == std::string::npos ? 0 : colon + 2) +
         "` is one argument too many";
}

/// The error of the command line, with the nearest verb or option if there is one, and the command that lists all.
std::string complaint(const CLI::App& app, const CLI::ParseError& error, std::span<char*> words) {
  std::vector<std::string> verbs;
  for (const auto* verb : app.get_subcommands({})) verbs.push_back(verb->get_name());
  const std::string given = words.size() > 1 ? words[1] : "";
  const std::string all = " (see jounce --help)";
  if (given.empty()) return "the verb is missing" + all;
  const bool is_verb = std::find(verbs.begin(), verbs.end(), given) != verbs.end();
  if (!is_verb && given[0] != '-') {
    const std::string near = nearest(given, verbs);
    return "`" + given + "` is not a verb" + (near.empty() ? "" : ": did you mean " + near + "?") +
           all;
  }
  const CLI::App& asked = is_verb ? *app.get_subcommand(given) : app;
  const std::string strange =
      stranger(asked, is_verb ? "this verb" : "jounce", words.subspan(is_verb ? 2 : 1));
  return (strange.empty() ? words_of(error) : strange) +
         (is_verb ? " (see jounce " + given + " --help)" : all);
}

}  // namespace

CommandLine::CommandLine()
    : app_(std::make_unique<CLI::App>("Design, check, optimize, prove and play motion tables.",
                                      "jounce")) {
  app_->formatter(std::make_shared<Help>());
  CLI::Option* version = app_->set_version_flag("--version", "", "Print the version and the build");
  app_->add_flag("--json")->description("With --version: as JSON")->needs(version);
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
  try {
    app_->parse(meant(std::span(argv, static_cast<std::size_t>(argc)).subspan(1)));
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", app_->help());
    return fine;
  } catch (const CLI::CallForVersion&) {
    const bool json = app_->count("--json") > 0;
    fmt::print("{}", json ? build_json(build_info()) : build_text(build_info()));
    return fine;
  } catch (const CLI::ParseError& error) {
    const std::span<char*> words(argv, static_cast<std::size_t>(argc));
    fmt::print(stderr, "jounce: {}\n", printable_lines(complaint(*app_, error, words)));
    return bad_input;
  }
  return chosen_();
}

}  // namespace jounce::cli
