#include "verb.hpp"

#include <algorithm>
#include <filesystem>
#include <span>
#include <system_error>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "jounce/io/nearest.hpp"
#include "jounce/io/table_file.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::cli {
namespace {

/// Help for people: a wide enough column, no type names in capitals beside every option.
class Help : public CLI::Formatter {
 public:
  Help() { column_width(34); }
  std::string make_option_opts(const CLI::Option* option) const override {
    std::string text;
    if (option->get_required()) return text;
    if (!option->get_default_str().empty()) text += " [" + option->get_default_str() + "]";
    return text;
  }
};

/// What was wrong with the command line, with the nearest verb or option where one is near.
std::string complaint(const CLI::App& app, const CLI::ParseError& error, std::span<char*> words) {
  std::vector<std::string> verbs;
  for (const auto* verb : app.get_subcommands({})) verbs.push_back(verb->get_name());
  const std::string given = words.size() > 1 ? words[1] : "";
  if (given.empty()) return "no verb given";
  const auto ask = [](const std::string& near) {
    return near.empty() ? "" : ". Did you mean " + near + "?";
  };
  const bool is_verb = std::find(verbs.begin(), verbs.end(), given) != verbs.end();
  if (!is_verb && given[0] != '-')
    return "`" + given + "` is not a verb" + ask(nearest(given, verbs));

  std::vector<std::string> options;
  for (const auto* option : (is_verb ? app.get_subcommand(given) : &app)->get_options())
    for (const auto& name : option->get_lnames()) options.push_back("--" + name);
  for (const std::string word : words.subspan(is_verb ? 2 : 1)) {
    const std::string name = word.substr(0, word.find('='));
    if (!name.starts_with("--") || std::find(options.begin(), options.end(), name) != options.end())
      continue;
    return "`" + name + "` is not an option here" + ask(nearest(name, options));
  }
  return error.what();
}

}  // namespace

Check one_of(std::vector<std::string> words) {
  return [words = std::move(words)](const std::string& text) {
    if (std::find(words.begin(), words.end(), text) != words.end()) return std::string();
    return text + " not in {" + fmt::format("{}", fmt::join(words, ",")) + "}";
  };
}

Check whole(std::int64_t low, std::int64_t high) {
  return [=](const std::string& text) {
    std::int64_t value = 0;
    const bool good = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
    return good ? std::string() : fmt::format("Value {} not in range {} to {}", text, low, high);
  };
}

Check within(double low, double high) {
  return [=](const std::string& text) {
    const auto value = number_in(text);
    const bool good = value && *value >= low && *value <= high;
    return good ? std::string() : fmt::format("`{}` is not from {} to {}", text, low, high);
  };
}

Check seconds() {
  return [](const std::string& text) {
    const auto value = number_in(text);
    const bool good = value && *value >= 1e-3 && *value <= 1e12;
    return good ? std::string() : "`" + text + "` is not a number of seconds, 0.001 or more";
  };
}

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  return CLI::detail::lexical_cast(text, value) ? std::optional(value) : std::nullopt;
}

const Option& Option::required() const {
  option_->required();
  return *this;
}

const Option& Option::check(Check check) const {
  option_->check(check);
  return *this;
}

const Option& Option::shown() const {
  option_->capture_default_str();
  return *this;
}

const Option& Option::hidden() const {
  option_->group("");
  return *this;
}

const Option& Option::one_each() const {
  option_->allow_extra_args(false);
  return *this;
}

const Option& Option::separated() const {
  option_->delimiter(',');
  return *this;
}

const Option& Option::needs(const Option& other) const {
  option_->needs(other.option_);
  return *this;
}

const Option& Option::excludes(const std::vector<Option>& others) const {
  for (const Option& other : others) option_->excludes(other.option_);
  return *this;
}

template <class Target>
Option Verb::option(const std::string& name, Target& target, const std::string& help) const {
  return Option(verb_->add_option(name, target, help));
}

// All that the verbs take.
template Option Verb::option(const std::string&, std::string&, const std::string&) const;
template Option Verb::option(const std::string&, std::vector<std::string>&,
                             const std::string&) const;
template Option Verb::option(const std::string&, double&, const std::string&) const;
template Option Verb::option(const std::string&, int&, const std::string&) const;
template Option Verb::option(const std::string&, std::int64_t&, const std::string&) const;
template Option Verb::option(const std::string&, unsigned&, const std::string&) const;
template Option Verb::option(const std::string&, std::uint64_t&, const std::string&) const;
template Option Verb::option(const std::string&, std::optional<double>&, const std::string&) const;
template Option Verb::option(const std::string&, std::optional<int>&, const std::string&) const;
template Option Verb::option(const std::string&, std::optional<std::uint16_t>&,
                             const std::string&) const;
template Option Verb::option(const std::string&, std::optional<std::size_t>&,
                             const std::string&) const;
template Option Verb::option(const std::string&, std::optional<std::filesystem::path>&,
                             const std::string&) const;

Option Verb::flag(const std::string& name, bool& target, const std::string& help) const {
  return Option(verb_->add_flag(name, target, help));
}

Option Verb::axis(std::string& target) const {
  return option("--axis", target, "NAME: this axis only, of a spec with several");
}

void Verb::work(Work work) const {
  verb_->callback([chosen = chosen_, work = std::move(work)] { *chosen = work; });
}

CommandLine::CommandLine()
    : app_(std::make_unique<CLI::App>("Design, check, optimise, prove and play motion tables.",
                                      "jounce")) {
  app_->formatter(std::make_shared<Help>());
  app_->set_version_flag("--version", made_by());
  app_->require_subcommand(1);
  app_->footer(
      "Files are named as arguments; - is standard input or output, so verbs pipe.\n"
      "Exit status: 0 fine, 1 a finding, 2 bad input or usage, 3 a fault of the machine.\n"
      "jounce VERB --help shows an example of each verb.");
}

CommandLine::~CommandLine() = default;

Verb CommandLine::verb(const std::string& name, const std::string& description,
                       const std::string& examples) {
  CLI::App* verb = app_->add_subcommand(name, description);
  std::string lines = "Example:\n" + examples;
  for (std::size_t at = 0; (at = lines.find('\n', at)) != std::string::npos; at += 3)
    lines.insert(at + 1, "  ");
  verb->footer(lines);
  return Verb(*verb, chosen_);
}

int CommandLine::run(int argc, char** argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", app_->help());
    return fine;
  } catch (const CLI::CallForVersion&) {
    fmt::print("{}\n", made_by());
    return fine;
  } catch (const CLI::ParseError& error) {
    const std::span<char*> words(argv, static_cast<std::size_t>(argc));
    fmt::print(stderr, "jounce: {} (jounce --help shows all)\n", complaint(*app_, error, words));
    return bad_input;
  }
  return chosen_();
}

void require_other_file(const std::string& input, const std::string& output) {
  std::error_code none;  // a file that is not there is another one
  if (input != "-" && output != "-" && std::filesystem::equivalent(input, output, none))
    throw InputError("--output", output,
                     "is the input: it would be replaced by what is made from it");
}

}  // namespace jounce::cli
