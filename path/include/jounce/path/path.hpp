// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "jounce/path/point.hpp"
#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/over_length.hpp"

namespace jounce {

/// Kind of a piece of a path.
enum class PieceKind : std::uint8_t {
  line,  ///< straight line
  arc,   ///< arc or helix: for each axis one sine and a line
  turn,  ///< corner of two lines: the tangent changes by a trapezoid (docs/path/README.md, Turns)
  /// Corner of any two pieces: a quintic with the curvatures of its neighbors (README, Blends).
  blend,
  curve,  ///< polynomial: a piece of a spline, an ellipse, or an averaged sequence of lines
};

/// One piece of a path: a single formula.
struct PathPiece {
  /// Number of settings that a program can have: an index has 24 bits.
  static constexpr std::uint32_t most_settings = std::uint32_t{1} << 24U;

  double start = 0;        ///< q at its start
  double length = 0;       ///< length in q
  std::uint32_t data = 0;  ///< index of its first number among those of the turns, or of the others
  /// Source line: for joined lines, the line of the first one; for a corner, the line of the
  /// command after the corner.
  std::int32_t line = 0;
  std::uint32_t settings = 0;  ///< index into the settings of the program
  PieceKind kind = PieceKind::line;
  /// For a corner: index of the settings of the command before it.
  std::uint32_t settings_before : 24 = 0;

  bool operator==(const PathPiece&) const = default;
};

/// The path of a group of axes: one curve for each axis as a function of the path parameter q.
///
/// **q** is the arc length on lines and arcs. A corner has the same length in q as the two ends
/// that it replaces. So a path of lines has the same length in q with and without rounded corners.
/// On a turn, |r'| <= 1, where r is the position on the path.
///
/// **Memory.** A piece needs 32 bytes and, for n axes, 2n numbers for a line, 2n + 1 for a turn (n
/// more for the first one, and behind a piece that is no line), 6n + 1 for a blend. curve() makes a
/// Curve from these numbers.
class Path {
 public:
  /// Used by plan(), which makes paths. `turns`: the numbers of the turns; `numbers`: those of all other
  /// pieces. Throws InputError for more than 2^32 - 1 of either.
  Path(std::size_t axes, std::vector<PathPiece> pieces, std::vector<double> numbers,
       std::vector<double> turns = {});

  [[nodiscard]] std::size_t axes() const { return axes_; }
  [[nodiscard]] double length() const;  ///< in q
  [[nodiscard]] std::span<const PathPiece> pieces() const { return pieces_; }
  /// Used by plan(), which uses the memory of a path without turns again: the pieces and the numbers.
  [[nodiscard]] std::pair<std::vector<PathPiece>, std::vector<double>> release() && {
    return {std::move(pieces_), std::move(numbers_)};
  }

  /// Size of pieces and numbers, bytes.
  [[nodiscard]] std::size_t bytes() const {
    return pieces_.size() * sizeof(PathPiece) + (numbers_.size() + turns_.size()) * sizeof(double);
  }
  /// Returns the numbers of a piece. path/src/geometry/pieces.hpp defines their layout.
  [[nodiscard]] const double* numbers(std::size_t piece) const {
    const PathPiece& p = pieces_[piece];
    return (p.kind == PieceKind::turn ? turns_ : numbers_).data() + p.data;
  }

  /// Writes the position and three derivatives with respect to q of every axis to `out`, at the
  /// distance u in q from the start of a piece, 0 to its length. `out` has one entry for each axis;
  /// otherwise the function throws InputError.
  void jets(std::size_t piece, double u, std::span<Jet> out) const;
  /// Returns the point at the distance u in q from the start of a piece, 0 to its length.
  [[nodiscard]] Point point(std::size_t piece, double u) const;

  /// Appends the segments of one axis on one piece to `out`: one, or up to three for a turn.
  void segments(std::size_t piece, std::size_t axis, std::vector<Segment>& out) const;

  /// Returns one axis as a function of q, from 0 to length(); it holds outside. Exact.
  [[nodiscard]] Curve<OverLength> curve(std::size_t axis) const;

  bool operator==(const Path&) const = default;

 private:
  std::size_t axes_;
  std::vector<PathPiece> pieces_;
  std::vector<double> numbers_, turns_;
};

}  // namespace jounce
