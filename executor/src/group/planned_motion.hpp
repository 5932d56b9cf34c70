// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "jounce/axis/detail/group_program.hpp"
#include "jounce/axis/detail/path_commands.hpp"
#include "jounce/axis/detail/plan_agreement.hpp"
#include "jounce/executor/detail/sent_program.hpp"
#include "jounce/executor/detail/worker.hpp"
#include "jounce/executor/executor_options.hpp"

#include "executor/src/group/group_step.hpp"

namespace jounce {

/// A motion that a group can play, or the reason why there is none.
struct PlannedMotion {
  std::shared_ptr<const GroupProgram> program = {};
  std::optional<Agreement> agreement =
      {};                   ///< its agreement with the present program; nullopt: they differ
  std::string reason = {};  ///< error of the commands; empty: none
  double from = 0;          ///< length along the present path at which the program may take over, u

  /// Extends the path of the group at `position`. Requires program and agreement.
  [[nodiscard]] group_step::Extend extension(double position,
                                             const group_step::Request& request) const {
    return {program, position, agreement->shift, agreement->until, request};
  }
};

/// Single commands to plan. `before` and `q`: the present program, and the place of the group on it.
/// `fast`: the axes move from these positions, each in its shortest time.
struct PlanTask {
  PathCommands commands;
  std::shared_ptr<const GroupProgram> before = {};
  double q = 0;
  std::optional<Point> fast = {};
};

/// Commands of a program that was sent as a whole.
struct SentPart {
  std::shared_ptr<const SentProgram> of;
  std::size_t stage = 0;  ///< index of the stage to which they belong
  std::size_t first = 0;  ///< index of the first one
  std::size_t last = 0;   ///< index of the command after the last one
};

/// Returns a list without commands that begins at this place.
[[nodiscard]] PathCommands commands_from(const Point& place, const ExecutorGroup& group);

/// Plans single commands. Returns neither a program nor a reason if it was canceled.
[[nodiscard]] PlannedMotion planned_motion(const PlanTask& task, const ExecutorGroup& group,
                                           const std::atomic<bool>& canceled);
/// Plans a part of a program. `before`: a plan with the same beginning, which the group plays; null:
/// none.
[[nodiscard]] PlannedMotion planned_motion(const SentPart& part, const GroupProgram* before,
                                           const ExecutorGroup& group);
/// Plans a window of a program, and compares it with the one before, of `known` commands, in the middle
/// of the commands that both contain.
[[nodiscard]] PlannedMotion planned_window(const SentPart& part, const GroupProgram& before,
                                           std::size_t known, const ExecutorGroup& group);

/// The highest rate at which a group may play this program.
[[nodiscard]] double highest_rate_of(const GroupProgram& program);

/// Plans short motions at once, and long ones in the thread of a worker.
class MotionPlanner {
 public:
  /// `worker` must outlive the planner. `most_at_once`: the greatest number of commands that the
  /// calling thread plans itself.
  MotionPlanner(Worker& worker, std::size_t most_at_once)
      : worker_(worker), most_at_once_(most_at_once) {}

  /// Begins to plan so many commands.
  [[nodiscard]] std::future<PlannedMotion> begin(std::size_t commands,
                                                 std::function<PlannedMotion()> work);
  /// Begins to plan a part of a program.
  [[nodiscard]] std::future<PlannedMotion> begin(const SentPart& part,
                                                 std::shared_ptr<const GroupProgram> before,
                                                 std::shared_ptr<const ExecutorGroup> group);

 private:
  Worker& worker_;
  std::size_t most_at_once_;
};

/// True if the planning has ended.
[[nodiscard]] bool is_ready(const std::future<PlannedMotion>& planned);

}  // namespace jounce
