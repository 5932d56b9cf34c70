// SPDX-License-Identifier: Apache-2.0
// The parts of a program that was sent as a whole: from one M word that waits to the next, and in
// single step from one command to the next.
#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

#include "jounce/axis/detail/group_program.hpp"
#include "jounce/executor/detail/group_plan.hpp"
#include "jounce/executor/detail/sent_program.hpp"
#include "jounce/profiles/error.hpp"

#include "executor/src/group/group_queue.hpp"

namespace jounce {

GroupQueue::Stage GroupQueue::stage_of(SentPart part, std::optional<Gate> gate) const {
  PathCommands end = commands_from(part.of->sent.program.place_before(part.last));
  return {.commands = std::move(end),
          .program = nullptr,
          .group = base_,
          .gate = gate,
          .sent = std::move(part)};
}

void GroupQueue::begins(std::uint64_t movement, std::shared_ptr<const GroupProgram> motion,
                        std::shared_ptr<const SentProgram> sent, std::size_t last,
                        const Tick& group) {
  drop_stages();
  unacknowledged_ = false;
  cut_.reset();
  window_.reset();
  const std::vector<SentStage>& stages = sent->stages;
  const bool steps = single_step_ || last < sent->window_end(stages.front(), 0);
  if (last < stages.front().last)
    stages_.push_back(stage_of({sent, 0, last, stages.front().last},
                               steps ? std::optional(Gate{.is_step = true}) : std::nullopt));
  for (std::size_t k = 1; k < stages.size(); ++k) {
    stages_.push_back(stage_of({sent, k, stages[k].first, stages[k].last},
                               Gate{*stages[k].m_word, base_->m_words.timeout}));
    stages_.back().program = stages[k].program;
    stages_.back().planned = stages[k].planned;
  }
  if (!stages_.empty()) stages_.front().finished = group.finished;
  sent_ = PlayingSent{movement, std::move(motion), {std::move(sent), 0, 0, last}};
}

/// Plans a part of a program. `before`: a plan with
/// the same beginning, which the group plays; null: none.
std::future<GroupQueue::Planned> GroupQueue::part_planned(
    const SentPart& part, std::shared_ptr<const GroupProgram> before) {
  auto work = [part, before = std::move(before), group = base_]() -> Planned {
    try {
      Planned made{.program = planned_part(*part.of, part.of->stages[part.stage], part.first,
                                           part.last, *group)};
      if (!before) return made;
      made.agreement = agreement(*before->plan, *made.program->plan, 0);
      GroupProgram slopes_alike = *made.program;  // a change of the rate goes on in the same way
      slopes_alike.axes = before->axes;
      made.program = std::make_shared<const GroupProgram>(std::move(slopes_alike));
      return made;
    } catch (const InputError& error) {
      return {.reason = error.what()};
    } catch (const std::bad_alloc&) {
      return {.reason = "the path does not fit into the memory of the executor"};
    }
  };
  return begun(part.last - part.first, std::move(work));
}

/// Plans the first stage: one command in single step, otherwise all of its commands, or the first
/// window. Returns false if the plan is not ready, or if the stages were dropped.
bool GroupQueue::prepare() {
  Stage& stage = stages_.front();
  const SentPart part = *stage.sent;
  if (part.first == part.last) return true;
  if (!preparing_.valid()) {
    const SentStage& whole = part.of->stages[part.stage];
    prepared_last_ = single_step_ ? part.of->step_end(part.first, part.last)
                                  : std::min(part.of->window_end(whole, part.first), part.last);
    if (stage.program && prepared_last_ == stage.planned) return divide(part);
    preparing_ = part_planned({part.of, part.stage, part.first, prepared_last_}, nullptr);
  }
  if (preparing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
  Planned made = preparing_.get();
  if (!made.program) {
    dropped_because_ = "the rest of the program was dropped: " + made.reason;
    drop_stages();
    return false;
  }
  stage.program = std::move(made.program);
  return divide(part);
}

/// The first stage has the commands before prepared_last_, and a further stage those after it.
bool GroupQueue::divide(const SentPart& part) {
  Stage& stage = stages_.front();
  stage.sent->last = prepared_last_;
  stage.commands = commands_from(part.of->sent.program.place_before(prepared_last_));
  if (prepared_last_ < part.last)
    stages_.insert(stages_.begin() + 1,
                   stage_of({part.of, part.stage, prepared_last_, part.last},
                            single_step_ ? std::optional(Gate{.is_step = true}) : std::nullopt));
  return true;
}

/// Single step begins during a part with several commands: the group continues with a shorter plan,
/// which ends at the end of a command. It is equal to the present plan up to its last command.
std::optional<GroupQueue::Step> GroupQueue::cut(const Tick& group) {
  const bool plays = sent_ && group.job == sent_->movement && in_motion(group);
  if (cut_ && cut_->program) return std::nullopt;
  if (!plays || !single_step_) {
    cut_.reset();
    cut_skips_ = 0;
    return std::nullopt;
  }
  if (!cut_ && (sent_->is_step || !begin_cut(group))) return std::nullopt;
  if (cut_->planned.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return std::nullopt;
  const Planned made = cut_->planned.get();
  if (!made.program || !made.agreement || made.agreement->until <= group.path_time) {
    cut_answered(false, 0);
    return std::nullopt;
  }
  cut_->program = made.program;
  cut_->position = sent_->origin + made.agreement->position;
  return made.extension(cut_->position, {.kind = CommandKind::move_linear_absolute});
}

/// Plans the part up to the end of the present command, or of a later one. Returns false if the part
/// has no such command: it then ends at its end.
bool GroupQueue::begin_cut(const Tick& group) {
  const SentPart& part = sent_->part;
  std::size_t last = part.first;
  const auto pieces = sent_->program->plan->drawn().pieces();
  const auto after =
      std::upper_bound(pieces.begin() + 1, pieces.end(), group.position - sent_->origin,
                       [](double at, const PathPiece& p) { return at < p.start; });
  const std::int32_t line = std::prev(after)->line;
  const auto commands = part.of->sent.program.commands();
  while (last < part.last && commands[last].line < line) ++last;
  for (std::size_t k = 0; k <= cut_skips_ && last < part.last; ++k)
    last = part.of->step_end(last, part.last);
  sent_->is_step = last >= part.last;
  if (sent_->is_step) return false;
  cut_ = Cut{.last = last,
             .planned = part_planned({part.of, part.stage, part.first, last}, sent_->program)};
  return true;
}

/// The group has the shorter plan, or it came too late: the next attempt ends at a later command.
void GroupQueue::cut_answered(bool accepted, std::uint64_t movement) {
  Cut cut = std::move(*cut_);
  cut_.reset();
  if (!accepted) {
    cut_skips_ = 2 * cut_skips_ + 1;
    return;
  }
  const bool continues = has_rest();
  const std::size_t end = continues ? stages_.front().sent->last : sent_->part.last;
  if (continues) stages_.pop_front();
  stages_.push_front(
      stage_of({sent_->part.of, sent_->part.stage, cut.last, end}, Gate{.is_step = true}));
  if (stages_.size() > 1) stages_[1].finished.reset();
  stages_.front().finished = finished_;
  sent_->part.last = cut.last;
  sent_->origin = cut.position;
  sent_->movement = movement;
  sent_->program = std::move(cut.program);
  sent_->is_step = true;
}

}  // namespace jounce
