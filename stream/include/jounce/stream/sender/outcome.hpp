// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "jounce/stream/message/message.hpp"

namespace jounce {

/// Reason why a call to an executor failed.
enum class StreamError {
  none,             ///< the call did not fail
  no_answer,        ///< the executor has never answered
  contact_lost,     ///< the executor has answered before, but no longer answers
  stalled,          ///< the executor answers, but no chunk arrives
  command_timeout,  ///< the executor answers, but a command (arm, start or stop) has no outcome
  out_of_time,      ///< the total time limit was reached
  restarted,        ///< the executor has restarted and lost its state
  refused,          ///< the executor rejected a message: see refusal and reason
  underrun,         ///< rows arrived too slowly, and the axis has stopped on its path
  stopped,          ///< another sender or a fault has stopped the axis
  dropped,          ///< the start was accepted for later, but could not take place: see reason
};
const char* name(StreamError error);

/// Outcome of a call to an executor.
struct [[nodiscard]] CallOutcome {
  StreamError error = StreamError::none;
  wire::Refusal refusal = wire::Refusal::none;
  std::int32_t cause = 0;  ///< number of the Cause that the axis reported
  std::string reason{};    ///< the reason as text; may be empty
  std::int32_t fault = 0;  ///< number of the fault of the axis in its last status; 0: none

  [[nodiscard]] bool ok() const { return error == StreamError::none; }
};

}  // namespace jounce
