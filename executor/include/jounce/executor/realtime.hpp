// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/profiles/error.hpp"

namespace jounce {

/// Requests of a thread to the operating system for real-time execution.
struct Realtime {
  int priority = 0;  ///< priority of SCHED_FIFO, 1 to 99; 0: no request
  int cpu = -1;      ///< number of the CPU on which the thread runs, from 0 as in Linux; -1: any

  /// True if anything is requested.
  [[nodiscard]] bool asked() const { return priority > 0 || cpu >= 0; }
};

/// Throws InputError (key "cpu") unless this process may use the CPU. -1: any CPU.
void require_cpu(int cpu);

/// Applies the requests to the calling thread. A request that the system does not permit is
/// skipped. With a priority, all memory of the process is locked. In any case, the function touches
/// the stack in advance, so that no page fault occurs later, and sets the timer slack to 1 ns
/// instead of 50 us (SCHED_FIFO has no slack). Returns the results as text; "" if nothing was
/// requested.
std::string make_realtime(const Realtime& wanted);

}  // namespace jounce
