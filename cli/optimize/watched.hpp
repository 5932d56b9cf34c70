// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/optimize/outcome.hpp"

#include "cli/common/interrupt.hpp"
#include "cli/common/progress.hpp"

namespace jounce::cli {

/// Runs an optimizer, shows its progress on the terminal, and stops it at Ctrl-C. `state(progress)` is the
/// text beside the bar. `optimize(keep_going)` returns the outcome.
template <class State, class Optimize>
auto watched(const char* work, const State& state, const Optimize& optimize) {
  Progress progress(work);
  const Interrupt interrupt;
  return optimize([&](const OptimizeProgress& p) {
    progress.show(p.done, state(p));
    return !interrupt.asked();
  });
}

}  // namespace jounce::cli
