// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce {

/// Real-time requests of a thread to the operating system.
struct Realtime {
  int priority = 0;  ///< priority of SCHED_FIFO, 1 to 99; 0: not requested
  int cpu = -1;      ///< the only CPU for the thread, counted from 0 like in Linux; -1: any

  [[nodiscard]] bool asked() const { return priority > 0 || cpu >= 0; }
};

/// Applies the requests to the calling thread; with a priority, it also locks all memory. It always
/// touches the stack in advance, so that no page is missing later, and sets the timer slack to 1 ns
/// instead of 50 us (SCHED_FIFO has none). Each request is granted as far as permitted: the
/// returned text reports the results, and is empty if nothing was requested.
std::string make_realtime(const Realtime& wanted);

}  // namespace jounce
