// SPDX-License-Identifier: Apache-2.0
#include "cli/machine/await_home.hpp"

#include <chrono>
#include <utility>
#include <variant>

#include "jounce/command/cause.hpp"
#include "jounce/stream/sender/driver.hpp"

#include "cli/common/interrupt.hpp"

namespace jounce::cli {
namespace {

using namespace std::chrono_literals;

CallOutcome failed(std::int32_t cause) {
  const auto why = static_cast<Cause>(cause);
  return {StreamError::refused, wire::Refusal::axis, cause,
          std::string("not homed: ") + name(why) + ": " + meaning(why)};
}

CallOutcome outcome_of(const wire::Status& status) {
  if (status.homed) return {};
  if (status.last_error != 0) return failed(status.last_error);
  return failed(status.reason);
}

}  // namespace

CallOutcome await_home(const std::string& executor, Client& client, Link& link) {
  const Interrupt interrupt;
  bool stopped = false;
  for (;;) {
    const auto message = next_status(link.transport(), executor, 50ms, steady_now, link.key());
    if (message) {
      const auto& status = std::get<wire::Status>(message->body);
      const bool moves = status.slave_velocity != 0;  // it may still brake, also in a fault
      const bool under_way = status.state == State::homing || moves;
      if (!under_way) return outcome_of(status);
    }
    if (interrupt.asked() && !std::exchange(stopped, true))
      if (const CallOutcome stop = client.stop(); !stop.ok()) return stop;
    if (const CallOutcome alive = client.beat(); !alive.ok()) return alive;
  }
}

}  // namespace jounce::cli
