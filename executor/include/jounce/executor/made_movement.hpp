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

/// A movement as it was made of tables, with where it begins and ends, u, if that is known.
struct MadeMovement {
  std::shared_ptr<Movement> movement = {};
  std::optional<double> first = {};
  std::optional<double> last = {};
  std::optional<MadeFrom> source = {};
};

/// The movement that an arm asks for, for an axis with this period, ns, that stands at `position`, u, when
/// it begins; none where the tables do not make one. Takes as long as the tables are large.
MadeMovement movement_of(const ArmRequested& arm, std::uint64_t id, std::int64_t period,
                         double position);

}  // namespace jounce
