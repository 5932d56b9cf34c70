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
  const char* note = "";  ///< a difference, as a clause; may be empty
};

/// All of them, in the order of the laws.
std::span<const LawAlias> law_aliases();

/// Returns the law that another tool calls `name`, in any case and with any spaces and signs: "Mod.
/// Sine", "poly-5". A law of Jounce in another spelling is found as well, but not its name itself.
/// Null if there is none.
const LawAlias* law_alias(std::string_view name);

/// `is called "inclined_sine" here`, with the note.
std::string rule_of(const LawAlias& alias);

}  // namespace jounce
