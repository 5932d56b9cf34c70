// SPDX-License-Identifier: Apache-2.0
#include "stream/src/transport/memory_transport.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace jounce {

MemoryTransport::MemoryTransport(MemoryNetwork& network) : network_(network) {
  network_.links_.push_back(this);
}

MemoryTransport::~MemoryTransport() {
  std::erase(network_.links_, this);
}

void MemoryTransport::subscribe(const std::string& channel, int capacity) {
  assert(capacity >= 1);
  subscriptions_[channel].capacity = capacity;
}

void MemoryTransport::send(const std::string& channel, std::span<const std::byte> bytes) {
  for (MemoryTransport* link : network_.links_) {
    const auto it = link->subscriptions_.find(channel);
    if (it == link->subscriptions_.end() || it->second.waiting >= it->second.capacity) continue;
    ++it->second.waiting;
    link->waiting_.push_back({channel, {bytes.begin(), bytes.end()}});
  }
}

std::optional<Packet> MemoryTransport::receive(Nanos timeout) {
  if (waiting_.empty() && timeout > Nanos{} && network_.on_wait) network_.on_wait(timeout);
  if (waiting_.empty()) return std::nullopt;
  Packet packet = std::move(waiting_.front());
  waiting_.pop_front();
  --subscriptions_[packet.channel].waiting;
  return packet;
}

}  // namespace jounce
