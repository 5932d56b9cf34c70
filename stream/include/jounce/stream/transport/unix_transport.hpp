// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// A link between the programs of one machine through Unix sockets in a given folder. It needs no
/// network and no privilege, and its packets cannot leave the machine. It also connects containers
/// that share the folder.
///
/// The folder's permissions are the only access control: any program that can enter it and write in
/// it takes part. Each program has its own socket in the folder, and sends to all of them.
///
///     UnixTransport link("/run/jounce");
///     link.subscribe(wire::channel("feeder", wire::Lane::status), 1);
///     const auto packet = link.receive(1s);
class UnixTransport : public Transport {
 public:
  /// Creates the folder, for its owner alone, if it does not exist. Throws InputError for an empty
  /// name or one of more than 75 bytes, and for a folder that all users may write; TransportError
  /// if the folder cannot be used, or if 64 programs use it.
  explicit UnixTransport(const std::string& folder);
  ~UnixTransport() override;
  UnixTransport(const UnixTransport&) = delete;
  UnixTransport& operator=(const UnixTransport&) = delete;

  /// `channel`: at most 63 characters. A * stands for any text without a dot.
  void subscribe(const std::string& channel, int capacity) override;

  /// `bytes`: at most 65000. Throws TransportError once this program's socket is no longer in the
  /// folder: it could no longer receive.
  void send(const std::string& channel, std::span<const std::byte> bytes) override;
  std::optional<Packet> receive(Nanos timeout) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace jounce
