// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "jounce/profiles/curve/break_index.hpp"
#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Interpolation of a table between its knots. Each rule needs its own columns.
enum class Interpolation {
  linear,           ///< column p; the position is continuous
  cubic_hermite,    ///< columns p and v; the velocity is continuous (PVT table)
  quintic_hermite,  ///< columns p, v and a; the acceleration is continuous (PVA or XYVA table)
};

/// Meaning of the first column of a table: time, or position of a master.
enum class Domain { time, master };

/// Equally spaced instants for Table::sample(), in time or master position. Instant k is start +
/// k * step, each operation rounded. m is the master's unit.
struct Grid {
  double start = 0;  ///< s or m
  double step = 1;   ///< > 0, s or m
};

/// The columns of a table, each with one entry for each knot. v and a are empty unless the rule
/// needs them. u is the unit of the position.
struct Columns {
  std::vector<double> x = {};  ///< s or m: time or position of the master, strictly ascending
  std::vector<double> p = {};  ///< u, position
  std::vector<double> v = {};  ///< dp/dx, u/s or u/m
  std::vector<double> a = {};  ///< d2p/dx2, u/s^2 or u/m^2
};

/// A table: knots in columns, and the interpolation rule between them. Controllers and the executor
/// play motions as tables. A table is a Signal; its evaluation does not allocate.
///
///     Table table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap, columns);
///     double slave = table.jet(master)[0];
///     Cam exact = table.curve<OverMaster>();     // the same polynomials, for exact checks
///     table.sample({.start = 0, .step = 0.001}, p, v, a);        // into columns p, v and a
///
/// A table is immutable: copies share their knots. A table that was moved from is empty: assign to
/// it or destroy it, but call no other member.
///
/// Evaluation (pvt/src/table/piece.hpp) gives the same result on every processor. The curve() of
/// the table agrees to rounding. As in a Curve, an interval includes its start but not its end. The
/// end of the table belongs to the last interval; but if the table repeats, Side::right gives the
/// start of the next period.
///
/// The constructor throws InputError, with the knot and the rule, for fewer than two knots; columns
/// of unequal size; a missing column, or a column that the rule does not use; an x that does not
/// ascend; and numbers that are not finite.
class Table {
 public:
  /// `outside`: policy for queries outside [start, end].
  Table(Domain axis, Interpolation rule, Extrapolation outside, Columns columns);

  [[nodiscard]] Domain axis() const { return axis_; }
  [[nodiscard]] Interpolation rule() const { return rule_; }
  [[nodiscard]] Extrapolation outside() const { return outside_; }
  /// Change of the position over one period if outside() is Extrapolation::advance; otherwise 0.
  [[nodiscard]] double advance() const;
  [[nodiscard]] const Columns& columns() const { return knots_->columns; }
  [[nodiscard]] std::size_t size() const { return columns().x.size(); }  ///< number of knots

  [[nodiscard]] double start() const { return columns().x.front(); }
  [[nodiscard]] double end() const { return columns().x.back(); }
  [[nodiscard]] double length() const { return end() - start(); }
  [[nodiscard]] std::span<const double> breaks() const { return columns().x; }
  /// Returns the position and three derivatives at x.
  [[nodiscard]] Jet jet(double x, Side side = Side::right) const;

  /// Writes the position and two derivatives at every x[i] to p[i], v[i], a[i]. The results equal
  /// the results of jet() bit for bit on every processor; if x ascends, the function is many times
  /// as fast. Throws InputError if the spans differ in size. Does not allocate.
  void sample(std::span<const double> x, std::span<double> p, std::span<double> v,
              std::span<double> a) const;
  /// Writes the values at the instants of a grid, whose step is > 0. The size of p, v and a is the
  /// number of instants. Throws InputError if they differ in size.
  void sample(const Grid& grid, std::span<double> p, std::span<double> v,
              std::span<double> a) const;

  /// Returns the index of the interval that contains x, from 0. Before the start: the first
  /// interval; at or after the end: the last one.
  [[nodiscard]] std::size_t interval(double x) const {
    return knots_->index.find(columns().x, x, Side::right);
  }

  /// Returns the interval from knot i to knot i + 1 as a segment.
  [[nodiscard]] Segment segment(std::size_t i) const;

  /// Returns the table as a curve. Throws InputError if Over does not agree with axis(), or if a
  /// coefficient is too large for a double.
  template <class Over>
  [[nodiscard]] Curve<Over> curve() const;

 private:
  struct Knots {
    Columns columns = {};
    BreakIndex index = {};
  };

  [[nodiscard]] Jet at_end_or_outside(double x, Side side) const;
  [[nodiscard]] Jet inside(std::size_t interval, double at) const;
  void fetch(std::size_t interval) const;

  Domain axis_;
  Interpolation rule_;
  Extrapolation outside_;
  std::shared_ptr<const Knots> knots_;
};

/// Throws InputError like table.curve(), but does not make the curve.
void require_curve(const Table& table);

/// Returns the table in another unit of its first column: x times `factor`, with derivatives
/// adapted. Throws InputError unless factor > 0, and if a number overflows or x no longer ascends.
/// For example, 1e-3 converts ms to s.
Table stretched(const Table& table, double factor);

/// Return the word used in every file: "linear", "cubic_hermite", "quintic_hermite"; "time",
/// "master"; "refuse", "hold", "wrap", "advance".
const char* name(Interpolation rule);
const char* name(Domain axis);
const char* name(Extrapolation outside);

}  // namespace jounce
