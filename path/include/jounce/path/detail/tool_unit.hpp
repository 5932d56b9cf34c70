// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "jounce/profiles/error.hpp"

namespace jounce {

/// Returns the error of a place on the path that the joints cannot take (key "point" or "start"), with the unit of its
/// numbers: the plan has only numbers. Other errors are unchanged.
inline InputError in_unit_of_tool(const InputError& error, const std::string& unit) {
  if (unit.empty() || (error.key() != "point" && error.key() != "start")) return error;
  std::string rule = error.rule();
  constexpr std::string_view place = " along the path";
  if (const std::size_t at = rule.find(place); at != std::string::npos) rule.insert(at, " " + unit);
  return InputError(error.key(), error.value() + " " + unit, rule)
      .at(error.document(), error.line());
}

}  // namespace jounce
