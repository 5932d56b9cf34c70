#include "jounce/stream/transport.hpp"

namespace jounce {

Nanos steady_now() {
  return std::chrono::duration_cast<Nanos>(std::chrono::steady_clock::now().time_since_epoch());
}

}  // namespace jounce
