// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace jounce {

/// A multicast group of IPv4, and the range of its packets:
///
///     udpm://239.255.76.67:7667                        this machine: its loopback interface
///     udpm://239.255.76.67:7667?ttl=1                  the interface of the group's route
///     udpm://239.255.76.67:7667?ttl=1&interface=eth1   that interface
struct MulticastAddress {
  std::string group;          ///< 224.0.0.0 to 239.255.255.255, in digits
  std::uint16_t port = 7667;  ///< port of UDP, > 0
  int ttl = 0;  ///< routers that a packet may pass, plus 1; 0: it stays on this machine
  std::string interface {};  ///< its name; empty: that of the route; with ttl 0 always empty
  int receive_buffer = 1 << 22;  ///< requested bytes; Linux gives up to net.core.rmem_max

  /// True if packets come only from this machine and go only to this machine.
  [[nodiscard]] bool is_local() const { return ttl == 0; }
};

/// Throws InputError for anything other than "udpm://GROUP:PORT" with ttl, interface,
/// recv_buf_size.
MulticastAddress multicast_address(const std::string& url);

/// True if packets to and from an address of open_transport() stay on this machine. Throws
/// InputError like multicast_address().
bool is_local(const std::string& url);

}  // namespace jounce
