// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "jounce/profiles/error.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// Opens the link for an address:
///
///     udpm://239.255.76.67:7667    LCM multicast on this machine, ?ttl=1: network (UdpTransport)
///     memq://                      within this object only, for tests
///     unix://FOLDER                Unix sockets in a folder (UnixTransport)
///
/// Throws InputError for any other address, and the exceptions of the selected transport.
std::unique_ptr<Transport> open_transport(const std::string& url);

}  // namespace jounce
