// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>

namespace jounce {

/// The family of a rule: the first word of its text, before the slash.
enum class RuleFamily : std::uint8_t {
  none,        ///< no rule
  limit,       ///< a quantity against its limit
  unlimited,   ///< the peak of a quantity that has no limit
  objective,   ///< the place where a quantity that is minimized has its peak
  continuity,  ///< a step at a break, against the required order of continuity
  table,       ///< a table against its exact curve
  joint,       ///< a permitted step at a break
  kept,        ///< a step that an optimization left as it was
  polydyne,    ///< a cam for a load on a spring
  warning,     ///< perhaps not intended: an overshoot, a reversal
  bound,       ///< a figure against its least possible value
  identity,    ///< an integral against its exact value
  coupling,    ///< engaging and disengaging a cam
  compare,     ///< position compare
  disc,        ///< the plate of a disc cam
  drive,       ///< a servo drive
  feasible,    ///< a slave in step, at the speeds of its master
  fill,        ///< knots that are filled in
  follow,      ///< table of segments over the master's travel (follow table)
  follower,    ///< a cam follower
  gear,        ///< gears
  knife,       ///< a rotary knife
  shear,       ///< a flying shear
  inverse,     ///< the inverse of a cam
  pt,          ///< PT tables: points over time, with linear velocity
  tolerance,   ///< a drive, with the tolerances of its parameters
  witness,     ///< an independent integration, against the exact curve
  played,      ///< the log of an executor against its table
  fixed,       ///< a value that a spec fixes at an end of a free shape
  constraint,  ///< a constraint of a search
};

/// Returns the family as a word: "limit", "continuity", ...; "" for RuleFamily::none.
const char* name(RuleFamily family) noexcept;

/// The rule of a finding, a stable identifier for programs: "limit/position_max".
///
///     if (finding.rule.family() == RuleFamily::limit) ...
///     if (finding.rule == "table/position") ...
///
/// The word after the slash is a quantity ("limit/geo_velocity"), one side of it
/// ("limit/position_max"), or an event ("knife/reversal"). `jounce explain RULE` prints the meaning
/// (report/rules.hpp).
class Rule {
 public:
  Rule() = default;
  /// Makes a rule from its text. "" is no rule. If the word before the slash is not the name of a
  /// family, the family is `none`.
  Rule(const char* text) : Rule(std::string(text)) {}
  Rule(std::string text);
  Rule(RuleFamily family, std::string_view name);

  /// The family; the word after the slash; the whole text.
  [[nodiscard]] RuleFamily family() const noexcept { return family_; }
  [[nodiscard]] std::string_view name() const noexcept;
  [[nodiscard]] const std::string& text() const noexcept { return text_; }

  bool operator==(const Rule&) const = default;

 private:
  RuleFamily family_ = RuleFamily::none;
  std::string text_;
};

std::ostream& operator<<(std::ostream& out, const Rule& rule);

}  // namespace jounce
