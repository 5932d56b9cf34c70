// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "jounce/axis/detail/group_program.hpp"
#include "jounce/executor/detail/trace.hpp"

namespace jounce {
namespace {

constexpr std::size_t most_parts = 64;  // chords of a curved piece

/// The points of a path, in the order of its length.
struct PathPoints {
  const Path& path;
  TracePath& out;

  void add(std::size_t piece, double u) {
    const Point place = path.point(piece, u);
    out.at[out.points] = path.pieces()[piece].start + u;
    for (std::size_t k = 0; k < out.coordinates; ++k) out.places[k][out.points] = place[k];
    ++out.points;
  }

  /// The start of each piece, points inside the curved pieces, and the end.
  void add_pieces(std::size_t parts) {
    const auto pieces = path.pieces();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const std::size_t count = pieces[i].kind == PieceKind::line ? 1 : parts;
      for (std::size_t k = 0; k < count; ++k)
        add(i, pieces[i].length * static_cast<double>(k) / static_cast<double>(count));
    }
    add(pieces.size() - 1, pieces.back().length);
  }

  void add_equally() {
    std::size_t piece = 0;
    const auto pieces = path.pieces();
    for (std::size_t k = 0; k < TracePath::most_points; ++k) {
      const double q = path.length() * static_cast<double>(k) / (TracePath::most_points - 1);
      while (piece + 1 < pieces.size() && pieces[piece + 1].start <= q) ++piece;
      add(piece, std::clamp(q - pieces[piece].start, 0.0, pieces[piece].length));
    }
  }
};

}  // namespace

std::unique_ptr<TracePath> trace_path(const GroupProgram& program, const ExecutorGroup& group,
                                      double origin) {
  auto out = std::make_unique<TracePath>();
  const Path& path = program.plan->drawn();
  const auto& names = group.coordinates();
  out->origin = origin;
  out->coordinates = std::min({TracePath::most_names, group.path_axes(), path.axes()});
  for (std::size_t k = 0; k < out->coordinates; ++k)
    names[k].copy(out->names[k].data(), out->names[k].size() - 1);
  (group.kinematics ? group.kinematics->unit : group.unit)
      .copy(out->unit.data(), out->unit.size() - 1);
  if (group.kinematics && program.first == 0) return out;  // planned in the joints
  const auto curved = static_cast<std::size_t>(
      std::count_if(path.pieces().begin(), path.pieces().end(),
                    [](const PathPiece& piece) { return piece.kind != PieceKind::line; }));
  const std::size_t ends = path.pieces().size() - curved + 1;
  PathPoints points{path, *out};
  if (ends + curved > TracePath::most_points)
    points.add_equally();
  else
    points.add_pieces(curved == 0 ? 1
                                  : std::min(most_parts, (TracePath::most_points - ends) / curved));
  return out;
}

}  // namespace jounce
