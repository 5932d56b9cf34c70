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
  RecordedJob job;                      ///< arguments of its constructor
  StoredTable time;                     ///< table over time; for a cam on a live master, the cam
  std::optional<StoredTable> cam = {};  ///< cam over a virtual master; nullopt: none
};

/// A movement made from tables.
struct MadeMovement {
  std::shared_ptr<Movement> movement = {};  ///< null: the tables do not fit together
  std::optional<double> first = {};         ///< start position, u (unit of the axis), if known
  std::optional<double> last = {};          ///< end position, u, if known
  std::optional<MadeFrom> source = {};      ///< parts of the movement
};

/// Makes the movement for an arm request. `id`: id of the movement. `period`: tick of the axis, ns.
/// `position`: position of the axis at the start, u. The result has no movement if the tables do
/// not fit together. The duration of the call is proportional to the size of the tables.
MadeMovement movement_of(const ArmRequested& arm, std::uint64_t id, std::int64_t period,
                         double position);

}  // namespace jounce
