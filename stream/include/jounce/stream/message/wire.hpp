// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "jounce/stream/message/message.hpp"
#include "jounce/stream/security/key.hpp"

/// Conversion between messages and bytes. The LCM types in stream/lcm define the bytes, so every
/// tool of LCM can read them. Arrays have a fixed size, so all messages of a type have the same
/// length.
namespace jounce::wire {

/// The bytes of a message.
using Bytes = std::vector<std::byte>;

/// Reason why bytes are not a message.
enum class Reject {
  too_short,       ///< shorter than type, magic number and version
  wrong_magic,     ///< not a message of Jounce
  wrong_version,   ///< another version of the protocol
  unknown_type,    ///< the hash of no type of this version
  wrong_length,    ///< not the length of its type
  wrong_checksum,  ///< changed during transmission
  bad_field,       ///< an enumeration, a count or a name is out of range
  /// The authentication code (mac) does not match the key; or the packet has one, but no key is
  /// set.
  not_authentic,
};
inline constexpr std::size_t reject_count = 8;  ///< number of reasons
/// Returns the name of a reason.
const char* name(Reject reject);

/// Encodes a message. With a key, adds an authentication code. Throws InputError for a name, unit
/// or count that does not fit into the wire format. Shortens a reason that is too long.
Bytes encode(const Message& message, const std::optional<Key>& key = {});

/// Decodes a message. With a key, rejects a message whose authentication code is missing or wrong,
/// before reading its fields. For any input, the function does not throw and does not read beyond
/// the bytes.
std::variant<Message, Reject> decode(std::span<const std::byte> bytes,
                                     const std::optional<Key>& key = {});

/// The channels of an executor; each kind of message has one.
enum class Lane {
  table,    ///< Header, Chunk, Queue, Rows: to the executor
  command,  ///< Arm, Start, Stop, Heartbeat, Command: to the executor
  reply,    ///< Ack, Reply, QueueAck: from the executor
  status,   ///< Status: from the executor; only the newest one is valid
  /// Master: to all executors that follow this master; the channel has the name of the master.
  master,
  event,    ///< Event: from the executor
  masters,  ///< MasterStatus: from the executor; only the newest one of each master is valid
  claim,    ///< Claim: between executors
  group,    ///< GroupStatus: from the executor; only the newest one is valid
};
/// Returns the channel of a message.
Lane lane(const Body& body);

/// Returns the name of a channel: "JOUNCE2.<executor>.table", ...
std::string channel(const std::string& executor, Lane lane);

}  // namespace jounce::wire
