// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "jounce/stream/message/message.hpp"

namespace jounce {

/// Reason why a call to an executor failed.
enum class StreamError {
  none,             ///< it did not fail
  no_answer,        ///< the executor has never answered
  contact_lost,     ///< it has answered before, but no longer does
  stalled,          ///< it answers, but no chunk gets through
  command_timeout,  ///< it answers, but without an outcome of arm, start or stop
  out_of_time,      ///< the total time limit was reached
  restarted,        ///< the executor has restarted and lost its state
  refused,          ///< see refusal and reason
  underrun,         ///< rows arrived too slowly, and the axis has stopped on its path
  stopped,          ///< another sender has stopped the axis, or a fault has
  dropped,          ///< the start was accepted for later, but could not take place: see reason
};
const char* name(StreamError error);

/// Outcome of a call to an executor.
struct CallOutcome {
  StreamError error = StreamError::none;
  wire::Refusal refusal = wire::Refusal::none;
  std::int32_t cause = 0;  ///< the axis's number of the cause
  std::string reason{};    ///< in words; may be empty

  [[nodiscard]] bool ok() const { return error == StreamError::none; }
};

}  // namespace jounce
