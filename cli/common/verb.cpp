// SPDX-License-Identifier: Apache-2.0
#include "cli/common/verb.hpp"

#include <filesystem>
#include <optional>
#include <type_traits>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "jounce/about/command_words.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::cli {
namespace {

/// Puts a word into the target. Returns the rule that the word breaks, or "".
template <class Target>
std::string put(const std::string& word, Target& target) {
  if constexpr (std::is_assignable_v<Target&, const std::string&>) {
    target = word;
    return "";
  } else {
    if (std::is_unsigned_v<Target> && word.starts_with('-'))
      return "must be a number of at least 0";
    const auto number = number_in<Target>(word);
    if (number) target = *number;
    return number ? "" : "must be a number";
  }
}

template <class Target>
std::string put(const std::string& word, std::optional<Target>& target) {
  return put(word, target.emplace());
}

template <class Target>
std::string shown_of(const Target& target) {
  if constexpr (std::is_arithmetic_v<Target>) return fmt::format("{}", target);
  if constexpr (std::is_same_v<Target, std::string>) return target;
  return "";
}

/// The name of an option on the command line: --output, FILE. Includes hidden options.
std::string name_of(const CLI::Option& option) {
  return option.get_lnames().empty() ? option.get_name(true) : "--" + option.get_lnames().front();
}

template <class Target>
constexpr bool is_list = std::is_same_v<Target, std::vector<std::string>>;

template <class Target>
constexpr bool is_text = is_list<Target> || std::is_same_v<Target, std::string> ||
                         std::is_same_v<Target, std::optional<std::filesystem::path>>;

}  // namespace

const Option& Option::required() const {
  option_->required();
  return *this;
}

const Option& Option::check(ValueCheck check) const {
  if (!check.words.empty()) completed_by([words = check.words] { return words; });
  option_->check([option = option_, check = std::move(check)](const std::string& text) {
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

template <class Target>
Option Verb::option(const std::string& name, Target& target, const std::string& help) const {
  CLI::Option* option = verb_->add_option(
      name,
      [&target, name](const CLI::results_t& words) {
        if (name[0] == '-' && looks_like_option(words.back()))
          throw InputError(name.substr(name.rfind(',') + 1), "", "has no value after it");
        if constexpr (is_list<Target>) {
          target = words;
        } else if (const std::string rule = put(words.front(), target); !rule.empty()) {
          throw InputError(name.substr(name.rfind(',') + 1), words.front(), rule);
        }
        return true;
      },
      help, false, [&target] { return shown_of(target); });
  option->type_name(is_text<Target> ? "value" : "number");
  if constexpr (is_list<Target>) option->expected(CLI::detail::expected_max_vector_size);
  return {option, *words_};
}

// All types that the verbs use.
template Option Verb::option(const std::string&, std::string&, const std::string&) const;
template Option Verb::option(const std::string&, std::vector<std::string>&,
                             const std::string&) const;
template Option Verb::option(const std::string&, double&, const std::string&) const;
template Option Verb::option(const std::string&, int&, const std::string&) const;
template Option Verb::option(const std::string&, std::int64_t&, const std::string&) const;
template Option Verb::option(const std::string&, unsigned&, const std::string&) const;
template Option Verb::option(const std::string&, std::uint64_t&, const std::string&) const;
template Option Verb::option(const std::string&, std::optional<double>&, const std::string&) const;
template Option Verb::option(const std::string&, std::optional<std::int32_t>&,
                             const std::string&) const;
template Option Verb::option(const std::string&, std::optional<std::uint16_t>&,
                             const std::string&) const;
template Option Verb::option(const std::string&, std::optional<std::size_t>&,
                             const std::string&) const;
template Option Verb::option(const std::string&, std::optional<std::filesystem::path>&,
                             const std::string&) const;

Option Verb::flag(const std::string& name, bool& target, const std::string& help) const {
  return {verb_->add_flag(name, target, help), *words_};
}

Option Verb::axis(std::string& target) const {
  return option(
      "--axis", target,
      "Name of the axis in a spec with several axes, or of the cam in a file with several cams");
}

Option Verb::over(std::string& target) const {
  return option("--over", target,
                "Show a cam over its master, or the slave over time with the [master] of the spec")
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
