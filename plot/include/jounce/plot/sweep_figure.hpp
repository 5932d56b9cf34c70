// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/plot/figure.hpp"
#include "jounce/study/sweep_summary.hpp"

namespace jounce {

/// A complete sweep as a picture, which depends on the request:
///
/// - two objectives or more: the first one along x, the others stacked; every possible case is a
///   dot, the Pareto front a line, and the spec as given is marked;
/// - otherwise, with random parameters: each figure over the share of cases that do not exceed it
///   (the distribution function with its axes exchanged), with its limit; one line for each of up
///   to four combinations of the listed values;
/// - otherwise the figures over the first parameter.
///
/// Figures that are the same in all cases are omitted, as are those beyond the first eight.
Figure sweep_figure(const SweepSpec& spec, const SweepResult& result, const SweepSummary& summary);

}  // namespace jounce
