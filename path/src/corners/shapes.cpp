// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "jounce/profiles/curve/query.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "path/src/corners/blend.hpp"
#include "path/src/corners/route_view.hpp"
#include "path/src/corners/turn.hpp"
#include "path/src/geometry/pieces.hpp"
#include "path/src/geometry/vector.hpp"
#include "path/src/kept_memory.hpp"
#include "path/src/timing/stretch.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_sum;
using profiles_detail::square;
using profiles_detail::two_roundings;

using path_detail::unlimited;

using How = CornerShape::How;

constexpr double least_cosine = 1e-8;           ///< a corner with a smaller one turns back
constexpr double blend_resolution = 1e-12;      ///< relative, of a bisection
constexpr double deviation_resolution = 1e-13;  ///< relative
constexpr double tangent =
    1e-9;  ///< a change of direction below this is none: a step of the velocity, relative
constexpr int most_halvings = 20;  ///< greatest number of times that the trim of a blend is halved
constexpr double most_of_side = 0.99;  ///< share of a side up to a rest that a corner may take
constexpr double widest_trim = 1.0;    ///< rad of an arc that a blend may replace
constexpr double least_share =
    0.25;  ///< share of the least trim of a blend that is more than rounding

/// Both sides of a joint.
struct Sides {
  Point before{}, behind{};            ///< directions
  Point bend_before{}, bend_behind{};  ///< curvatures
};

/// Two directions that meet: the squares of w - u and of w + u. Only the path axes count, unless
/// only followers change their direction.
struct Bend {
  double change = 0, both = 0;
  bool is_tangent = false;

  Bend(std::span<const double> u, std::span<const double> w, std::size_t path_axes) {
    double length = 0;
    const auto add = [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) {
        change += square(w[i] - u[i]);
        both += square(w[i] + u[i]);
        length += square(w[i]);
      }
    };
    add(0, path_axes);
    const Bend in_path = *this;
    add(path_axes, u.size());
    if (in_path.change > square(tangent)) {
      change = in_path.change;
      both = in_path.both;
    }
    is_tangent = !(change > square(tangent) * length);
  }
  [[nodiscard]] double size() const { return std::sqrt(change); }  ///< |w - u|
  /// Cosine of half the angle: |w + u| / 2.
  [[nodiscard]] double cosine() const { return std::sqrt(both) / 2; }
  [[nodiscard]] bool turns_back() const { return !(both > square(2 * least_cosine)); }
};

class Shapes {
 public:
  Shapes(RouteView view, const std::vector<bool>& stop, JunctionNote note_of_stop)
      : view_(std::move(view)), stop_(stop), note_of_stop_(note_of_stop) {}

  std::vector<CornerShape> run() {
    const std::size_t count = view_.count();
    shapes_ = path_detail::with_kept_memory<CornerShape>(count + 1);
    shapes_.resize(count + 1);
    shapes_[0].how = shapes_[count].how = How::rest;
    for (std::size_t k = 1; k < count; ++k) {
      view_.rates.require_wanted();
      shapes_[k] = shape(k, std::min(whole(k - 1), whole(k)));
      shapes_[k].wanted = shapes_[k].trim;
    }
    for (std::size_t k = 1; k < count; ++k) {
      view_.rates.require_wanted();
      share(k);
    }
    for (std::size_t k = 1; k < count; ++k) rest_if_faster(k);
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t k = 1; k < count; ++k)
        if (leave_rest(k, k - 1, k - 1) || leave_rest(k, k + 1, k)) changed = true;
    }
    return std::move(shapes_);
  }

 private:
  /// Length of a piece that is available for corners.
  [[nodiscard]] double whole(std::size_t k) const {
    const PathPiece& p = view_.piece(k);
    if (p.kind != PieceKind::arc) return p.length;
    const double sweep = ArcNumbers(view_.route.path.numbers(k), view_.axes()).sweep();
    return p.length * std::min(1.0, 2 * widest_trim / sweep);
  }

  [[nodiscard]] Sides sides(std::size_t k) const {
    Sides s;
    std::array<Jet, max_axes> jet{};
    view_.route.path.jets(k - 1, view_.piece(k - 1).length, std::span(jet).first(view_.axes()));
    for (std::size_t i = 0; i < view_.axes(); ++i) {
      s.before[i] = jet[i][1];
      s.bend_before[i] = jet[i][2];
    }
    view_.route.path.jets(k, 0, std::span(jet).first(view_.axes()));
    for (std::size_t i = 0; i < view_.axes(); ++i) {
      s.behind[i] = jet[i][1];
      s.bend_behind[i] = jet[i][2];
    }
    return s;
  }

  /// The shape that the settings require, with at most `room` on each side.
  [[nodiscard]] CornerShape shape(std::size_t k, double room) const {
    CornerShape s;
    if (view_.route.joints[k].rests) {
      s.how = How::rest;
      return s;
    }
    if (view_.route.joints[k].smooth) return s;
    if (view_.are_lines(k)) {
      const Bend bend(view_.direction(k - 1), view_.direction(k), view_.rates.path_axes);
      if (bend.is_tangent) return s;
      if (rests_at(k, bend, s)) return s;
      return turned(k, bend, room);
    }
    const Sides both = sides(k);
    const Bend bend(std::span(both.before).first(view_.axes()),
                    std::span(both.behind).first(view_.axes()), view_.rates.path_axes);
    if (bend.is_tangent) return smooth(k, both, room);
    return rests_at(k, bend, s) ? s : blended(k, room);
  }

  /// True if the plan rests at the corner in any case; then sets `s` to the rest.
  [[nodiscard]] bool rests_at(std::size_t k, const Bend& bend, CornerShape& s) const {
    const bool asked = view_.settings(k).corner == Corner::stop;
    if (!asked && !stop_[k] && !bend.turns_back()) return false;
    s.how = How::rest;
    if (!asked) s.note = bend.turns_back() ? JunctionNote::turns_back : note_of_stop_;
    return true;
  }

  /// The shape of a tangential joint: no corner, unless the curvature steps and the settings
  /// require a corner.
  [[nodiscard]] CornerShape smooth(std::size_t k, const Sides& both, double room) const {
    const double step = vec::distance(both.bend_before, both.bend_behind, view_.axes());
    const double larger = std::max(vec::norm(both.bend_before, view_.axes()),
                                   vec::norm(both.bend_behind, view_.axes()));
    // Rounding: a shorter trim changes no direction.
    const double shorter = std::min(view_.piece(k - 1).length, view_.piece(k).length);
    if (step <= std::max(tangent * larger, rounded_sum / shorter)) return {};
    CornerShape s;
    // Without a jerk limit, the acceleration may step, and a blend takes only time.
    if (view_.settings(k).corner == Corner::stop || !has_jerk_limit()) {
      s.note = JunctionNote::steps;
    } else if (stop_[k]) {
      s.how = How::rest;
      s.note = note_of_stop_;
    } else {
      s = blended(k, room, true);
    }
    return s;
  }

  [[nodiscard]] bool has_jerk_limit() const {
    const auto jerks = std::span(view_.rates.jerk).first(view_.axes());
    return std::ranges::any_of(jerks, [](double jerk) { return jerk < unlimited; });
  }

  [[nodiscard]] CornerShape turned(std::size_t k, const Bend& corner, double room) const {
    const double bend = corner.size();
    TurnRates rates{
        std::min(view_.rates.path.normal_acceleration, view_.rates.path.total_acceleration) / bend,
        TurnRates::none};
    double fastest = view_.cap(k);
    const auto before = view_.direction(k - 1);
    const auto behind = view_.direction(k);
    for (std::size_t i = 0; i < view_.axes(); ++i) {
      const double d = std::abs(behind[i] - before[i]);
      const double u = std::max(std::abs(before[i]), std::abs(behind[i]));
      if (u > 0) fastest = std::min(fastest, view_.rates.velocity[i] / u);
      if (!(d > 0)) continue;
      rates.acceleration = std::min(rates.acceleration, view_.rates.acceleration[i] / d);
      rates.jerk = std::min(rates.jerk, view_.rates.jerk[i] / d);
    }
    const PathSettings& asked = view_.settings(k);
    const bool bounded = rates.acceleration < unlimited || rates.jerk < unlimited;
    Turn turn;
    bool fits = true;
    if (asked.corner == Corner::curvature) {
      turn = curved_turn(rates, bend / square(corner.cosine()), asked.value);
      fits = turn.length <= 2 * room;
      if (!fits) turn = fastest_turn(rates, unlimited, 2 * room);
    } else if (asked.corner == Corner::velocity) {
      fastest = std::min(fastest, asked.value);
      turn = bounded ? least_turn(rates, fastest) : fastest_turn(rates, unlimited, 2 * room);
      fits = turn.length <= 2 * room;
      if (!fits) turn = fastest_turn(rates, unlimited, 2 * room);
    } else {
      const bool distance = asked.corner == Corner::distance;
      const double length = distance ? std::min(2 * asked.value, 2 * room) : 2 * room;
      turn = fastest_turn(rates, distance ? unlimited : asked.value / bend, length);
      fits = turn.length < 2 * room || (distance && asked.value <= room);
      // A corner is no larger than its velocity needs.
      if (bounded && turn.velocity > fastest) {
        const Turn least = least_turn(rates, fastest);
        if (least.length <= turn.length) turn = least;
      }
    }
    CornerShape s;
    s.how = How::turn;
    s.trim = turn.length / 2;
    s.share = turn.share;
    s.velocity = std::min(turn.velocity, fastest);
    if (!fits && (asked.corner == Corner::curvature || turn.velocity < fastest))
      s.note = JunctionNote::short_sides;
    return s;
  }

  /// A blend whose trim is found by bracketing.
  [[nodiscard]] CornerShape blended(std::size_t k, double room, bool is_tangent = false) const {
    const PathSettings& asked = view_.settings(k);
    double trim = room;
    bool fits = true;
    // The least trim for which holds(trim) is true and that is more than rounding, or `most`. Two corners that share a
    // side get at least half of what they want: that must be more than rounding, too.
    const auto least = [&](double most, auto holds) {
      const auto enough = [&](double d) { return !is_rounding(k, least_share * d) && holds(d); };
      if (!(fits = enough(most))) return most;
      double low = 0;
      double high = most;
      for (int i = 0; i < 60 && high - low > blend_resolution * most; ++i) {
        const double middle = (low + high) / 2;
        (enough(middle) ? high : low) = middle;
      }
      return high;
    };
    switch (asked.corner) {
      case Corner::distance:
        trim = std::min(asked.value, room);
        fits = asked.value <= room;
        break;
      case Corner::curvature:
        // Where both pieces have one direction, no trim is the least.
        if (is_tangent) {
          trim = fastest_within(k, room, asked.value);
          fits = is_within(k, trim, asked.value);
        } else {
          trim = least(room, [&](double d) { return is_within(k, d, asked.value); });
        }
        break;
      case Corner::velocity:
        trim = least(room, [&](double d) {
          return blend_velocity(k, blend_of(view_.route.path, k - 1, d)) >= asked.value;
        });
        break;
      default:
        trim = trim_for(k, asked.value, room);
        fits = trim < room;
    }
    const bool is_least = asked.corner == Corner::curvature || asked.corner == Corner::velocity;
    const double most = is_least ? room : trim;
    if (!is_least) {
      trim = fastest_trim(k, most);
      if (trim < most) fits = true;
    }
    while (is_rounding(k, trim) && 2 * trim <= most) trim *= 2;
    CornerShape s;
    if (is_rounding(k, trim)) {
      s.how = How::rest;
      s.note = JunctionNote::slower;
      return s;
    }
    s.how = How::blend;
    s.trim = trim;
    s.velocity = blend_velocity(k, blend_of(view_.route.path, k - 1, trim));
    if (asked.corner == Corner::velocity) s.velocity = std::min(s.velocity, asked.value);
    if (!fits) s.note = JunctionNote::short_sides;
    return s;
  }

  /// True if the sides of a blend turn so little that rounding changes its third derivative by more
  /// than half of the reserve of its limits.
  [[nodiscard]] bool is_rounding(std::size_t k, double trim) const {
    const Blend blend = blend_of(view_.route.path, k - 1, trim);
    double change = 0;
    double size = 0;
    for (const Segment& f : blend.segments()) {
      change += square(f.c[3]);
      size = std::max(size, std::abs(f.c[1]));
    }
    // The coefficient of the cube is computed from differences of steps, times 10.
    return 10 * two_roundings * size > fit_share / 2 * std::sqrt(change);
  }

  [[nodiscard]] bool is_within(std::size_t k, double trim, double curvature) const {
    const Blend blend = blend_of(view_.route.path, k - 1, trim);
    return greatest_curvature(blend.segments(), view_.rates.path_axes) <= curvature;
  }

  /// The trim up to `most` whose blend takes the least time, or a half, a quarter ... of it that is
  /// within a curvature, if there is one.
  [[nodiscard]] double fastest_within(std::size_t k, double most, double curvature) const {
    const double fastest = fastest_trim(k, most);
    double trim = fastest;
    for (int i = 0; i < most_halvings; ++i, trim /= 2)
      if (is_within(k, trim, curvature)) return trim;
    return fastest;
  }

  /// The trim, at most `most`, whose blend takes the least time. The time on the blend and on the
  /// ramps to its velocity is compared with both sides at full velocity. A larger blend is passed
  /// faster, until its speed |r'| differs noticeably from 1.
  [[nodiscard]] double fastest_trim(std::size_t k, double most) const {
    const Box before = box(k - 1);
    const Box behind = box(k);
    const auto lost = [](double v, const Box& b, double a) {
      if (!(v < b.velocity) || !(b.velocity < unlimited)) return 0.0;
      return ramp_time(b.velocity - v, a, b.jerk) -
             ramp_distance(v, b.velocity, a, b.jerk) / b.velocity;
    };
    const auto time = [&](double d) {
      const double v = blend_velocity(k, blend_of(view_.route.path, k - 1, d));
      return d * (2 / v - 1 / before.velocity - 1 / behind.velocity) +
             lost(v, before, before.deceleration) + lost(v, behind, behind.acceleration);
    };
    double best = most;
    double least = time(most);
    const double rounding =
        rounded_input * most / blend_velocity(k, blend_of(view_.route.path, k - 1, most));
    const auto consider = [&](double d) {
      if (d > most) return;
      const double t = time(d);
      if (!(t < least - rounding)) return;
      best = d;
      least = t;
    };
    for (double d = most / 2; d > 1e-4 * most; d /= 2) consider(d);
    for (const double step : {1.3, 1.12, 1.04, 1.01})
      for (int round = 0; round < 2; ++round)
        for (const double d : {best * step, best / step}) consider(d);
    return best;
  }

  /// The largest trim for which the blend is at most `deviation` from the corner and from both
  /// sides. In all tests the distance grew with the trim. The result keeps the deviation in any
  /// case, because it is the lower end of a bracket.
  [[nodiscard]] double trim_for(std::size_t k, double deviation, double room) const {
    const Point at = view_.corner(k);
    const auto over = [&](double d) {
      const Blend blend = blend_of(view_.route.path, k - 1, d);
      return std::max(least_distance(blend.segments(), at, view_.rates.path_axes),
                      distance_from_sides(view_.route.path, k - 1, blend, view_.rates.path_axes)) -
             deviation;
    };
    double high = room;
    double f_high = over(high);
    if (f_high <= 0) return room;
    double low = 0;
    double f_low = -deviation;
    for (int i = 0; i < 100 && high - low > deviation_resolution * high;
         ++i) {  // regula falsi, Illinois
      double middle = low + (high - low) * f_low / (f_low - f_high);
      if (!(middle > low && middle < high)) middle = (low + high) / 2;
      const double f = over(middle);
      if (f <= 0) {
        low = middle;
        f_low = f;
        f_high /= 2;
        if (f > -deviation_resolution * deviation) break;
      } else {
        high = middle;
        f_high = f;
        f_low /= 2;
      }
    }
    return low > 0 ? low : high / 2;
  }

  [[nodiscard]] double blend_velocity(std::size_t k, const Blend& blend) const {
    const double speed = greatest_speed(blend.segments(), view_.rates.path_axes);
    const double feed = speed > 0 ? view_.cap(k) / std::max(speed, 1.0) : unlimited;
    return std::min(blend_box(view_.curved, blend.segments()).velocity, feed);
  }

  /// The corners at both ends of a piece share its length, in proportion to their requests. If the
  /// plan rests at the other end, a corner gets at most half, because the law needs a distance to
  /// leave the rest.
  [[nodiscard]] double allowed(std::size_t k, std::size_t other, std::size_t side) const {
    const double length =
        view_.piece(side).kind == PieceKind::arc ? whole(side) : view_.piece(side).length;
    const CornerShape& there = shapes_[other];
    if (there.how == How::rest) return length / 2;
    const double wanted = shapes_[k].wanted;
    const double sum = wanted + there.wanted;
    return sum > length ? length * (wanted / sum) : wanted;
  }

  void share(std::size_t k) {
    const double wanted = shapes_[k].wanted;
    if (!(wanted > 0)) return;
    const double room = std::min(allowed(k, k - 1, k - 1), allowed(k, k + 1, k));
    if (wanted > room) shapes_[k] = shape(k, room);
    shapes_[k].wanted = wanted;
    if (shapes_[k].trim > room) shapes_[k].trim = room;  // rounding
  }

  /// Replaces a corner by a rest if the rounding would take longer. Both sides are compared with
  /// and without it, each up to the velocity that half of the shorter side permits.
  void rest_if_faster(std::size_t k) {
    CornerShape& s = shapes_[k];
    if (s.how != How::turn && s.how != How::blend) return;
    if (view_.settings(k).corner == Corner::velocity) return;
    const double feed = view_.cap(k);
    if (s.velocity >= 0.3 * feed) return;
    const Box before = box(k - 1);
    const Box behind = box(k);
    const double a = std::min(before.deceleration, behind.acceleration);
    const double j = std::min(before.jerk, behind.jerk);
    const double half = std::min(view_.piece(k - 1).length, view_.piece(k).length) / 2;
    const double v = std::min({before.velocity, behind.velocity,
                               entry_velocity(half, 0, Ramp{a, j}).value_or(unlimited)});
    if (!(v < unlimited) || s.velocity >= v) return;
    const auto lost = [&](double from) {
      return 2 * (ramp_time(v - from, a, j) - ramp_distance(from, v, a, j) / v);
    };
    if (lost(s.velocity) + 2 * s.trim * (1 / s.velocity - 1 / v) > lost(0)) {
      s = CornerShape{};
      s.how = How::rest;
      s.note = JunctionNote::slower;
    }
  }

  /// The law needs a distance to leave a rest: a corner that takes nearly the whole side up to a rest gets half of it.
  /// Returns true if the corner changed.
  bool leave_rest(std::size_t k, std::size_t other, std::size_t side) {
    const double length = view_.piece(side).length;
    if (shapes_[other].how != How::rest || !shapes_[k].is_round()) return false;
    if (shapes_[k].trim <= most_of_side * length) return false;
    shapes_[k] = shape(k, length / 2);
    return true;
  }

  [[nodiscard]] Box box(std::size_t k) const {
    return view_.box(k, end_velocity(k), end_velocity(k + 1));
  }

  /// The greatest velocity at a joint, as far as its shape is known.
  [[nodiscard]] double end_velocity(std::size_t joint) const {
    return shapes_[joint].how == How::rest ? 0 : shapes_[joint].velocity;
  }

  const RouteView view_;
  const std::vector<bool>& stop_;
  const JunctionNote note_of_stop_;
  std::vector<CornerShape> shapes_;
};

}  // namespace

std::vector<CornerShape> shapes_of(const Route& route, const Lines& lines, const Program& program,
                                   const Rates& rates, const std::vector<bool>& stop,
                                   JunctionNote note_of_stop) {
  return Shapes({route, lines, program, rates}, stop, note_of_stop).run();
}

}  // namespace jounce
