// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace jounce {

/// Calls body(0) to body(count - 1), in parallel on all cores; each thread takes the next number.
/// The calling thread calls `progress` with the share that is done, 0 to 1. If a body or `progress`
/// throws, no further body begins, and the first exception is rethrown after all threads have
/// ended. `threads`: greatest number of threads, with the calling one; 0: one for each core.
void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& body,
                  const std::function<void(double)>& progress = {}, std::size_t threads = 0);

}  // namespace jounce
