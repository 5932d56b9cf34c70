#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "jounce/stream/message.hpp"

namespace jounce {

/// How far a streamer goes.
enum class StreamGoal { download, arm, start };

/// What is to be streamed where, and what is to become of it.
struct StreamPlan {
  struct Item {
    Table table;
    Units units;
  };
  std::string executor;      ///< its name
  std::vector<Item> tables;  ///< 1...64; the first one is the slave's, the second the master's
  StreamGoal goal = StreamGoal::start;
  wire::ArmMode mode = wire::ArmMode::play;
  CouplingSpec coupling{};       ///< of a slave that follows a master, in s; without master_jump
  std::int64_t start_tick = -1;  ///< of the executor; -1: the next one
};

/// Throws InputError for no or too many tables, a bad tick, or, unless the goal is to download
/// only, tables whose axes or units do not fit the mode, or a bad coupling.
void require_valid(const StreamPlan& plan);

/// What announces this table as number `index` of a session. Throws InputError for too many knots.
wire::Header header_of(const StreamPlan::Item& item, std::size_t index);

/// Chunk `seq` of the table with this header.
wire::Chunk chunk_of(const Table& table, const wire::Header& header, std::uint32_t seq);

}  // namespace jounce
