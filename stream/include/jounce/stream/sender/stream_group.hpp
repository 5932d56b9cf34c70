// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "jounce/stream/sender/driver.hpp"

namespace jounce {

/// Options of a group.
struct GroupOptions {
  SenderOptions sender = {};  ///< times of each stream
  /// Common tick of the start; -1: `lead` after the newest known tick.
  std::int64_t tick = -1;
  /// For tick -1: time for all axes to accept the start.
  Nanos lead = std::chrono::milliseconds(300);
  bool watch = true;  ///< true: ends when all motions have ended; false: when all have begun
};

/// Streams to several axes of one machine whose motions start together: sends all tables, arms all
/// axes, and starts them in the same tick. If one axis rejects a message, no axis starts. If one
/// axis later fails to start, stops or has a fault, the others stop, too. Axes of different machines are
/// rejected, because they cannot start in the same tick. The goal and the start tick of each plan
/// are replaced by those of the group.
///
/// `options.total` is the time limit until all motions have begun; `options.cancelled` stops all
/// axes. Returns the outcome of each axis, each with its own reason. Throws InputError for fewer
/// than 2 plans, a duplicate name, a plan with swaps, or one that cannot be sent, and
/// TransportError.
std::vector<StreamOutcome> stream_group(Transport& link, std::vector<StreamPlan> plans,
                                        const GroupOptions& group,
                                        const StreamOptions& options = {},
                                        const Clock& clock = steady_now);

}  // namespace jounce
