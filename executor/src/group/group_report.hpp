// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "jounce/axis/tick.hpp"
#include "jounce/executor/executor_options.hpp"
#include "jounce/path/plan_progress.hpp"
#include "jounce/stream/message/message.hpp"

#include "executor/src/group/group_queue.hpp"

namespace jounce {

/// Makes the status message of a group from its ticks: its place on the path, and what remains.
///
///     GroupReport report;
///     report.status(group, tick, program, queue);              // every few milliseconds
class GroupReport {
 public:
  /// `places`: commanded positions of the axes of the group. `program`: the program that the group
  /// plays in this tick; null: none. `queue`: its single commands. The first call after a change of
  /// the program takes a time proportional to its length.
  [[nodiscard]] wire::GroupStatus status(const ExecutorGroup& group, const Tick& tick,
                                         const Point& places,
                                         const std::shared_ptr<const GroupProgram>& program,
                                         const GroupQueue& queue);

 private:
  std::shared_ptr<const GroupProgram> program_;  // program of progress_
  std::optional<PlanProgress> progress_;
};

}  // namespace jounce
