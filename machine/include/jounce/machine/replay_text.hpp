// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>

#include "jounce/executor/replay.hpp"
#include "jounce/plot/figure.hpp"

/// The record of an executor and its replay, as text, JSON and a figure.
namespace jounce {

/// Returns the axis with this name in the record `file`; "" means the first axis. Reads the whole
/// file. Throws InputError (key "axis") for an unknown name, and like replay().
RecordedAxis recorded_axis(const std::string& file, const std::string& name = "");

/// Returns the axes, cycles and masters of a record, and the first difference of its replay, as
/// text. `file`: name of the record.
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

/// Returns a figure over time: setpoint and actual position, velocity, following error and torque,
/// with a mark at each fault. Quantities that the drive does not report are omitted.
Figure tick_figure(const std::deque<Tick>& ticks, const RecordedAxis& axis);

/// The parts of a record that replay_file() keeps.
struct ReplayFileOptions {
  std::string axis = {};                 ///< name of the axis to keep; empty: the first
  std::optional<std::size_t> last = {};  ///< number of last ticks of it; nullopt: see below
  std::string csv = {};  ///< tick log to write, by default of all ticks; empty: none
  bool ticks = false;    ///< keep ticks for tick_figure(), by default 5000
};

/// The replay of a record, and the kept ticks of one axis.
struct ReplayedFile {
  Replay replay;
  RecordedAxis axis = {};  ///< axis of the ticks, if there are any or a CSV file
  std::deque<Tick> ticks = {};
};

/// Replays a record and writes its ticks as they come: a record may be longer than memory. Throws
/// InputError like recorded_axis(), and std::system_error for the CSV file.
ReplayedFile replay_file(const std::string& path, const ReplayFileOptions& options = {});

}  // namespace jounce
