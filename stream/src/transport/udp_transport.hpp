// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "jounce/stream/transport/transport.hpp"

#include "stream/src/transport/address.hpp"

namespace jounce {

/// A link over UDP multicast with the packets of LCM (lcm-proj.github.io, "UDP Multicast
/// Protocol"). Programs that use LCM can exchange messages with it. A message is one datagram. (LCM
/// splits messages above 65 499 bytes into fragments. No message of this protocol is that long, so
/// the link drops fragments.)
///
/// The link receives only packets to its group and port, and only through its own interface:
/// - With ttl 0, this interface is the loopback interface, so all packets come from this machine.
///   (With ttl 0, the library of LCM restricts only the packets that it sends, and receives from
///   every machine.)
/// - The socket is bound to the group, so it does not receive datagrams to the address of this
///   machine.
/// - It does not receive groups that another program has joined on another interface
///   (IP_MULTICAST_ALL is off).
class UdpTransport : public Transport {
 public:
  /// Throws TransportError if the interface does not exist or is down, or if the machine has no
  /// route to the group.
  explicit UdpTransport(const MulticastAddress& address);
  ~UdpTransport() override;
  UdpTransport(const UdpTransport&) = delete;
  UdpTransport& operator=(const UdpTransport&) = delete;

  /// `channel` has at most 63 characters, the limit of LCM. A * stands for any text without a dot:
  /// "JOUNCE2.*.status" matches the status channels of all executors.
  void subscribe(const std::string& channel, int capacity) override;
  /// Sends at most 65 499 bytes, including the name of the channel. A packet that the network
  /// rejects is lost.
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
