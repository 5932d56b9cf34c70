#pragma once

#include <memory>

#include "jounce/stream/transport.hpp"

namespace jounce {

/// A link through LCM: "udpm://239.255.76.67:7667" multicasts, "memq://" stays within this object.
///
/// The URL is always explicit: neither the environment nor LCM's default decides where a motion
/// goes. Unless it names a ttl, ttl=0 is added, which keeps packets on this machine.
class LcmTransport : public Transport {
 public:
  /// Throws InputError for an empty URL or an unknown scheme, TransportError where the network
  /// cannot be used, as where there is no route for multicast. May take some seconds: LCM tests
  /// its own loopback here.
  explicit LcmTransport(const std::string& url);
  ~LcmTransport() override;
  LcmTransport(const LcmTransport&) = delete;
  LcmTransport& operator=(const LcmTransport&) = delete;

  /// At most 63 characters, LCM's limit. A * stands for any text without a dot: "JOUNCE2.*.status" are
  /// those of all executors.
  void subscribe(const std::string& channel, int capacity) override;
  void send(const std::string& channel, std::span<const std::byte> bytes) override;
  std::optional<Packet> receive(Nanos timeout) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace jounce
