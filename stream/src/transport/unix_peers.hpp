// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>

namespace jounce::detail {

/// The most programs that can use one socket folder at a time.
inline constexpr std::size_t most_peers = 64;

/// The sockets of all programs that use a socket folder, one connection each: a program that takes
/// nothing fills its own connection and no other.
class UnixPeers {
 public:
  explicit UnixPeers(std::filesystem::path folder);
  ~UnixPeers();
  UnixPeers(const UnixPeers&) = delete;
  UnixPeers& operator=(const UnixPeers&) = delete;

  /// Connects to the sockets that have appeared and forgets those that have gone; removes those whose
  /// program has ended without doing so. Throws TransportError where the folder cannot be read.
  void refresh();

  [[nodiscard]] std::size_t size() const { return peers_.size(); }

  /// Sends a datagram to all of them. Waits a moment for one whose queue is full, then goes on: for
  /// that one the datagram is lost, and so are the next until it takes one.
  void send(std::span<const std::byte> datagram);

 private:
  struct Peer {
    int socket = -1;
    bool takes = true;
    bool listed = true;
  };

  using Peers = std::map<std::string, Peer>;

  void add(const std::string& name);
  Peers::iterator forget(Peers::iterator at);
  [[nodiscard]] static bool send_to(Peer& peer, std::span<const std::byte> datagram);

  std::filesystem::path folder_;
  Peers peers_;
};

}  // namespace jounce::detail
