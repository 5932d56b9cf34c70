// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "jounce/stream/message/message.hpp"

namespace jounce {

/// Last step of a streamer.
enum class StreamGoal { download, arm, start };

/// Tables that replace the active motion without a stop, if position, velocity and acceleration
/// meet.
struct SwapPlan {
  std::size_t slave = 0;   ///< in StreamPlan::tables, from 0
  std::size_t master = 0;  ///< for follow_table
  wire::ArmMode mode = wire::ArmMode::play;
  CouplingSpec
      coupling{};  ///< coupling of a slave that follows a master, in s; without master_jump
  StartAt when = StartAt::end_of_table;
  double position = 0;         ///< position of the master, m, with master_position
  CamEnd end = CamEnd::brake;  ///< for follow_input
};

/// Content, target and goal of a stream.
struct StreamPlan {
  struct Item {
    Table table;
    Units units;
    std::optional<Sha256> hash{};  ///< content_hash(table, units), if already computed
  };
  std::string executor;      ///< its name
  std::vector<Item> tables;  ///< 1...64; the first one is the slave's, the second the master's
  StreamGoal goal = StreamGoal::start;
  wire::ArmMode mode = wire::ArmMode::play;
  CouplingSpec
      coupling{};  ///< coupling of a slave that follows a master, in s; without master_jump
  std::int64_t start_tick = -1;  ///< start tick of the executor; -1: the next one
  StartAt when = StartAt::tick;  ///< or when the live master passes `position`
  double position = 0;           ///< position of the master, m, with master_position
  CamEnd end = CamEnd::brake;    ///< for follow_input
  bool await =
      false;  ///< the goal is reached when the last start has taken place, not when it is accepted
  std::vector<SwapPlan>
      swaps{};  ///< executed after that, each once the previous one has taken place
};

/// Throws InputError for no or too many tables, or a bad tick. Unless the goal is download, also
/// for tables whose axes or units do not fit the mode, and a bad coupling.
void require_valid(const StreamPlan& plan);

/// All starts of the plan: the first tables at their tick, then the swaps.
std::vector<SwapPlan> legs_of(const StreamPlan& plan);

/// Header of this table as number `index` of a session, in chunks of at most `values` doubles;
/// without its hash if the plan has none. Throws InputError for too many knots.
wire::Header header_of(const StreamPlan::Item& item, std::size_t index,
                       std::size_t values = wire::message_values);

/// Chunk `seq` of the table with this header.
wire::Chunk chunk_of(const Table& table, const wire::Header& header, std::uint32_t seq);

}  // namespace jounce
