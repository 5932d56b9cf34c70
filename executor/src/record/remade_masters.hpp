// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "jounce/executor/record.hpp"

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
  void add(const RecordedMaster& master);
  void take(const RecordedSample& sample);
  /// `time`: s, of the sight's tick. Returns nullopt for a master from elsewhere.
  [[nodiscard]] std::optional<TickDifference> compare(const RecordedSight& seen, double time);

 private:
  struct One {
    std::unique_ptr<ExternalMaster> heard = {};
    std::unique_ptr<EncoderMaster> read = {};
  };
  std::vector<One> masters_;
};

}  // namespace jounce::executor_detail
