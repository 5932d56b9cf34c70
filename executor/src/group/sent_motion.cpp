// SPDX-License-Identifier: Apache-2.0
// The parts of a program that was sent as a whole: from one M word that waits to the next, and in
// single step from one command to the next.
#include "executor/src/group/sent_motion.hpp"

#include <algorithm>
#include <utility>

#include "jounce/executor/detail/sent_program.hpp"

namespace jounce {

Stage SentMotion::stage_of(SentPart part, std::optional<Gate> gate) const {
  PathCommands end = commands_from(part.of->sent.program.place_before(part.last), *group_);
  return {.commands = std::move(end),
          .program = nullptr,
          .group = group_,
          .gate = gate,
          .sent = std::move(part)};
}

void SentMotion::begins(std::uint64_t movement, std::shared_ptr<const GroupProgram> motion,
                        std::shared_ptr<const SentProgram> sent, std::size_t last,
                        const Tick& group) {
  stages_.drop();
  stages_.begin_motion();
  cut_.reset();
  window_.reset();
  const std::vector<SentStage>& stages = sent->stages;
  const bool steps = stages_.single_step() || last < sent->window_end(stages.front(), 0);
  if (last < stages.front().last)
    stages_.add(stage_of({sent, 0, last, stages.front().last},
                         steps ? std::optional(Gate{.is_step = true}) : std::nullopt));
  for (std::size_t k = 1; k < stages.size(); ++k) {
    stages_.add(stage_of({sent, k, stages[k].first, stages[k].last},
                         Gate{*stages[k].m_word, group_->m_words.timeout}));
    stages_.last().program = stages[k].program;
    stages_.last().planned = stages[k].planned;
  }
  if (!stages_.empty()) stages_.first().finished = group.finished;
  playing_ = Playing{movement, std::move(motion), {std::move(sent), 0, 0, last}};
}

void SentMotion::begins(std::uint64_t movement, const Stage& stage) {
  playing_ = Playing{movement, stage.program, *stage.sent};
}

bool SentMotion::prepare() {
  Stage& stage = stages_.first();
  const SentPart part = *stage.sent;
  if (part.first == part.last) return true;
  if (!stage.preparing.valid()) {
    const SentStage& whole = part.of->stages[part.stage];
    stage.prepared_last = stages_.single_step()
                              ? part.of->step_end(part.first, part.last)
                              : std::min(part.of->window_end(whole, part.first), part.last);
    if (stage.program && stage.prepared_last == stage.planned) return divide(part);
    stage.preparing =
        planner_.begin({part.of, part.stage, part.first, stage.prepared_last}, nullptr, group_);
  }
  if (!is_ready(stage.preparing)) return false;
  PlannedMotion made = stage.preparing.get();
  if (!made.program) {
    stages_.notify("the rest of the program was dropped: " + made.reason);
    stages_.drop();
    return false;
  }
  stage.program = std::move(made.program);
  return divide(part);
}

/// The first stage has the commands before its prepared_last, and a further stage those after it.
bool SentMotion::divide(const SentPart& part) {
  Stage& stage = stages_.first();
  stage.sent->last = stage.prepared_last;
  stage.commands = commands_from(part.of->sent.program.place_before(stage.prepared_last), *group_);
  if (stage.prepared_last < part.last)
    stages_.add_second(
        stage_of({part.of, part.stage, stage.prepared_last, part.last}, stages_.step_gate()));
  return true;
}

std::optional<GroupStep> SentMotion::next(const Tick& group) {
  if (auto step = cut(group)) return step;
  return next_window(group);
}

bool SentMotion::answered(bool accepted, std::uint64_t movement, std::uint64_t finished) {
  if (cut_ && cut_->program) {
    cut_answered(accepted, movement, finished);
    return true;
  }
  if (!window_ || !window_->program) return false;
  window_answered(accepted, movement, finished);
  return true;
}

/// Single step begins during a part with several commands: the group continues with a shorter plan,
/// which ends at the end of a command. It is equal to the present plan up to its last command.
std::optional<GroupStep> SentMotion::cut(const Tick& group) {
  if (cut_ && cut_->program) return std::nullopt;
  if (!plays(group) || !in_motion(group) || !stages_.single_step()) {
    cut_.reset();
    cut_skips_ = 0;
    return std::nullopt;
  }
  if (!cut_ && (playing_->is_step || !begin_cut(group))) return std::nullopt;
  if (!is_ready(cut_->planned)) return std::nullopt;
  const PlannedMotion made = cut_->planned.get();
  if (!made.program || !made.agreement || made.agreement->until <= group.path_time) {
    cut_answered(false, 0, 0);
    return std::nullopt;
  }
  cut_->program = made.program;
  cut_->position = playing_->origin + made.agreement->position;
  return made.extension(cut_->position, {.kind = CommandKind::move_linear_absolute});
}

/// Plans the part up to the end of the present command, or of a later one. Returns false if the part
/// has no such command: it then ends at its end.
bool SentMotion::begin_cut(const Tick& group) {
  const SentPart& part = playing_->part;
  std::size_t last = part.first;
  const auto pieces = playing_->program->plan->drawn().pieces();
  const auto after =
      std::upper_bound(pieces.begin() + 1, pieces.end(), group.position - playing_->origin,
                       [](double at, const PathPiece& p) { return at < p.start; });
  const std::int32_t line = std::prev(after)->line;
  const auto commands = part.of->sent.program.commands();
  while (last < part.last && commands[last].line < line) ++last;
  for (std::size_t k = 0; k <= cut_skips_ && last < part.last; ++k)
    last = part.of->step_end(last, part.last);
  playing_->is_step = last >= part.last;
  if (playing_->is_step) return false;
  cut_ = Cut{.last = last,
             .planned = planner_.begin({part.of, part.stage, part.first, last}, playing_->program,
                                       group_)};
  return true;
}

/// The group has the shorter plan, or it came too late: the next attempt ends at a later command.
void SentMotion::cut_answered(bool accepted, std::uint64_t movement, std::uint64_t finished) {
  Cut cut = std::move(*cut_);
  cut_.reset();
  if (!accepted) {
    cut_skips_ = 2 * cut_skips_ + 1;
    return;
  }
  const bool continues = has_rest();
  const std::size_t end = continues ? stages_.first().sent->last : playing_->part.last;
  if (continues) stages_.end_first({});
  stages_.add_first(
      stage_of({playing_->part.of, playing_->part.stage, cut.last, end}, Gate{.is_step = true}),
      finished);
  playing_->part.last = cut.last;
  playing_->origin = cut.position;
  playing_->movement = movement;
  playing_->program = std::move(cut.program);
  playing_->is_step = true;
}

}  // namespace jounce
