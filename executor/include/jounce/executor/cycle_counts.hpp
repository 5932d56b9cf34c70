// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace jounce {

/// Timing statistics of a cycle.
struct CycleCounts {
  std::int64_t ticks = 0;        ///< number of steps
  std::int64_t late = 0;         ///< steps that began a period or more too late
  std::int64_t skipped = 0;      ///< ticks that were skipped because of late steps
  std::int64_t latest_ns = 0;    ///< greatest delay of a step, ns
  std::int64_t computed_ns = 0;  ///< longest computation of a step, ns
  /// Ticks that were dropped because the ring to the communication thread was full.
  std::int64_t lost = 0;
};

}  // namespace jounce
