// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "jounce/executor/detail/record.hpp"
#include "jounce/executor/detail/recorder.hpp"
#include "jounce/executor/run_executor.hpp"

namespace jounce::executor_detail {

/// The recorder of a run and its buffer; both are null if the run has no record.
struct RunRecord {
  std::unique_ptr<RecordBuffer> buffer = {};
  std::unique_ptr<Recorder> recorder = {};
};

/// Creates the recorder for the options of a run. Throws InputError and std::system_error like
/// Recorder.
RunRecord record_of(const RunOptions& run, const std::vector<ExecutorOptions>& axes);

/// Returns the masters of a run, with their followers and the data from which a replay computes
/// them.
std::vector<RecordedMaster> recorded_masters(const std::vector<MachineMaster>& masters,
                                             const std::vector<ExecutorOptions>& axes);

}  // namespace jounce::executor_detail
