// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "jounce/profiles/curve/break_index.hpp"
#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Interpolation of a table between its knots: each rule with the columns it needs.
enum class Interpolation {
  linear,           ///< p; position continuous
  cubic_hermite,    ///< p, v; velocity continuous (a PVT table)
  quintic_hermite,  ///< p, v, a; acceleration continuous (a PVA or XYVA table)
};

/// Meaning of the first column of a table.
enum class Domain { time, master };

/// Equal steps on a table's axis: instant k is start + k step, each operation rounded.
struct Grid {
  double start = 0;
  double step = 1;  ///< > 0
};

/// The columns of a table; each has one entry for each knot, v and a only if the rule needs them.
struct Columns {
  std::vector<double> x;  ///< time or master position, strictly ascending
  std::vector<double> p;  ///< position
  std::vector<double> v;  ///< dp/dx
  std::vector<double> a;  ///< d2p/dx2
};

/// Knots in columns plus the rule between them: the form that a controller holds and the executor
/// plays. It is a Signal, and evaluates without allocating.
///
///     Table table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap, columns);
///     double slave = table.jet(master)[0];
///     Cam exact = table.curve<OverMaster>();     // the same polynomials, for exact checks
///     table.sample({.start = 0, .step = 0.001}, p, v, a);        // a column each, in blocks
///
/// A table is immutable: copies share their knots.
///
/// An interval is evaluated by detail/piece.hpp, the same on every processor; the curve agrees
/// within rounding.
///
/// Intervals are half-open, the last closed, as in a Curve. Throws InputError, naming knot and
/// rule, for fewer than two knots, columns of unequal size, a column that the rule does not have or
/// lacks, x that does not ascend, and numbers that are not finite.
class Table {
 public:
  Table(Domain axis, Interpolation rule, Extrapolation outside, Columns columns);

  [[nodiscard]] Domain axis() const { return axis_; }
  [[nodiscard]] Interpolation rule() const { return rule_; }
  [[nodiscard]] Extrapolation outside() const { return outside_; }
  /// Advance of the position in one period: Extrapolation::advance; otherwise 0.
  [[nodiscard]] double advance() const;
  [[nodiscard]] const Columns& columns() const { return knots_->columns; }
  [[nodiscard]] std::size_t size() const { return columns().x.size(); }

  [[nodiscard]] double start() const { return columns().x.front(); }
  [[nodiscard]] double end() const { return columns().x.back(); }
  [[nodiscard]] double length() const { return end() - start(); }
  [[nodiscard]] std::span<const double> breaks() const { return columns().x; }
  [[nodiscard]] Jet jet(double x, Side side = Side::right) const;

  /// Position and two derivatives at every x, each in a column of its own: jet() to the bit, on
  /// every processor, and many times as fast if x ascends. Spans of equal size (asserted). Does not
  /// allocate, does not throw.
  void sample(std::span<const double> x, std::span<double> p, std::span<double> v,
              std::span<double> a) const noexcept;
  /// The same at the instants of a grid, as many as the columns hold: a cycle's positions, the rows
  /// of a file.
  void sample(const Grid& grid, std::span<double> p, std::span<double> v,
              std::span<double> a) const noexcept;

  /// The interval that x in [start, end) lies in, counted from 0.
  [[nodiscard]] std::size_t interval(double x) const {
    return knots_->index.find(columns().x, x, Side::right);
  }

  /// The interval between knots i and i + 1 as a segment.
  [[nodiscard]] Segment segment(std::size_t i) const;

  /// The same function as a curve. Over must agree with axis(); anything else is an InputError.
  template <class Over>
  [[nodiscard]] Curve<Over> curve() const;

 private:
  struct Knots {
    Columns columns;
    BreakIndex index;
  };

  [[nodiscard]] Jet at_end_or_outside(double x, Side side) const;
  [[nodiscard]] Jet inside(std::size_t interval, double at) const;
  void fetch(std::size_t interval) const;

  Domain axis_;
  Interpolation rule_;
  Extrapolation outside_;
  std::shared_ptr<const Knots> knots_;
};

/// Throws like table.curve(), without making the curve.
void require_curve(const Table& table);

/// The same table with its first column in another unit: x times `factor` > 0, the derivatives
/// accordingly. Milliseconds become seconds with 1e-3.
Table stretched(const Table& table, double factor);

/// "linear", "cubic_hermite", "quintic_hermite"; "time", "master"; "refuse", "hold", "wrap", "advance": the
/// words of every file.
const char* name(Interpolation rule);
const char* name(Domain axis);
const char* name(Extrapolation outside);

}  // namespace jounce
