// SPDX-License-Identifier: Apache-2.0
#include "executor/src/server/last_start.hpp"

#include <cmath>

#include "jounce/command/detail/refusal_text.hpp"
#include "jounce/profiles/detail/six_digits.hpp"

namespace jounce {

namespace {

std::string with_unit(double number, const std::string& unit) {
  return six_digits(number) + (unit.empty() ? "" : " " + unit);
}

/// "until its master passes 340 mm"
std::string awaited(const StartRequested& start, const std::string& unit) {
  switch (start.when) {
    case StartAt::master_position:
      return "until its master passes " + with_unit(start.position, unit);
    case StartAt::end_of_table:
      return "for the end of the present pass or table";
    case StartAt::tick:
      break;
  }
  return "for tick " + std::to_string(start.tick);
}

}  // namespace

std::string place_of_master(const Tick& now, double position, const std::string& unit) {
  const auto [place, velocity] = now.live_master;
  if (!std::isfinite(place)) return "its master sends no position";
  const std::string at = "its master is at " + with_unit(place, unit);
  if (velocity == 0 || !std::isfinite(velocity)) return at + ", and rests";
  const bool away = (position - place) * velocity < 0;
  return at + (away ? ", and moves away from " : ", and moves towards ") +
         with_unit(position, unit);
}

void LastStart::request(const StartRequested& start, std::uint64_t movement) {
  *this = {};
  requested_ = start;
  movement_ = movement;
}

void LastStart::answer(std::int64_t session, std::int32_t command,
                       const std::optional<Refusal>& refused) {
  if (session != requested_.session || command != requested_.command || refused) return;
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

void LastStart::report(wire::Status& status, std::int64_t session, const Units& units,
                       const Tick& now) const {
  if (outcome_ == wire::StartOutcome::waiting && now.armed == movement_) {
    status.start = outcome_;
    status.start_reason = awaited(requested_, units.x);
  }
  if (requested_.session != session || outcome_ == wire::StartOutcome::none) return;
  status.start_command = requested_.command;
  status.start = outcome_;
  status.start_cause = static_cast<std::int32_t>(why_.cause);
  if (outcome_ == wire::StartOutcome::dropped) status.start_reason = text(why_, units.position);
}

}  // namespace jounce
