// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "jounce/stream/security/key.hpp"

namespace jounce::wire {

inline constexpr std::size_t mac_bytes = 16;

/// Writes the keyed BLAKE2b-128 of `bytes` to `mac`, mac_bytes long; zeros without a key.
void write_mac(std::span<const std::byte> bytes, const std::optional<Key>& key, std::byte* mac);

/// True if `mac` equals the result of write_mac(); takes the same time for any difference.
bool is_mac(std::span<const std::byte> bytes, const std::optional<Key>& key, const std::byte* mac);

}  // namespace jounce::wire
