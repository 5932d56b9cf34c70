// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// A link between the programs of one machine through Unix sockets in a folder that they name. It
/// needs no network and no privilege, and nothing it sends can leave the machine. It also joins
/// containers that share the folder.
///
/// Who may enter the folder and write in it takes part; its permissions are the only gate. Each
/// program has a socket of its own in it, and sends to all of them.
///
///     UnixTransport link("/run/jounce");
///     link.subscribe(wire::channel("feeder", wire::Lane::status), 1);
///     const auto packet = link.receive(1s);
class UnixTransport : public Transport {
 public:
  /// Makes the folder, for its owner alone, where there is none. Throws InputError for a name of no
  /// or of more than 75 bytes and for a folder that all users may write; TransportError where the
  /// folder cannot be used, or where 64 programs use it.
  explicit UnixTransport(const std::string& folder);
  ~UnixTransport() override;
  UnixTransport(const UnixTransport&) = delete;
  UnixTransport& operator=(const UnixTransport&) = delete;

  /// At most 63 characters. A * stands for any text without a dot.
  void subscribe(const std::string& channel, int capacity) override;

  /// At most 65000 bytes. Throws TransportError once this program's socket is no longer in the
  /// folder: it could receive nothing any more.
  void send(const std::string& channel, std::span<const std::byte> bytes) override;
  std::optional<Packet> receive(Nanos timeout) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace jounce
