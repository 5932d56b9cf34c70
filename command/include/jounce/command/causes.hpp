// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/command/cause.hpp"

namespace jounce {

/// A cause in words, for the machine operator.
struct CauseInfo {
  Cause cause;
  const char* name;     ///< "following_error": the word of logs and messages
  const char* meaning;  ///< one sentence: the event
  const char* remedy;   ///< the next step of the operator
};

/// One entry for each Cause, in the order of their numbers.
std::span<const CauseInfo> all_causes();

}  // namespace jounce
