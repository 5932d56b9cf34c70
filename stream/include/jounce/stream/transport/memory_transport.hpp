// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "jounce/stream/transport/transport.hpp"

namespace jounce {

class MemoryTransport;

/// Connects the links of one process: a message sent on one reaches all subscribers, the sender
/// included, at once and complete.
class MemoryNetwork {
 public:
  /// Called at the points at which a real link would wait, with the longest time to wait: a test
  /// advances its virtual clock and the other side here. May be empty.
  std::function<void(Nanos)> on_wait;

 private:
  friend class MemoryTransport;
  std::vector<MemoryTransport*> links_;
};

/// One link of a MemoryNetwork, which must outlive it. One thread uses all links of a network.
class MemoryTransport : public Transport {
 public:
  explicit MemoryTransport(MemoryNetwork& network);
  ~MemoryTransport() override;
  MemoryTransport(const MemoryTransport&) = delete;
  MemoryTransport& operator=(const MemoryTransport&) = delete;

  void subscribe(const std::string& channel, int capacity) override;
  void send(const std::string& channel, std::span<const std::byte> bytes) override;
  std::optional<Packet> receive(Nanos timeout) override;

 private:
  struct Subscription {
    int capacity = 1;
    int waiting = 0;
  };

  MemoryNetwork& network_;
  std::map<std::string, Subscription> subscriptions_;
  std::deque<Packet> waiting_;
};

}  // namespace jounce
