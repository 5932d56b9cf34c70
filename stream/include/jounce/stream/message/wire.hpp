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

/// Messages <-> bytes. The bytes are those of the LCM types in stream/lcm, so that every LCM tool
/// can read them. Arrays have a fixed size: a type has one length.
namespace jounce::wire {

using Bytes = std::vector<std::byte>;

/// Reason why bytes are not a message.
enum class Reject {
  too_short,       ///< shorter than type, magic and version
  wrong_magic,     ///< not Jounce's
  wrong_version,   ///< another version of the protocol
  unknown_type,    ///< a type hash unknown to this version
  wrong_length,    ///< not the length of its type
  wrong_checksum,  ///< damaged on the way
  bad_field,       ///< an enumeration, a count or a name is out of range
  not_authentic,   ///< its mac does not match the key; or it has a mac, and no key is set
};
inline constexpr std::size_t reject_count = 8;
const char* name(Reject reject);

/// Encodes the message and signs it with the key, if any. Throws InputError for a name, unit or
/// count that does not fit the wire. Shortens a reason that is too long.
Bytes encode(const Message& message, const std::optional<Key>& key = {});

/// Decodes a message. If there is a key, rejects messages without its signature before it reads any
/// field. Never throws and never reads past the bytes, for any input.
std::variant<Message, Reject> decode(std::span<const std::byte> bytes,
                                     const std::optional<Key>& key = {});

/// The channels of an executor: each message has its own.
enum class Lane {
  table,    ///< Header, Chunk, Queue, Rows: to the executor
  command,  ///< Arm, Start, Stop, Heartbeat, Command: to the executor
  reply,    ///< Ack, Reply, QueueAck: from the executor
  status,   ///< Status: from the executor; only the newest counts
  master,   ///< Master: to all executors that follow it, under the master's name
  event,    ///< Event: from the executor
  masters,  ///< MasterStatus: from the executor; only the newest of each master counts
  claim,    ///< Claim: between executors of one name
};
Lane lane(const Body& body);

/// "JOUNCE2.<executor>.table", ...
std::string channel(const std::string& executor, Lane lane);

}  // namespace jounce::wire
