// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "jounce/axis/tick.hpp"
#include "jounce/stream/detail/receiver.hpp"
#include "jounce/stream/message/message.hpp"

namespace jounce {

/// The last start that a client requested, and its outcome. The answer and the ticks of the axis
/// determine the outcome.
///
///     LastStart start;
///     start.request(request, movement);
///     start.answer(session, command, refused);      // waiting, or none
///     start.follow(before, tick);                   // every tick: begun, or dropped
///     start.report(status, session, units, tick);
class LastStart {
 public:
  /// Records a requested start. `movement`: id of the armed movement.
  void request(const StartRequested& start, std::uint64_t movement);
  /// Records the answer of the axis to a start. Has no effect if this start is not the last one.
  void answer(std::int64_t session, std::int32_t command, const std::optional<Refusal>& refused);
  /// Updates the outcome after a tick: an accepted start has begun, or its armed movement was
  /// dropped.
  void follow(const Tick& before, const Tick& now);

  /// Outcome of the start.
  [[nodiscard]] wire::StartOutcome outcome() const { return outcome_; }
  /// Sets the fields of the start in a status message for this session. Any session receives what a
  /// start waits for. `now`: the newest tick.
  void report(wire::Status& status, std::int64_t session, const Units& units,
              const Tick& now) const;

 private:
  StartRequested requested_{};
  std::uint64_t movement_ = 0;
  wire::StartOutcome outcome_ = wire::StartOutcome::none;
  Refusal why_{};
};

/// The place of a live master before a start at a position: "its master is at 2134 mm, and moves away
/// from 340 mm"; "its master sends no position".
std::string place_of_master(const Tick& now, double position, const std::string& unit);

}  // namespace jounce
