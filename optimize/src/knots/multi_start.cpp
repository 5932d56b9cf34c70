// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/knots/multi_start.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

namespace jounce::optimize_detail {
namespace {

using namespace std::chrono_literals;

class MultiStart {
 public:
  MultiStart(const Subproblem& subproblem, const std::vector<Point>& starts,
             const MultiStartOptions& options)
      : subproblem_(subproblem), starts_(starts), options_(options), results_(starts.size()) {}

  std::vector<LocalSolution> run() {
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    {
      std::vector<std::jthread> threads;
      for (std::size_t i = 0; i < std::min(cores, starts_.size()); ++i)
        threads.emplace_back([this] { work(); });
      try {
        watch(threads.size());
      } catch (...) {
        stopped_ = true;
        throw;
      }
    }
    if (trouble_) std::rethrow_exception(trouble_);
    std::vector<LocalSolution> all;
    for (std::size_t i = 0; i < starts_.size() && i <= last_; ++i)
      all.push_back(std::move(*results_[i]));
    return all;
  }

 private:
  /// One thread: it runs one start after the other.
  void work() {
    for (std::size_t i = next_++; i < starts_.size(); i = next_++) {
      if (i > last_) continue;
      std::optional<LocalSolution> result;
      std::exception_ptr trouble;
      try {
        result = exchange_method(subproblem_, starts_[i], options_.evaluations,
                                 [this, i] { return !stopped_ && i <= last_; });
      } catch (...) {
        trouble = std::current_exception();
      }
      const std::lock_guard lock(mutex_);
      if (trouble) trouble_ = trouble;
      if (trouble) stopped_ = true;
      if (result && (!best_ || is_better(result->merit, *best_))) best_ = result->merit;
      if (result && options_.enough && options_.enough(*result)) last_ = std::min(last_.load(), i);
      results_[i] = std::move(result);
      ++done_;
      changed_.notify_one();
    }
    const std::lock_guard lock(mutex_);
    ++ended_;
    changed_.notify_one();
  }

  void watch(std::size_t threads) {
    std::unique_lock lock(mutex_);
    std::size_t reported = 0;
    while (ended_ < threads || reported < done_) {
      changed_.wait_for(lock, 20ms, [&] { return ended_ == threads || reported < done_; });
      reported = done_;
      const std::optional<Merit> best = best_;
      lock.unlock();
      if (!options_.go_on(reported, best)) stopped_ = true;
      lock.lock();
    }
  }

  const Subproblem& subproblem_;
  const std::vector<Point>& starts_;
  const MultiStartOptions& options_;
  std::vector<std::optional<LocalSolution>> results_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<std::size_t> last_ =
      static_cast<std::size_t>(-1);  ///< number of the start whose result is enough
  std::atomic<bool> stopped_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Merit> best_;
  std::size_t done_ = 0;
  std::size_t ended_ = 0;
  std::exception_ptr trouble_;
};

}  // namespace

std::vector<LocalSolution> multi_start(const Subproblem& subproblem,
                                       const std::vector<Point>& starts,
                                       const MultiStartOptions& options) {
  return MultiStart(subproblem, starts, options).run();
}

}  // namespace jounce::optimize_detail
