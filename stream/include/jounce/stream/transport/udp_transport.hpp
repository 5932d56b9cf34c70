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

/// A link over UDP multicast that carries LCM's packets (lcm-proj.github.io, "UDP Multicast Protocol"): LCM's
/// own programs, and others that use LCM, send to it and receive from it. A message is one datagram; one in
/// fragments, which LCM makes above 65 499 bytes, is longer than any of this protocol and is dropped.
///
/// It receives what is sent to its group and port through its own interface, and nothing else:
/// - with ttl 0 that interface is loopback, so that packets come from this machine alone. LCM's own library
///   limits with ttl 0 what it sends, and receives from every machine.
/// - its socket is bound to the group: a datagram that is sent to this machine's own address is not taken.
/// - what another program of this machine has joined on another interface is not taken either
///   (IP_MULTICAST_ALL is off).
class UdpTransport : public Transport {
 public:
  /// Throws TransportError where the interface is missing or down, or where there is no route to the group.
  explicit UdpTransport(const MulticastAddress& address);
  ~UdpTransport() override;
  UdpTransport(const UdpTransport&) = delete;
  UdpTransport& operator=(const UdpTransport&) = delete;

  /// At most 63 characters, LCM's limit. A * stands for any text without a dot: "JOUNCE2.*.status" are
  /// those of all executors.
  void subscribe(const std::string& channel, int capacity) override;
  /// A packet that the network does not take is lost, as others are. At most 65 499 bytes with the channel.
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
