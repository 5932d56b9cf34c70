// SPDX-License-Identifier: Apache-2.0
// The windows of a long program: the group changes from one plan to the next one while both are equal,
// as it does for single commands. If the next plan comes too late, or differs, the group rests at the
// end of its window, and the next window begins there.
#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

#include "jounce/executor/detail/sent_program.hpp"
#include "jounce/path/command_times.hpp"
#include "jounce/profiles/error.hpp"

#include "executor/src/group/group_queue.hpp"

namespace jounce {

/// True if the first stage has the commands that follow the present window.
bool GroupQueue::has_rest() const {
  if (!sent_ || stages_.empty() || stages_.front().gate) return false;
  const std::optional<SentPart>& rest = stages_.front().sent;
  return rest && rest->of == sent_->part.of && rest->first == sent_->part.last;
}

std::optional<GroupQueue::Step> GroupQueue::next_window(const Tick& group) {
  if (window_ && window_->program) return std::nullopt;
  const bool plays = sent_ && group.job == sent_->movement && in_motion(group);
  if (!plays || single_step_ || sent_->rests || !has_rest()) {
    window_.reset();
    return std::nullopt;
  }
  if (!window_) begin_window();
  if (!window_->made) {
    if (window_->planned.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
      return std::nullopt;
    window_->made = window_->planned.get();
  }
  const Planned& made = *window_->made;
  const bool late = !made.program || !made.agreement || group.path_time > made.agreement->until;
  if (late) {
    window_answered(false, 0);
    return std::nullopt;
  }
  if (group.position - sent_->origin < made.from) return std::nullopt;
  window_->program = made.program;
  window_->position = sent_->origin + made.agreement->position;
  return made.extension(window_->position, {.kind = CommandKind::move_linear_absolute});
}

void GroupQueue::begin_window() {
  SentPart part = sent_->part;
  const SentStage& stage = part.of->stages[part.stage];
  part.first = part.last - part.of->window.common;
  part.last = part.of->window_end(stage, sent_->part.last);
  const std::size_t known = sent_->part.last - sent_->part.first;
  auto work = [part, known, before = sent_->program, group = base_] {
    return planned_window(part, *before, known, *group);
  };
  window_ = Window{.first = part.first,
                   .last = part.last,
                   .planned = begun(part.last - part.first, std::move(work))};
}

/// Plans a window, and compares it with the one before, of `known` commands, in the middle of the
/// commands that both contain.
GroupQueue::Planned GroupQueue::planned_window(const SentPart& part, const GroupProgram& before,
                                               std::size_t known, const ExecutorGroup& group) {
  try {
    Planned made{.program = planned_part(*part.of, part.of->stages[part.stage], part.first,
                                         part.last, group)};
    const std::size_t common = part.of->window.common;
    const Program present =
        part.of->sent.program.part(part.first + common - known, part.first + common);
    const std::size_t middle = known - common / 2;
    made.from = command_starts(present, *before.plan, std::span(&middle, 1)).front().where;
    made.agreement = agreement(*before.plan, *made.program->plan, made.from);
    return made;
  } catch (const InputError& error) {
    return {.reason = error.what()};
  } catch (const std::bad_alloc&) {
    return {.reason = "the path does not fit into the memory of the executor"};
  }
}

void GroupQueue::window_answered(bool accepted, std::uint64_t movement) {
  Window window = std::move(*window_);
  window_.reset();
  sent_->rests = !accepted;
  if (!accepted) return;
  sent_->movement = movement;
  sent_->program = std::move(window.program);
  sent_->origin = window.position;
  sent_->part.first = window.first;
  sent_->part.last = window.last;
  std::optional<SentPart>& rest = stages_.front().sent;
  if (rest->last > window.last) {
    rest->first = window.last;
    return;
  }
  stages_.pop_front();
  if (!stages_.empty()) stages_.front().finished = finished_;
}

WindowRest GroupQueue::beyond(const Tick& group) const {
  if (!sent_ || group.job != sent_->movement || !has_rest()) return {};
  const SentPart& part = sent_->part;
  for (const WindowRest& rest : part.of->stages[part.stage].windows)
    if (rest.last == part.last) return rest;
  return {};
}

}  // namespace jounce
