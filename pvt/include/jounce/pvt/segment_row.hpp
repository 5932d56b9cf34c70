// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "jounce/pvt/pt.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

/// A row: one segment of a motion that is sent row by row (a rolling stream, the FIFO of a
/// controller). A row gives the end of the segment and the data of its polynomial. x is the time or
/// the position of the master. u is the axis' unit, m the master's.
///
///     const SegmentRow row{.x_end = 1024, .p_end = 1024, .v_start = 0, .degree = 2};
///     const Jet now = point(row, {0, 0}, 0, 512);          // 256, rate 1: Googol example 7-3
///     for (const SegmentRow& r : rows_of(table)) ...       // exactly the table
///
/// **Degree** of the position as a function of x. The *rate* is the first derivative. A row has
/// different data for each degree:
/// - 1: a straight line. No rate is used.
/// - 2: p and one rate, at the start or at the end. If both rates are given, they must agree. NaN
///   means open. If both rates are open, the row begins at the end rate of the previous row
///   (Googol's NORMAL and CONTINUE). If only v_end is given, the row ends at this rate (STOP: 0).
/// - 3: p and both rates, as in a cubic Hermite table (PVT).
/// - 5: p, both rates and both second derivatives, as in a quintic Hermite table (PVA).
///
/// x_end and p_end count from the start of the motion. Rows of degree 3 and 5 agree bit for bit
/// with the table from which they are made. Rows of degree 1 and 2 agree bit for bit with pt() of
/// the same points if the sums of x are exact, otherwise to rounding. Rows of a linear Table agree
/// with it to one rounding of the position (Table multiplies by 1/length, pt() divides).
struct SegmentRow {
  /// Value of a rate that is not given.
  static constexpr double open = std::numeric_limits<double>::quiet_NaN();

  double x_end = 0;       ///< s or m: end of the row, beyond the end of the previous row
  double p_end = 0;       ///< u, position at the end
  double v_start = open;  ///< u/s or u/m, rate at the start
  double v_end = open;    ///< u/s or u/m, rate at the end
  double a_start = 0;     ///< u/s^2 or u/m^2, for degree 5
  double a_end = 0;       ///< u/s^2 or u/m^2, for degree 5
  int degree = 2;         ///< 1, 2, 3 or 5
  bool last = false;      ///< true: the last row of a stream
};

/// Start of a row: the end of the previous row.
struct RowStart {
  double x = 0;         ///< s or m
  double position = 0;  ///< u
};

/// Reason why a row is rejected, or `none`. The numbers are part of the wire format.
enum class RowRule : std::uint8_t {
  none = 0,
  full = 1,           ///< there is no space for the row
  not_finite = 2,     ///< a number that the degree needs is not finite
  no_degree = 3,      ///< the degree is not 1, 2, 3 or 5
  not_ascending = 4,  ///< x does not ascend
  /// Degree 2 with both rates: the two rates do not lead from the start to the end of the row.
  rates_differ = 5,
  velocity = 6,       ///< the row exceeds the limit of the velocity
  acceleration = 7,   ///< the row exceeds the limit of the acceleration
  jerk = 8,           ///< the row exceeds the limit of the jerk
  velocity_step = 9,  ///< the rate steps at the start of the row by more than the limit
  after_last = 10,    ///< the stream already has its last row
  in_use = 11,        ///< the FIFO is about to be emptied by a switch
  position = 12,      ///< the row leaves the range of positions
};
const char* name(RowRule rule);  ///< the rule as a word
/// Returns one sentence that explains a rule to a user.
const char* explain(RowRule rule);

/// Limits of rows, with respect to x; infinite: no limit.
struct RowLimits {
  static constexpr double none = std::numeric_limits<double>::infinity();  ///< no limit
  double velocity = none;       ///< greatest rate, u/s or u/m
  double acceleration = none;   ///< greatest second derivative, u/s^2 or u/m^2
  double jerk = none;           ///< greatest third derivative, u/s^3 or u/m^3
  double velocity_step = none;  ///< greatest step of the rate from one row to the next
  double position_min = -none;  ///< u, in the coordinates of the rows
  double position_max = none;   ///< u
};

/// The greatest magnitudes within a row, the step of the rate at its start, and the range of
/// positions.
struct RowPeaks {
  double velocity = 0, acceleration = 0, jerk = 0, velocity_step = 0;
  double position_min = 0, position_max = 0;
};

/// Returns the rates at both ends of a row. `from` is the start of the row, `rate` the end rate of
/// the previous row.
PtRate rates(const SegmentRow& row, const RowStart& from, double rate);

/// Returns the position and derivatives of a row at x. Outside the row, returns the values at its
/// nearer end. Does not allocate.
Jet point(const SegmentRow& row, const RowStart& from, double rate, double x);

/// Returns the exact extrema of the row's polynomial.
RowPeaks peaks(const SegmentRow& row, const RowStart& from, double rate);

/// Checks the numbers of a row that begins at `from`; returns the first broken rule.
RowRule check(const SegmentRow& row, const RowStart& from);
/// Checks the limits, with a tolerance of 1e-9 for rounding; returns the first broken rule.
RowRule check(const RowPeaks& peaks, const RowLimits& limits);

/// columns_of() returns the row as eight numbers, in the order of the members; `degree` and `last`
/// become numbers. Use it for messages and files. row_of() makes a row from these numbers. If the
/// degree is not a whole number, it becomes 0, which check() rejects.
std::array<double, 8> columns_of(const SegmentRow& row);
SegmentRow row_of(const std::array<double, 8>& columns);

/// Returns the rows of a PT table with Googol's types, played from rest at (0, 0).
std::vector<SegmentRow> rows_of(std::span<const PtPoint> points);
/// Returns the row of one point. `first` is true for the first row of its pass.
SegmentRow row_of(const PtPoint& point, bool first);

/// rows_of() returns the rows of a table with its numbers unchanged. The rows are played from the
/// first knot of the table, which start_of() returns.
std::vector<SegmentRow> rows_of(const Table& table);
RowStart start_of(const Table& table);

}  // namespace jounce
