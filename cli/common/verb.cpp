// SPDX-License-Identifier: Apache-2.0
#include "cli/common/verb.hpp"

#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "jounce/about/command_words.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::cli {
namespace {

/// The name of an option on the command line: --output, FILE. Includes hidden options.
std::string name_of(const CLI::Option& option) {
  return option.get_lnames().empty() ? option.get_name(true) : "--" + option.get_lnames().front();
}

}  // namespace

const Option& Option::required() const {
  option_->required();
  return *this;
}

const Option& Option::check(ValueCheck check) const {
  if (!check.words.empty()) completed_by([words = check.words] { return words; });
  option_->check([option = option_, check = std::move(check)](const std::string& text) {
    require_value(name_of(*option), text);
    const std::string rule = check.broken_rule(text);
    if (!rule.empty()) throw InputError(name_of(*option), text, rule);
    return std::string();
  });
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

const Option& Option::completed_by(Words words) const {
  (*words_)[option_] = std::move(words);
  return *this;
}

Option Verb::option(const std::string& name, OptionTarget target, const std::string& help) const {
  CLI::Option* option = verb_->add_option(
      name,
      [target, name = name.substr(name.rfind(',') + 1)](const CLI::results_t& words) {
        require_value(name, words.back());
        if (const std::string rule = target.put(words); !rule.empty())
          throw InputError(name, words.front(), rule);
        return true;
      },
      help, false, [target] { return target.text(); });
  option->type_name(target.is_number() ? "number" : "value");
  if (target.is_list()) option->expected(CLI::detail::expected_max_vector_size);
  return {option, *words_};
}

Option Verb::flag(const std::string& name, bool& target, const std::string& help) const {
  return {verb_->add_flag(name, target, help)->disable_flag_override(), *words_};
}

Option Verb::axis(std::string& target) const {
  return option(
      "--axis", target,
      "Name of the axis in a spec with several axes, or of the cam in a file with several cams");
}

Option Verb::over(std::string& target) const {
  return option("--over", target,
                "master or time: show a cam over its master, or its slave over time with [master]")
      .check(one_of({"master", "time"}));
}

Option Verb::machine(std::string& target) const {
  return option(
      "--machine", target,
      "For a G-code program: spec of kind \"path\" with the axes and limits of the machine");
}

const Verb& Verb::hidden() const {
  verb_->group("");
  return *this;
}

void Verb::work(Work work) const {
  verb_->callback([chosen = chosen_, work = std::move(work)] { *chosen = work; });
}

}  // namespace jounce::cli
