// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/transport/open_transport.hpp"

#include <string_view>
#include <thread>

#include "jounce/profiles/error.hpp"

#include "stream/src/transport/address.hpp"
#include "stream/src/transport/memory_transport.hpp"
#include "stream/src/transport/udp_transport.hpp"
#include "stream/src/transport/unix_transport.hpp"

namespace jounce {
namespace {

/// A memory network with one link.
class OwnMemory : public Transport {
 public:
  OwnMemory() {
    network_.on_wait = [](Nanos timeout) { std::this_thread::sleep_for(timeout); };
  }
  void subscribe(const std::string& channel, int capacity) override {
    link_.subscribe(channel, capacity);
  }
  void send(const std::string& channel, std::span<const std::byte> bytes) override {
    link_.send(channel, bytes);
  }
  std::optional<Packet> receive(Nanos timeout) override { return link_.receive(timeout); }

 private:
  MemoryNetwork network_;
  MemoryTransport link_{network_};
};

}  // namespace

std::unique_ptr<Transport> open_transport(const std::string& url) {
  constexpr std::string_view folder = "unix://";
  if (url.starts_with(folder)) return std::make_unique<UnixTransport>(url.substr(folder.size()));
  if (url.starts_with("udpm://")) return std::make_unique<UdpTransport>(multicast_address(url));
  if (url == "memq://") return std::make_unique<OwnMemory>();
  throw InputError("url", url, "must begin with udpm://, unix:// or memq://");
}

}  // namespace jounce
