// SPDX-License-Identifier: Apache-2.0
#include "stream/src/transport/unix_inbox.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include "stream/src/transport/datagram.hpp"
#include "stream/src/transport/unix_socket.hpp"

namespace jounce::stream_detail {
namespace {

/// Binds the socket under a temporary name, then renames it: senders see it only when it can
/// receive.
void bind_at(int socket, const std::filesystem::path& path) {
  const std::string unfinished = path.string() + ".new";
  const sockaddr_un address = address_of(unfinished);
  // The folder's permissions control sending; the umask would restrict the socket's own.
  if (bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      chmod(unfinished.c_str(), 0666) != 0 || rename(unfinished.c_str(), path.c_str()) != 0) {
    const int error = errno;
    unlink(unfinished.c_str());
    close(socket);
    throw TransportError(
        fmt::format("cannot make the socket {}: {}", path.string(), std::strerror(error)));
  }
}

}  // namespace

UnixInbox::UnixInbox(const std::filesystem::path& folder)
    : path_(folder / unique_socket_name()), socket_(datagram_socket()) {
  bind_at(socket_, path_);
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);  // signals belong to the thread that created this
  try {
    thread_ = std::thread([this] { read(); });
  } catch (...) {
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    unlink(path_.c_str());
    close(socket_);
    throw;
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

UnixInbox::~UnixInbox() {
  unlink(path_.c_str());
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  shutdown(socket_, SHUT_RDWR);  // ends the thread's recv()
  thread_.join();
  close(socket_);
}

void UnixInbox::subscribe(const std::string& channel, int capacity) {
  const std::lock_guard lock(mutex_);
  subscriptions_[channel].capacity = capacity;
}

std::optional<Packet> UnixInbox::receive(Nanos timeout) {
  std::unique_lock lock(mutex_);
  arrived_.wait_for(lock, timeout, [this] { return !waiting_.empty() || error_ != 0; });
  if (waiting_.empty()) {
    if (error_ != 0)
      throw TransportError(fmt::format("{}: {}", path_.string(), std::strerror(error_)));
    return std::nullopt;
  }
  Waiting next = std::move(waiting_.front());
  waiting_.pop_front();
  --next.subscription->waiting;
  return std::move(next.packet);
}

void UnixInbox::read() {
  std::vector<std::byte> buffer(longest_datagram);
  for (;;) {
    const ssize_t size = recv(socket_, buffer.data(), buffer.size(), MSG_TRUNC);
    const int error = size < 0 ? errno : 0;
    if (size > 0 && static_cast<std::size_t>(size) <= buffer.size()) {
      if (auto packet = packet_of({buffer.data(), static_cast<std::size_t>(size)}))
        keep(*std::move(packet));
    }
    const std::lock_guard lock(mutex_);
    if (error != 0 && error != EINTR) error_ = error;
    if (ending_ || error_ != 0) break;
  }
  arrived_.notify_all();
}

void UnixInbox::keep(Packet packet) {
  const std::lock_guard lock(mutex_);
  for (auto& [pattern, subscription] : subscriptions_) {
    if (subscription.waiting >= subscription.capacity || !matches(pattern, packet.channel))
      continue;
    ++subscription.waiting;
    waiting_.push_back({std::move(packet), &subscription});
    arrived_.notify_one();
    return;
  }
}

}  // namespace jounce::stream_detail
