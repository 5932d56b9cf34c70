// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "optimize/src/knots/subproblem.hpp"
#include "optimize/src/solvers/program.hpp"

namespace jounce::optimize_detail {

/// The rows that represent a subproblem: its ceilings and the epigraph of its objective. At first
/// they are at a few Chebyshev points of every piece, later also at the exact extrema of solutions
/// that exceed them.
class ExchangeRows {
 public:
  ExchangeRows(const Subproblem& subproblem, const Point& start);

  /// The present rows.
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
  /// Value of the objective for t = 1.
  [[nodiscard]] double reference() const { return reference_; }
  /// Relative excess of the epigraph that counts as rounding.
  [[nodiscard]] double precision() const;

  /// Adds the extrema of `shape`, the cam at z, that exceed a ceiling, or exceed the epigraph at t.
  /// Returns their number.
  int exchange(const Shape& shape, const Point& z, double t);

 private:
  void add_spacing(std::size_t segment);
  void add_everywhere(std::size_t piece, const Point& z);
  bool exclude(const DerivativeBound& ceiling, std::size_t piece, double s, const Point& z,
               double excess);
  bool add_peak(std::size_t piece, double s, std::size_t order, double sign, const Point& z);
  bool add(const Row& row, const Point& z);

  [[nodiscard]] Row row_of(const DerivativeBound& ceiling, std::size_t piece, double s,
                           const Point& z) const;
  [[nodiscard]] double largest_slope(const Row& row, const Point& z) const;
  [[nodiscard]] Row* find(const Row& row);

  const Subproblem& subproblem_;
  double reference_;
  double margin_;  ///< relative distance from the ceilings, for the rounding of SLSQP
  int sharpened_ = 0;
  std::vector<Row> rows_;
};

}  // namespace jounce::optimize_detail
