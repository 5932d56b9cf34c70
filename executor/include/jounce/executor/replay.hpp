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
  /// The first tick that came out otherwise.
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
    std::int64_t lost = 0;  ///< lost of these, without it
  };
  std::vector<Master> masters = {};
  std::int64_t cycles = 0;    ///< in the record, of all axes together
  std::int64_t compared = 0;  ///< compared of them executed again
  std::optional<Difference> difference = {};
  /// Why not all of it was executed again, a sentence; empty: all was, or it differs.
  std::string shorter = {};
  std::optional<std::int64_t> first_tick = {};
  std::int64_t last_tick = 0;

  /// Executed to its end, and equal to the last bit.
  [[nodiscard]] bool same() const { return !difference && shorter.empty(); }
};

/// Executes a record again: every axis, a pure function of its commands and inputs, in every tick, and
/// compares its outputs bit for bit.
///
///     std::ifstream file("run.lcmlog", std::ios::binary);
///     const Replay r = replay(file, "run.lcmlog");
///     if (r.difference) std::cerr << r.difference->what.field;
///
/// Masters from outside are executed again from their samples and readings ("master_position", ...), and that every
/// follower saw its master so is compared, too ("live_master").
///
/// `watch` is called with every cycle of the record, also after a difference and of a black box, which begins in
/// the middle of a run and cannot be executed again. A record is read as a stream: its length does not matter.
///
/// What ends the execution early, but not the reading: cycles that were lost, a movement that is not in the
/// record (a program of your own has not noted it), a file that is cut off.
///
/// Throws InputError, with the event's number and place, for what is no LCM log, a damaged one, one without our
/// events, tables that do not have their hash, and an axis that cannot be configured as recorded.
Replay replay(std::istream& in, const std::string& name,
              const std::function<void(const RecordedCycle&)>& watch = {},
              const std::function<void(const RecordedSight&)>& watch_master = {});

}  // namespace jounce
