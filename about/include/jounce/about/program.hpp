// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

/// The command line of a program as data. The manual pages (man_page.hpp) and the completion in
/// shells (completion.hpp) are computed from it.
namespace jounce {

/// Kind of value that an option takes.
enum class OptionValue { none, number, text };

/// An option of a verb, or one of its positional arguments.
struct OptionInfo {
  /// "-o", "--output"; for a positional argument, one name such as "FILE".
  std::vector<std::string> names{};
  std::string help{};
  std::string default_value{};  ///< "" if the help does not show one
  OptionValue value = OptionValue::none;
  bool required = false;
  bool repeated = false;  ///< accepts more than one value
  /// Returns the permitted words; without it, any value is permitted.
  std::function<std::vector<std::string>()> words{};
  std::vector<std::string> needs{}, excludes{};  ///< names of other options of the verb
};

/// A verb (subcommand).
struct VerbInfo {
  std::string name{}, description{};
  std::vector<std::string> examples{};  ///< one line each
  std::vector<OptionInfo> positionals{}, options{};
};

/// A program: its options, its verbs, and the texts of its help.
struct ProgramInfo {
  std::string name{}, description{}, notes{};
  std::vector<std::pair<int, std::string>> exit_statuses{};  ///< numbers and meanings
  std::vector<OptionInfo> options{};  ///< options without a verb, such as --version
  std::vector<VerbInfo> verbs{};

  /// The verb of this name; nullptr if there is none.
  [[nodiscard]] const VerbInfo* verb(const std::string& verb_name) const;
};

}  // namespace jounce
