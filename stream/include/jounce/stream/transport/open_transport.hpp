// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// The link that an address names, the only place where an address chooses one:
///
///     udpm://239.255.76.67:7667    LCM's multicast, on this machine; ?ttl=1: on its network. See UdpTransport
///     memq://                      this object alone
///     unix://FOLDER                Unix sockets in a folder, see UnixTransport
///
/// Throws InputError for any other, and what that transport throws.
std::unique_ptr<Transport> open_transport(const std::string& url);

}  // namespace jounce
