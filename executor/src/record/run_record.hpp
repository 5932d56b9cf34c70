// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "jounce/executor/run_executor.hpp"

namespace jounce::executor_detail {

/// The record of a run, and the buffer to it; both null without a record.
struct RunRecord {
  std::unique_ptr<RecordBuffer> buffer = {};
  std::unique_ptr<Recorder> recorder = {};
};

/// Creates the recorder for the options of a run. Throws like Recorder.
RunRecord record_of(const RunOptions& run, const std::vector<ExecutorOptions>& axes);

/// The masters of a run, their followers, and the data to reconstruct them in a replay.
std::vector<RecordedMaster> recorded_masters(const std::vector<MachineMaster>& masters,
                                             const std::vector<ExecutorOptions>& axes);

}  // namespace jounce::executor_detail
