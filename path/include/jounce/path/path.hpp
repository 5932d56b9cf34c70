// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "jounce/path/point.hpp"
#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/over_length.hpp"

namespace jounce {

/// Kind of a piece of a path.
enum class PieceKind : std::uint8_t {
  line,
  arc,    ///< or helix: one sine and a line an axis
  turn,   ///< corner of two lines: the tangent turns by a trapezoid (docs/path/README.md, 2.1)
  blend,  ///< corner of any two pieces: a quintic with the curvatures of its neighbors (2.2)
  curve,  ///< polynomial: a piece of a spline, an ellipse, or an averaged polyline
};

/// One formula of a path.
struct PathPiece {
  double start = 0;      ///< q where it begins
  double length = 0;     ///< in q
  std::size_t data = 0;  ///< its first number
  /// Line of the source: the first of lines in one direction; a corner has that of the command behind it.
  std::int32_t line = 0;
  std::uint32_t settings = 0;  ///< index into the settings of the program
  PieceKind kind = PieceKind::line;
};

/// The way of a group: one curve an axis over the path parameter q.
///
/// **q** is the arc length on lines and arcs. A corner keeps the length of what it replaces, so q has the same
/// length with and without rounding for line-line corners; there |r'| <= 1.
///
/// **Memory**: 32 bytes a piece, and for n axes 2n numbers a line, 3n + 1 a turn, 6n + 1 a blend. `curve` makes
/// the curves of the library from them.
class Path {
 public:
  Path(std::size_t axes, std::vector<PathPiece> pieces, std::vector<double> numbers);

  [[nodiscard]] std::size_t axes() const { return axes_; }
  [[nodiscard]] double length() const;
  [[nodiscard]] std::span<const PathPiece> pieces() const { return pieces_; }

  /// Memory of pieces and numbers.
  [[nodiscard]] std::size_t bytes() const {
    return pieces_.size() * sizeof(PathPiece) + numbers_.size() * sizeof(double);
  }
  /// The numbers of a piece; their layout is that of path/src/geometry/pieces.hpp.
  [[nodiscard]] const double* numbers(std::size_t piece) const {
    return numbers_.data() + pieces_[piece].data;
  }

  /// Value and three derivatives by q of every axis, at s = u / length in [0, 1] of a piece.
  void jets(std::size_t piece, double u, std::span<Jet> out) const;
  [[nodiscard]] Point point(std::size_t piece, double u) const;

  /// The segments of one axis on one piece: one, or three for a turn (fewer where it has no ramp or no middle).
  void segments(std::size_t piece, std::size_t axis, std::vector<Segment>& out) const;

  /// One axis over q, from 0 to length(). Exact.
  [[nodiscard]] Curve<OverLength> curve(std::size_t axis) const;

 private:
  std::size_t axes_;
  std::vector<PathPiece> pieces_;
  std::vector<double> numbers_;
};

}  // namespace jounce
