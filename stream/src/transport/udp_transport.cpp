// SPDX-License-Identifier: Apache-2.0
#include "stream/src/transport/udp_transport.hpp"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <utility>

#include <arpa/inet.h>
#include <net/if.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <unistd.h>

#include "stream/src/transport/datagram.hpp"

namespace jounce {
namespace {

// An LCM packet: magic, number, the channel's name with a final zero, then the message.
constexpr std::uint32_t packet_magic = 0x4C433032;  // "LC02"
constexpr std::size_t head_bytes = 8;
[[maybe_unused]] constexpr std::size_t most_channel = 63;
[[maybe_unused]] constexpr std::size_t most_message =
    65'499;  // including the channel's name and its zero
constexpr std::size_t most_datagram = 65'536;
constexpr int most_at_once = 512;  // datagrams: a flood must not keep receive() from returning

std::string trouble(const std::string& what) {
  return what + ": " + std::strerror(errno);
}

std::uint32_t big_endian(std::span<const std::byte> bytes) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data(), sizeof number);
  return ntohl(number);
}

}  // namespace

/// The descriptor, configured to receive from one interface.
class UdpTransport::Socket {
 public:
  explicit Socket(const MulticastAddress& address)
      : fd_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    if (fd_ < 0) throw TransportError(trouble("cannot open a UDP socket"));
    try {
      set_up(address);
    } catch (...) {
      close(fd_);
      throw;
    }
  }
  ~Socket() { close(fd_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  /// A packet lost here counts as lost on the network: the sender repeats it on demand.
  void send(std::span<const iovec> parts) const {
    msghdr message{};
    sockaddr_in to = group_;
    message.msg_name = &to;
    message.msg_namelen = sizeof to;
    message.msg_iov = const_cast<iovec*>(parts.data());  // POSIX: sendmsg() does not write to it
    message.msg_iovlen = parts.size();
    while (sendmsg(fd_, &message, MSG_NOSIGNAL) < 0 && errno == EINTR) {
    }
  }

  /// The length of the waiting datagram; nullopt if there is none.
  std::optional<std::size_t> receive(std::span<std::byte> into) const {
    const ssize_t size = recv(fd_, into.data(), into.size(), MSG_DONTWAIT);
    if (size >= 0) return static_cast<std::size_t>(size);
    // The network reports that an earlier packet was not delivered: others may follow it.
    if (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR) return std::nullopt;
    if (errno == ECONNREFUSED || errno == EHOSTUNREACH || errno == ENETUNREACH || errno == ENETDOWN)
      return std::size_t{0};
    throw TransportError(trouble("the UDP socket cannot receive"));
  }

  /// True if a packet has arrived.
  [[nodiscard]] bool wait(Nanos timeout) const {
    pollfd descriptor{fd_, POLLIN, 0};
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(timeout);
    const timespec limit{static_cast<time_t>(seconds.count()),
                         static_cast<long>((timeout - seconds).count())};
    const int ready = ppoll(&descriptor, 1, &limit, nullptr);
    if (ready < 0 && errno != EINTR) throw TransportError(trouble("the UDP socket failed"));
    return ready > 0;
  }

 private:
  void set_up(const MulticastAddress& address) {
    group_.sin_family = AF_INET;
    group_.sin_port = htons(address.port);
    inet_pton(AF_INET, address.group.c_str(), &group_.sin_addr);
    ip_mreqn membership{};
    membership.imr_multiaddr = group_.sin_addr;
    membership.imr_ifindex = interface(address);
    set(SOL_SOCKET, SO_REUSEADDR, 1);
    set(SOL_SOCKET, SO_RCVBUF, address.receive_buffer);
    set(IPPROTO_IP, IP_MULTICAST_ALL, 0);
    set(IPPROTO_IP, IP_MULTICAST_LOOP, 1);
    set(IPPROTO_IP, IP_MULTICAST_TTL, address.ttl);
    if (membership.imr_ifindex != 0) set(IPPROTO_IP, IP_MULTICAST_IF, membership);
    if (bind(fd_, reinterpret_cast<const sockaddr*>(&group_), sizeof group_) != 0)
      throw TransportError(
          trouble("UDP port " + std::to_string(address.port) + " of " + address.group));
    if (setsockopt(fd_, IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof membership) != 0)
      throw TransportError(trouble("cannot join " + address.group) +
                           "; is there a route to it (ip route add " + address.group +
                           "/32 dev eth1), or name the interface: &interface=eth1");
  }

  /// Index of the interface; 0: the one of the route.
  [[nodiscard]] int interface(const MulticastAddress& address) const {
    const std::string name = address.is_local() ? "lo" : address.interface;
    if (name.empty()) return 0;
    const auto number = static_cast<int>(if_nametoindex(name.c_str()));
    if (number == 0) throw TransportError("there is no network interface " + name);
    ifreq request{};
    std::strncpy(request.ifr_name, name.c_str(), sizeof request.ifr_name - 1);
    if (ioctl(fd_, SIOCGIFFLAGS, &request) != 0)
      throw TransportError(trouble("network interface " + name));
    if ((static_cast<unsigned>(request.ifr_flags) & IFF_UP) == 0)
      throw TransportError("network interface " + name + " is down: ip link set " + name + " up");
    return number;
  }

  template <class Value>
  void set(int level, int option, const Value& value) const {
    if (setsockopt(fd_, level, option, &value, sizeof value) != 0)
      throw TransportError(trouble("cannot set an option of the UDP socket"));
  }

  int fd_;
  sockaddr_in group_{};
};

UdpTransport::UdpTransport(const MulticastAddress& address)
    : socket_(std::make_unique<Socket>(address)), received_(most_datagram) {}

UdpTransport::~UdpTransport() = default;

void UdpTransport::subscribe(const std::string& channel, int capacity) {
  assert(channel.size() <= most_channel && capacity >= 1);
  const auto at = std::find_if(subscriptions_.begin(), subscriptions_.end(),
                               [&](const Subscription& one) { return one.pattern == channel; });
  if (at != subscriptions_.end())
    at->capacity = capacity;
  else
    subscriptions_.push_back({channel, capacity});
}

void UdpTransport::send(const std::string& channel, std::span<const std::byte> bytes) {
  assert(channel.size() <= most_channel && channel.size() + 1 + bytes.size() <= most_message);
  std::array<std::uint32_t, 2> head{htonl(packet_magic), htonl(sent_++)};
  const std::array<iovec, 3> parts{iovec{head.data(), head_bytes},
                                   iovec{const_cast<char*>(channel.c_str()), channel.size() + 1},
                                   iovec{const_cast<std::byte*>(bytes.data()), bytes.size()}};
  socket_->send(parts);
}

std::optional<Packet> UdpTransport::receive(Nanos timeout) {
  const Nanos begin = steady_now();
  for (Nanos left = timeout; waiting_.empty(); left = timeout - (steady_now() - begin)) {
    if (!socket_->wait(std::max(left, Nanos{}))) break;
    take_what_came();
    if (left <= Nanos{}) break;
  }
  if (waiting_.empty()) return std::nullopt;
  Waiting first = std::move(waiting_.front());
  waiting_.pop_front();
  --subscriptions_[first.subscription].waiting;
  return std::move(first.packet);
}

void UdpTransport::take_what_came() {
  for (int i = 0; i < most_at_once; ++i) {
    const auto size = socket_->receive(received_);
    if (!size) return;
    take(std::span(received_).first(*size));
  }
}

/// Keeps a packet of a subscribed channel with free capacity; drops all others.
void UdpTransport::take(std::span<const std::byte> datagram) {
  if (datagram.size() <= head_bytes || big_endian(datagram) != packet_magic) return;
  auto packet = stream_detail::packet_of(datagram.subspan(head_bytes));
  if (!packet) return;
  const auto at =
      std::find_if(subscriptions_.begin(), subscriptions_.end(), [&](const Subscription& one) {
        return stream_detail::matches(one.pattern, packet->channel);
      });
  if (at == subscriptions_.end() || at->waiting >= at->capacity) return;
  ++at->waiting;
  waiting_.push_back({*std::move(packet), static_cast<std::size_t>(at - subscriptions_.begin())});
}

}  // namespace jounce
