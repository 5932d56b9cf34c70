// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "jounce/stream/message/message.hpp"

namespace jounce {

/// Progress of a queue on an axis. Arrays have one entry for each of the two banks.
struct QueueLevel {
  /// Number of rows that were freed since the queue was opened.
  std::array<std::uint64_t, 2> freed{};
  std::int64_t played = 0;  ///< number of rows that were played since the queue was opened
  wire::Progress progress = wire::Progress::none;  ///< progress of the motion
};

}  // namespace jounce
