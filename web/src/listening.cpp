// SPDX-License-Identifier: Apache-2.0
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "jounce/profiles/error.hpp"
#include "jounce/web/server.hpp"

namespace jounce::web {
namespace {

constexpr int backlog = 1024;

sockaddr_in here(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

}  // namespace

Listening::Listening(std::uint16_t port)
    : descriptor_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  const int yes = 1;  // not SO_REUSEPORT: another process could share the port
  const sockaddr_in address = here(port);
  if (descriptor_ >= 0 &&
      setsockopt(descriptor_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes) == 0 &&
      bind(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
      listen(descriptor_, backlog) == 0)
    return;
  const std::string why = std::strerror(errno);
  if (descriptor_ >= 0) close(descriptor_);
  throw InputError(
      "port", std::to_string(port),
      "cannot be used on 127.0.0.1: " + why + ": choose another port, or 0 for any free one");
}

Listening Listening::inherited(int descriptor) {
  Listening listening;
  listening.descriptor_ = descriptor;
  return listening;
}

Listening::Listening(Listening&& other) noexcept : descriptor_(other.release()) {}

Listening::~Listening() {
  if (descriptor_ >= 0) close(descriptor_);
}

int Listening::release() {
  return std::exchange(descriptor_, -1);
}

std::uint16_t Listening::port() const {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  if (getsockname(descriptor_, reinterpret_cast<sockaddr*>(&address), &size) != 0 ||
      address.sin_family != AF_INET)
    throw InputError("port", std::to_string(descriptor_), "is no descriptor of a listening socket");
  return ntohs(address.sin_port);
}

}  // namespace jounce::web
