// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Rules for the values of a command line:
///
///     const ValueCheck check = checks::whole(1, 4);
///     if (const std::string rule = check("5"); !rule.empty()) ...   // "must be a whole number ..."
namespace jounce {

/// A rule for the value of an option: a function that returns the broken rule, such as "must be a
/// whole number from 1 to 4", or "".
struct ValueCheck {
  template <class Rule>
  ValueCheck(Rule rule) : broken_rule(std::move(rule)) {}  // NOLINT(google-explicit-constructor)

  std::string operator()(const std::string& text) const { return broken_rule(text); }

  std::function<std::string(const std::string& text)> broken_rule;
  std::vector<std::string> words;  ///< all permitted words, if they can be listed
};

namespace checks {

/// One of these words. The rule names the nearest word.
ValueCheck one_of(std::vector<std::string> words);
/// A whole number from `low` to `high`, both included. `what`: its meaning, such as "a tick, ".
ValueCheck whole(std::int64_t low, std::int64_t high, const std::string& what = "");
/// A number from `low` to `high`, both included; nan is rejected.
ValueCheck within(double low, double high);
/// A number of seconds, from 0.001 to 1e12.
ValueCheck seconds();
/// A number of seconds from `low` to `high`, both included; or 0, which means none.
ValueCheck seconds_or_none(double low, double high);

/// A file to write. If its name has an extension, it must be one of `endings`; {}: any extension.
ValueCheck ends_in(std::vector<std::string> endings);
/// A file that is written after long work. In addition to the rule of ends_in(), it must not be a
/// folder, and its own folder must exist. "-" is standard output.
ValueCheck output_file(std::vector<std::string> endings = {});
/// A folder that is made after long work, if it does not exist: it must not be a file, nor in one.
ValueCheck output_folder();

}  // namespace checks

/// The whole text as a number: double in the syntax of strtod; whole numbers are decimal, also with
/// leading zeros. nullopt if the text is not a number, or if a whole number is out of the range of
/// its type. value_check.cpp lists the types.
template <class Number = double>
std::optional<Number> number_in(const std::string& text);

}  // namespace jounce
