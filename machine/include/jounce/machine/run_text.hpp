// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/executor/run_executor.hpp"

namespace jounce {

/// The summary of a run for people: motions and fault of each axis, lateness of the cycle.
std::string summary_text(const ExecutorSummary& summary);

/// The same as a JSON object, with both histograms.
std::string summary_json(const ExecutorSummary& summary);

/// Sentences on what a run has lost: its name to another executor, ticks of its tick log `log`
/// (MachineOptions::log; empty: it has none), cycles of its record. Empty: nothing.
std::vector<std::string> missing_parts(const ExecutorSummary& summary, const std::string& log);

}  // namespace jounce
