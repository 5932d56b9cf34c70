// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include <sys/un.h>

namespace jounce::stream_detail {

/// Greatest length of the path of a socket folder, bytes. With the name of a socket, and .new
/// during its creation, it fits into an address of Linux.
inline constexpr std::size_t longest_folder = 75;

/// Returns a socket name that no other program has or will have. Removing the socket of an ended
/// program can therefore not remove another one.
std::string unique_socket_name();

/// True if the name has the form of unique_socket_name().
bool is_socket_name(const std::string& name);

/// Returns the address of a path of at most 107 bytes.
sockaddr_un address_of(const std::string& path);

/// Opens a datagram socket. Throws TransportError if none is available.
int datagram_socket();

}  // namespace jounce::stream_detail
