// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "jounce/profiles/detail/entry_key.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::profiles_detail {

/// Throws InputError unless the `time` of every event is finite and greater than the time of the
/// previous event. The key of the error counts from 1: `key[2].time`.
template <class Event>
void require_ascending(const std::string& key, std::span<const Event> events) {
  for (std::size_t i = 0; i < events.size(); ++i) {
    const std::string name = entry_key(key, i, "time");
    require_finite(name.c_str(), events[i].time);
    if (i > 0 && !(events[i].time > events[i - 1].time))
      throw InputError(name, events[i].time,
                       "must be above the time before it, " + number(events[i - 1].time));
  }
}

}  // namespace jounce::profiles_detail
