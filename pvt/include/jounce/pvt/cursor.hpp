// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "jounce/pvt/table.hpp"

namespace jounce {

/// A cursor speeds up queries of a table that mostly stay in the same interval, such as a cycle of
/// 1 ms in a table with knots 10 ms apart.
///
///     Cursor cursor(table);
///     for (double t = 0; t < table.end(); t += 0.001) {
///       const Jet now = cursor.jet(t);          // equals table.jet(t), about three times as fast
///     }
///
/// The cursor stores the polynomials of one interval. Its results do not depend on earlier queries:
/// for any order of queries, they equal the results of table.jet(x) bit for bit. A copy is an
/// independent cursor. The table must outlive its cursors. A cursor does not change the table, and
/// does not throw or allocate. Use a separate cursor in each thread.
class Cursor {
 public:
  explicit Cursor(const Table& table);

  /// Returns the value and three derivatives at x, right-continuous. Outside, the policy of the
  /// table applies.
  [[nodiscard]] Jet jet(double x);

 private:
  void enter(std::size_t interval);

  const Table* table_;
  std::size_t interval_ = 0;
  double from_ = 0, to_ = 0;  ///< interval [from_, to_) that is stored; empty at first
  double per_length_ = 1;
  int degree_ = 1;
  std::array<double, 6> p_{};
  std::array<double, 5> v_{};
  std::array<double, 4> a_{};
  std::array<double, 3> j_{};
};

}  // namespace jounce
