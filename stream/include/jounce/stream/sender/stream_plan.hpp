// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "jounce/stream/message/message.hpp"

namespace jounce {

/// Last step of a stream: send the tables, arm, or start.
enum class StreamGoal { download, arm, start };

/// Tables that take over from the present motion without a stop. Position, velocity and
/// acceleration must be continuous at the swap.
struct SwapPlan {
  std::size_t slave = 0;                     ///< index of the slave's table in StreamPlan::tables
  std::size_t master = 0;                    ///< index of the master's table; for follow_table
  wire::ArmMode mode = wire::ArmMode::play;  ///< the motion that the axis plays
  /// Coupling of a slave over a master, times in s; its master_jump is not transmitted.
  CouplingSpec coupling{};
  StartAt when = StartAt::end_of_table;  ///< instant of the swap
  double position = 0;  ///< for master_position: position of the master, m (unit of the master)
  CamEnd end = CamEnd::brake;  ///< for follow_input: behavior at the end of the cam
};

/// A stream: its tables, its axis, and its goal.
struct StreamPlan {
  /// A table of the stream.
  struct Item {
    Table table;                   ///< the table
    Units units = {};              ///< its units
    std::optional<Sha256> hash{};  ///< content_hash(table, units), if the caller has it already
  };
  std::string executor = {};            ///< name of the axis
  std::vector<Item> tables = {};        ///< 1 to 64 tables: the slave's first, then the master's
  StreamGoal goal = StreamGoal::start;  ///< the last step
  wire::ArmMode mode = wire::ArmMode::play;  ///< the motion that the axis plays
  /// Coupling of a slave over a master, times in s; its master_jump is not transmitted.
  CouplingSpec coupling{};
  std::int64_t start_tick = -1;  ///< tick of the start; -1: the next one
  /// `tick`, or `master_position` (when the live master passes `position`).
  StartAt when = StartAt::tick;
  double position = 0;  ///< for master_position: position of the master, m (unit of the master)
  CamEnd end = CamEnd::brake;  ///< for follow_input: behavior at the end of the cam
  /// True: the goal is reached when the last start has taken place; false: when it is accepted.
  bool await = false;
  /// Swaps after the start, each sent when the previous one has taken place.
  std::vector<SwapPlan> swaps{};
  /// Remark for the user: what this plan does not use, or what to consider; may be empty.
  std::string remark{};
};

/// Throws InputError for no tables, more than 64 tables, or a start tick below -1. Unless the goal
/// is `download`, also throws for a swap to a table that does not exist, tables whose variables or
/// units do not fit the mode, the mode `queue`, a position that is not finite, and an invalid
/// coupling.
void require_valid(const StreamPlan& plan);

/// Returns all starts of the plan in their order: the start of the first tables, then the swaps.
std::vector<SwapPlan> legs_of(const StreamPlan& plan);

/// Returns the header of a table. `index`: index of the table in the session. `values`: greatest
/// number of doubles in a chunk. The header has no hash if the item has none. Throws InputError for
/// too many knots.
wire::Header header_of(const StreamPlan::Item& item, std::size_t index,
                       std::size_t values = wire::message_values);

/// Returns chunk `seq` of the table with this header.
wire::Chunk chunk_of(const Table& table, const wire::Header& header, std::uint32_t seq);

}  // namespace jounce
