// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
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

/// Returns the same as a JSON object.
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

}  // namespace jounce
