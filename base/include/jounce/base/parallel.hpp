// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace jounce {

/// Calls `body` for 0 to count - 1 on every core; each thread takes the next number. The calling thread reports the
/// share that is done. Throws the first exception of a body again, after all threads have ended.
void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& body,
                  const std::function<void(double)>& progress = {});

}  // namespace jounce
