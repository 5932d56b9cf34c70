// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <stop_token>
#include <thread>
#include <type_traits>

namespace jounce {

/// A thread that executes tasks one after another, for work that would delay the communication
/// thread. For example, building a job of millions of knots takes seconds.
///
///     Worker worker;
///     auto job = worker.ask([table] { return std::make_unique<Job>(1, table); });
///     if (job.wait_for(0s) == std::future_status::ready) play(job.get());   // or throws
///
/// The destructor waits for the end of the present task, and drops the other tasks.
class Worker {
 public:
  Worker() : thread_([this](const std::stop_token& leave) { run(leave); }) {}

  /// Adds a task. The future receives its result or its exception.
  template <class Make>
  [[nodiscard]] auto ask(Make make) -> std::future<std::invoke_result_t<Make>> {
    auto task = std::make_shared<std::packaged_task<std::invoke_result_t<Make>()>>(std::move(make));
    auto result = task->get_future();
    {
      const std::lock_guard lock(mutex_);
      tasks_.emplace_back([task = std::move(task)] { (*task)(); });
    }
    asked_.notify_one();
    return result;
  }

 private:
  void run(const std::stop_token& leave) {
    for (;;) {
      std::function<void()> task;
      {
        std::unique_lock lock(mutex_);
        if (!asked_.wait(lock, leave, [this] { return !tasks_.empty(); }) || leave.stop_requested())
          return;
        task = std::move(tasks_.front());
        tasks_.pop_front();
      }
      task();
    }
  }

  std::mutex mutex_;
  std::condition_variable_any asked_;
  std::deque<std::function<void()>> tasks_;
  std::jthread thread_;  // declared last: the thread uses the other members
};

}  // namespace jounce
