// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/detail/farewell.hpp"

namespace jounce {

void Farewell::begin(std::int32_t last, bool stops) {
  bodies_.clear();
  if (stops) bodies_.emplace_back(wire::Stop{.command = ++last});
  release_ = ++last;
  bodies_.emplace_back(wire::Heartbeat{.command = release_, .release = true});
  sent_.reset();
  left_ = times;
}

std::vector<wire::Body> Farewell::due(Nanos now, Nanos repeat) {
  if (over() || (sent_ && now - *sent_ < repeat)) return {};
  sent_ = now;
  --left_;
  return bodies_;
}

void Farewell::take(const wire::Reply& reply) {
  if (reply.command == release_) left_ = 0;
}

}  // namespace jounce
