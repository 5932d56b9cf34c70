// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "jounce/executor/detail/record.hpp"

namespace jounce::executor_detail {

/// The masters of a record, computed again from their recorded inputs.
///
///     masters.add(recorded);                            // in order, before everything else
///     masters.take(sample);                             // for the next cycle
///     if (const auto what = masters.compare(sight, time)) ...   // difference from the cycle
///
/// Throws InputError for an invalid filter, and if there are more samples than one cycle can take.
class RemadeMasters {
 public:
  /// Adds a master. Call it in the order of the masters, before all other functions.
  void add(const RecordedMaster& master);
  /// Adds a sample for the next cycle.
  void take(const RecordedSample& sample);
  /// Computes the value of a master, and returns its difference from the recorded value; nullopt:
  /// none, or the master is not in the record (Made::elsewhere). `time`: time of the tick, s.
  [[nodiscard]] std::optional<TickDifference> compare(const RecordedSight& seen, double time);

 private:
  struct One {
    std::unique_ptr<ExternalMaster> heard = {};
    std::unique_ptr<EncoderMaster> read = {};
  };
  std::vector<One> masters_;
};

}  // namespace jounce::executor_detail
