// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "jounce/pvt/pt.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

/// One segment of a path that is passed row by row (a rolling stream, a controller's FIFO): its
/// end, and the data of its polynomial. x is time or master position.
///
///     const SegmentRow row{.x_end = 1024, .p_end = 1024, .v_start = 0, .degree = 2};
///     const Jet now = point(row, {0, 0}, 0, 512);          // 256, rate 1: manual, example 7-3
///     for (const SegmentRow& r : rows_of(table)) ...       // bit for bit the table
///
/// **Degree** is that of the position within the row, by x:
///
///     1   a straight line: no rate is read
///     2   p, and one rate, at whichever end is given (both: they must agree). NaN is left open: with
///         both open the row goes on at the rate at which the one before ended (Googol's NORMAL and
///         CONTINUE); with v_end alone it ends there (STOP: 0)
///     3   p and both rates: a cubic Hermite table (PVT)
///     5   p, both rates and both second derivatives: a quintic one (PVA)
///
/// Numbers are cumulative, from the start of the path. **To the last bit** rows of degree 3 and 5
/// equal the Table from which they come, and rows of degree 1 and 2 pt() of the same points (if x
/// adds up exactly, else to rounding); rows of a linear Table equal it to one rounding of its
/// position (Table multiplies by 1/length, pt() divides).
struct SegmentRow {
  static constexpr double open = std::numeric_limits<double>::quiet_NaN();

  double x_end = 0;       ///< s, or m: beyond the end of the row before
  double p_end = 0;       ///< u
  double v_start = open;  ///< u per x
  double v_end = open;    ///< u per x
  double a_start = 0;     ///< u per x^2; degree 5
  double a_end = 0;       ///< u per x^2; degree 5
  int degree = 2;
  bool last = false;  ///< last of a stream: nothing comes after it
};

/// Start of a row: the end of the row before.
struct RowStart {
  double x = 0;
  double position = 0;
};

/// Error of a row, or `none`. The numbers are part of the wire format.
enum class RowRule : std::uint8_t {
  none = 0,
  full = 1,        ///< there is no space for it
  not_finite = 2,  ///< a number that its degree reads is none
  no_degree = 3,   ///< a degree other than 1, 2, 3 and 5
  not_ascending = 4,
  rates_differ = 5,  ///< degree 2, both rates given: they do not lead from its start to its end
  velocity = 6,      ///< beyond the limits ...
  acceleration = 7,
  jerk = 8,
  velocity_step = 9,  ///< at its start
  after_last = 10,    ///< the stream has its last row
  in_use = 11,        ///< the FIFO is about to be emptied by a switch
  position = 12,      ///< beyond the range
};
const char* name(RowRule rule);
/// One sentence for people.
const char* explain(RowRule rule);

/// Limits of rows, per x; infinite: none.
struct RowLimits {
  static constexpr double none = std::numeric_limits<double>::infinity();
  double velocity = none;
  double acceleration = none;
  double jerk = none;
  double velocity_step = none;  ///< velocity step of the rate, from one row to the next
  double position_min = -none;  ///< u, of the rows' own coordinates
  double position_max = none;
};

/// The greatest magnitudes within a row, and the step of the rate at its begin.
struct RowPeaks {
  double velocity = 0, acceleration = 0, jerk = 0, velocity_step = 0;
  double position_min = 0, position_max = 0;
};

/// The rates at both ends of a row that follows one which ended at `rate`.
PtRate rates(const SegmentRow& row, const RowStart& from, double rate);

/// Position and its derivatives by x, held at the row's ends. Does not allocate.
Jet point(const SegmentRow& row, const RowStart& from, double rate, double x);

/// Exact extrema of the row's polynomials.
RowPeaks peaks(const SegmentRow& row, const RowStart& from, double rate);

/// Checks that its numbers are valid after `from`; returns the first violated rule.
RowRule check(const SegmentRow& row, const RowStart& from);
/// True if it keeps the limits (a rounding of 1e-9 is forgiven).
RowRule check(const RowPeaks& peaks, const RowLimits& limits);

/// A row as eight numbers, in the order of the members, for messages and files; degree and last as
/// numbers. A degree that is not a whole number becomes 0, which check() rejects.
std::array<double, 8> columns_of(const SegmentRow& row);
SegmentRow row_of(const std::array<double, 8>& columns);

/// The rows of a PT table by Googol's types, to be played from rest at (0, 0).
std::vector<SegmentRow> rows_of(std::span<const PtPoint> points);
/// One of them; `first` in its pass.
SegmentRow row_of(const PtPoint& point, bool first);

/// The rows of a table, to be played from its first knot, `start_of`: its numbers as they are.
std::vector<SegmentRow> rows_of(const Table& table);
RowStart start_of(const Table& table);

}  // namespace jounce
