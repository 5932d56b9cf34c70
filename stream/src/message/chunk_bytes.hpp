// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "jounce_lcm/chunk_t.hpp"

/// Bytes of a chunk on the wire. Chunks are nearly all traffic: their `count` doubles are therefore
/// copied directly between their vector and the bytes, and the generated code gets a chunk without
/// values. A count from the wire is checked against the length before any memory is allocated for
/// it.
namespace jounce::wire {

/// `head`: all fields except count and values. The result has space for mac and checksum at the
/// end.
std::vector<std::byte> chunk_bytes(const jounce_lcm::chunk_t& head, std::span<const double> values);

/// True if the length of the bytes matches their count, which is at most chunk_values.
bool has_chunk_length(std::span<const std::byte> bytes);

/// Reads a chunk from bytes for which has_chunk_length() is true. Returns false if its fields
/// cannot be decoded.
bool read_chunk(std::span<const std::byte> bytes, jounce_lcm::chunk_t& head,
                std::vector<double>& values);

}  // namespace jounce::wire
