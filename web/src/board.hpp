// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "jounce/stream/message/message.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce::web {

/// State of some axes: the newest status of each, and the last seconds for its plots.
///
///     Board board({"feeder", "knife"});
///     board.take("feeder", status, steady_now());
///     std::int64_t seen = 0;
///     send(board.json_since(seen, steady_now()));   // moves `seen` on
///
/// A value type: guard it if threads share it.
class Board {
 public:
  static constexpr std::size_t most_samples = 2000;  ///< samples of each axis
  static constexpr std::size_t most_masters =
      64;  ///< likewise: without a key, any sender can invent masters

  explicit Board(std::vector<std::string> axes);

  /// Stores a status; ignores it if its axis is not named, or if it is as old as the previous one.
  void take(const std::string& axis, const wire::Status& status, Nanos now);

  /// Stores the state of a master in an axis. If there are too many, drops the one of the earliest
  /// cycle.
  void take(const std::string& axis, const wire::MasterStatus& master);

  /// Returns all axes in JSON, with the samples after `seen`, and moves `seen` to the newest one.
  /// NaN becomes null. {"axes": [{"name", "state", "heard" (s since), "position", ..., "samples":
  /// [[time s, position, velocity, following error], ...], "masters": [{"name", "unit", "lost",
  /// "position", "velocity", "age_ms"}]}]}; time is tick * cycle.
  [[nodiscard]] std::string json_since(std::int64_t& seen, Nanos now) const;

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
  };

  std::vector<AxisView> axes_;
  std::int64_t count_ = 0;
};

}  // namespace jounce::web
