// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jounce {

/// An explanation of a rule of findings, for a person who reads a report. (sentence() in
/// report_text.hpp returns the sentence of a finding, with its numbers.)
struct RuleInfo {
  const char* rule;     ///< the rule, "limit/position_max", or a family of rules, "limit/*"
  const char* meaning;  ///< one sentence: what was found
  const char* remedy;   ///< one sentence: what to do
};

/// Returns the explanations of all rules, in families. Each finding has an entry for its rule or
/// for the family of the rule.
std::span<const RuleInfo> all_rules();

/// Returns the words that can follow the slash in a rule of a family that names a quantity
/// ("limit/*", "continuity/*"): "velocity", "geo_jerk", "position_max". Empty for any other family.
/// An optimum has further rules: the names of its figures, which contain a space.
std::vector<std::string> quantities_of(std::string_view family);

/// Returns the entry of a rule, or the entry of its family; null if neither has an entry.
const RuleInfo* rule_info(std::string_view rule);

}  // namespace jounce
