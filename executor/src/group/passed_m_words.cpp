// SPDX-License-Identifier: Apache-2.0
#include "executor/src/group/passed_m_words.hpp"

#include <algorithm>
#include <utility>

namespace jounce {

void PassedMWords::begin(std::shared_ptr<const GroupProgram> program, double path_time) {
  program_ = std::move(program);
  next_ = 0;
  while (program_ && next_ < program_->m_words.size() && program_->m_words[next_].time < path_time)
    ++next_;
}

std::vector<wire::Event> PassedMWords::passed(const Tick& before, const Tick& now,
                                              std::int64_t period) {
  std::vector<wire::Event> events;
  if (!program_ || next_ == program_->m_words.size()) return events;
  const bool ends = now.job == 0;
  if (ends && now.finished == before.finished) return events;  // it was stopped
  const double dt = static_cast<double>((now.skipped + 1) * period) * 1e-9;
  const double rate = now.rate > 0 && !ends ? now.rate : before.rate;
  const double s = ends ? before.path_time + rate * dt : now.path_time;
  const auto& words = program_->m_words;
  for (; next_ < words.size() && (ends || words[next_].time < s); ++next_) {
    const auto& [time, number] = words[next_];
    events.push_back({.kind = wire::EventKind::m_word,
                      .number = static_cast<std::uint32_t>(number),
                      .on = false,
                      .tick = now.tick,
                      .offset_s = rate > 0 ? std::clamp((s - time) / rate, 0.0, dt) : 0,
                      .position = program_->plan->law().at(time).position});
  }
  return events;
}

}  // namespace jounce
