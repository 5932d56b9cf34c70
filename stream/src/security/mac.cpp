// SPDX-License-Identifier: Apache-2.0
#include "stream/src/security/mac.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include <sodium.h>

namespace jounce::wire {
namespace {

static_assert(mac_bytes >= crypto_generichash_BYTES_MIN);
static_assert(std::tuple_size_v<Key> == crypto_generichash_KEYBYTES);

/// Selects the fastest code for this processor; once, from any thread.
bool ready() {
  static const bool chosen = sodium_init() >= 0;
  return chosen;
}

const unsigned char* raw(const std::byte* bytes) {
  return reinterpret_cast<const unsigned char*>(bytes);
}

}  // namespace

void write_mac(std::span<const std::byte> bytes, const std::optional<Key>& key, std::byte* mac) {
  if (!key) {
    std::fill_n(mac, mac_bytes, std::byte{});
    return;
  }
  static_cast<void>(ready());
  crypto_generichash(reinterpret_cast<unsigned char*>(mac), mac_bytes, raw(bytes.data()),
                     bytes.size(), key->data(), key->size());
}

bool is_mac(std::span<const std::byte> bytes, const std::optional<Key>& key, const std::byte* mac) {
  std::array<std::byte, mac_bytes> expected;
  write_mac(bytes, key, expected.data());
  return sodium_memcmp(expected.data(), mac, mac_bytes) == 0;
}

}  // namespace jounce::wire
