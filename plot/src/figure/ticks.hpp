// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace jounce {

/// An interval of numbers that a plot shows. It is empty until a finite number is added.
struct PlotRange {
  double lo = 1;
  double hi = -1;

  [[nodiscard]] bool empty() const { return lo > hi; }
  [[nodiscard]] double span() const { return hi - lo; }
  void add(double value);
};

/// True if a plot can show the value: it is finite, and so far below the largest double that
/// differences are finite.
bool drawable(double value);

/// Returns an interval that an axis can show: around `data`, never empty or a single point. A
/// variation of at most `noise`, or within rounding, counts as a constant.
PlotRange axis_extent(PlotRange data, double noise = 0);

/// Positions and labels of the marks of an axis.
struct Ticks {
  std::vector<double> at;           ///< ascending, within the axis
  std::vector<std::string> labels;  ///< one for each mark, without the factor
  int exponent = 0;                 ///< the labels must be multiplied by 10^exponent
};

/// Returns ticks at steps of 1, 2 or 5 times a power of ten, with at most `most` >= 1 intervals.
Ticks ticks(PlotRange axis, int most);

/// The same for an angle in degrees: from 60 deg on, steps are 5, 10, 15, 30, 45, 60, 90, 180 or
/// multiples of 360.
Ticks angle_ticks(PlotRange axis, int most);

/// The same for an axis of decimal logarithms. The labels are the numbers themselves: 1, 2 and 5
/// times each power of ten, each power, or every n-th power.
Ticks decade_ticks(PlotRange axis, int most);

}  // namespace jounce
