#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "jounce/executor/dispatcher.hpp"

namespace jounce {

/// How long run_executor() runs.
struct RunOptions {
  std::optional<double> seconds{};  ///< > 0; without it until a signal
  bool once = false;                ///< until one motion has ended, in whatever way
  int realtime_priority = 0;        ///< of SCHED_FIFO for the cyclic thread; 0: not asked for
};

/// What came of a run.
struct ExecutorSummary {
  std::uint64_t finished = 0;  ///< motions that reached their end
  std::uint64_t stopped = 0;   ///< motions that a stop brought to rest
  Cause fault = Cause::none;   ///< latched at the end
  double position = 0;         ///< where the axis stands
  CycleCounts cycle;
  std::string realtime;  ///< what make_realtime() was granted; empty if it was not asked
};

/// The executor behind `jounce run`: the cyclic thread steps the axis, the calling one communicates
/// over `link`, until its time is over, one motion is over, or SIGINT or SIGTERM comes. A motion
/// under way is stopped on its path first; a second signal does not wait for it.
///
/// Throws InputError for bad options, TransportError, and std::system_error for the log.
ExecutorSummary run_executor(Transport& link, const ExecutorOptions& options,
                             const RunOptions& run);

}  // namespace jounce
