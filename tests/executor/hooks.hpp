// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace jounce::test {

/// Counts of the forbidden operations of a thread in a cycle.
struct Noise {
  long heap = 0;    ///< taken from it, or given back
  long locks = 0;   ///< mutexes locked, conditions waited for or signalled
  long writes = 0;  ///< to files, terminals, sockets

  bool operator==(const Noise&) const = default;
};

/// The noise of the calling thread so far. The whole test program counts: hooks.cpp puts itself
/// before malloc, pthread_mutex_lock, write and their like, also where a library calls them.
Noise noise();

inline Noise operator-(const Noise& a, const Noise& b) {
  return {a.heap - b.heap, a.locks - b.locks, a.writes - b.writes};
}

}  // namespace jounce::test
