// SPDX-License-Identifier: Apache-2.0
#include "stream/src/transport/unix_transport.hpp"

#include <cassert>
#include <cerrno>
#include <cstring>

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "jounce/profiles/error.hpp"

#include "stream/src/transport/datagram.hpp"
#include "stream/src/transport/unix_inbox.hpp"
#include "stream/src/transport/unix_peers.hpp"
#include "stream/src/transport/unix_socket.hpp"

namespace jounce {
namespace {

[[noreturn]] void refuse_folder(const std::string& folder, const std::string& rule) {
  throw InputError("url", "unix://" + folder, rule);
}

std::string usable(const std::string& folder) {
  if (folder.empty() || folder.size() > stream_detail::longest_folder)
    refuse_folder(folder,
                  fmt::format("must name a folder, such as unix:///run/jounce, in at most {} bytes",
                              stream_detail::longest_folder));
  struct stat about {};
  if ((mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) || stat(folder.c_str(), &about) != 0)
    throw TransportError(fmt::format("cannot use the folder {}: {}", folder, std::strerror(errno)));
  if (!S_ISDIR(about.st_mode)) refuse_folder(folder, "is a file: name a folder");
  if ((about.st_mode & S_IWOTH) != 0)
    refuse_folder(
        folder,
        "must not be writable for all users of this machine, because they could move the axes: "
        "name another folder, or chmod o-w this one");
  return folder;
}

}  // namespace

struct UnixTransport::Impl {
  explicit Impl(const std::string& name) : peers(usable(name)) {
    peers.refresh();
    if (peers.size() >= stream_detail::most_peers)
      throw TransportError(
          fmt::format("{}: {} programs already use it, and it serves no more: end one of them",
                      name, stream_detail::most_peers));
    inbox.emplace(name);
  }

  stream_detail::UnixPeers peers;
  std::optional<stream_detail::UnixInbox> inbox;
};

UnixTransport::UnixTransport(const std::string& folder) : impl_(std::make_unique<Impl>(folder)) {}

UnixTransport::~UnixTransport() = default;

void UnixTransport::subscribe(const std::string& channel, int capacity) {
  assert(channel.size() <= 63 && capacity >= 1);
  impl_->inbox->subscribe(channel, capacity);
}

void UnixTransport::send(const std::string& channel, std::span<const std::byte> bytes) {
  assert(channel.size() <= 63 && bytes.size() <= 65000);
  if (access(impl_->inbox->path().c_str(), F_OK) != 0)
    throw TransportError(
        fmt::format("{}: this program's socket has been removed", impl_->inbox->path().string()));
  impl_->peers.refresh();
  impl_->peers.send(stream_detail::datagram_of(channel, bytes));
}

std::optional<Packet> UnixTransport::receive(Nanos timeout) {
  return impl_->inbox->receive(timeout);
}

}  // namespace jounce
