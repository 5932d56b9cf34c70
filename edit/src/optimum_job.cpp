// SPDX-License-Identifier: Apache-2.0
#include "edit/src/optimum_job.hpp"

#include <exception>
#include <utility>

namespace jounce::edit_detail {

OptimumJob::OptimumJob(const std::string& path, const std::string& text)
    : given_(parse_spec(text, path)) {
  prepare_optimum(given_);
  thread_ = std::thread([this] { work(); });
}

OptimumJob::~OptimumJob() {
  stop();
  thread_.join();
}

OptimumJob::State OptimumJob::state() const {
  const std::scoped_lock lock(mutex_);
  return state_;
}

void OptimumJob::work() {
  State result;
  try {
    SpecOptimum best = optimum_of(given_, [this](double done, const std::string& step) {
      const std::scoped_lock lock(mutex_);
      state_.done = done;
      state_.step = step;
      return !stopped_;
    });
    result.text = std::move(best.text);
    result.spec = std::move(best.spec);
    if (result.spec) {
      const Spec optimized = parse_spec(*result.spec, given_.document.name);
      result.text += improvement_text(given_, optimized);
      result.broken = broken_checks(optimized);
    }
  } catch (const std::exception& error) {
    result.error = error.what();
  }
  result.running = false;
  result.done = 1;
  const std::scoped_lock lock(mutex_);
  state_ = std::move(result);
}

}  // namespace jounce::edit_detail
