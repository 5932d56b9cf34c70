// SPDX-License-Identifier: Apache-2.0
#include "stream/src/transport/unix_peers.hpp"

#include <cerrno>
#include <cstring>
#include <iterator>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include "jounce/stream/transport/transport.hpp"

#include "stream/src/transport/unix_socket.hpp"

namespace jounce::stream_detail {
namespace {

constexpr timeval patience{.tv_sec = 0, .tv_usec = 1000};  // the kernel rounds it up to its tick
constexpr int buffer_bytes = 1 << 20;                      // some large chunks of a table

/// Removes the socket of a killed program: nothing receives there any more. Names are never reused.
void remove_left_over(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_socket(path, ignored)) unlink(path.c_str());
}

}  // namespace

UnixPeers::UnixPeers(std::filesystem::path folder) : folder_(std::move(folder)) {}

UnixPeers::~UnixPeers() {
  for (auto& [name, peer] : peers_) close(peer.socket);
}

void UnixPeers::refresh() {
  for (auto& [name, peer] : peers_) peer.listed = false;
  std::error_code error;
  for (std::filesystem::directory_iterator at(folder_, error), end; !error && at != end;
       at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (!is_socket_name(name)) continue;
    if (const auto known = peers_.find(name); known != peers_.end())
      known->second.listed = true;
    else if (peers_.size() < most_peers)
      add(name);
  }
  if (error) throw TransportError(fmt::format("{}: {}", folder_.string(), error.message()));
  for (auto at = peers_.begin(); at != peers_.end();)
    at = at->second.listed ? std::next(at) : forget(at);
}

void UnixPeers::add(const std::string& name) {
  const std::filesystem::path path = folder_ / name;
  const sockaddr_un address = address_of(path.string());
  const int socket = datagram_socket();
  if (connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    if (errno == ECONNREFUSED) remove_left_over(path);
    close(socket);  // not permitted, or gone meanwhile: nothing to send to
    return;
  }
  setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  setsockopt(socket, SOL_SOCKET, SO_SNDBUF, &buffer_bytes, sizeof buffer_bytes);
  peers_[name] = {.socket = socket};
}

void UnixPeers::send(std::span<const std::byte> datagram) {
  for (auto at = peers_.begin(); at != peers_.end();) {
    if (send_to(at->second, datagram)) {
      ++at;
    } else {
      remove_left_over(folder_ / at->first);
      at = forget(at);
    }
  }
}

UnixPeers::Peers::iterator UnixPeers::forget(Peers::iterator at) {
  close(at->second.socket);
  return peers_.erase(at);
}

/// Sends to one peer; returns false if its other end is gone.
bool UnixPeers::send_to(Peer& peer, std::span<const std::byte> datagram) {
  const int wait = peer.takes ? 0 : MSG_DONTWAIT;
  const ssize_t sent = ::send(peer.socket, datagram.data(), datagram.size(), MSG_NOSIGNAL | wait);
  peer.takes = sent >= 0;
  return sent >= 0 ||
         (errno != ECONNREFUSED && errno != ENOTCONN && errno != EPIPE && errno != ECONNRESET);
}

}  // namespace jounce::stream_detail
