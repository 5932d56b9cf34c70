#pragma once

#include <zlib.h>

#include "jounce/stream/wire.hpp"

#include "fuzz/fuzz.hpp"
#include "stream/samples.hpp"

namespace jounce::fuzz {

/// A packet that gets past magic, version, length and checksum: a good one of some type, with bytes of
/// its fields turned over, and the checksum made to fit. A fuzzer alone never guesses one.
inline wire::Bytes packet(Source& source) {
  static const std::vector<wire::Message> good = test::samples();
  wire::Message message = good[source.below(good.size())];
  message.executor = "feeder";
  message.session = 1 + static_cast<std::int64_t>(source.below(2));
  wire::Bytes bytes = wire::encode(message);
  constexpr std::size_t head = 16, tail = 4;  // type hash, magic, version; checksum
  for (std::size_t changes = source.below(12); changes > 0; --changes) {
    const std::size_t at = source.byte() * std::size_t{256} + source.byte();
    bytes[head + at % (bytes.size() - head - tail)] = static_cast<std::byte>(source.byte());
  }
  const auto sum = static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(bytes.data()),
                                                    static_cast<uInt>(bytes.size() - tail)));
  for (std::size_t i = 0; i < tail; ++i)
    bytes[bytes.size() - tail + i] = static_cast<std::byte>(sum >> (24U - 8U * i) & 0xFFU);
  return bytes;
}

}  // namespace jounce::fuzz
