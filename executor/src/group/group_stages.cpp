// SPDX-License-Identifier: Apache-2.0
#include "executor/src/group/group_stages.hpp"

#include "executor/src/group/group_text.hpp"

namespace jounce {

void GroupStages::add_first(Stage stage, std::uint64_t finished) {
  if (!stages_.empty()) stages_.front().finished.reset();
  stages_.push_front(std::move(stage));
  stages_.front().finished = finished;
}

void GroupStages::end_first(std::optional<std::uint64_t> finished) {
  stages_.pop_front();
  gate_since_ = -1;
  acknowledged_ = false;
  if (!stages_.empty()) stages_.front().finished = finished;
}

std::size_t GroupStages::drop() {
  const auto first = stages_.begin() + (starts_ ? 1 : 0);
  std::size_t dropped = 0;
  for (auto stage = first; stage != stages_.end(); ++stage) dropped += stage->size();
  stages_.erase(first, stages_.end());
  gate_since_ = -1;
  acknowledged_ = false;
  return dropped;
}

void GroupStages::drop(const std::string& reason) {
  if (const std::size_t dropped = drop(); dropped > 0)
    notice_ = reason + ": " + dropped_text(dropped);
}

std::size_t GroupStages::commands() const {
  std::size_t all = taken();
  for (const Stage& stage : stages_)
    if (stage.sent && stage.sent->first < stage.sent->last)
      all += stage.sent->last - stage.sent->first - (stage.gate ? 1 : 0);
  return all;
}

std::size_t GroupStages::taken() const {
  std::size_t all = 0;
  for (const Stage& stage : stages_)
    all += !stage.sent  ? stage.size()
           : stage.gate ? (stage.sent->first < stage.sent->last ? 2 : 1)
                        : 0;  // it belongs to the present motion
  return all;
}

std::optional<group_step::Announce> GroupStages::wait_at_gate(std::int64_t tick, double cycle) {
  const Gate gate = *stages_.front().gate;
  const bool arrives = gate_since_ < 0;
  if (arrives) gate_since_ = tick;
  if (arrives && !gate.is_step) return group_step::Announce{gate.m_word, true};
  const double waited = static_cast<double>(tick - gate_since_) * cycle;
  if (!(gate.timeout > 0 && waited >= gate.timeout)) return std::nullopt;
  unacknowledged_ = true;
  return group_step::Announce{gate.m_word, false, gate.timeout, drop() - 1};  // without the gate
}

std::optional<std::int32_t> GroupStages::m_word() const {
  return waits() && !stages_.front().gate->is_step ? std::optional(stages_.front().gate->m_word)
                                                   : std::nullopt;
}

Cause GroupStages::acknowledge(std::int32_t number) {
  if (!waits() || (number != 0 && number != m_word())) return Cause::no_handshake;
  acknowledged_ = true;
  return Cause::none;
}

Cause GroupStages::rests_because(bool moves) const {
  if (waits()) return Cause::awaits_acknowledge;
  return unacknowledged_ && !moves ? Cause::no_acknowledge : Cause::none;
}

}  // namespace jounce
