#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "jounce/pvt/table.hpp"

namespace jounce {

/// What the two axes of a table are counted in: "deg", "pulse", "s", "mm", ... as in the spec.
struct Units {
  std::string x;         ///< of the first column: time or master position
  std::string position;  ///< of the slave position; derivatives are position/x, position/x^2
};

using Sha256 = std::array<std::uint8_t, 32>;

/// SHA-256 of any bytes.
Sha256 sha256(std::string_view bytes);

/// Lower-case hexadecimal, 64 characters.
std::string hex(const Sha256& hash);

/// The identity of a table: SHA-256 over schema version, axis, rule, policy outside, units, number
/// of knots and every column as little-endian IEEE doubles. Provenance and file format do not
/// count: the same table has the same hash as CSV, as JSON and on the wire.
Sha256 content_hash(const Table& table, const Units& units);

}  // namespace jounce
