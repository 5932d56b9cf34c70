// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/executor/run_executor.hpp"

namespace jounce {

/// Returns the summary of a run as text: motions and fault of each axis, lateness of the cycle.
std::string summary_text(const ExecutorSummary& summary);

/// Returns the contents of summary_text() as a JSON object, with the two histograms of the cycle.
std::string summary_json(const ExecutorSummary& summary);

/// Returns sentences about what is missing after a run: the name that another executor owns, ticks
/// of the tick log, cycles of the record. `log`: MachineOptions::log; "": none. Empty if nothing is
/// missing.
std::vector<std::string> missing_parts(const ExecutorSummary& summary, const std::string& log);

}  // namespace jounce
