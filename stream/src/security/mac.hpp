// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "jounce/stream/security/key.hpp"

namespace jounce::wire {

inline constexpr std::size_t mac_bytes = 16;

/// Writes the BLAKE2b-128 of `bytes` with the key to `mac`, which has mac_bytes bytes; zeros
/// without a key.
void write_mac(std::span<const std::byte> bytes, const std::optional<Key>& key, std::byte* mac);

/// True if `mac` equals the result of write_mac(). The duration does not depend on the place of a
/// difference.
bool is_mac(std::span<const std::byte> bytes, const std::optional<Key>& key, const std::byte* mac);

}  // namespace jounce::wire
