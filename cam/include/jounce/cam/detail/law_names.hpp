// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "jounce/cam/laws/law.hpp"

namespace jounce {

/// The name of a law in books, standards and the cam editors of controllers.
struct LawAlias {
  const char* name = "";  ///< "cycloidal"
  Law law = Law::line;
  const char* note = "";  ///< the difference from the law of Jounce, as a clause; may be empty
};

/// Returns all other names, in the order of the laws.
std::span<const LawAlias> law_aliases();

/// Returns the law that another tool calls `name`, in upper or lower case and with any spaces and
/// signs: "Mod. Sine", "poly-5". Also finds a law whose name in Jounce is spelled differently, such
/// as "Modified-Sine"; does not find a name in the spelling of Jounce. Returns null if no law has
/// the name.
const LawAlias* law_alias(std::string_view name);

/// Returns a clause for an error: `is called "inclined_sine" here`, with the note.
std::string rule_of(const LawAlias& alias);

}  // namespace jounce
