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

/// A duration, or a time of a Clock.
using Nanos = std::chrono::nanoseconds;

/// Returns the time since a fixed instant. The time never decreases.
using Clock = std::function<Nanos()>;

/// Returns the time of the system's monotonic clock.
Nanos steady_now();

/// Converts seconds to a duration. More than thirty years counts as unlimited.
Nanos nanos(double seconds);

/// Bytes received on a channel.
struct Packet {
  std::string channel = {};           ///< name of the channel
  std::vector<std::byte> bytes = {};  ///< content
};

/// The link itself has failed (no network, no route). The cause is in the computer, not in the
/// input.
class TransportError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Moves bytes on named channels. Packets may be lost, duplicated, delayed and reordered; the
/// protocol tolerates this. Use a transport in one thread only.
class Transport {
 public:
  virtual ~Transport() = default;

  /// Receives this channel from now on. At most `capacity` >= 1 packets of the channel wait for
  /// receive(); further packets are lost. A second call for a channel replaces its capacity. (LCM
  /// keeps the oldest packets. To get the newest state, first remove all waiting packets, then wait
  /// for one.)
  virtual void subscribe(const std::string& channel, int capacity) = 0;

  /// Sends bytes on a channel. A packet that cannot be sent now is lost. Throws TransportError if the
  /// link has failed; streamers and clients end with it only after 0.3 s in which no send succeeded.
  virtual void send(const std::string& channel, std::span<const std::byte> bytes) = 0;

  /// Waits for at most `timeout` >= 0 and returns the next packet; nullopt if none has arrived.
  /// Throws TransportError if the link has failed.
  virtual std::optional<Packet> receive(Nanos timeout) = 0;

 protected:
  Transport() = default;
  Transport(const Transport&) = default;
  Transport& operator=(const Transport&) = default;
};

}  // namespace jounce
