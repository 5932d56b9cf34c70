// SPDX-License-Identifier: Apache-2.0
#include "executor/src/group/planned_motion.hpp"

#include <algorithm>
#include <chrono>
#include <new>
#include <span>
#include <utility>
#include <vector>

#include "jounce/axis/detail/path_clock.hpp"
#include "jounce/executor/detail/group_plan.hpp"
#include "jounce/path/command_times.hpp"
#include "jounce/profiles/error.hpp"

#include "executor/src/group/group_text.hpp"

namespace jounce {
namespace {

/// The slope of the rate must hold also for the programs that continue this one: the axes may use
/// their limits there. If this program has a reserve, it can be played at a higher rate h. The peaks
/// then are those of a program that uses the limits at this rate.
GroupProgram with_peaks_of_limits(GroupProgram program) {
  const double h = highest_rate_of(program);
  for (GroupAxis& axis : program.axes) {
    const Limits& limits = axis.config.limits;
    axis.peaks = {.velocity = *limits.velocity / h,
                  .acceleration = *limits.acceleration / (h * h),
                  .jerk = limits.jerk ? *limits.jerk / (h * h * h) : axis.peaks.jerk};
  }
  return program;
}

/// Plans, and returns an error as a reason. `sentence`: the sentence of an error.
template <typename Work, typename Sentence>
PlannedMotion planned(const Work& work, const Sentence& sentence) {
  try {
    return work();
  } catch (const PlanCanceled&) {
    return {};
  } catch (const InputError& error) {
    return {.reason = sentence(error)};
  } catch (const std::bad_alloc&) {
    return {.reason = "the path does not fit into the memory of the executor"};
  }
}

std::string as_thrown(const InputError& error) {
  return error.what();
}

/// The program of a part, without a comparison.
std::shared_ptr<const GroupProgram> program_of(const SentPart& part, const ExecutorGroup& group) {
  return planned_part(*part.of, part.of->stages[part.stage], part.first, part.last, group);
}

}  // namespace

double highest_rate_of(const GroupProgram& program) {
  double rate = 2;
  for (const GroupAxis& axis : program.axes)
    rate = std::min(rate, highest_rate(axis.peaks, axis.config));
  return rate;
}

PathCommands commands_from(const Point& place, const ExecutorGroup& group) {
  PathCommands commands(group.coordinates().size(), place, 1, group.path_axes());
  std::vector<double> modulo;
  for (const AxisConfig& axis : group.configs) modulo.push_back(axis.modulo);
  if (!group.kinematics) commands.set_modulo(std::move(modulo));
  return commands;
}

PlannedMotion planned_motion(const PlanTask& task, const ExecutorGroup& group,
                             const std::atomic<bool>& canceled) {
  const auto work = [&]() -> PlannedMotion {
    const std::vector<Limits> limits = space_of(group).limits;
    const auto program =
        task.fast ? fast_program(*task.fast, task.commands.position(), group)
                  : planned_program(task.commands.program(), {.axes = limits}, group, &canceled);
    PlannedMotion made;
    if (task.before != nullptr) {
      made.agreement = agreement(*task.before->plan, *program->plan, task.q);
      if (!made.agreement) return made;
    }
    made.program = std::make_shared<const GroupProgram>(with_peaks_of_limits(*program));
    return made;
  };
  return planned(work, [&](const InputError& error) { return reason_of(error, group); });
}

PlannedMotion planned_motion(const SentPart& part, const GroupProgram* before,
                             const ExecutorGroup& group) {
  const auto work = [&]() -> PlannedMotion {
    PlannedMotion made{.program = program_of(part, group)};
    if (before == nullptr) return made;
    made.agreement = agreement(*before->plan, *made.program->plan, 0);
    GroupProgram slopes_alike = *made.program;  // a change of the rate goes on in the same way
    slopes_alike.axes = before->axes;
    made.program = std::make_shared<const GroupProgram>(std::move(slopes_alike));
    return made;
  };
  return planned(work, as_thrown);
}

PlannedMotion planned_window(const SentPart& part, const GroupProgram& before, std::size_t known,
                             const ExecutorGroup& group) {
  const auto work = [&]() -> PlannedMotion {
    PlannedMotion made{.program = program_of(part, group)};
    const std::size_t common = part.of->window.common;
    const Program present =
        part.of->sent.program.part(part.first + common - known, part.first + common);
    const std::size_t middle = known - common / 2;
    made.from = command_starts(present, *before.plan, std::span(&middle, 1)).front().where;
    made.agreement = agreement(*before.plan, *made.program->plan, made.from);
    return made;
  };
  return planned(work, as_thrown);
}

std::future<PlannedMotion> MotionPlanner::begin(std::size_t commands,
                                                std::function<PlannedMotion()> work) {
  if (commands > most_at_once_) return worker_.ask(std::move(work));
  std::promise<PlannedMotion> now;
  now.set_value(work());
  return now.get_future();
}

std::future<PlannedMotion> MotionPlanner::begin(const SentPart& part,
                                                std::shared_ptr<const GroupProgram> before,
                                                std::shared_ptr<const ExecutorGroup> group) {
  return begin(part.last - part.first,
               [part, before = std::move(before), group = std::move(group)] {
                 return planned_motion(part, before.get(), *group);
               });
}

bool is_ready(const std::future<PlannedMotion>& planned) {
  return planned.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace jounce
