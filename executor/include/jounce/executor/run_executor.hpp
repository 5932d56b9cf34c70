// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jounce/executor/dispatcher.hpp"
#include "jounce/executor/realtime.hpp"
#include "jounce/executor/recorder.hpp"

namespace jounce {

/// Options of run_executor().
struct RunOptions {
  std::optional<double> seconds{};  ///< > 0; omitted: until a signal
  std::vector<MachineMaster> masters =
      {};                  ///< masters of the axes; their notices go to the first axis's
  bool once = false;       ///< ends after a motion has ended for any reason, and all axes rest
  Realtime realtime = {};  ///< realtime of the cyclic thread
  /// s: if the communication thread hangs for longer, the cycle stops all axes; 0: never.
  double watchdog = 0.5;
  RecorderOptions record = {};  ///< files of the record; its notices go to those of the first axis
  /// Called once it owns the names of the axes and its files are open: it accepts commands.
  std::function<void()> up = {};
};

/// Result of one axis.
struct AxisSummary {
  std::string name;
  std::uint64_t finished = 0;  ///< motions that reached their end
  std::uint64_t stopped = 0;   ///< motions that a stop brought to rest
  Cause fault = Cause::none;   ///< latched at the end
  double position = 0;         ///< position of the axis
  bool log_truncated = false;  ///< the log ended before the run
};

/// Result of a run.
struct ExecutorSummary {
  std::vector<AxisSummary> axes;
  CycleCounts cycle;
  Histogram::Counts lateness{};   ///< lateness of waking up
  Histogram::Counts computing{};  ///< computing time of a cycle
  std::string realtime;           ///< result of make_realtime(); empty without a request
  std::string record_trouble;     ///< reason why the record is incomplete; empty: it is complete
  std::int64_t record_lost = 0;   ///< cycles that are missing from the record
  std::string lost_name;          ///< name that another executor owns, so that this one left

  /// True if the fault of an axis is latched at the end.
  [[nodiscard]] bool has_fault() const {
    return std::any_of(axes.begin(), axes.end(),
                       [](const AxisSummary& axis) { return axis.fault != Cause::none; });
  }
  /// True if an axis has ended a motion.
  [[nodiscard]] bool has_played() const {
    return std::any_of(axes.begin(), axes.end(),
                       [](const AxisSummary& axis) { return axis.finished + axis.stopped > 0; });
  }
};

/// The executor behind `jounce run`: the cyclic thread steps all axes, the calling thread
/// communicates over `link`, until its time is over, one motion is over, or SIGINT or SIGTERM
/// arrives. It first stops active motions on their paths; a second signal does not wait for them.
///
/// Before it opens a file, it claims the names of its axes (Claim), all at once, in 0.3 s. If two
/// executors with one name meet later (two networks were joined), one of them leaves.
///
/// Throws InputError for bad options and for a name that another executor owns, TransportError, and
/// std::system_error for a log.
ExecutorSummary run_executor(Transport& link, const std::vector<ExecutorOptions>& axes,
                             const RunOptions& run);

}  // namespace jounce
