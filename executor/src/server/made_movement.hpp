// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "jounce/axis/movement.hpp"
#include "jounce/executor/detail/record.hpp"
#include "jounce/executor/detail/sent_program.hpp"
#include "jounce/executor/executor_options.hpp"
#include "jounce/stream/detail/receiver.hpp"

namespace jounce {

/// The parts of a movement, for the record of the run.
struct MadeFrom {
  RecordedJob job;                      ///< arguments of the movement's constructor
  StoredTable time;                     ///< table over time; for a cam on a live master, the cam
  std::optional<StoredTable> cam = {};  ///< cam over a virtual master; nullopt: none
};

/// A movement made from tables.
struct MadeMovement {
  std::shared_ptr<Movement> movement = {};  ///< null: the tables do not fit together
  std::optional<double> first = {};         ///< start position, u (unit of the axis), if known
  std::optional<double> last = {};          ///< end position, u, if known
  std::optional<MadeFrom> source = {};      ///< parts of the movement
  std::shared_ptr<const GroupProgram> program = {};  ///< program of a group
  /// program that was sent as a whole, and whose first motion this is; null: none
  std::shared_ptr<const SentProgram> sent = {};
  std::size_t sent_last = 0;  ///< number of the command of `sent` after this motion
  /// sentence that states why no movement was made, if the reason is known
  std::string reason = {};
};

/// Makes the movement for an arm request. `id` is the id of the movement, `period` the tick of the
/// axis in ns, and `position` the position of the axis at the start, u. If the tables do not fit
/// together, the result has no movement. The duration of the call is proportional to the size of
/// the tables.
MadeMovement movement_of(const ArmRequested& arm, std::uint64_t id, std::int64_t period,
                         double position);

/// Makes the plan of cuts of an axis.
MadeMovement movement_of(const ExecutorCutter& cutter, std::uint64_t id, const AxisConfig& config);

/// Makes the movement of a group from its program.
MadeMovement movement_of(std::shared_ptr<const GroupProgram> program, std::uint64_t id);

/// Plans the path of an arm request within the limits of the axes of the group, and makes its
/// movement. The result has a reason instead if the numbers are not a program, or the path does not
/// suit the group. The duration of the call is proportional to the length of the program. If
/// `canceled` becomes true, the call ends early, without a movement. `single_step`: the movement is
/// the first command of the program.
MadeMovement movement_of(const ArmRequested& arm, std::uint64_t id, const ExecutorGroup& group,
                         bool single_step, const std::atomic<bool>& canceled);

/// Makes the first movement of a program that was sent as a whole.
MadeMovement movement_of(std::shared_ptr<const SentProgram> sent, std::uint64_t id,
                         const ExecutorGroup& group, bool single_step);

}  // namespace jounce
