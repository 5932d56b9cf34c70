// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/transport/transport.hpp"

#include <algorithm>

namespace jounce {

Nanos steady_now() {
  return std::chrono::duration_cast<Nanos>(std::chrono::steady_clock::now().time_since_epoch());
}

Nanos nanos(double seconds) {
  return std::chrono::duration_cast<Nanos>(std::chrono::duration<double>(std::min(seconds, 1e9)));
}

}  // namespace jounce
