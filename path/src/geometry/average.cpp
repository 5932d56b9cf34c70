// SPDX-License-Identifier: Apache-2.0
#include "path/src/geometry/average.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "path/src/corners/turn.hpp"
#include "path/src/geometry/pieces.hpp"
#include "path/src/geometry/vector.hpp"

// Two box averages of width l / 2 of a polyline over its own length. At the vertices q_k, the
// direction of the polyline steps by D_k:
//
//   (1)  r' = u_0 + sum over k of D_k T((q - q_k) / l + 1/2),   T' = 4 x, then 4 (1 - x)
//        (T of a turn with the share 1/2: turn.hpp)
//
// The polyline is continued beyond both ends by point reflection, so the average begins and ends at
// its ends. r is cubic between the places q_k - l/2, q_k, q_k + l/2, and r'' is continuous. |r'| <=
// 1, because it is a mean of directions. With P(q) on the polyline, |r(q) - P(q)| bounds the
// distance of either from the other. It is at most the greatest norm of the Bernstein coefficients
// of the difference on each piece.

namespace jounce {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_sum;

struct Vertex {
  double at = 0;
  Point point{};
  Point behind{};       ///< direction of the leg that begins here
  Point change{};       ///< D of (1)
  std::size_t leg = 0;  ///< piece of the route that begins here
};

/// A run of lines, with its ends reflected.
struct Run {
  std::vector<Vertex> vertices;  ///< ascending, with the legs between them
  double length = 0;
  std::size_t n = 0, path_axes = 0;
};

Run run_of(const Route& route, std::size_t first, std::size_t last, std::size_t path_axes) {
  Run run;
  run.n = route.path.axes();
  run.path_axes = path_axes;
  double at = 0;
  const auto pieces = route.path.pieces();
  for (std::size_t k = first; k < last; ++k) {
    Vertex v;
    v.at = at;
    v.leg = k;
    const double* data = route.path.numbers(k);
    for (std::size_t i = 0; i < run.n; ++i) {
      v.point[i] = data[i];
      v.behind[i] = data[run.n + i] / pieces[k].length;
    }
    at += pieces[k].length;
    run.vertices.push_back(v);
  }
  run.length = at;
  const std::size_t m = run.vertices.size();
  const Point end = route.path.point(last - 1, pieces[last - 1].length);
  // The reflection: vertices at -q_k before the start and at 2 S - q_k after the end, with the legs
  // reversed.
  std::vector<Vertex> all;
  const Point start = run.vertices.front().point;
  for (std::size_t k = m; k-- > 0;) {
    const bool is_last = k + 1 == m;
    Vertex v;
    v.at = -(is_last ? run.length : run.vertices[k + 1].at);
    v.point = vec::sum(vec::scaled(start, 2), is_last ? end : run.vertices[k + 1].point, -1);
    v.behind = run.vertices[k].behind;
    v.leg = first;
    all.push_back(v);
  }
  all.insert(all.end(), run.vertices.begin(), run.vertices.end());
  for (std::size_t k = m; k-- > 0;) {
    const bool is_last = k + 1 == m;
    Vertex v;
    v.at = 2 * run.length - (is_last ? run.length : run.vertices[k + 1].at);
    v.point = vec::sum(vec::scaled(end, 2), is_last ? end : run.vertices[k + 1].point, -1);
    v.behind = run.vertices[k].behind;
    v.leg = last - 1;
    all.push_back(v);
  }
  for (std::size_t k = 1; k < all.size(); ++k)
    all[k].change = vec::difference(all[k].behind, all[k - 1].behind);
  run.vertices = std::move(all);
  return run;
}

struct CubicPiece {
  double from = 0, to = 0;
  std::size_t leg = 0;
  std::array<Jet, max_axes> at_start{};  ///< r and its derivatives with respect to q
  Point polyline{}, direction{};
};

/// Calls `visit` for each cubic of the average with window `l`, ascending from 0 to the length of
/// the run.
template <class Visit>
void for_pieces(const Run& run, double l, Visit visit) {
  const auto& v = run.vertices;
  std::size_t enters = 0;  // the first vertex with at - l/2 > q
  std::size_t meets = 0;   // the first with at > q
  std::size_t leaves = 0;  // the first with at + l/2 > q
  double q = 0;
  const double least = rounded_sum * run.length;
  const auto pass = [&](std::size_t& i, double offset) {
    while (i < v.size() && v[i].at + offset <= q + least) ++i;
  };
  CubicPiece piece;
  while (q < run.length) {
    pass(enters, -l / 2);
    pass(meets, 0);
    pass(leaves, l / 2);
    double next = run.length;
    if (enters < v.size()) next = std::min(next, v[enters].at - l / 2);
    if (meets < v.size()) next = std::min(next, v[meets].at);
    if (leaves < v.size()) next = std::min(next, v[leaves].at + l / 2);
    if (run.length - next <= least) next = run.length;
    piece.from = q;
    piece.to = next;
    const std::size_t base = leaves - 1;  // the leg before the first vertex within the window
    const Vertex& here = v[meets - 1];
    piece.leg = here.leg;
    for (std::size_t i = 0; i < run.n; ++i) {
      piece.at_start[i] = {v[base].point[i] + v[base].behind[i] * (q - v[base].at),
                           v[base].behind[i], 0, 0};
      piece.polyline[i] = here.point[i] + here.behind[i] * (q - here.at);
      piece.direction[i] = here.behind[i];
    }
    for (std::size_t k = leaves; k < enters; ++k) {
      const Jet rise = turn_rise(0.5, std::clamp((q - v[k].at) / l + 0.5, 0.0, 1.0));
      const bool second = k < meets;  // true also if x is 1/2 except for rounding
      const Jet weight{l * rise[0], rise[1], rise[2] / l, (second ? -4 : 4) / (l * l)};
      for (std::size_t i = 0; i < run.n; ++i)
        for (std::size_t m = 0; m < weight.size(); ++m)
          piece.at_start[i][m] += v[k].change[i] * weight[m];
    }
    visit(piece);
    q = next;
  }
}

/// Bound of the distance of a cubic piece from its polyline.
double distance_of(const CubicPiece& piece, std::size_t n) {
  const double h = piece.to - piece.from;
  double norm[4] = {};
  for (std::size_t i = 0; i < n; ++i) {
    const Jet& r = piece.at_start[i];
    const double c0 = r[0] - piece.polyline[i];
    const double c1 = (r[1] - piece.direction[i]) * h;
    const double c2 = r[2] * h * h / 2;
    const double c3 = r[3] * h * h * h / 6;
    const double b[4] = {c0, c0 + c1 / 3, c0 + 2 * c1 / 3 + c2 / 3, c0 + c1 + c2 + c3};
    for (int k = 0; k < 4; ++k) norm[k] += b[k] * b[k];
  }
  return std::sqrt(*std::max_element(norm, norm + 4));
}

double distance_of(const Run& run, double l) {
  double most = 0;
  for_pieces(run, l, [&](const CubicPiece& piece) {
    most = std::max(most, distance_of(piece, run.path_axes));
  });
  return most;
}

/// A window whose average is at most `deviation` from the polyline, and close to it. The bound
/// grows with a power of l between 1 and 2.
double window_of(const Run& run, double deviation) {
  double largest = 0;
  for (std::size_t k = 1; k < run.vertices.size(); ++k)
    largest = std::max(
        largest, vec::distance(run.vertices[k].behind, run.vertices[k - 1].behind, run.path_axes));
  // A corner alone leaves the polyline by largest l / 12: a little less, so that rounding does not decide.
  double l = std::min(run.length,
                      largest > 0 ? 12 * deviation * (1 - rounded_input) / largest : run.length);
  double best = 0;
  double low = 0;
  double high = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 16; ++i) {
    const double bound = distance_of(run, l);
    if (bound <= deviation) {
      low = best = std::max(best, l);
      if (bound >= 0.97 * deviation || l >= run.length) break;
    } else {
      high = l;
    }
    const double guess = l * std::pow(0.985 * deviation / bound, bound <= deviation ? 0.6 : 0.75);
    l = std::min(guess > low && guess < high ? guess : (low + std::min(high, 2 * low + l)) / 2,
                 run.length);
  }
  return best;
}

/// True if the joint before piece k is within a run.
bool averages(const Route& route, const Program& program, std::size_t k) {
  const auto pieces = route.path.pieces();
  if (pieces[k].kind != PieceKind::line || pieces[k - 1].kind != PieceKind::line ||
      route.joints[k].rests)
    return false;
  if (program.settings()[pieces[k].settings].corner != Corner::average) return false;
  const std::size_t n = route.path.axes();
  double change = 0;
  for (std::size_t i = 0; i < program.path_axes(); ++i)
    change += profiles_detail::square(route.path.numbers(k)[n + i] / pieces[k].length -
                                      route.path.numbers(k - 1)[n + i] / pieces[k - 1].length);
  return change <= sharpest * sharpest;
}

}  // namespace

std::optional<Route> with_averages(const Route& route, const Program& program) {
  const auto pieces = route.path.pieces();
  bool any = false;
  for (const PathSettings& s : program.settings()) any = any || s.corner == Corner::average;
  if (!any) return {};
  std::vector<PathPiece> out;
  std::vector<double> numbers;
  std::vector<Joint> joints;
  const std::size_t n = route.path.axes();
  double start = 0;
  const auto add = [&](PathPiece piece, double length) {
    piece.start = start;
    piece.length = length;
    start += length;
    out.push_back(piece);
  };
  for (std::size_t k = 0; k < pieces.size();) {
    std::size_t last = k + 1;
    double deviation = std::numeric_limits<double>::infinity();
    while (last < pieces.size() && averages(route, program, last)) {
      deviation = std::min(deviation, program.settings()[pieces[last].settings].value);
      ++last;
    }
    joints.push_back(route.joints[k]);
    double window = 0;
    if (last - k > 1) {
      const Run run = run_of(route, k, last, program.path_axes());
      window = window_of(run, deviation);
      if (window > 0) {
        for_pieces(run, window, [&](const CubicPiece& cubic) {
          if (cubic.from > 0) joints.push_back({0, false, true});
          PathPiece piece = pieces[cubic.leg];
          piece.kind = PieceKind::curve;
          piece.data = next_index(numbers);
          const double h = cubic.to - cubic.from;
          numbers.push_back(3);
          for (std::size_t i = 0; i < n; ++i) {
            const Jet& r = cubic.at_start[i];
            numbers.insert(numbers.end(), {r[0], r[1] * h, r[2] * h * h / 2, r[3] * h * h * h / 6});
          }
          add(piece, h);
        });
        k = last;
        continue;
      }
    }
    PathPiece piece = pieces[k];
    piece.data = next_index(numbers);
    const double* data = route.path.numbers(k);
    const std::size_t count = piece.kind == PieceKind::line ? 2 * n
                              : piece.kind == PieceKind::arc
                                  ? ArcNumbers::count(n)
                                  : polynomial_count(n, static_cast<int>(data[0]));
    numbers.insert(numbers.end(), data, data + count);
    add(piece, piece.length);
    ++k;
  }
  joints.push_back(route.joints.back());
  return Route{Path(n, std::move(out), std::move(numbers)), std::move(joints), route.empty_lines};
}

}  // namespace jounce
