// SPDX-License-Identifier: Apache-2.0
#include "stream/src/message/chunk_bytes.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <cstring>

#include "jounce/stream/message/message.hpp"

#include "stream/src/security/mac.hpp"

namespace jounce::wire {
namespace {

constexpr std::size_t behind = mac_bytes + 4;  // mac and checksum

std::size_t values_at() {
  static const auto size = static_cast<std::size_t>(jounce_lcm::chunk_t{}.getEncodedSize());
  return size - behind;
}

template <class Word>
Word swapped(Word word) {
  if constexpr (std::endian::native == std::endian::big) return word;
  if constexpr (sizeof word == 4) return __builtin_bswap32(word);
  return static_cast<Word>(__builtin_bswap64(word));
}

std::uint32_t count_in(std::span<const std::byte> bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + values_at() - sizeof count, sizeof count);
  return swapped(count);
}

}  // namespace

std::vector<std::byte> chunk_bytes(const jounce_lcm::chunk_t& head,
                                   std::span<const double> values) {
  assert(head.count == 0);
  std::vector<std::byte> bytes(values_at() + values.size_bytes() + behind);
  head.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  const std::uint32_t count = swapped(static_cast<std::uint32_t>(values.size()));
  std::byte* to = bytes.data() + values_at();
  std::memcpy(to - sizeof count, &count, sizeof count);
  for (const double value : values) {
    const std::uint64_t word = swapped(std::bit_cast<std::uint64_t>(value));
    std::memcpy(to, &word, sizeof word);
    to += sizeof word;
  }
  return bytes;
}

bool has_chunk_length(std::span<const std::byte> bytes) {
  const std::size_t none = values_at() + behind;
  if (bytes.size() < none) return false;
  const std::size_t count = count_in(bytes);
  return count <= chunk_values && bytes.size() == none + count * sizeof(double);
}

bool read_chunk(std::span<const std::byte> bytes, jounce_lcm::chunk_t& head,
                std::vector<double>& values) {
  assert(has_chunk_length(bytes));
  std::vector<std::byte> empty(values_at() + behind);
  std::copy_n(bytes.begin(), values_at() - sizeof(std::uint32_t), empty.begin());
  if (head.decode(empty.data(), 0, static_cast<int>(empty.size())) < 0) return false;
  values.resize(count_in(bytes));
  const std::byte* from = bytes.data() + values_at();
  for (double& value : values) {
    std::uint64_t word = 0;
    std::memcpy(&word, from, sizeof word);
    value = std::bit_cast<double>(swapped(word));
    from += sizeof word;
  }
  return true;
}

}  // namespace jounce::wire
