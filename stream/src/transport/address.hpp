// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace jounce {

/// An IPv4 multicast group, and the reach of its packets:
///
///     udpm://239.255.76.67:7667                        this machine: its loopback interface
///     udpm://239.255.76.67:7667?ttl=1                  the interface of the group's route
///     udpm://239.255.76.67:7667?ttl=1&interface=eth1   that interface
struct MulticastAddress {
  std::string group;          ///< 224.0.0.0 to 239.255.255.255
  std::uint16_t port = 7667;  ///< UDP port, > 0
  int ttl = 0;  ///< 0: packets stay on this machine; otherwise they may pass ttl - 1 routers
  std::string interface {};  ///< name of the interface; "": the interface of the route; with ttl 0
                             ///< always ""
  /// Requested receive buffer, bytes; Linux grants up to net.core.rmem_max.
  int receive_buffer = 1 << 22;

  /// True if packets can neither come from nor go to another machine.
  [[nodiscard]] bool is_local() const { return ttl == 0; }
};

/// Reads an address of the form "udpm://GROUP:PORT", with the options ttl, interface and
/// recv_buf_size. Throws InputError for any other text.
MulticastAddress multicast_address(const std::string& url);

/// True if the packets of a link to this address (see open_transport()) stay on this machine.
/// Throws InputError like multicast_address().
bool is_local(const std::string& url);

}  // namespace jounce
