// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "jounce/pvt/table.hpp"

namespace jounce {

/// A place in a table, for queries that mostly stay in one interval, for example of a cycle of 1 ms
/// in a table with knots 10 ms apart.
///
///     Cursor cursor(table);
///     for (double t = 0; t < table.end(); t += 0.001) {
///       const Jet now = cursor.jet(t);          // table.jet(t) to the bit, about three times as fast
///     }
///
/// It keeps the polynomials of one interval, nothing of the query before: in any order,
/// the answers are table.jet(x), to the bit. A copy is a cursor of its own. The table must outlive it
/// and is not changed by it: one cursor a thread. Throws and allocates nothing.
class Cursor {
 public:
  explicit Cursor(const Table& table);

  /// The value with three derivatives, right-continuous, outside by the policy of the table.
  [[nodiscard]] Jet jet(double x);

 private:
  void enter(std::size_t interval);

  const Table* table_;
  std::size_t interval_ = 0;
  double from_ = 0, to_ = 0;  ///< from of the interval that is kept, none at first
  double per_length_ = 1;
  int degree_ = 1;
  std::array<double, 6> p_{};
  std::array<double, 5> v_{};
  std::array<double, 4> a_{};
  std::array<double, 3> j_{};
};

}  // namespace jounce
