// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/plot/figure.hpp"
#include "jounce/study/sweep_summary.hpp"

namespace jounce {

/// Returns a picture of a finished sweep. Its kind depends on the request:
///
/// - with two or more objectives, the first one is x, and the others have a panel each. Every
///   possible case is a dot, the Pareto front is a line, and the case of the given spec is marked;
/// - otherwise, with random parameters, each figure is drawn over the share of cases that do not
///   exceed it (a distribution function with exchanged axes), with its limit. There is one line for
///   each of up to four combinations of the listed values;
/// - otherwise, each figure is drawn over the first parameter.
///
/// Figures that are the same in all cases are omitted. At most eight figures are drawn.
Figure sweep_figure(const SweepSpec& spec, const SweepResult& result, const SweepSummary& summary);

}  // namespace jounce
