// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "jounce/executor/record.hpp"

namespace jounce {

/// Result of the replay of a record.
struct Replay {
  /// The first tick with a different result.
  struct Difference {
    std::size_t axis = 0;  ///< counted from 0; or the master
    std::int64_t tick = 0;
    TickDifference what = {};
    bool of_master = false;
  };

  std::vector<RecordedAxis> axes = {};
  /// State of a master.
  struct Master : RecordedMaster {
    std::int64_t cycles = 0;
    std::int64_t lost = 0;  ///< cycles without the master
  };
  std::vector<Master> masters = {};
  std::int64_t cycles = 0;    ///< in the record, of all axes together
  std::int64_t compared = 0;  ///< cycles executed again
  std::optional<Difference> difference = {};
  /// Reason, as a sentence, why a part was not executed again; empty: all was, or there is a
  /// difference.
  std::string shorter = {};
  std::optional<std::int64_t> first_tick = {};
  std::int64_t last_tick = 0;

  /// True if executed to its end, and equal to the last bit.
  [[nodiscard]] bool same() const { return !difference && shorter.empty(); }
  /// True if nothing differs, and all was executed that can be: a black box begins within a run.
  [[nodiscard]] bool agrees() const {
    return same() || (!difference && !axes.empty() && !axes.front().whole);
  }
};

/// Executes a record again: every axis, a pure function of its commands and inputs, in every tick,
/// and compares its outputs bit for bit.
///
///     std::ifstream file("run.lcmlog", std::ios::binary);
///     const Replay r = replay(file, "run.lcmlog");
///     if (r.difference) std::cerr << r.difference->what.field;
///
/// External masters are executed again from their samples and readings ("master_position", ...).
/// The value of the master in every follower is compared, too ("live_master").
///
/// `watch` is called with every cycle of the record, even after a difference, and for a black box,
/// which begins in the middle of a run and cannot be executed again. A record is read as a stream:
/// its length does not matter.
///
/// Lost cycles, a movement that is not in the record (a custom program has not recorded it), and a
/// truncated file end the execution early, but not the reading.
///
/// Throws InputError, with the event's number and position, for a file that is not an LCM log, a
/// damaged one, one without Jounce events, tables with a wrong hash, and an axis that cannot be
/// configured as recorded.
Replay replay(std::istream& in, const std::string& name,
              const std::function<void(const RecordedCycle&)>& watch = {},
              const std::function<void(const RecordedSight&)>& watch_master = {});

}  // namespace jounce
