// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "jounce/axis/axis.hpp"
#include "jounce/stream/message/message.hpp"

namespace jounce {

/// The last start that a stream requested, and its outcome: the answer of the axis, then the ticks
/// decide it.
///
///     LastStart start;
///     start.request(session, command, movement);
///     start.answer(session, command, refused);      // waiting, or none
///     start.follow(before, tick);                   // every tick: begun, or dropped
///     start.report(status, session, "mm");
class LastStart {
 public:
  /// `movement`: id of the armed movement.
  void request(std::int64_t session, std::int32_t command, std::uint64_t movement);
  /// The answer of the axis to a start; without effect for another one than the last.
  void answer(std::int64_t session, std::int32_t command, const std::optional<Refusal>& refused);
  /// An accepted start begins, or its armed movement is gone.
  void follow(const Tick& before, const Tick& now);

  [[nodiscard]] wire::StartOutcome outcome() const { return outcome_; }
  /// Sets the fields of the start in the status for this session. `unit` is that of the positions.
  void report(wire::Status& status, std::int64_t session, const std::string& unit) const;

 private:
  std::int64_t session_ = 0;
  std::int32_t command_ = 0;
  std::uint64_t movement_ = 0;
  wire::StartOutcome outcome_ = wire::StartOutcome::none;
  Refusal why_{};
};

}  // namespace jounce
