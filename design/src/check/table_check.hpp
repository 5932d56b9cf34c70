// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/design/input.hpp"

namespace jounce::design_detail {

/// Compares the slave of a cam, behind the [master] of its spec, with [limits.slave], and the speed
/// of the master with the greatest possible one. Reports the worst place of each limit in each
/// segment of the spec. Empty without such limits.
Report check_slave(const Input& input);

/// Findings for the limits that a table exceeds between its knots, and that the curve keeps: those
/// of the input and, behind [master], those of [limits.slave]. An excess is a finding if it is
/// greater than the rounding of the knots.
///
/// `table` is in the units of the input. `of_curve` has the findings of the curve: there are none
/// for a limit that the curve exceeds. If the curve steps, there are none, because the table
/// follows the step. `rises`: FileRounding::rises.
Report check_table(const Table& table, const Input& input, const Report& of_curve,
                   std::span<const Jet> rises = {});

/// The excess that the numbers of a file may cause.
struct FileRounding {
  double share = 0;  ///< share of a limit
  /// For each interval of the table, the rise of the value and its derivatives (time_rounding()), in
  /// the units of the input; empty: none.
  std::vector<Jet> rises = {};
};

/// check_table() for another table than that of the input. The position is not compared: it exceeds
/// its limits by no more than the error of the table, which has a tolerance of its own.
Report check_converted(const Table& table, const Input& input, const FileRounding& file = {});

/// For a table: removes the findings of limits that the rounding of its knots explains, and, for a
/// table with its spec (set_against()), those of a position that its permitted deviation explains.
void forgive_rounding(Report& report, const Input& input);

/// Keeps the worst finding of each limit in each segment of the spec, which may have several pieces.
void keep_worst(Report& report, const Labels& labels);

}  // namespace jounce::design_detail
