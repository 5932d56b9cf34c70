// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include <sys/un.h>

namespace jounce::stream_detail {

/// The longest name of a socket folder, in bytes: with a socket's name, and .new during its
/// creation, it fits Linux's address.
inline constexpr std::size_t longest_folder = 75;

/// A socket name that no other program has had or will have: removing the socket of an ended
/// program can therefore remove no other.
std::string unique_socket_name();

/// True if unique_socket_name() makes such names.
bool is_socket_name(const std::string& name);

/// The address of a path of at most 107 bytes.
sockaddr_un address_of(const std::string& path);

/// Opens a datagram socket. Throws TransportError if none is available.
int datagram_socket();

}  // namespace jounce::stream_detail
