// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/stream/message/message.hpp"

namespace jounce::wire {

/// A refusal in words, for the author of a streamer or the machine operator.
struct RefusalInfo {
  Refusal refusal;
  const char* name;
  const char* meaning;  ///< one sentence: the event
  const char* remedy;   ///< the next step of the operator
};

/// One entry for each Refusal, in the order of their numbers.
std::span<const RefusalInfo> all_refusals();

}  // namespace jounce::wire
