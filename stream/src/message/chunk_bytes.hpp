// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "jounce_lcm/chunk_t.hpp"

/// A chunk on the wire: nearly all that is ever sent. Its `count` doubles go straight between their
/// vector and the bytes; the generated code sees a chunk that has none. It never allocates by a
/// count from the wire: that is checked against the length first.
namespace jounce::wire {

/// `head`: all fields but count and values. Includes space for mac and checksum at the end.
std::vector<std::byte> chunk_bytes(const jounce_lcm::chunk_t& head, std::span<const double> values);

/// True if the bytes are as long as their count requires, which is at most chunk_values.
bool has_chunk_length(std::span<const std::byte> bytes);

/// Chunk of bytes with that length.
bool read_chunk(std::span<const std::byte> bytes, jounce_lcm::chunk_t& head,
                std::vector<double>& values);

}  // namespace jounce::wire
