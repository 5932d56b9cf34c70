// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "jounce/path/hold.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/flow/partial_law.hpp"
#include "path/src/geometry/pieces.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_root;

/// f(1 - s).
Segment mirrored(const Segment& f) {
  Segment g = f;
  const int n = f.degree;
  for (int i = 0; i < n; ++i)  // to powers of s - 1
    for (int k = n - 1; k >= i; --k)
      g.c[static_cast<std::size_t>(k)] += g.c[static_cast<std::size_t>(k) + 1];
  for (std::size_t k = 1; k <= static_cast<std::size_t>(n); k += 2) g.c[k] = -g.c[k];
  return g;
}

void append_polynomials(const double* data, std::size_t n, double length,
                        std::vector<double>& out) {
  const int degree = static_cast<int>(data[0]);
  const std::size_t count = static_cast<std::size_t>(degree) + 1;
  out.push_back(degree);
  for (std::size_t i = 0; i < n; ++i) {
    Segment f;
    f.length = length;
    f.degree = degree;
    std::copy_n(data + 1 + i * count, count, f.c.begin());
    f = mirrored(f);
    out.insert(out.end(), f.c.begin(), f.c.begin() + static_cast<std::ptrdiff_t>(count));
  }
}

/// Appends the numbers of a turn to `turns`; returns PathPiece::data.
std::uint32_t append_reversed_turn(const Path& path, std::size_t k, std::vector<double>& turns) {
  const std::size_t n = path.axes();
  const TurnNumbers turn(path.numbers(k), n);
  const Point end = path.point(k, path.pieces()[k].length);
  Point before;
  for (std::size_t i = 0; i < n; ++i) before[i] = -turn.after(i);
  const std::uint32_t data = append_direction(turns, before.data(), n);
  append(turns, end.data(), n);
  turns.push_back(turn.share());
  for (std::size_t i = 0; i < n; ++i) turns.push_back(-turn.before(i));
  return data;
}

/// Appends the numbers of any other piece.
void append_reversed(const Path& path, std::size_t k, std::vector<double>& out) {
  const std::size_t n = path.axes();
  const PathPiece& piece = path.pieces()[k];
  const double* data = path.numbers(k);
  const auto each = [&](auto component) {
    for (std::size_t i = 0; i < n; ++i) out.push_back(component(i));
  };
  switch (piece.kind) {
    case PieceKind::line:
      each([&](std::size_t i) { return data[i] + data[n + i]; });
      each([&](std::size_t i) { return -data[n + i]; });
      break;
    case PieceKind::arc: {
      const ArcNumbers arc(data, n);
      each([&](std::size_t i) { return arc.center(i) + arc.drift(i); });
      each([&](std::size_t i) { return arc.cosine(i); });
      each([&](std::size_t i) { return -arc.sine(i); });
      each([&](std::size_t i) { return -arc.drift(i); });
      out.push_back(-(arc.phase() + arc.sweep()));
      out.push_back(arc.sweep());
      break;
    }
    case PieceKind::turn:
      break;
    case PieceKind::blend:
    case PieceKind::curve: {
      append_polynomials(data, n, piece.length, out);
      const double* rest = data + polynomial_count(n, static_cast<int>(data[0]));
      if (piece.kind == PieceKind::blend) out.insert(out.end(), rest, rest + 2);
      break;
    }
  }
}

/// The same path from its end to its start.
Path reversed(const Path& path) {
  std::vector<PathPiece> pieces;
  std::vector<double> numbers;
  std::vector<double> turns;
  pieces.reserve(path.pieces().size());
  for (std::size_t k = path.pieces().size(); k-- > 0;) {
    PathPiece piece = path.pieces()[k];
    piece.start = path.length() - (piece.start + piece.length);
    if (pieces.empty()) piece.start = 0;
    if (piece.kind == PieceKind::turn) {
      piece.data = append_reversed_turn(path, k, turns);
    } else {
      piece.data = next_index(numbers);
      append_reversed(path, k, numbers);
    }
    pieces.push_back(piece);
  }
  return {path.axes(), std::move(pieces), std::move(numbers), std::move(turns)};
}

/// A unit of the reversed path: the law brakes where it accelerated before.
Unit turned_around(const Unit& unit, const Path& path) {
  Unit back = unit;
  if (!unit.box.constant)
    back.box.acceleration = back.box.deceleration =
        std::min(unit.box.acceleration, unit.box.deceleration);
  back.piece = static_cast<std::uint32_t>(path.pieces().size() - unit.piece - unit.pieces);
  back.dwell = 0;
  return back;
}

}  // namespace

Plan retreated(const Plan& plan, const Plan& held, double to) {
  const LawInterval last = held.law().stretches().back();
  const double from = last.start + last.length;
  if (!(to >= 0 && to < from))
    throw InputError("to", to, "must be from 0 to less than " + number(from) + ", the held place");
  const Plan base = by_stations(plan, 1);
  const PlannedUnits all = units_of(base);
  std::vector<Unit> units;  // from `to` to the held place
  for (std::size_t k = 0; k < all.units.size(); ++k) {
    const double length = std::min(all.starts[k + 1], from) - std::max(all.starts[k], to);
    if (!(length > rounded_root * (from - to))) continue;
    units.push_back(all.units[k]);
    units.back().length = length;
  }
  open_end_corners(units, base);
  std::vector<Unit> back;
  double entry = PathSettings::none;
  for (std::size_t k = units.size(); k-- > 0;) {
    back.push_back(turned_around(units[k], base.path()));
    back.back().entry = entry;
    entry = units[k].entry;
  }
  const Path path = reversed(base.path());
  Plan::Given given = plan.given();
  if (given.drawn) given.drawn = reversed(*given.drawn);
  PartialLaw law;
  const double start = path.length() - from;
  for (LawInterval s : stations(back)) {
    s.start += start;
    law.add(s);
  }
  return {path,
          TimingLaw(law.law),
          {plan.junctions().begin(), plan.junctions().end()},
          plan.stop_duration(),
          std::move(given)};
}

}  // namespace jounce
