// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/path/path.hpp"
#include "jounce/path/program.hpp"

namespace jounce {

/// A junction of a route: the place where a command begins. The first and the last junction are the
/// ends.
struct Joint {
  double dwell = 0;     ///< s, duration of the rest
  bool rests = false;   ///< true: the plan rests here (a dwell, a buffered command, an end)
  bool smooth = false;  ///< true: inside an average or a curve, so there is no corner
};

/// The pieces of a program with sharp corners, and the junctions before, between and after them.
struct Route {
  Path path;
  std::vector<Joint> joints;              ///< one more than pieces
  std::vector<std::int32_t> empty_lines;  ///< source lines of commands that cover no distance
};

/// Makes the route. Successive lines of one direction (to 1e-10) with the same settings become one
/// piece, with the source line of the first; so do successive arcs of one circle or helix. Throws InputError for a program that covers no
/// distance.
Route route_of(const Program& program);

/// Appends the part of piece k of `from` between u0 and u1 to `pieces`; nothing if u1 - u0 is
/// within rounding.
void append_part(const Path& from, std::size_t k, double u0, double u1,
                 std::vector<PathPiece>& pieces, std::vector<double>& numbers);

/// Appends the numbers of a curve. All axes get the highest degree of any of them, at least `degree`.
void append_curve(std::span<const Segment> axes, std::vector<double>& numbers, int degree = 1);

}  // namespace jounce
