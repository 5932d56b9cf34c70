// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "cli/common/interrupt.hpp"
#include "cli/common/progress.hpp"
#include "cli/optimize/shape_words.hpp"

namespace jounce::cli {

/// The outcome, with progress and Ctrl-C. `optimize` is given what to ask whether to go on.
template <class Optimize>
auto watched(const ShapeWords& words, const Optimize& optimize) {
  Progress progress("optimising");
  const Interrupt interrupt;
  return optimize([&](const CamShapeProgress& p) {
    const double parts = static_cast<double>(p.runs * p.stages);
    const double round = static_cast<double>(p.round);
    const double done = static_cast<double>(p.run * p.stages + p.stage) + round / (round + 10);
    progress.show(done / parts,
                  words.figures()[std::min(p.stage, words.figures().size() - 1)].name);
    return !interrupt.asked();
  });
}

}  // namespace jounce::cli
