// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "jounce/axis/movement.hpp"
#include "jounce/executor/record.hpp"
#include "jounce/stream/receiver/receiver.hpp"

namespace jounce {

/// Parts of a movement, for the record.
struct MadeFrom {
  RecordedJob job;
  StoredTable time;
  std::optional<StoredTable> cam = {};
};

/// A movement made of tables, with its start and end position, u, if available.
struct MadeMovement {
  std::shared_ptr<Movement> movement = {};
  std::optional<double> first = {};
  std::optional<double> last = {};
  std::optional<MadeFrom> source = {};
};

/// Builds the movement of an arm, for an axis with this period, ns, that stands at `position`, u,
/// when it begins; without a movement if the tables do not fit. Its duration is proportional to the
/// size of the tables.
MadeMovement movement_of(const ArmRequested& arm, std::uint64_t id, std::int64_t period,
                         double position);

}  // namespace jounce
