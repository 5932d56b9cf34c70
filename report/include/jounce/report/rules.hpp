// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace jounce {

/// A rule of a Finding in words, for a person who reads a report. Its sentence, with the numbers: sentence() of
/// report_text.hpp.
struct RuleInfo {
  const char* rule;     ///< "limit/position_max", or a family: "limit/*"
  const char* meaning;  ///< one sentence: what was found
  const char* remedy;   ///< the next step
};

/// All rules, by family; the rule of each Finding has a row, or its family has one.
std::span<const RuleInfo> all_rules();

/// The row of a rule, by its text: its own, otherwise that of its family; nullptr if there is none.
const RuleInfo* rule_info(std::string_view rule);

}  // namespace jounce
