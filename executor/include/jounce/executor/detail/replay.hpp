// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "jounce/executor/detail/record.hpp"

namespace jounce {

/// Result of the replay of a record.
struct Replay {
  /// The first difference between the record and its replay.
  struct Difference {
    std::size_t axis = 0;      ///< index of the axis or of the master
    std::int64_t tick = 0;     ///< tick of the difference
    TickDifference what = {};  ///< field and values
    bool of_master = false;    ///< true: `axis` is the index of a master
  };

  std::vector<RecordedAxis> axes = {};  ///< the axes in the record
  /// A master in the record.
  struct Master : RecordedMaster {
    std::int64_t cycles = 0;  ///< number of cycles
    std::int64_t lost = 0;    ///< cycles in which the master was lost
  };
  std::vector<Master> masters = {};  ///< the masters in the record
  std::int64_t cycles = 0;           ///< number of cycles in the record, of all axes together
  std::int64_t compared = 0;         ///< number of cycles that were computed again
  /// The first difference; nullopt: none.
  std::optional<Difference> difference = {};
  /// Reason, as a sentence, why a part of the record was not computed again; "" if all of it was,
  /// or if there is a difference.
  std::string shorter = {};
  /// Damage that the checksums of the record show, as a sentence; "": none.
  std::string damage = {};
  bool has_checksums = false;  ///< false: an older version wrote the record; see `damage`
  /// First tick of the record; nullopt: the record has no cycles.
  std::optional<std::int64_t> first_tick = {};
  std::int64_t last_tick = 0;  ///< last tick of the record

  /// True if the whole record was computed again, with identical results.
  [[nodiscard]] bool same() const { return !difference && shorter.empty() && damage.empty(); }
  /// True if the replay found no difference, and computed everything that can be computed. (A black
  /// box cannot be computed again, because it begins in the middle of a run.)
  [[nodiscard]] bool agrees() const {
    return same() || (!difference && damage.empty() && !axes.empty() && !axes.front().whole);
  }
};

/// Replays a record: steps every axis again with its recorded commands and inputs, in every tick,
/// and compares the outputs bit for bit.
///
///     std::ifstream file("run.lcmlog", std::ios::binary);
///     const Replay r = replay(file, "run.lcmlog");
///     if (r.difference) std::cerr << r.difference->what.field;
///
/// External masters and encoders are computed again from their samples and readings (fields
/// "master_position", ...). The value of the master in each follower is also compared (field
/// "live_master").
///
/// `name` is the name of the file for errors. `watch` is called for every cycle in the record, even
/// after a difference, and also for a black box. `watch_master` is called for every value of a
/// master. The record is read as a stream, so it may have any length.
///
/// The checksums of the record show whether an event was changed, inserted or lost, also where this
/// does not change an output. The computation continues after such a damage.
///
/// In three cases, the function no longer computes outputs, but still reads the record to its end:
/// cycles are lost, a movement is not in the record (a custom program did not record it), or the
/// file is truncated.
///
/// Throws InputError, with the number and the position of the event, for a file that is not an LCM
/// log, a damaged file, a file without events of Jounce, a table with a wrong hash, and an axis
/// whose recorded configuration is invalid.
Replay replay(std::istream& in, const std::string& name,
              const std::function<void(const RecordedCycle&)>& watch = {},
              const std::function<void(const RecordedSight&)>& watch_master = {});

}  // namespace jounce
