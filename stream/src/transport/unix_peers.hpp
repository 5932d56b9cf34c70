// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>

namespace jounce::stream_detail {

/// Greatest number of programs that can use one socket folder at a time.
inline constexpr std::size_t most_peers = 64;

/// The sockets of all programs that use a socket folder. There is a separate connection to each: a
/// program that receives nothing fills only the queue of its own connection.
class UnixPeers {
 public:
  explicit UnixPeers(std::filesystem::path folder);
  ~UnixPeers();
  UnixPeers(const UnixPeers&) = delete;
  UnixPeers& operator=(const UnixPeers&) = delete;

  /// Connects to new sockets, drops removed ones, and deletes the sockets of ended programs. Throws
  /// TransportError if the folder cannot be read.
  void refresh();

  /// Number of connections.
  [[nodiscard]] std::size_t size() const { return peers_.size(); }

  /// Sends a datagram to all peers. Waits a moment for a peer whose queue is full. If it remains
  /// full, the datagram is lost for that peer, and later ones are sent to it without waiting until
  /// it receives again. Removes a peer whose other end is closed.
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

}  // namespace jounce::stream_detail
