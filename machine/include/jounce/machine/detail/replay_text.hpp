// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>

#include "jounce/executor/detail/replay.hpp"
#include "jounce/plot/figure.hpp"

/// The record of an executor and its replay, as text, JSON and a figure.
namespace jounce {

/// Returns the axes, cycles and masters of a record, and the first difference of its replay, as
/// text. `file` is the name of the record.
std::string replay_text(const Replay& replay, const std::string& file);

/// Returns the contents of replay_text() as a JSON object.
std::string replay_json(const Replay& replay);

/// Collects the last ticks of one axis from a record.
class LastTicks {
 public:
  /// `axis`: index of the axis. `most`: number of ticks that are kept.
  LastTicks(std::size_t axis, std::size_t most) : axis_(axis), most_(most) {}

  /// Adds a cycle; ignores other axes.
  void add(const RecordedCycle& cycle) {
    if (cycle.axis != axis_) return;
    kept_.push_back(cycle.tick);
    if (kept_.size() > most_) kept_.pop_front();
  }
  /// The ticks, the oldest first.
  [[nodiscard]] const std::deque<Tick>& kept() const { return kept_; }

 private:
  std::size_t axis_;
  std::size_t most_;
  std::deque<Tick> kept_;
};

/// Collects the last motion of one axis from a record, for a picture: the last 5000 ticks up to its
/// end, without the rest before them, and 200 ticks of the rest after it. A motion is a setpoint that
/// moves; a new fault counts as one. Without a motion: the last 5000 ticks.
class LastMotion {
 public:
  static constexpr std::size_t most = 5000;  ///< number of ticks up to the end of the motion
  static constexpr std::size_t after =
      200;  ///< number of ticks after it, in which the drive settles
  static constexpr std::size_t before = 20;  ///< number of ticks before it

  /// `axis`: index of the axis.
  explicit LastMotion(std::size_t axis) : last_(axis, most + after), axis_(axis) {}

  /// Adds a cycle; ignores other axes.
  void add(const RecordedCycle& cycle);
  /// The ticks, the oldest first.
  [[nodiscard]] std::deque<Tick> kept() const;

 private:
  LastTicks last_;
  std::size_t axis_;
  std::optional<std::size_t>
      rest_;                   ///< number of ticks since the last motion; nullopt: none so far
  std::deque<Tick> motion_;    ///< the ticks that are kept of the last motion, if it is over
  Cause fault_ = Cause::none;  ///< fault of the previous tick
};

/// Returns a figure over time: setpoint and actual position, velocity, following error and torque,
/// with a mark at each fault. Quantities that the drive does not report are omitted.
Figure tick_figure(const std::deque<Tick>& ticks, const RecordedAxis& axis);

/// Options of replay_file(): the parts of a record to keep.
struct ReplayFileOptions {
  std::string axis = {};                 ///< name of the axis whose ticks are kept; "": the first
                                         ///< axis
  std::optional<std::size_t> last = {};  ///< number of last ticks to keep; nullopt: see csv and
                                         ///< ticks
  std::string csv = {};  ///< tick log to write; without `last`, with all ticks; "": none
  bool ticks = false;    ///< true: keep ticks for tick_figure(); without `last`, see LastMotion
};

/// The replay of a record, and the ticks of one axis that were kept.
struct ReplayedFile {
  Replay replay = {};
  RecordedAxis axis = {};  ///< axis of the ticks; set only if ticks are kept or a CSV file is
                           ///< written
  std::deque<Tick> ticks = {};
};

/// Replays a record, and writes its ticks while it reads the record, so the record may be larger
/// than memory. Throws InputError for a file that cannot be read, for a pipe if ticks are kept,
/// with the key "axis" for an unknown axis, and like replay(); std::system_error for the CSV file.
ReplayedFile replay_file(const std::string& path, const ReplayFileOptions& options = {});

}  // namespace jounce
