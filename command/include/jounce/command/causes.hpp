// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/command/cause.hpp"

namespace jounce {

/// A cause in words, for the machine operator.
struct CauseInfo {
  Cause cause;          ///< the cause
  const char* name;     ///< "following_error": the word in logs and messages
  const char* meaning;  ///< one sentence: what happened
  const char* remedy;   ///< one or two sentences: what the operator should do next
};

/// Returns one entry for each Cause, in the order of their numbers.
std::span<const CauseInfo> all_causes();

}  // namespace jounce
