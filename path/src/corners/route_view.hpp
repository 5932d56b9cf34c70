// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "path/src/corners/rounding.hpp"
#include "path/src/timing/not_limited.hpp"

namespace jounce {

/// The pieces of a route with their settings and limits. Junction k is between the pieces k - 1 and
/// k.
struct RouteView {
  const Route& route;
  const Lines& lines;
  const Program& program;
  const Rates& rates;
  const Rates curved = reserved(rates);  ///< the same for pieces that are not lines

  [[nodiscard]] std::size_t axes() const { return rates.axes; }
  [[nodiscard]] std::size_t count() const { return route.path.pieces().size(); }
  [[nodiscard]] const PathPiece& piece(std::size_t k) const { return route.path.pieces()[k]; }
  [[nodiscard]] const PathSettings& settings(std::size_t k) const {
    return program.settings()[piece(k).settings];
  }
  [[nodiscard]] std::span<const double> direction(std::size_t k) const {
    return std::span(lines.directions).subspan(k * axes(), axes());
  }
  /// True if the junction is between two lines.
  [[nodiscard]] bool are_lines(std::size_t k) const {
    return piece(k - 1).kind == PieceKind::line && piece(k).kind == PieceKind::line;
  }
  /// The lower one of the feeds on both sides of a junction.
  [[nodiscard]] double cap(std::size_t k) const {
    return std::min({settings(k - 1).velocity, settings(k).velocity, rates.path.velocity});
  }
  [[nodiscard]] Point corner(std::size_t k) const { return route.path.point(k, 0); }

  /// The box of a piece. `entry` and `exit`: greatest velocities at its ends; 0 is a rest.
  [[nodiscard]] Box box(std::size_t k, double entry, double exit) const {
    if (piece(k).kind == PieceKind::line) return lines.boxes[k];
    if (piece(k).kind == PieceKind::arc)
      return arc_box(curved, settings(k), route.path.numbers(k), piece(k).length, entry, exit);
    // The pieces of a curve are short: a ramp is assumed to extend over several of them.
    return curve_box(curved, settings(k), derivatives_of(route.path, k, rates.path_axes),
                     20 * piece(k).length);
  }
};

}  // namespace jounce
