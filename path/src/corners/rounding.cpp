// SPDX-License-Identifier: Apache-2.0
#include "path/src/corners/rounding.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/large_pages.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/corners/blend.hpp"
#include "path/src/corners/route_view.hpp"
#include "path/src/geometry/pieces.hpp"
#include "path/src/kept_memory.hpp"
#include "path/src/tolerances.hpp"

namespace jounce {
namespace {

using profiles_detail::reserve_large;

using path_detail::unlimited;

using How = CornerShape::How;

/// Makes the units of a route with the given shapes of its junctions.
class Rounding {
 public:
  /// `stopping`: the motion rests at each corner, so no corner is rounded.
  Rounding(RouteView view, std::span<const CornerShape> shapes, bool stopping)
      : view_(std::move(view)), shapes_(shapes), n_(view_.axes()), stopping_(stopping) {}

  Rounded run() {
    const bool sharp = std::ranges::none_of(shapes_, &CornerShape::is_round);
    reserve(sharp);
    const auto add = [&](const Unit& unit) { append_unit(unit); };
    if (sharp)
      assemble_sharp(add);
    else
      assemble(add);
    for (const std::int32_t line : view_.route.empty_lines)
      junctions_.push_back({0, line, JunctionNote::no_distance, false});
    Rounded result{{}, std::move(units_), std::move(junctions_)};
    if (!sharp) result.path.emplace(n_, std::move(pieces_), std::move(numbers_), std::move(turns_));
    return result;
  }

  template <class Add>
  void assemble_sharp(Add add) {
    for (std::size_t k = 0; k < view_.count(); ++k, ++placed_) {
      view_.rates.require_wanted();
      if (k > 0 && !stopping_) mark(k);
      add_units(k, view_.piece(k).length, add);
    }
  }

 private:
  [[nodiscard]] How how(std::size_t k) const {
    const How shape = shapes_[k].how;
    return stopping_ && shape != How::through ? How::rest : shape;
  }

  /// The greatest velocity at a junction.
  [[nodiscard]] double end_velocity(std::size_t k) const {
    return how(k) == How::rest ? 0 : shapes_[k].velocity;
  }

  /// True for a joint of lines that is passed although their directions differ by rounding. The
  /// velocities of the axes step there by up to 1e-9, which a table turns into jerk.
  [[nodiscard]] bool steps_at(std::size_t k) const {
    if (k == 0 || k >= view_.count() || how(k) != How::through) return false;
    if (!view_.are_lines(k)) return false;
    double square = 0;
    for (std::size_t i = 0; i < n_; ++i)
      square += profiles_detail::square(view_.direction(k)[i] - view_.direction(k - 1)[i]);
    return square > path_detail::same_direction;
  }

  void require_ramps(const Box& b, std::size_t k) const {
    if (!(b.acceleration < unlimited) || !(b.acceleration > 0))
      throw InputError(
          "acceleration", "",
          "is missing: add acceleration to the limits of each axis that moves, or to [path.limits]")
          .at({}, view_.piece(k).line);
  }

  /// Reserves the memory of the result.
  void reserve(bool sharp) {
    const std::size_t count = view_.count();
    std::size_t corners = 0;
    std::size_t marks = view_.route.empty_lines.size();
    std::size_t numbers = 0;
    std::size_t turns = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const CornerShape& s = shapes_[k];
      if (k > 0 && is_marked(s)) ++marks;
      if (view_.piece(k).kind == PieceKind::line) numbers += 2 * n_;
      if (s.how == How::turn)
        turns += TurnNumbers::count(n_) - (k > 0 && shapes_[k - 1].how == How::turn ? n_ : 0);
      if (s.is_round()) ++corners;
    }
    reserve_large(junctions_, marks);
    units_ = path_detail::with_kept_memory<Unit>(count + corners);
    if (sharp) return;
    reserve_large(pieces_, count + corners);
    reserve_large(numbers_, numbers);
    reserve_large(turns_, turns);
  }

  static bool is_marked(const CornerShape& s) {
    return s.how != How::through || s.note != JunctionNote::none;
  }
  void mark(std::size_t k) {
    const CornerShape& s = shapes_[k];
    if (is_marked(s))
      junctions_.push_back({placed_, view_.piece(k).line, s.note, s.how == How::rest});
  }

  /// Appends the pieces of the result, and calls `add` for each unit.
  template <class Add>
  void assemble(Add add) {
    for (std::size_t k = 0; k < view_.count(); ++k) {
      view_.rates.require_wanted();
      const CornerShape& here = shapes_[k];
      if (k > 0) mark(k);
      if (here.is_round()) {
        (here.how == How::turn) ? append_turn(k, here) : append_blend(k, here);
        Unit unit{place_last(), {}, unlimited, 0, placed_, 1, static_cast<std::uint32_t>(k)};
        unit.box.constant = true;
        unit.box.velocity = here.velocity;
        add(unit);
        ++placed_;
      }
      const std::size_t before = pieces_.size();
      append_part(view_.route.path, k, here.trim, view_.piece(k).length - shapes_[k + 1].trim,
                  pieces_, numbers_);
      if (pieces_.size() == before) continue;
      add_units(k, place_last(), add);
      ++placed_;
    }
  }

  /// Calls `add` for the units of piece k, of which the law covers `length`.
  template <class Add>
  void add_units(std::size_t k, double length, Add add) {
    const bool rests = how(k) == How::rest;
    Unit unit{length, {}, unlimited, 0, placed_, 1, static_cast<std::uint32_t>(k)};
    if (rests) {
      unit.entry = 0;
      unit.dwell = view_.route.joints[k].dwell;
    } else if (how(k) == How::through && k > 0) {
      unit.entry = view_.cap(k);
    }
    if (view_.piece(k).kind == PieceKind::arc) {
      const ArcZones zones =
          arc_zones(view_.curved, view_.settings(k), view_.route.path.numbers(k),
                    view_.piece(k).length, length, end_velocity(k), end_velocity(k + 1));
      for (std::size_t i = 0; i < zones.count; ++i) {
        unit.length = zones.zone[i].length;
        unit.box = zones.zone[i].box;
        require_ramps(unit.box, k);
        add(unit);
        unit.entry = unlimited;
        unit.dwell = 0;
      }
      return;
    }
    unit.box = view_.box(k, end_velocity(k), end_velocity(k + 1));
    require_ramps(unit.box, k);
    if (steps_at(k) || steps_at(k + 1))
      for (double* limit : {&unit.box.acceleration, &unit.box.deceleration, &unit.box.jerk})
        *limit *= 1 - fit_share / 10;
    add(unit);
  }

  /// Appends a unit, member by member: see append_blank().
  void append_unit(const Unit& unit) {
    Unit& to = path_detail::append_blank(units_);
    to.length = unit.length;
    to.box.velocity = unit.box.velocity;
    to.box.acceleration = unit.box.acceleration;
    to.box.deceleration = unit.box.deceleration;
    to.box.jerk = unit.box.jerk;
    to.box.constant = unit.box.constant;
    to.entry = unit.entry;
    to.dwell = unit.dwell;
    to.piece = unit.piece;
    to.pieces = unit.pieces;
    to.joint = unit.joint;
  }

  /// Places the last appended piece after the previous one; returns its length.
  double place_last() {
    PathPiece& last = pieces_.back();
    last.start = end_;
    end_ += last.length;
    return last.length;
  }

  PathPiece& append_corner(std::size_t k, const CornerShape& s, PieceKind kind) {
    const PathPiece& next = view_.piece(k);
    PathPiece& corner = path_detail::append_blank(pieces_);
    corner.length = 2 * s.trim;
    corner.data = next_index(numbers_);
    corner.line = next.line;
    corner.settings = next.settings;
    corner.kind = kind;
    corner.settings_before = view_.piece(k - 1).settings & (PathPiece::most_settings - 1);
    return corner;
  }

  void append_turn(std::size_t k, const CornerShape& s) {
    PathPiece& corner = append_corner(k, s, PieceKind::turn);
    corner.data = append_direction(turns_, view_.direction(k - 1).data(), n_);
    const double* before = view_.route.path.numbers(k - 1);
    const double share = (view_.piece(k - 1).length - s.trim) / view_.piece(k - 1).length;
    double* out = append_blank(turns_, 2 * n_ + 1);
    for (std::size_t i = 0; i < n_; ++i) *out++ = before[i] + before[n_ + i] * share;
    *out++ = s.share;
    std::copy_n(view_.direction(k).data(), n_, out);
  }

  void append_blend(std::size_t k, const CornerShape& s) {
    append_corner(k, s, PieceKind::blend);
    const Blend blend = blend_of(view_.route.path, k - 1, s.trim);
    const std::size_t path_axes = view_.rates.path_axes;
    // Between two lines, the last coefficient is zero or rounding. The degree decides how tight Bernstein bounds are.
    append_curve(blend.segments(), numbers_, 5);
    numbers_.push_back(least_distance(blend.segments(), view_.corner(k), path_axes));
    numbers_.push_back(distance_from_sides(view_.route.path, k - 1, blend, path_axes));
  }

  const RouteView view_;
  const std::span<const CornerShape> shapes_;
  const std::size_t n_;
  const bool stopping_;
  std::vector<PathPiece> pieces_;  // parts of the result
  std::vector<double> numbers_, turns_;
  std::vector<Unit> units_;
  std::uint32_t placed_ = 0;  // number of placed pieces
  double end_ = 0;            // end of the last piece
  std::vector<JunctionMark> junctions_;
};

}  // namespace

Lines lines_of(const Route& route, const Program& program, const Rates& rates) {
  const std::size_t n = rates.axes;
  const auto pieces = route.path.pieces();
  Lines lines;
  lines.directions = path_detail::with_kept_memory<double>(n * pieces.size());
  lines.boxes = path_detail::with_kept_memory<Box>(pieces.size());
  Point direction{};
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const bool is_line = pieces[k].kind == PieceKind::line;
    const double* step = route.path.numbers(k) + n;
    const double by_length = is_line ? 1 / pieces[k].length : 0;
    for (std::size_t i = 0; i < n; ++i) direction[i] = is_line ? step[i] * by_length : 0;
    append(lines.directions, direction.data(), n);
    lines.boxes.push_back(
        is_line ? line_box(rates, program.settings()[pieces[k].settings], direction.data())
                : Box{});
  }
  return lines;
}

Rounded rounded(const Route& route, const Lines& lines, const Program& program, const Rates& rates,
                std::span<const CornerShape> shapes) {
  return Rounding({route, lines, program, rates}, shapes, false).run();
}

void send_stopping_units(const Route& route, const Lines& lines, const Program& program,
                         const Rates& rates, std::span<const CornerShape> shapes, UnitSink& to) {
  Rounding({route, lines, program, rates}, shapes, true).assemble_sharp([&](const Unit& unit) {
    to.add(unit);
  });
}

}  // namespace jounce
