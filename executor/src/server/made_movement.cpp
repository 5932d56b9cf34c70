// SPDX-License-Identifier: Apache-2.0
#include "executor/src/server/made_movement.hpp"

#include <new>
#include <utility>

#include "jounce/axis/detail/group_path.hpp"
#include "jounce/axis/detail/live_cuts.hpp"
#include "jounce/axis/job.hpp"
#include "jounce/axis/live_cam.hpp"
#include "jounce/executor/detail/group_plan.hpp"
#include "jounce/executor/detail/sent_program.hpp"
#include "jounce/path/program_numbers.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {

MadeMovement movement_of(const ArmRequested& arm, std::uint64_t id, std::int64_t period,
                         double position) {
  const double tick = static_cast<double>(period) * 1e-9;
  try {
    if (arm.mode == wire::ArmMode::follow_input) {
      const auto end = static_cast<CamEnd>(arm.end);  // the numbers of both are equal
      const RecordedJob job{
          .id = id, .live = true, .tick = tick, .coupling = arm.coupling, .end = end};
      return {.movement = std::make_shared<LiveCam>(id, arm.slave.table, arm.coupling, end),
              .source = MadeFrom{job, arm.slave}};
    }
    auto job = arm.master ? std::make_shared<Job>(id, arm.master->table, arm.slave.table, tick,
                                                  arm.coupling, position)
                          : std::make_shared<Job>(id, arm.slave.table, nullptr, tick, arm.coupling);
    MadeMovement made{
        .movement = job, .first = job->first().slave[0], .last = job->last().slave[0]};
    made.source = MadeFrom{{.id = id, .tick = tick}, arm.master.value_or(arm.slave)};
    made.source->job.coupling = arm.coupling;
    if (arm.master) {
      made.source->cam = arm.slave;
      made.source->job.position = position;
    }
    return made;
  } catch (const InputError& error) {
    return {.reason = error.what()};
  } catch (const std::bad_alloc&) {
    return {};
  }
}

ExecutorCutter executor_cutter(const CutJob& job, const Units& units) {
  ExecutorCutter cutter{.task = std::make_shared<const CutTask>(job), .numbers = {}};
  Columns columns;
  columns.p = numbers_of(job);
  for (std::size_t i = 0; i < columns.p.size(); ++i) columns.x.push_back(static_cast<double>(i));
  cutter.numbers.table = std::make_shared<const Table>(Domain::master, Interpolation::linear,
                                                       Extrapolation::hold, std::move(columns));
  cutter.numbers.units = units;
  cutter.numbers.hash = content_hash(*cutter.numbers.table, units);
  return cutter;
}

MadeMovement movement_of(const ExecutorCutter& cutter, std::uint64_t id, const AxisConfig& config) {
  return {.movement = std::make_shared<LiveCuts>(id, cutter.task, config),
          .source = MadeFrom{{.id = id, .live = true, .cuts = true}, cutter.numbers}};
}

MadeMovement movement_of(std::shared_ptr<const GroupProgram> program, std::uint64_t id) {
  auto movement = std::make_shared<GroupPath>(id, *program);
  return {.movement = std::move(movement), .program = std::move(program)};
}

MadeMovement movement_of(std::shared_ptr<const SentProgram> sent, std::uint64_t id,
                         const ExecutorGroup& group, bool single_step) {
  std::size_t last = 0;
  MadeMovement made = movement_of(first_motion(*sent, single_step, group, last), id);
  made.sent = std::move(sent);
  made.sent_last = last;
  return made;
}

MadeMovement movement_of(const ArmRequested& arm, std::uint64_t id, const ExecutorGroup& group,
                         bool single_step, const std::atomic<bool>& canceled) {
  try {
    if (canceled) return {};
    LimitedProgram sent = program_of(arm.slave.table->columns().p);
    require_coordinates(sent, group);
    return movement_of(sent_program(std::move(sent), group, &canceled), id, group, single_step);
  } catch (const PlanCanceled&) {
    return {};
  } catch (const InputError& error) {
    return {.reason = error.what()};
  } catch (const std::bad_alloc&) {
    return {.reason = "the program does not fit into the memory of the executor"};
  }
}

}  // namespace jounce
