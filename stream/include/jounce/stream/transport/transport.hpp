// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace jounce {

using Nanos = std::chrono::nanoseconds;

/// The time since a fixed instant; it is monotonic.
using Clock = std::function<Nanos()>;

/// The machine's monotonic clock.
Nanos steady_now();

/// Seconds as a time; more than thirty years counts as unlimited.
Nanos nanos(double seconds);

/// Bytes received on a channel.
struct Packet {
  std::string channel;
  std::vector<std::byte> bytes;
};

/// The link itself failed (no network, no route): a fault of the machine, not of the input.
class TransportError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Moves bytes on named channels. It may lose, duplicate, delay and reorder them: the protocol
/// above tolerates that. One thread uses it.
class Transport {
 public:
  virtual ~Transport() = default;

  /// Receives this channel from now on, once. At most `capacity` >= 1 packets of it wait for
  /// receive(); further ones are lost. (LCM keeps the oldest ones: for the newest state, drain the
  /// link, then wait.)
  virtual void subscribe(const std::string& channel, int capacity) = 0;

  virtual void send(const std::string& channel, std::span<const std::byte> bytes) = 0;

  /// Returns the next packet, after waiting for at most `timeout` >= 0. Throws TransportError if
  /// the link has failed.
  virtual std::optional<Packet> receive(Nanos timeout) = 0;

 protected:
  Transport() = default;
  Transport(const Transport&) = default;
  Transport& operator=(const Transport&) = default;
};

}  // namespace jounce
