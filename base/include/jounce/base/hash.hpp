// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "jounce/pvt/table.hpp"

namespace jounce {

/// Units of the two axes of a table: "deg", "pulse", "s", "mm", ... as in the spec.
struct Units {
  std::string x;  ///< unit of the first column: time or master position
  std::string
      position;  ///< unit of the position; those of the derivatives are position/x, position/x^2
};

using Sha256 = std::array<std::uint8_t, 32>;

/// SHA-256 of any bytes.
Sha256 sha256(std::string_view bytes);

/// Lower-case hexadecimal, 64 characters.
std::string hex(const Sha256& hash);

/// The identity of a table: SHA-256 over schema, axis, rule, policy outside, units and number of
/// knots, and the SHA-256 of each column as little-endian IEEE doubles. Provenance and file format
/// do not count: the same table has the same hash as CSV, as JSON and on the wire.
Sha256 content_hash(const Table& table, const Units& units);

/// The same hash, of columns that arrive in pieces, each from its beginning. So a receiver can hash
/// a table while it arrives.
///
///     ContentHasher hasher;
///     hasher.add({x, p, v, {}});         // repeat for each block of knots
///     Sha256 hash = hasher.result(Domain::time, Interpolation::cubic_hermite, Extrapolation::hold, units, knots);
///
/// Throws std::bad_alloc if memory runs out.
class ContentHasher {
 public:
  ContentHasher();
  ~ContentHasher();
  ContentHasher(ContentHasher&&) noexcept;
  ContentHasher& operator=(ContentHasher&&) noexcept;

  /// Adds the next knots of x, p, v and a; empty for a column that the table does not have.
  void add(const std::array<std::span<const double>, 4>& columns);
  /// Returns the hash; call it once, at the end.
  [[nodiscard]] Sha256 result(Domain axis, Interpolation rule, Extrapolation outside,
                              const Units& units, std::size_t knots);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace jounce
