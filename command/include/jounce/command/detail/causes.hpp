// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "jounce/command/cause.hpp"

namespace jounce {

enum class CommandKind : std::uint8_t;

/// A cause in words, for the machine operator.
struct CauseInfo {
  Cause cause;                     ///< the cause
  const char* name;                ///< "following_error": the word in logs and messages
  const char* meaning;             ///< one sentence: what happened
  const char* remedy;              ///< one or two sentences: what the operator should do next
  const char* of_order = nullptr;  ///< remedy for an order; null: `remedy`
  const char* of_table = nullptr;  ///< remedy for a table; null: `remedy`
};

/// Returns the remedy for a rejected order of this kind: the part of CauseInfo::remedy that
/// concerns the order. The placeholder NAME stands for the axis or group.
std::string remedy_of_order(Cause cause, CommandKind kind);
/// Returns the remedy for a rejected table.
std::string remedy_of_table(Cause cause);

/// Returns one entry for each Cause, in the order of their numbers.
std::span<const CauseInfo> all_causes();

}  // namespace jounce
