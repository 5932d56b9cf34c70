// SPDX-License-Identifier: Apache-2.0
// The windows of a long program: the group changes from one plan to the next one while both are equal,
// as it does for single commands. If the next plan comes too late, or differs, the group rests at the
// end of its window, and the next window begins there.
#include <algorithm>
#include <utility>

#include "jounce/executor/detail/sent_program.hpp"

#include "executor/src/group/sent_motion.hpp"

namespace jounce {

/// True if the first stage has the commands that follow the present window.
bool SentMotion::has_rest() const {
  if (!playing_ || stages_.empty() || stages_.first().gate) return false;
  const std::optional<SentPart>& rest = stages_.first().sent;
  return rest && rest->of == playing_->part.of && rest->first == playing_->part.last;
}

std::optional<GroupStep> SentMotion::next_window(const Tick& group) {
  if (window_ && window_->program) return std::nullopt;
  const bool may_continue = plays(group) && in_motion(group) && !stages_.single_step();
  if (!may_continue || playing_->rests || !has_rest()) {
    window_.reset();
    return std::nullopt;
  }
  if (!window_) begin_window();
  if (!window_->made) {
    if (!is_ready(window_->planned)) return std::nullopt;
    window_->made = window_->planned.get();
  }
  const PlannedMotion& made = *window_->made;
  const bool late = !made.program || !made.agreement || group.path_time > made.agreement->until;
  if (late) {
    window_answered(false, 0, 0);
    return std::nullopt;
  }
  if (group.position - playing_->origin < made.from) return std::nullopt;
  window_->program = made.program;
  window_->position = playing_->origin + made.agreement->position;
  return made.extension(window_->position, {.kind = CommandKind::move_linear_absolute});
}

void SentMotion::begin_window() {
  SentPart part = playing_->part;
  const SentStage& stage = part.of->stages[part.stage];
  part.first = part.last - part.of->window.common;
  part.last = part.of->window_end(stage, playing_->part.last);
  const std::size_t known = playing_->part.last - playing_->part.first;
  auto work = [part, known, before = playing_->program, group = group_] {
    return planned_window(part, *before, known, *group);
  };
  window_ = Window{.first = part.first,
                   .last = part.last,
                   .planned = planner_.begin(part.last - part.first, std::move(work))};
}

void SentMotion::window_answered(bool accepted, std::uint64_t movement, std::uint64_t finished) {
  Window window = std::move(*window_);
  window_.reset();
  playing_->rests = !accepted;
  if (!accepted) return;
  playing_->movement = movement;
  playing_->program = std::move(window.program);
  playing_->origin = window.position;
  playing_->part.first = window.first;
  playing_->part.last = window.last;
  std::optional<SentPart>& rest = stages_.first().sent;
  if (rest->last > window.last) {
    rest->first = window.last;
    return;
  }
  stages_.end_first(finished);
}

WindowRest SentMotion::beyond(const Tick& group) const {
  if (!plays(group) || !has_rest()) return {};
  const SentPart& part = playing_->part;
  for (const WindowRest& rest : part.of->stages[part.stage].windows)
    if (rest.last == part.last) return rest;
  return {};
}

}  // namespace jounce
