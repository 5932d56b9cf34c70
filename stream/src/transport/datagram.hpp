// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jounce/stream/transport/transport.hpp"

namespace jounce::stream_detail {

/// The longest datagram, in bytes.
inline constexpr std::size_t longest_datagram = 65536;

/// Returns a packet as one datagram of at most longest_datagram bytes: its channel, a zero byte,
/// its bytes.
std::vector<std::byte> datagram_of(const std::string& channel, std::span<const std::byte> bytes);

/// Returns the packet of a datagram; nullopt if the bytes are not such a datagram.
std::optional<Packet> packet_of(std::span<const std::byte> datagram);

/// True if the channel matches the pattern, in which * stands for any text without a dot.
bool matches(const std::string& pattern, const std::string& channel);

}  // namespace jounce::stream_detail
