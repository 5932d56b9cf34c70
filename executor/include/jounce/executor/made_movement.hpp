// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "jounce/axis/movement.hpp"
#include "jounce/executor/record.hpp"
#include "jounce/stream/receiver/receiver.hpp"

namespace jounce {

/// The parts from which a movement was made, for the record.
struct MadeFrom {
  /// Arguments of its constructor.
  RecordedJob job;
  /// Table over time; for a cam on a live master, the cam.
  StoredTable time;
  /// Cam over a virtual master; nullopt: none.
  std::optional<StoredTable> cam = {};
};

/// A movement made from tables.
struct MadeMovement {
  /// Null: the tables do not fit together.
  std::shared_ptr<Movement> movement = {};
  /// Start position, u (unit of the axis), if known.
  std::optional<double> first = {};
  /// End position, u, if known.
  std::optional<double> last = {};
  /// Parts of the movement.
  std::optional<MadeFrom> source = {};
};

/// Makes the movement for an arm request. `id`: id of the movement. `period`: tick of the axis, ns.
/// `position`: position of the axis at the start, u. The result has no movement if the tables do
/// not fit together. The duration of the call is proportional to the size of the tables.
MadeMovement movement_of(const ArmRequested& arm, std::uint64_t id, std::int64_t period,
                         double position);

}  // namespace jounce
