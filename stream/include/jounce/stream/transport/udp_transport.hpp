// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "jounce/stream/transport/address.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// A link over UDP multicast that carries LCM's packets (lcm-proj.github.io, "UDP Multicast
/// Protocol"): LCM's own programs, and others that use LCM, send to it and receive from it. A
/// message is one datagram. LCM splits messages above 65 499 bytes into fragments: these are longer
/// than any message of this protocol and are dropped.
///
/// It receives only packets to its group and port through its own interface:
/// - with ttl 0 that interface is loopback, so that packets come from this machine alone. LCM's own
///   library, with ttl 0, limits only its output, and receives from every machine.
/// - its socket is bound to the group: it does not receive datagrams to this machine's own address.
/// - it does not receive groups that another program has joined on another interface
///   (IP_MULTICAST_ALL is off).
class UdpTransport : public Transport {
 public:
  /// Throws TransportError if the interface is missing or down, or if there is no route to the
  /// group.
  explicit UdpTransport(const MulticastAddress& address);
  ~UdpTransport() override;
  UdpTransport(const UdpTransport&) = delete;
  UdpTransport& operator=(const UdpTransport&) = delete;

  /// `channel`: at most 63 characters, LCM's limit. A * stands for any text without a dot:
  /// "JOUNCE2.*.status" matches those of all executors.
  void subscribe(const std::string& channel, int capacity) override;
  /// A packet that the network rejects is lost, like others. At most 65 499 bytes with the channel.
  void send(const std::string& channel, std::span<const std::byte> bytes) override;
  std::optional<Packet> receive(Nanos timeout) override;

 private:
  struct Subscription {
    std::string pattern;
    int capacity = 1;
    int waiting = 0;
  };
  struct Waiting {
    Packet packet;
    std::size_t subscription;
  };

  void take_what_came();
  void take(std::span<const std::byte> datagram);

  class Socket;
  std::unique_ptr<Socket> socket_;
  std::vector<Subscription> subscriptions_;
  std::deque<Waiting> waiting_;
  std::vector<std::byte> received_;
  std::uint32_t sent_ = 0;
};

}  // namespace jounce
