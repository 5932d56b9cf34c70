// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/plot/figure.hpp"
#include "jounce/study/detail/sweep_summary.hpp"

namespace jounce {

/// Returns a picture of a finished sweep. Its kind depends on the request:
///
/// - With two or more objectives, the first one is x, and each of the others has a panel. Every
///   possible case is a dot, the Pareto front is a line, and the case of the given spec is marked.
/// - Otherwise, with random parameters, each figure is drawn over the share of cases that do not
///   exceed it (a distribution function with exchanged axes), with its limit. Each of up to four
///   combinations of the listed values has a line.
/// - Otherwise, each figure is drawn over the first parameter. Each combination of the other
///   parameters has a line, if there are at most four. If there are more, up to four values of the
///   second parameter have a line, evenly spread over its list; each further parameter has the value
///   of its list that is nearest to the given spec. Below the picture, a note states what is drawn.
///
/// Figures that are the same in all cases are omitted. At most eight figures are drawn.
Figure sweep_figure(const SweepSpec& spec, const SweepResult& result, const SweepSummary& summary);

/// Returns the look of sweep_figure(): a Pareto front has high panels, because its points are read
/// one by one.
SvgOptions sweep_look(const SweepSpec& spec);

}  // namespace jounce
