// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/detail/master_intake.hpp"

namespace jounce {

bool MasterIntake::take(const wire::Master& message, Nanos now) {
  const bool other_unit = message.unit != options_.unit;
  if (other_unit) other_unit_ = message.unit;
  if (other_unit || !is_news(message, now)) {
    ++refused_;
    return false;
  }
  last_ = message;
  heard_ = now;
  ++taken_;
  return true;
}

bool MasterIntake::is_news(const wire::Master& message, Nanos now) const {
  if (taken_ == 0 || message.clock > last_.clock) return true;
  if (message.clock == last_.clock && message.seq > last_.seq && message.stamp_ns > last_.stamp_ns)
    return true;
  return !options_.keyed && now - heard_ > options_.forget;
}

}  // namespace jounce
