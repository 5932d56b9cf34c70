// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/message/wire.hpp"

#include <cassert>
#include <limits>
#include <optional>
#include <utility>

#include <libdeflate.h>

#include "jounce/profiles/error.hpp"

#include "stream/src/message/body_fields.hpp"
#include "stream/src/message/chunk_bytes.hpp"
#include "stream/src/message/lcm_body.hpp"
#include "stream/src/message/queue_fields.hpp"
#include "stream/src/message/report_fields.hpp"
#include "stream/src/security/mac.hpp"

namespace jounce::wire {
namespace {

// A message on the wire: type hash (8 bytes), magic (4), version (4), executor, session, challenge,
// fields, mac (16), checksum (4), all big-endian.
constexpr std::int32_t magic = 0x4A4E4345;
constexpr std::size_t magic_at = 8;
constexpr std::size_t version_at = 12;
constexpr std::size_t shortest = 20;
constexpr std::size_t checksum_bytes = 4;

std::uint32_t big_endian(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i)
    number = number << 8U | std::to_integer<std::uint32_t>(bytes[at + i]);
  return number;
}

std::uint32_t checksum(std::span<const std::byte> bytes) {
  return libdeflate_crc32(0, bytes.data(), bytes.size());
}

template <class Lcm>
std::size_t size_of() {
  static const auto size = static_cast<std::size_t>(Lcm{}.getEncodedSize());
  return size;
}

template <class Lcm, class Body>
Bytes encoded(const Lcm& lcm, const Body& body) {
  if constexpr (std::is_same_v<Body, Chunk>) {
    return chunk_bytes(lcm, body.values);
  } else {
    Bytes bytes(size_of<Lcm>());
    [[maybe_unused]] const int written =
        lcm.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
    assert(written == static_cast<int>(bytes.size()));
    return bytes;
  }
}

template <class Body>
Bytes encode_as(const Message& message, const Body& body, const std::optional<Key>& key) {
  typename LcmOf<Body>::type lcm{};
  lcm.envelope.magic = magic;
  lcm.envelope.version = protocol_version;
  put_text(message.executor, lcm.envelope.executor, executor_bytes);
  lcm.envelope.session = message.session;
  lcm.envelope.challenge = message.challenge;
  PutFields fields;
  each_field(body, lcm, fields);

  Bytes bytes = encoded(lcm, body);
  const std::size_t end = bytes.size() - checksum_bytes;
  const std::size_t signed_end = end - mac_bytes;
  write_mac(std::span(bytes).first(signed_end), key, bytes.data() + signed_end);
  const std::uint32_t sum = checksum(std::span(bytes).first(end));
  for (std::size_t i = 0; i < checksum_bytes; ++i)
    bytes[end + i] = static_cast<std::byte>(sum >> (24U - 8U * i) & 0xFFU);
  return bytes;
}

template <class Body, class... Others>
constexpr bool is_one_of = (std::is_same_v<Body, Others> || ...);

/// Session 0: the status of a free axis, an operator, and messages without a session.
template <class Body>
bool is_session_of(const jounce_lcm::envelope_t& envelope) {
  if (envelope.challenge < 0) return false;
  if (is_one_of<Body, Master, Claim>) return envelope.session == 0 && envelope.challenge == 0;
  if (is_one_of<Body, Event, MasterStatus, GroupStatus>) return envelope.session == 0;
  constexpr bool may_have_none = is_one_of<Body, Status, Stop, Reply, Command>;
  return envelope.session > 0 || (may_have_none && envelope.session == 0);
}

/// A type has one length; a chunk has the length of its count.
template <class Body>
bool has_length(std::span<const std::byte> bytes) {
  if constexpr (std::is_same_v<Body, Chunk>) return has_chunk_length(bytes);
  return bytes.size() == size_of<typename LcmOf<Body>::type>();
}

template <class Lcm, class Body>
bool decoded(std::span<const std::byte> bytes, Lcm& lcm, Body& body) {
  if constexpr (std::is_same_v<Body, Chunk>) return read_chunk(bytes, lcm, body.values);
  return lcm.decode(bytes.data(), 0, static_cast<int>(bytes.size())) >= 0;
}

/// Copies the fields of a generated type. Returns false if a field is out of its range.
template <class Lcm, class Body>
bool get(const Lcm& lcm, Body& body) {
  GetFields fields;
  each_field(body, lcm, fields);
  return fields.valid();
}

/// Checks length, checksum and mac, then decodes the fields, of bytes of this type. The generated
/// decoder only gets complete and authentic bytes.
template <class Body>
std::variant<Message, Reject> decode_as(std::span<const std::byte> bytes,
                                        const std::optional<Key>& key) {
  if (!has_length<Body>(bytes)) return Reject::wrong_length;
  const std::size_t end = bytes.size() - checksum_bytes;
  if (checksum(bytes.first(end)) != big_endian(bytes, end)) return Reject::wrong_checksum;
  const std::size_t signed_end = end - mac_bytes;
  if (!is_mac(bytes.first(signed_end), key, bytes.data() + signed_end))
    return Reject::not_authentic;

  typename LcmOf<Body>::type lcm{};
  Message message;
  Body body;
  if (!decoded(bytes, lcm, body)) return Reject::wrong_length;
  if (!get_text(lcm.envelope.executor, executor_bytes, message.executor) ||
      !is_executor_name(message.executor) || !is_session_of<Body>(lcm.envelope) || !get(lcm, body))
    return Reject::bad_field;
  message.session = lcm.envelope.session;
  message.challenge = lcm.envelope.challenge;
  if constexpr (std::is_same_v<Body, PathCommand>)
    message.body = Command(body);
  else
    message.body = std::move(body);
  return message;
}

using Decoded = std::optional<std::variant<Message, Reject>>;

template <class Body>
void decode_if(std::int64_t type, std::span<const std::byte> bytes, const std::optional<Key>& key,
               Decoded& result) {
  if (!result && type == LcmOf<Body>::type::getHash()) result = decode_as<Body>(bytes, key);
}

template <class... Bodies>
Decoded decode_any(std::int64_t type, std::span<const std::byte> bytes,
                   const std::optional<Key>& key,
                   std::type_identity<std::variant<Bodies...>> /*of*/) {
  Decoded result;
  (decode_if<Bodies>(type, bytes, key, result), ...);
  decode_if<PathCommand>(type, bytes, key, result);
  return result;
}

}  // namespace

Bytes encode(const Message& message, const std::optional<Key>& key) {
  if (!is_executor_name(message.executor)) {
    throw InputError("executor", message.executor, executor_name_rule);
  }
  const auto* const command = std::get_if<Command>(&message.body);
  if (command != nullptr && is_path_command(*command))
    return encode_as(message, PathCommand{*command}, key);
  return std::visit([&](const auto& body) { return encode_as(message, body, key); }, message.body);
}

std::variant<Message, Reject> decode(std::span<const std::byte> bytes,
                                     const std::optional<Key>& key) {
  if (bytes.size() < shortest) return Reject::too_short;
  if (big_endian(bytes, magic_at) != static_cast<std::uint32_t>(magic)) return Reject::wrong_magic;
  if (big_endian(bytes, version_at) != static_cast<std::uint32_t>(protocol_version))
    return Reject::wrong_version;
  const auto type =
      static_cast<std::int64_t>(std::uint64_t{big_endian(bytes, 0)} << 32U | big_endian(bytes, 4));
  Decoded result = decode_any(type, bytes, key, std::type_identity<Body>{});
  if (!result) return Reject::unknown_type;
  return *std::move(result);
}

const char* name(Reject reject) {
  constexpr const char* names[] = {"too_short",    "wrong_magic",  "wrong_version",
                                   "unknown_type", "wrong_length", "wrong_checksum",
                                   "bad_field",    "not_authentic"};
  return names[static_cast<std::size_t>(reject)];
}

namespace {

template <class... Bodies>
bool is_any(const Body& body) {
  return (std::holds_alternative<Bodies>(body) || ...);
}

}  // namespace

Lane lane(const Body& body) {
  if (is_any<Header, Chunk, Queue, Rows>(body)) return Lane::table;
  if (is_any<Ack, Reply, QueueAck>(body)) return Lane::reply;
  if (is_any<Status>(body)) return Lane::status;
  if (is_any<Master>(body)) return Lane::master;
  if (is_any<MasterStatus>(body)) return Lane::masters;
  if (is_any<Claim>(body)) return Lane::claim;
  if (is_any<GroupStatus>(body)) return Lane::group;
  return is_any<Event>(body) ? Lane::event : Lane::command;
}

std::string channel(const std::string& executor, Lane lane) {
  constexpr const char* ends[] = {".table", ".command", ".reply", ".status", ".master",
                                  ".event", ".masters", ".claim", ".group"};
  return "JOUNCE2." + executor + ends[static_cast<std::size_t>(lane)];
}

}  // namespace jounce::wire
