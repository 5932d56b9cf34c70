// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// A link between the programs of one machine, through Unix sockets in a folder. It needs no
/// network and no privileges, and its packets cannot leave the machine. Containers that share the
/// folder can also use the link.
///
/// The permissions of the folder are the only access control: any program that can enter the folder
/// and write into it can send and receive. Each program has its own socket in the folder; a packet
/// is sent to all sockets.
///
///     UnixTransport link("/run/jounce");
///     link.subscribe(wire::channel("feeder", wire::Lane::status), 1);
///     const auto packet = link.receive(1s);
class UnixTransport : public Transport {
 public:
  /// Creates the folder, for its owner only, if it does not exist. Throws InputError for an empty
  /// name, a name of more than 75 bytes, and a folder into which all users can write. Throws
  /// TransportError if the folder cannot be used, or if 64 programs use it already.
  explicit UnixTransport(const std::string& folder);
  ~UnixTransport() override;
  UnixTransport(const UnixTransport&) = delete;
  UnixTransport& operator=(const UnixTransport&) = delete;

  /// `channel`: at most 63 characters. A * stands for any text without a dot.
  void subscribe(const std::string& channel, int capacity) override;

  /// Sends at most 65000 bytes. Throws TransportError if the socket of this program is no longer in
  /// the folder, because the program could then not receive any more.
  void send(const std::string& channel, std::span<const std::byte> bytes) override;
  std::optional<Packet> receive(Nanos timeout) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace jounce
