// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/path/path.hpp"
#include "jounce/path/program.hpp"

namespace jounce {

/// A joint of a route: where a command begins; the first and the last are the ends.
struct Joint {
  double dwell = 0;     ///< s of rest
  bool rests = false;   ///< a dwell, a buffered command, an end
  bool smooth = false;  ///< within an average or a curve: nothing is to be done
};

/// The pieces of a program with sharp corners, from end to end, and the joints before, between and behind them.
struct Route {
  Path path;
  std::vector<Joint> joints;              ///< one more than pieces
  std::vector<std::int32_t> empty_lines;  ///< lines of commands that cover no distance
};

/// Lines of one direction (to 1e-10) under the same settings are one piece, with the line of the first: a point
/// within a line changes nothing. Throws InputError for a program that covers no distance.
Route route_of(const Program& program);

/// Appends piece k of `from` between u0 and u1 to `pieces`; nothing if u1 - u0 is within rounding.
void append_part(const Path& from, std::size_t k, double u0, double u1,
                 std::vector<PathPiece>& pieces, std::vector<double>& numbers);

/// Appends the numbers of a curve: all axes have the degree of the highest.
void append_curve(std::span<const Segment> axes, std::vector<double>& numbers);

}  // namespace jounce
