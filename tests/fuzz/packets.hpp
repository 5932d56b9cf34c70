// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <zlib.h>

#include "jounce/stream/message/wire.hpp"

#include "fuzz/fuzz.hpp"
#include "stream/message/samples.hpp"

namespace jounce::fuzz {

constexpr std::size_t checksum = 4;  ///< bytes at the end of a packet

/// Makes the checksum of a packet fit.
inline void set_checksum(wire::Bytes& bytes) {
  const auto sum = static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(bytes.data()),
                                                    static_cast<uInt>(bytes.size() - checksum)));
  for (std::size_t i = 0; i < checksum; ++i)
    bytes[bytes.size() - checksum + i] = static_cast<std::byte>(sum >> (24U - 8U * i) & 0xFFU);
}

/// A packet that gets past magic, version, length and checksum: a good one of some type, with bytes of
/// its fields turned over, and the checksum made to fit. A fuzzer alone never guesses one.
inline wire::Bytes packet(Source& source) {
  static const std::vector<wire::Message> good = test::samples();
  wire::Message message = good[source.below(good.size())];
  message.executor = "feeder";
  message.session = 1 + static_cast<std::int64_t>(source.below(2));
  wire::Bytes bytes = wire::encode(message);
  constexpr std::size_t head = 16;  // type hash, magic, version
  for (std::size_t changes = source.below(12); changes > 0; --changes) {
    const std::size_t at = source.byte() * std::size_t{256} + source.byte();
    bytes[head + at % (bytes.size() - head - checksum)] = static_cast<std::byte>(source.byte());
  }
  set_checksum(bytes);
  return bytes;
}

}  // namespace jounce::fuzz
