// SPDX-License-Identifier: Apache-2.0
#include "edit/src/jobs/job.hpp"

#include <exception>
#include <utility>

namespace jounce::edit_detail {

Job::Job(std::string given, std::function<Outcome(Job& job)> work) : given_(std::move(given)) {
  thread_ = std::thread([this, run = std::move(work)] {
    Outcome outcome;
    try {
      outcome = run(*this);
    } catch (const std::exception& error) {
      outcome = {.error = error.what()};
    }
    const std::scoped_lock lock(mutex_);
    state_.running = false;
    state_.done = 1;
    state_.outcome = std::move(outcome);
  });
}

Job::~Job() {
  stop();
  thread_.join();
}

Job::State Job::state() const {
  const std::scoped_lock lock(mutex_);
  return state_;
}

bool Job::report(double done, std::string step) {
  const std::scoped_lock lock(mutex_);
  state_.done = done;
  state_.step = std::move(step);
  return !stopped_;
}

}  // namespace jounce::edit_detail
