// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "jounce/stream/transport/transport.hpp"

namespace jounce::stream_detail {

/// This program's socket in a socket folder, and a thread that receives the subscribed channels
/// from it. The thread is needed because Linux queues only about ten datagrams for a socket.
class UnixInbox {
 public:
  /// Throws TransportError if no socket can be created.
  explicit UnixInbox(const std::filesystem::path& folder);
  ~UnixInbox();
  UnixInbox(const UnixInbox&) = delete;
  UnixInbox& operator=(const UnixInbox&) = delete;

  /// Path of the socket.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// See Transport::subscribe().
  void subscribe(const std::string& channel, int capacity);
  /// See Transport::receive().
  std::optional<Packet> receive(Nanos timeout);

 private:
  struct Subscription {
    int capacity = 1;
    int waiting = 0;
  };
  struct Waiting {
    Packet packet;
    Subscription* subscription;
  };

  void read();
  void keep(Packet packet);

  std::filesystem::path path_;
  int socket_ = -1;
  std::mutex mutex_;  // protects all below
  std::condition_variable arrived_;
  std::map<std::string, Subscription> subscriptions_;
  std::deque<Waiting> waiting_;
  bool ending_ = false;
  int error_ = 0;  // errno that ended the thread
  std::thread thread_;
};

}  // namespace jounce::stream_detail
