// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "jounce_lcm/chunk_t.hpp"

/// A chunk on the wire: nearly all traffic. Its `count` doubles move directly between their vector
/// and the bytes; the generated code sees a chunk without values. It never allocates by a count
/// from the wire: it checks the count against the length first.
namespace jounce::wire {

/// `head`: all fields except count and values. The result has space for mac and checksum at the
/// end.
std::vector<std::byte> chunk_bytes(const jounce_lcm::chunk_t& head, std::span<const double> values);

/// True if the length of the bytes matches their count, which is at most chunk_values.
bool has_chunk_length(std::span<const std::byte> bytes);

/// Reads a chunk from bytes of that length.
bool read_chunk(std::span<const std::byte> bytes, jounce_lcm::chunk_t& head,
                std::vector<double>& values);

}  // namespace jounce::wire
