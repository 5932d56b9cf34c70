// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "jounce/pvt/segment_row.hpp"
#include "jounce/pvt/table.hpp"
#include "jounce/stream/message/queue.hpp"
#include "jounce/stream/sender/outcome.hpp"

namespace jounce {

/// Returns the next rows of a stream, at most `most`. An empty result means that no row is
/// available yet. The last row of the stream has `last` set.
using RowSource = std::function<std::vector<wire::Row>(std::size_t most)>;

/// A stream of rows, which may be longer than any memory, or computed while it is played.
struct RowPlan {
  std::string executor = {};     ///< name of the axis
  wire::Queue queue{};           ///< a dynamic queue, over time in s or over a master
  RowSource rows = {};           ///< source of the rows
  std::int64_t start_tick = -1;  ///< tick of the start; -1: the next one
  /// True: after an underrun, the stream continues when the prefill has arrived again.
  bool resume = false;
};

/// Returns the rows of a table, from its first knot on. x and p are relative to the first knot.
RowSource source_of(Table table);

/// Returns a row in its wire format.
wire::Row on_wire(const SegmentRow& row);
/// Returns a row as an axis plays it.
SegmentRow segment_row(const wire::Row& row);

/// Range of a table's positions, relative to its first knot. A queue of the table's rows must
/// announce this range. u is the unit of the position.
struct Travel {
  double lowest = 0;   ///< lowest position, u, <= 0
  double highest = 0;  ///< highest position, u, >= 0
  double net = 0;      ///< position at the end, u
};
/// Returns the exact range: from the extrema of the rows, computed as an executor computes them.
Travel travel_of(const Table& table);

/// Progress of a stream of rows.
struct RowProgress {
  std::uint64_t sent = 0;          ///< number of rows taken from the source
  std::uint64_t acknowledged = 0;  ///< number of rows that the executor has acknowledged
  std::uint64_t played = 0;        ///< number of rows that were played
  std::size_t messages = 0;        ///< number of messages with rows, without repetitions
  std::size_t resent = 0;          ///< number of messages that were sent again
  int underruns = 0;               ///< number of stops of the axis because rows were missing
  bool started = false;            ///< true: the motion has begun
  bool all = false;                ///< true: the executor has the last row
  bool finished = false;           ///< true: the executor has played the last row
};

/// Outcome of a rolling stream. An underrun is an error unless the plan resumes.
struct [[nodiscard]] RowOutcome : CallOutcome {
  RowProgress progress{};  ///< progress at the end
};

}  // namespace jounce
