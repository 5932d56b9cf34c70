// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "jounce/executor/detail/trace.hpp"
#include "jounce/stream/message/message.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce::web {

/// The state of several axes for the live page: the newest status of each, and the samples of the
/// last seconds for its plots.
///
///     Board board({"feeder", "knife"});
///     board.take("feeder", status, steady_now());
///     std::int64_t seen = 0;
///     send(board.json_since(seen, steady_now()));   // moves `seen` on
///
/// A value type, not synchronized: threads that share it need a lock.
class Board {
 public:
  static constexpr std::size_t most_samples = 2000;  ///< greatest number of samples of each axis
  /// Greatest number of masters of each axis; without a key, any program can send some.
  static constexpr std::size_t most_masters = 64;
  static constexpr std::size_t most_entries = 200;  ///< greatest number of events in the list

  /// `axes`: names of the axes.
  explicit Board(std::vector<std::string> axes);

  /// Stores a status, which arrived at the time `now`. Ignores an axis that is not in the list, and
  /// a status that is not newer than the previous one.
  void take(const std::string& axis, const wire::Status& status, Nanos now);

  /// Stores the state of a master that an axis follows. If there are too many, drops the one whose
  /// cycle is the earliest.
  void take(const std::string& axis, const wire::MasterStatus& master);

  /// Stores the place of a group on its path.
  void take(const std::string& axis, const wire::GroupStatus& group);

  /// Adds the changes in these ticks of an axis to the list of events: states, faults, rejected
  /// commands, and the ends of motions. `period`: duration of a tick, ns. The ticks follow those of
  /// the previous call.
  void take(const std::string& axis, const std::vector<TraceTick>& ticks, std::int64_t period);

  /// Returns the units of an axis; nullopt if no status has arrived.
  [[nodiscard]] std::optional<Units> units(const std::string& axis) const;

  /// Returns the last status of a group; an empty one for a single axis.
  [[nodiscard]] wire::GroupStatus group(const std::string& name) const;

  /// Returns the state of all axes as JSON, with the samples whose number is above `seen`; sets
  /// `seen` to the newest number. NaN becomes null. The form is {"axes": [{"name", "state", "heard"
  /// (s since the last status), "position", ..., "samples": [[time s, position, velocity, following
  /// error], ...], "masters": [{"name", "unit", "lost", "position", "velocity", "age_ms"}],
  /// "group": null or {"axes", "place", "framed", "position", "length", "feed", "remaining",
  /// "estimated", "line", "commands", "look_ahead"}}], "log": [{"axis", "time", "kind", "name",
  /// "text", "remedy"}]}, where time is tick * cycle.
  /// `kind` is state, fault, rejected, dropped or ended.
  [[nodiscard]] std::string json_since(std::int64_t& seen, Nanos now) const;

  /// True if the axis is in the list.
  [[nodiscard]] bool has(const std::string& axis) const;

 private:
  struct Sample {
    std::int64_t number;  // number over all axes, ascending
    double time, position, velocity, error;
  };
  struct AxisView {
    std::string name{};
    wire::Status status{};
    Nanos heard{-1};
    std::deque<Sample> samples{};
    std::map<std::string, wire::MasterStatus> masters{};  // by name
    std::optional<wire::GroupStatus> group{};
    std::optional<TraceTick> last{};  // the last tick of the log
  };

  struct Entry {
    std::int64_t number;  // see Sample
    std::string axis;
    double time;
    std::string kind;
    std::string name;
    Cause cause;
  };
  AxisView* find(const std::string& axis);
  void note(const AxisView& view, double time, const char* kind, Cause cause);

  std::vector<AxisView> axes_;
  std::deque<Entry> log_;
  std::int64_t count_ = 0;
};

}  // namespace jounce::web
