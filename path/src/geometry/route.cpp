// SPDX-License-Identifier: Apache-2.0
#include "path/src/geometry/route.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "jounce/profiles/detail/large_pages.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/geometry/pieces.hpp"
#include "path/src/geometry/vector.hpp"
#include "path/src/kept_memory.hpp"

namespace jounce {
namespace {

using profiles_detail::reserve_large;
using profiles_detail::rounded_sum;

constexpr double same_vector = 1e-20;  ///< share of the square of a vector that its change may have
constexpr double same_circle = 1e-20;  ///< share of the square of a radius that its change may have
/// Length in the path axes; if these do not move, in all axes.
double measured(const double* from, const double* to, std::size_t axes, std::size_t path_axes) {
  const auto norm = [&](std::size_t n) {
    double s = 0;
    for (std::size_t i = 0; i < n; ++i) s += (to[i] - from[i]) * (to[i] - from[i]);
    return std::sqrt(s);
  };
  const double length = norm(path_axes);
  return length > 0 || path_axes == axes ? length : norm(axes);
}

void append_arc(const Arc& arc, const Point& from, std::size_t axes, std::vector<double>& numbers) {
  // Both ends are exact; rounding of the formula goes into the center and the drift.
  const Point begin = point_at(arc, 0);
  const Point end = point_at(arc, arc.sweep);
  const auto append = [&](auto component) {
    for (std::size_t i = 0; i < axes; ++i) numbers.push_back(component(i));
  };
  append([&](std::size_t i) { return arc.center[i] + (from[i] - begin[i]); });
  append([&](std::size_t i) { return arc.radius * arc.e1[i]; });
  append([&](std::size_t i) { return arc.radius * arc.e2[i]; });
  append([&](std::size_t i) { return arc.drift[i] + (arc.to[i] - end[i]) - (from[i] - begin[i]); });
  numbers.push_back(0);
  numbers.push_back(arc.sweep);
}

/// True if a line continues the last piece in the same direction, and that is a line with the same
/// settings: both become one line.
bool continues(const std::vector<PathPiece>& pieces, const PathPiece& next,
               const std::vector<double>& numbers, std::size_t axes) {
  if (pieces.empty() || pieces.back().kind != PieceKind::line ||
      pieces.back().settings != next.settings)
    return false;
  const PathPiece& last = pieces.back();
  const double* before = numbers.data() + last.data + axes;
  const double* behind = numbers.data() + next.data + axes;
  const double by_length = 1 / last.length;
  const double by_next = 1 / next.length;
  double change = 0;
  double size = 0;
  for (std::size_t i = 0; i < axes; ++i) {
    const double u = before[i] * by_length;
    const double w = behind[i] * by_next;
    change += (w - u) * (w - u);
    size += u * u;
  }
  return change <= same_vector * size;
}

/// True if an arc continues the last piece, and that is an arc of the same circle or helix with the
/// same settings: both become one arc.
bool continues_arc(const std::vector<PathPiece>& pieces, const PathPiece& next,
                   const std::vector<double>& numbers, std::size_t axes) {
  if (pieces.empty() || pieces.back().kind != PieceKind::arc ||
      pieces.back().settings != next.settings)
    return false;
  const ArcNumbers before(numbers.data() + pieces.back().data, axes);
  const ArcNumbers behind(numbers.data() + next.data, axes);
  const double end = before.phase() + before.sweep();
  double change = 0;
  double size = 0;
  for (std::size_t i = 0; i < axes; ++i) {
    const double radial = before.cosine(i) * std::cos(end) + before.sine(i) * std::sin(end);
    const double ahead = before.sine(i) * std::cos(end) - before.cosine(i) * std::sin(end);
    change += profiles_detail::square(behind.cosine(i) - radial) +
              profiles_detail::square(behind.sine(i) - ahead) +
              profiles_detail::square(behind.drift(i) / behind.sweep() -
                                      before.drift(i) / before.sweep());
    size += radial * radial;
  }
  return change <= same_circle * size;
}

/// Moves the end of an arc by the sweep of the next one to `to`. Rounding goes into the drift.
void extend_arc(double* arc, double sweep, const double* to, std::size_t axes) {
  double& whole = arc[4 * axes + 1];
  whole += sweep;
  const ArcNumbers now(arc, axes);
  const double end = now.phase() + whole;
  for (std::size_t i = 0; i < axes; ++i)
    arc[3 * axes + i] =
        to[i] - (now.center(i) + now.cosine(i) * std::cos(end) + now.sine(i) * std::sin(end));
}

}  // namespace

void append_curve(std::span<const Segment> axes, std::vector<double>& numbers, int degree) {
  for (const Segment& f : axes) degree = std::max(degree, f.degree);
  numbers.push_back(degree);
  for (const Segment& f : axes)
    numbers.insert(numbers.end(), f.c.begin(), f.c.begin() + degree + 1);
}

Route route_of(const Program& program) {
  const std::size_t n = program.axes();
  std::vector<PathPiece> pieces =
      path_detail::with_kept_memory<PathPiece>(program.commands().size());
  std::vector<double> numbers =
      path_detail::with_kept_memory<double>(program.commands().size() * 2 * n);
  std::vector<Joint> joints = path_detail::with_kept_memory<Joint>(program.commands().size() + 1);
  joints.push_back({0, true});
  std::vector<std::int32_t> empty;
  Point at = program.start();
  double length = 0;
  bool buffered = false;
  for (const Program::Command& command : program.commands()) {
    if (command.kind == Program::Kind::dwell) {
      joints.back().dwell += program.numbers()[command.data];
      joints.back().rests = true;
      continue;
    }
    PathPiece piece{length,         0, next_index(numbers), command.line, command.settings,
                    PieceKind::line};
    if (command.kind == Program::Kind::curve) {
      const PathCurve& curve = program.curves()[command.data];
      piece.kind = PieceKind::curve;
      if (program.settings()[command.settings].junction == Junction::buffered)
        joints.back().rests = true;
      for (std::size_t k = 0; k < curve.segments.size(); k += n) {
        piece.start = length;
        piece.length = curve.segments[k].length;
        piece.data = next_index(numbers);
        append_curve(std::span(curve.segments).subspan(k, n), numbers);
        length += piece.length;
        pieces.push_back(piece);
        joints.push_back({0, false, k + n < curve.segments.size()});
      }
      at = curve.to;
      continue;
    }
    buffered = program.settings()[command.settings].junction == Junction::buffered;
    if (command.kind == Program::Kind::line) {
      const double* to = program.numbers().data() + command.data;
      piece.length = measured(at.data(), to, n, program.path_axes());
      if (!(piece.length > 0)) {
        empty.push_back(command.line);
        continue;
      }
      double* straight = append_blank(numbers, 2 * n);
      for (std::size_t i = 0; i < n; ++i) {
        straight[i] = at[i];
        straight[n + i] = to[i] - at[i];
        at[i] = to[i];
      }
      if (!buffered && !joints.back().rests && continues(pieces, piece, numbers, n)) {
        PathPiece& whole = pieces.back();
        numbers.resize(piece.data);
        for (std::size_t i = 0; i < n; ++i)
          numbers[whole.data + n + i] = to[i] - numbers[whole.data + i];
        whole.length = measured(numbers.data() + whole.data, to, n, program.path_axes());
        length = whole.start + whole.length;
        continue;
      }
    } else {
      const Arc& arc = program.arcs()[command.data];
      piece.kind = PieceKind::arc;
      piece.length = std::hypot(arc.radius * arc.sweep, vec::norm(arc.drift, program.path_axes()));
      append_arc(arc, at, n, numbers);
      at = arc.to;
      if (!buffered && !joints.back().rests && continues_arc(pieces, piece, numbers, n)) {
        PathPiece& whole = pieces.back();
        const double sweep = ArcNumbers(numbers.data() + piece.data, n).sweep();
        numbers.resize(piece.data);
        extend_arc(numbers.data() + whole.data, sweep, at.data(), n);
        whole.length += piece.length;
        length = whole.start + whole.length;
        continue;
      }
    }
    if (!std::isfinite(piece.length))
      throw InputError("to", piece.length, "is too far away").at({}, command.line);
    if (buffered) joints.back().rests = true;
    length += piece.length;
    PathPiece& placed = path_detail::append_blank(pieces);
    placed.start = piece.start;
    placed.length = piece.length;
    placed.data = piece.data;
    placed.line = piece.line;
    placed.settings = piece.settings;
    placed.kind = piece.kind;
    joints.push_back({});
  }
  if (pieces.empty())
    throw InputError("program", "", "covers no distance: add a line or an arc to another position")
        .at({}, program.commands().empty() ? 0 : program.commands().front().line);
  joints.back().rests = true;
  return {Path(n, std::move(pieces), std::move(numbers)), std::move(joints), std::move(empty)};
}

void append_part(const Path& from, std::size_t k, double u0, double u1,
                 std::vector<PathPiece>& pieces, std::vector<double>& numbers) {
  const PathPiece& whole = from.pieces()[k];
  if (!(u1 - u0 > rounded_sum * whole.length)) return;
  const std::size_t n = from.axes();
  const double* data = from.numbers(k);
  PathPiece piece = whole;
  piece.data = next_index(numbers);
  piece.length = u1 - u0;
  const double s0 = u0 / whole.length;
  const double s1 = u1 / whole.length;
  // The share of the step: a difference of two places within the whole would have fewer digits.
  const double share = piece.length / whole.length;
  if (whole.kind == PieceKind::line) {
    double* line = append_blank(numbers, 2 * n);
    for (std::size_t i = 0; i < n; ++i) {
      line[i] = data[i] + data[n + i] * s0;
      line[n + i] = data[n + i] * share;
    }
  } else if (whole.kind == PieceKind::curve) {
    const int degree = static_cast<int>(data[0]);
    const auto count = static_cast<std::size_t>(degree) + 1;
    numbers.push_back(degree);
    for (std::size_t i = 0; i < n; ++i) {
      Segment f;
      f.length = whole.length;
      f.degree = degree;
      std::copy_n(data + 1 + i * count, count, f.c.begin());
      if (u0 > 0 || u1 < whole.length) {
        f = part(f, s0, s1);
        double power = 1;
        for (std::size_t m = 0; m < count; ++m, power *= share / (s1 - s0)) f.c[m] *= power;
      }
      numbers.insert(numbers.end(), f.c.begin(), f.c.begin() + static_cast<std::ptrdiff_t>(count));
    }
  } else {
    const ArcNumbers arc(data, n);
    for (std::size_t i = 0; i < n; ++i) numbers.push_back(arc.center(i) + arc.drift(i) * s0);
    numbers.insert(numbers.end(), data + n, data + 3 * n);
    for (std::size_t i = 0; i < n; ++i) numbers.push_back(arc.drift(i) * share);
    numbers.push_back(arc.phase() + arc.sweep() * s0);
    numbers.push_back(arc.sweep() * share);
  }
  pieces.push_back(piece);
}

}  // namespace jounce
