// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce {

/// Real-time requests of a thread to the operating system.
struct Realtime {
  int priority = 0;  ///< priority of SCHED_FIFO, 1 to 99; 0: not asked for
  int cpu = -1;      ///< the only one it may run on, counted from 0 as Linux does; -1: any

  [[nodiscard]] bool asked() const { return priority > 0 || cpu >= 0; }
};

/// Asks for all that for the calling thread, locks all memory where a priority is asked for, and
/// touches the stack that it may come to use, so that no page of it is missing later. Its timers are
/// in any case no longer put off for company's sake (a slack of 1 ns in place of 50 us; SCHED_FIFO has
/// none). Each as far as permitted: the returned text names the granted ones, and is empty
/// where nothing was asked for.
std::string make_realtime(const Realtime& wanted);

}  // namespace jounce
