// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/stream/message/message.hpp"

namespace jounce::wire {

/// A refusal in words, for who writes a streamer or stands at the machine.
struct RefusalInfo {
  Refusal refusal;
  const char* name;
  const char* meaning;  ///< one sentence: what happened
  const char* remedy;   ///< the next step of the operator
};

/// One for each Refusal, in the order of their numbers.
std::span<const RefusalInfo> all_refusals();

}  // namespace jounce::wire
