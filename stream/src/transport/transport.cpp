// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

Nanos steady_now() {
  return std::chrono::duration_cast<Nanos>(std::chrono::steady_clock::now().time_since_epoch());
}

}  // namespace jounce
