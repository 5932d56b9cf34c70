// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/limits/rule.hpp"

#include <algorithm>
#include <array>
#include <ostream>
#include <utility>

namespace jounce {
namespace {

/// In the order of the enum RuleFamily.
constexpr std::array<std::string_view, 30> families{
    "",         "limit",     "unlimited", "objective", "continuity", "table",
    "joint",    "kept",      "polydyne",  "warning",   "bound",      "identity",
    "coupling", "compare",   "disc",      "drive",     "feasible",   "fill",
    "follow",   "follower",  "gear",      "knife",     "shear",      "inverse",
    "pt",       "tolerance", "witness",   "played",    "fixed",      "constraint"};

/// The family with the name before the slash; `none` for any other name, and for a text without a
/// slash.
RuleFamily family_of(std::string_view text) {
  const auto slash = text.find('/');
  if (slash == std::string_view::npos) return RuleFamily::none;
  const auto found = std::find(families.begin(), families.end(), text.substr(0, slash));
  return found == families.end() ? RuleFamily::none
                                 : static_cast<RuleFamily>(found - families.begin());
}

}  // namespace

const char* name(RuleFamily family) noexcept {
  return families[static_cast<std::size_t>(family)].data();
}

Rule::Rule(std::string text) : family_(family_of(text)), text_(std::move(text)) {}

Rule::Rule(RuleFamily family, std::string_view name)
    : family_(family), text_(std::string(jounce::name(family)) + "/" + std::string(name)) {}

std::string_view Rule::name() const noexcept {
  const std::string_view text = text_;
  const auto slash = text.find('/');
  return slash == std::string_view::npos ? "" : text.substr(slash + 1);
}

std::ostream& operator<<(std::ostream& out, const Rule& rule) {
  return out << rule.text();
}

}  // namespace jounce
