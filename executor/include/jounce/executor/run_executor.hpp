// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "jounce/command/cause.hpp"
#include "jounce/executor/cycle_counts.hpp"
#include "jounce/executor/executor_options.hpp"
#include "jounce/executor/histogram.hpp"
#include "jounce/executor/machine_master.hpp"
#include "jounce/executor/realtime.hpp"
#include "jounce/executor/recorder_options.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// Options of run_executor().
struct RunOptions {
  std::optional<double> seconds{};  ///< duration of the run, s, > 0; nullopt: until a signal
  /// Masters of the machine; their notices are sent to the first axis's `notify`.
  std::vector<MachineMaster> masters = {};
  /// True: the run ends when a motion has ended, for any reason, and all axes are at rest.
  bool once = false;
  Realtime realtime = {};  ///< real-time requests of the cyclic thread
  /// Limit of the watchdog, s: if the communication thread does not respond for longer, all axes
  /// stop. 0: no watchdog.
  double watchdog = 0.5;
  /// Files of the record; its notices are sent to the first axis's `notify`.
  RecorderOptions record = {};
  Trace* trace = nullptr;  ///< receives the ticks of all axes, in their order; null: no trace
  /// Called when the executor owns the names of its axes, its files are open, and it accepts
  /// commands.
  std::function<void()> up = {};
  /// Ends the run, like SIGTERM: for an executor within another program.
  std::stop_token stop = {};
  /// False: run_executor() leaves the signal handlers of the process as they are. Then ignore
  /// SIGPIPE, so that a closed pipe does not end the process while an axis moves.
  bool handle_signals = true;
};

/// Result of one axis.
struct AxisSummary {
  std::string name = {};       ///< name of the axis
  std::uint64_t finished = 0;  ///< number of motions that reached their end
  std::uint64_t stopped = 0;   ///< number of motions that a stop brought to rest
  Cause fault = Cause::none;   ///< fault that is latched at the end
  double position = 0;         ///< position at the end, u (unit of the axis)
  std::string unit = {};       ///< u; "": not known
  bool log_truncated = false;  ///< true if the log ended before the end of the run
};

/// Result of run_executor().
struct ExecutorSummary {
  std::vector<AxisSummary> axes = {};  ///< result of each axis
  CycleCounts cycle = {};              ///< timing statistics of the cycle
  Histogram::Counts lateness{};        ///< lateness of the wake-ups
  Histogram::Counts computing{};       ///< duration of the computations
  std::string realtime = {};           ///< result of make_realtime(); "" without a request
  std::string record_trouble = {};     ///< reason why the record is incomplete; "": it is complete
  std::int64_t record_lost = 0;        ///< number of cycles that are missing in the record
  /// Name that another executor owns, which is why this executor ended; "": none.
  std::string lost_name = {};

  /// True if an axis has a latched fault at the end.
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

/// Runs an executor (`jounce run`). The cyclic thread steps all axes; the calling thread
/// communicates over `link`. The run ends after the given time, after one motion, at a request of
/// `stop`, or at SIGINT, SIGTERM or SIGHUP. Before it ends, axes in motion stop on their paths. A
/// second signal ends the run without waiting for these stops. During the run, the function handles
/// these signals and ignores SIGPIPE; then it restores the handlers of the process.
///
/// Before the executor opens a file, it claims the names of its axes, all at once, in 0.3 s
/// (Claim). If two running executors have the same name, because two networks were connected later,
/// one of them ends.
///
/// Throws InputError for invalid options and for a name that another executor owns, TransportError
/// for the link, and std::system_error if a log cannot be created.
ExecutorSummary run_executor(Transport& link, const std::vector<ExecutorOptions>& axes,
                             const RunOptions& run);

}  // namespace jounce
