// SPDX-License-Identifier: Apache-2.0
#include "executor/src/server/last_start.hpp"

#include "jounce/command/refusal_text.hpp"

namespace jounce {

void LastStart::request(std::int64_t session, std::int32_t command, std::uint64_t movement) {
  *this = {};
  session_ = session;
  command_ = command;
  movement_ = movement;
}

void LastStart::answer(std::int64_t session, std::int32_t command,
                       const std::optional<Refusal>& refused) {
  if (session != session_ || command != command_ || refused) return;
  if (outcome_ == wire::StartOutcome::none) outcome_ = wire::StartOutcome::waiting;
}

void LastStart::follow(const Tick& before, const Tick& now) {
  if (outcome_ != wire::StartOutcome::waiting) return;
  const bool ended = now.finished > before.finished && now.armed != movement_;
  if (now.job == movement_ || (ended && !now.dropped)) {
    outcome_ = wire::StartOutcome::begun;
  } else if (now.armed != movement_) {
    outcome_ = wire::StartOutcome::dropped;
    const Cause cause = now.fault != Cause::none ? now.fault : Cause::stopped;
    why_ = now.dropped.value_or(Refusal{.cause = cause});
  }
}

void LastStart::report(wire::Status& status, std::int64_t session, const std::string& unit) const {
  if (session_ != session || outcome_ == wire::StartOutcome::none) return;
  status.start_command = command_;
  status.start = outcome_;
  status.start_cause = static_cast<std::int32_t>(why_.cause);
  if (outcome_ == wire::StartOutcome::dropped) status.start_reason = text(why_, unit);
}

}  // namespace jounce
