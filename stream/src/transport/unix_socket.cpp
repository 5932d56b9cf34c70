// SPDX-License-Identifier: Apache-2.0
#include "stream/src/transport/unix_socket.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string_view>

#include <fmt/format.h>
#include <sys/socket.h>

#include "jounce/stream/transport/link.hpp"

namespace jounce::stream_detail {
namespace {

constexpr std::string_view prefix = "jounce-";
constexpr std::size_t name_digits = 16;

}  // namespace

std::string unique_socket_name() {
  return fmt::format("{}{:016x}", prefix, static_cast<std::uint64_t>(random_id()));
}

bool is_socket_name(const std::string& name) {
  return name.size() == prefix.size() + name_digits && name.starts_with(prefix) &&
         name.find_first_not_of("0123456789abcdef", prefix.size()) == std::string::npos;
}

sockaddr_un address_of(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, path.c_str(), std::min(path.size(), sizeof address.sun_path - 1));
  return address;
}

int datagram_socket() {
  const int made = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (made < 0) throw TransportError(std::string("cannot make a socket: ") + std::strerror(errno));
  return made;
}

}  // namespace jounce::stream_detail
