// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/stream/message/message.hpp"

namespace jounce::wire {

/// A refusal with an explanation, for the author of a streamer and the operator of a machine.
struct RefusalInfo {
  Refusal refusal;      ///< the refusal
  const char* name;     ///< its name
  const char* meaning;  ///< one sentence: what happened
  const char* remedy;   ///< the next step of the operator
};

/// Returns one entry for each Refusal, in the order of their numbers.
std::span<const RefusalInfo> all_refusals();

}  // namespace jounce::wire
