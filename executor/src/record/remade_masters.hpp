// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "jounce/executor/record.hpp"

namespace jounce::detail {

/// The masters of a record, made again from what came in of them.
///
///     masters.add(recorded);                            // in order, before all else
///     masters.take(sample);                             // of the cycle that follows
///     if (const auto what = masters.compare(sight, time)) ...   // what it sees otherwise than the cycle did
///
/// Throws InputError for a filter that cannot be, and for more samples than a cycle takes.
class RemadeMasters {
 public:
  void add(const RecordedMaster& master);
  void take(const RecordedSample& sample);
  /// `time`: s, of the sight's tick. Nothing of a master that was made elsewhere.
  [[nodiscard]] std::optional<TickDifference> compare(const RecordedSight& seen, double time);

 private:
  struct One {
    std::unique_ptr<ExternalMaster> heard = {};
    std::unique_ptr<EncoderMaster> read = {};
  };
  std::vector<One> masters_;
};

}  // namespace jounce::detail
