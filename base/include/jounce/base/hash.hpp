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

/// Units of the columns of a table, as the spec writes them: "deg", "pulse", "s", "mm", ...
struct Units {
  std::string x = {};  ///< unit of the first column x: time or master position
  /// Unit of the position; its derivatives have the units position/x, position/x^2.
  std::string position = {};
};

/// A SHA-256 hash.
using Sha256 = std::array<std::uint8_t, 32>;

/// Returns the SHA-256 of any bytes.
Sha256 sha256(std::string_view bytes);

/// Returns the hash as 64 lower-case hexadecimal digits.
std::string hex(const Sha256& hash);

/// Returns the identity of a table: the SHA-256 over the schema, the variable of the table, the
/// interpolation rule, the policy outside, the units, the number of knots, and the SHA-256 of each
/// column as little-endian IEEE doubles. Provenance and file format are not included: the same
/// table has the same hash in CSV, in JSON and on the wire.
Sha256 content_hash(const Table& table, const Units& units);

/// Computes content_hash() of columns that arrive in pieces; the pieces of a column must be in
/// order. So a receiver can hash a table while it arrives.
///
///     ContentHasher hasher;
///     hasher.add({{x, p, v, {}}});       // repeat for each block of knots
///     const Sha256 hash = hasher.result(Domain::time, Interpolation::cubic_hermite,
///                                       Extrapolation::hold, units, knots);
///
/// Throws std::bad_alloc if memory runs out.
class ContentHasher {
 public:
  ContentHasher();
  ~ContentHasher();
  ContentHasher(ContentHasher&&) noexcept;
  ContentHasher& operator=(ContentHasher&&) noexcept;

  /// Adds the next knots: their x, p, v and a. For a column that the table does not have, pass an
  /// empty span.
  void add(const std::array<std::span<const double>, 4>& columns);
  /// Returns the hash. Call once, at the end. `knots` is the total number of knots.
  [[nodiscard]] Sha256 result(Domain axis, Interpolation rule, Extrapolation outside,
                              const Units& units, std::size_t knots);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace jounce
