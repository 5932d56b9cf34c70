// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "jounce/command/cause.hpp"
#include "jounce/command/detail/refusal_text.hpp"
#include "jounce/stream/message/message.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce::stream_detail {

// Texts of CallOutcome::reason that several streamers share.

inline constexpr const char* session_ended_reason =
    "the executor ended the session: an operator stopped the axis, or heartbeats were missing";

/// The reason of a reply to a session that has ended; an executor may give none.
inline std::string session_ended_by(const std::string& reason) {
  return reason.empty() ? session_ended_reason : reason;
}

/// Commanded position: "39.7 mm"
inline std::string place_of(const wire::Status& status) {
  const std::string& unit = status.units.position;
  return place_text(status.slave_position) + (unit.empty() ? "" : " " + unit);
}

/// "5000 ms"
inline std::string milliseconds(Nanos time) {
  return std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(time).count()) +
         " ms";
}

/// The time limit of the whole call was reached.
inline std::string time_over_reason(Nanos total) {
  return "the stream did not reach its goal within " + milliseconds(total);
}

/// The axis came to rest too early, for a cause of the axis. `before`: "the swap".
inline std::string at_rest_reason(const std::string& before, std::int32_t cause) {
  const auto why = static_cast<Cause>(cause);
  return "the axis came to rest before " + before + ": " + name(why) + ": " + meaning(why);
}

}  // namespace jounce::stream_detail
