// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/detail/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace jounce {

void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& body,
                  const std::function<void(double)>& progress, std::size_t threads) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr thrown;
  std::mutex mutex;
  const auto work = [&](bool reports) {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        body(i);
        if (reports && progress) progress(static_cast<double>(i) / static_cast<double>(count));
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!thrown) thrown = std::current_exception();
        next = count;
      }
    }
  };
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t most = threads > 0 ? threads : cores;
  std::vector<std::jthread> others;
  for (std::size_t k = 1; k < std::min(most, count); ++k) others.emplace_back(work, false);
  work(true);
  others.clear();  // joins
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace jounce
