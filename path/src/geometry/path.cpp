// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/path.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>

#include "jounce/profiles/detail/evaluate.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/corners/turn.hpp"
#include "path/src/geometry/pieces.hpp"

namespace jounce {
namespace {

/// One axis of a line, an arc or a polynomial.
Segment plain_segment(const double* data, PieceKind kind, double length, std::size_t n,
                      std::size_t axis) {
  Segment f;
  f.length = length;
  if (kind == PieceKind::line) {
    f.c[0] = data[axis];
    f.c[1] = data[n + axis];
    f.degree = f.c[1] != 0 ? 1 : 0;
    return f;
  }
  if (kind == PieceKind::arc) {
    const ArcNumbers arc(data, n);
    const double a = arc.cosine(axis);
    const double b = arc.sine(axis);
    f.c[0] = arc.center(axis);
    f.c[1] = arc.drift(axis);
    f.degree = f.c[1] != 0 ? 1 : 0;
    if (a != 0 || b != 0) {
      f.sines = 1;
      f.sine[0] = {std::hypot(a, b), arc.sweep(), std::atan2(a, b) + arc.phase()};
    }
    return f;
  }
  f.degree = static_cast<int>(data[0]);
  const auto count = static_cast<std::size_t>(f.degree) + 1;
  std::copy_n(data + 1 + axis * count, count, f.c.begin());
  return f;
}

}  // namespace

Path::Path(std::size_t axes, std::vector<PathPiece> pieces, std::vector<double> numbers,
           std::vector<double> turns)
    : axes_(axes),
      pieces_(std::move(pieces)),
      numbers_(std::move(numbers)),
      turns_(std::move(turns)) {
  assert(!pieces_.empty());
  constexpr std::size_t most = std::numeric_limits<decltype(PathPiece::data)>::max();
  if (const std::size_t count = std::max(numbers_.size(), turns_.size()); count > most)
    throw InputError("numbers", std::to_string(count),
                     "must be at most " + std::to_string(most) + " in a path: divide the program");
}

double Path::length() const {
  return pieces_.back().start + pieces_.back().length;
}

void Path::jets(std::size_t piece, double u, std::span<Jet> out) const {
  require_size("out", out.size(), axes_);
  const PathPiece& p = pieces_[piece];
  const double* data = numbers(piece);
  const double s = u / p.length;
  switch (p.kind) {
    case PieceKind::line:
      for (std::size_t i = 0; i < axes_; ++i) {
        const double step = data[axes_ + i];
        out[i] = {data[i] + step * s, step / p.length, 0, 0};
      }
      return;
    case PieceKind::turn: {
      const TurnNumbers turn(data, axes_);
      const Jet rise = turn_rise(turn.share(), s);  // integral of T
      for (std::size_t i = 0; i < axes_; ++i) {
        const double bend = turn.after(i) - turn.before(i);
        out[i] = {turn.start(i) + p.length * (turn.before(i) * s + bend * rise[0]),
                  turn.before(i) + bend * rise[1], bend * rise[2] / p.length,
                  bend * rise[3] / (p.length * p.length)};
      }
      return;
    }
    case PieceKind::arc: {
      const ArcNumbers arc(data, axes_);
      const double angle = arc.phase() + arc.sweep() * s;
      const double cs = std::cos(angle);
      const double sn = std::sin(angle);
      const double k = arc.sweep() / p.length;
      for (std::size_t i = 0; i < axes_; ++i) {
        const double along = arc.cosine(i) * cs + arc.sine(i) * sn;
        const double across = arc.sine(i) * cs - arc.cosine(i) * sn;
        out[i] = {arc.center(i) + arc.drift(i) * s + along, arc.drift(i) / p.length + k * across,
                  -k * k * along, -k * k * k * across};
      }
      return;
    }
    case PieceKind::blend:
    case PieceKind::curve:
      for (std::size_t i = 0; i < axes_; ++i)
        out[i] = profiles_detail::evaluate(plain_segment(data, p.kind, p.length, axes_, i), s);
      return;
  }
}

Point Path::point(std::size_t piece, double u) const {
  std::array<Jet, max_axes> jet{};
  jets(piece, u, std::span(jet).first(axes_));
  Point p{};
  for (std::size_t i = 0; i < axes_; ++i) p[i] = jet[i][0];
  return p;
}

void Path::segments(std::size_t piece, std::size_t axis, std::vector<Segment>& out) const {
  const PathPiece& p = pieces_[piece];
  const double* data = numbers(piece);
  if (p.kind == PieceKind::turn) {
    const TurnNumbers turn(data, axes_);
    turn_segments(turn.start(axis), turn.before(axis), turn.after(axis), p.length, turn.share(),
                  out);
  } else {
    out.push_back(plain_segment(data, p.kind, p.length, axes_, axis));
  }
}

Curve<OverLength> Path::curve(std::size_t axis) const {
  std::vector<Segment> segments_of_axis;
  segments_of_axis.reserve(pieces_.size());
  for (std::size_t i = 0; i < pieces_.size(); ++i) segments(i, axis, segments_of_axis);
  return Curve<OverLength>(std::move(segments_of_axis), 0, Extrapolation::hold);
}

}  // namespace jounce
