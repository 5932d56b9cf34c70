// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/executor/run_executor.hpp"

namespace jounce {

/// Returns a sentence for the user of an executor that has just begun: the names of its axes and
/// groups, and their states. `enabled`: MachineOptions::enable, which does not enable groups.
/// Requires at least one axis.
std::string up_text(const std::vector<ExecutorOptions>& axes, bool enabled);

/// Returns the summary of an executor that has ended, as text: the motions and the fault of each
/// axis, and the lateness of the cycle.
std::string summary_text(const ExecutorSummary& summary);

/// Returns the contents of summary_text() as a JSON object, with the two histograms of the cycle.
std::string summary_json(const ExecutorSummary& summary);

/// Returns one sentence for each part that is missing after an executor has ended: the name that
/// another executor owns, ticks of the tick log, cycles of the record. `log` is
/// MachineOptions::log; "": none. Empty if no part is missing.
std::vector<std::string> missing_parts(const ExecutorSummary& summary, const std::string& log);

}  // namespace jounce
