// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace jounce {

/// A multicast group of IPv4, and how packets travel there:
///
///     udpm://239.255.76.67:7667                        this machine: its loopback interface
///     udpm://239.255.76.67:7667?ttl=1                  the interface to which the group's route leads
///     udpm://239.255.76.67:7667?ttl=1&interface=eth1   that interface
struct MulticastAddress {
  std::string group;          ///< 224.0.0.0 to 239.255.255.255, in digits
  std::uint16_t port = 7667;  ///< port of UDP, > 0
  int ttl = 0;  ///< routers that a packet may pass, plus 1; 0: it stays on this machine
  std::string interface {};  ///< its name; empty: where the route leads; with ttl 0 always empty
  int receive_buffer = 1 << 22;  ///< bytes that are asked for; Linux gives up to net.core.rmem_max

  /// Packets come from this machine alone and go to this machine alone.
  [[nodiscard]] bool is_local() const { return ttl == 0; }
};

/// Throws InputError for anything else than "udpm://GROUP:PORT" with ttl, interface, recv_buf_size.
MulticastAddress multicast_address(const std::string& url);

/// True if what is sent to an address of open_transport(), and what is received from it, stays on this
/// machine. Throws InputError as multicast_address() does.
bool is_local(const std::string& url);

}  // namespace jounce
