// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace jounce {

/// An interval of the numbers that a plot shows; empty until something finite is added.
struct PlotRange {
  double lo = 1;
  double hi = -1;

  [[nodiscard]] bool empty() const { return lo > hi; }
  [[nodiscard]] double span() const { return hi - lo; }
  void add(double value);
};

/// True if a plot can show the value: finite, and far enough from the largest double that
/// differences stay finite.
bool drawable(double value);

/// An interval that an axis can show: around `data`, never empty or a single point. A variation of
/// no more than `noise`, or than rounding, is taken for a constant.
PlotRange axis_extent(PlotRange data, double noise = 0);

/// Positions and labels of the marks of an axis.
struct Ticks {
  std::vector<double> at;           ///< ascending, within the axis
  std::vector<std::string> labels;  ///< one each, without the factor
  int exponent = 0;                 ///< labels are to be multiplied by 10^exponent
};

/// Ticks at steps of 1, 2 or 5 times a power of ten, at most `most` >= 1 intervals.
Ticks ticks(PlotRange axis, int most);

/// The same for an angle in degrees: from 60 deg on, steps are 5, 10, 15, 30, 45, 60, 90, 180 or
/// multiples of 360.
Ticks angle_ticks(PlotRange axis, int most);

/// The same for an axis of decimal logarithms, labelled with the numbers themselves: at 1, 2, 5 times each power of
/// ten, at each power, or at every n-th.
Ticks decade_ticks(PlotRange axis, int most);

}  // namespace jounce
