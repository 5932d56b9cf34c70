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

/// Connects links within one process. A message on one link reaches all subscribers at once and
/// complete, including the sender.
class MemoryNetwork {
 public:
  /// Called where a real link would wait, with the longest duration of the wait. In this function,
  /// a test advances its virtual clock and runs the other side. May be empty.
  std::function<void(Nanos)> on_wait;

 private:
  friend class MemoryTransport;
  std::vector<MemoryTransport*> links_;
};

/// One link of a MemoryNetwork. The network must outlive the link. Use all links of a network in
/// one thread.
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
