// SPDX-License-Identifier: Apache-2.0
#include "path/src/corners/rounding.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/curve/query.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/corners/blend.hpp"
#include "path/src/corners/turn.hpp"
#include "path/src/geometry/pieces.hpp"
#include "path/src/geometry/vector.hpp"
#include "path/src/timing/not_limited.hpp"
#include "path/src/timing/stretch.hpp"
#include "path/src/tolerances.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_sum;

using path_detail::none;

constexpr double least_cosine = 1e-8;           ///< a corner with a smaller one turns back
constexpr double blend_resolution = 1e-12;      ///< relative, of a bisection
constexpr double deviation_resolution = 1e-13;  ///< relative
constexpr double tangent =
    1e-9;  ///< a change of direction below this is none: a step of the velocity, relative
constexpr double widest_trim = 1.0;  ///< rad of an arc that a blend may replace

enum class How : std::uint8_t { through, rest, turn, blend };

struct Shape {
  double trim = 0;
  double wanted = 0;  ///< trim if there were no corners at the other ends of its sides
  double share = 0;   ///< share b of a turn
  double velocity = none;
  How how = How::through;
  JointNote note = JointNote::none;
};

/// Both sides of a joint.
struct Sides {
  Point before{}, behind{};            ///< directions
  Point bend_before{}, bend_behind{};  ///< curvatures
};

/// Two directions that meet: |w - u| and |w + u| / 2. Only the path axes count, unless only
/// followers change their direction.
struct Bend {
  double size = 0, cosine = 0;
  bool is_tangent = false;

  Bend(std::span<const double> u, std::span<const double> w, std::size_t path_axes) {
    double change = 0;
    double both = 0;
    double length = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
      change += (w[i] - u[i]) * (w[i] - u[i]);
      both += (w[i] + u[i]) * (w[i] + u[i]);
      length += w[i] * w[i];
      if (i + 1 != path_axes) continue;
      size = std::sqrt(change);
      cosine = std::sqrt(both) / 2;
    }
    if (!(size > tangent)) {
      size = std::sqrt(change);
      cosine = std::sqrt(both) / 2;
    }
    is_tangent = !(size > tangent * std::sqrt(length));
  }
};

class Rounding {
 public:
  /// `stop`: null if the motion rests at every corner.
  Rounding(const Route& route, const Lines& lines, const Program& program, const Rates& rates,
           const std::vector<bool>* stop)
      : route_(route),
        lines_(lines),
        program_(program),
        rates_(rates),
        curved_(reserved(rates)),
        stop_(stop),
        n_(rates.axes) {}

  Rounded run() {
    choose_shapes();
    for (std::size_t k = 1; k + 1 < shapes_.size(); ++k) {
      rates_.require_wanted();
      share(k);
    }
    for (std::size_t k = 1; k + 1 < shapes_.size(); ++k) rest_if_faster(k);
    const bool sharp =
        std::none_of(shapes_.begin(), shapes_.end(), [](const Shape& s) { return s.trim > 0; });
    reserve(sharp);
    assemble(sharp, [&](const Unit& unit) { units_.push_back(unit); });
    for (const std::int32_t line : route_.empty_lines)
      joints_.push_back({0, line, JointNote::no_distance, false});
    Rounded result{{}, std::move(units_), std::move(joints_)};
    if (!sharp) result.path.emplace(n_, std::move(pieces_), std::move(numbers_));
    return result;
  }

  void run_sharp(UnitSink& to) {
    choose_shapes();
    assemble(true, [&](const Unit& unit) { to.add(unit); });
  }

 private:
  void choose_shapes() {
    const std::size_t count = route_.path.pieces().size();
    shapes_.resize(count + 1);
    shapes_[0].how = shapes_[count].how = How::rest;
    for (std::size_t k = 1; k < count; ++k) {
      rates_.require_wanted();
      shapes_[k] = shape(k, std::min(whole(k - 1), whole(k)));
      shapes_[k].wanted = shapes_[k].trim;
    }
  }

  [[nodiscard]] bool stops(std::size_t k) const { return stop_ == nullptr || (*stop_)[k]; }

  [[nodiscard]] const PathPiece& piece(std::size_t k) const { return route_.path.pieces()[k]; }
  [[nodiscard]] const PathSettings& settings(std::size_t k) const {
    return program_.settings()[piece(k).settings];
  }

  /// Length of a piece that is available for corners.
  [[nodiscard]] double whole(std::size_t k) const {
    const PathPiece& p = piece(k);
    if (p.kind != PieceKind::arc) return p.length;
    const double sweep = ArcNumbers(route_.path.numbers(k), n_).sweep();
    return p.length * std::min(1.0, 2 * widest_trim / sweep);
  }

  [[nodiscard]] std::span<const double> direction(std::size_t k) const {
    return std::span(lines_.directions).subspan(k * n_, n_);
  }

  [[nodiscard]] bool are_lines(std::size_t k) const {
    return piece(k - 1).kind == PieceKind::line && piece(k).kind == PieceKind::line;
  }

  [[nodiscard]] Sides sides(std::size_t k) const {
    Sides s;
    std::array<Jet, max_axes> jet{};
    route_.path.jets(k - 1, piece(k - 1).length, std::span(jet).first(n_));
    for (std::size_t i = 0; i < n_; ++i) {
      s.before[i] = jet[i][1];
      s.bend_before[i] = jet[i][2];
    }
    route_.path.jets(k, 0, std::span(jet).first(n_));
    for (std::size_t i = 0; i < n_; ++i) {
      s.behind[i] = jet[i][1];
      s.bend_behind[i] = jet[i][2];
    }
    return s;
  }

  /// The requested velocity of a joint, and the feeds of both sides.
  [[nodiscard]] double cap(std::size_t k) const {
    return std::min({settings(k - 1).velocity, settings(k).velocity, rates_.path.velocity});
  }

  /// The shape that the settings require, with at most `room` on each side.
  [[nodiscard]] Shape shape(std::size_t k, double room) const {
    Shape s;
    if (route_.joints[k].rests) {
      s.how = How::rest;
      return s;
    }
    if (route_.joints[k].smooth) return s;
    if (are_lines(k)) {
      const Bend bend(direction(k - 1), direction(k), rates_.path_axes);
      if (bend.is_tangent) return s;
      if (rests_at(k, bend, s)) return s;
      return turned(k, bend, room);
    }
    const Sides both = sides(k);
    const Bend bend(std::span(both.before).first(n_), std::span(both.behind).first(n_),
                    rates_.path_axes);
    if (bend.is_tangent) return smooth(k, both, room);
    return rests_at(k, bend, s) ? s : blended(k, room);
  }

  /// True if the plan rests at the corner in any case; then sets `s` to the rest.
  [[nodiscard]] bool rests_at(std::size_t k, const Bend& bend, Shape& s) const {
    const bool asked = settings(k).corner == Corner::stop || stops(k);
    const bool turns_back = !(bend.cosine > least_cosine);
    if (!asked && !turns_back) return false;
    s.how = How::rest;
    if (!asked) s.note = JointNote::turns_back;
    return true;
  }

  /// The shape of a tangential joint: no corner, unless the curvature steps and the settings
  /// require a corner.
  [[nodiscard]] Shape smooth(std::size_t k, const Sides& both, double room) const {
    const double step = vec::distance(both.bend_before, both.bend_behind, n_);
    const double larger =
        std::max(vec::norm(both.bend_before, n_), vec::norm(both.bend_behind, n_));
    // Rounding: a shorter trim changes no direction.
    const double shorter = std::min(piece(k - 1).length, piece(k).length);
    if (step <= std::max(tangent * larger, rounded_sum / shorter)) return {};
    Shape s;
    if (settings(k).corner == Corner::stop) {
      s.note = JointNote::steps;
    } else if (stops(k)) {
      s.how = How::rest;
    } else {
      s = blended(k, room);
    }
    return s;
  }

  [[nodiscard]] Shape turned(std::size_t k, const Bend& corner, double room) const {
    const auto [bend, cosine, is_tangent] = corner;
    TurnRates rates{
        std::min(rates_.path.normal_acceleration, rates_.path.total_acceleration) / bend,
        TurnRates::none};
    double fastest = cap(k);
    const auto before = direction(k - 1);
    const auto behind = direction(k);
    for (std::size_t i = 0; i < n_; ++i) {
      const double d = std::abs(behind[i] - before[i]);
      const double u = std::max(std::abs(before[i]), std::abs(behind[i]));
      if (u > 0) fastest = std::min(fastest, rates_.velocity[i] / u);
      if (!(d > 0)) continue;
      rates.acceleration = std::min(rates.acceleration, rates_.acceleration[i] / d);
      rates.jerk = std::min(rates.jerk, rates_.jerk[i] / d);
    }
    const PathSettings& asked = settings(k);
    const bool bounded = rates.acceleration < none || rates.jerk < none;
    Turn turn;
    bool fits = true;
    if (asked.corner == Corner::curvature) {
      turn = curved_turn(rates, bend / (cosine * cosine), asked.value);
      fits = turn.length <= 2 * room;
      if (!fits) turn = fastest_turn(rates, none, 2 * room);
    } else if (asked.corner == Corner::velocity) {
      fastest = std::min(fastest, asked.value);
      turn = bounded ? least_turn(rates, fastest) : fastest_turn(rates, none, 2 * room);
      fits = turn.length <= 2 * room;
      if (!fits) turn = fastest_turn(rates, none, 2 * room);
    } else {
      const bool distance = asked.corner == Corner::distance;
      const double length = distance ? std::min(2 * asked.value, 2 * room) : 2 * room;
      turn = fastest_turn(rates, distance ? none : asked.value / bend, length);
      fits = turn.length < 2 * room || (distance && asked.value <= room);
      // A corner is no larger than its velocity needs.
      if (bounded && turn.velocity > fastest) {
        const Turn least = least_turn(rates, fastest);
        if (least.length <= turn.length) turn = least;
      }
    }
    Shape s;
    s.how = How::turn;
    s.trim = turn.length / 2;
    s.share = turn.share;
    s.velocity = std::min(turn.velocity, fastest);
    if (!fits && (asked.corner == Corner::curvature || turn.velocity < fastest))
      s.note = JointNote::short_sides;
    return s;
  }

  /// A blend whose trim is found by bracketing.
  [[nodiscard]] Shape blended(std::size_t k, double room) const {
    const PathSettings& asked = settings(k);
    double trim = room;
    bool fits = true;
    // The least trim for which enough(trim) holds, or `most`.
    const auto least = [&](double most, auto enough) {
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
        trim = least(room, [&](double d) {
          const Blend b = blend_of(route_.path, k - 1, d);
          return greatest_curvature(b.segments(), rates_.path_axes) <= asked.value;
        });
        break;
      case Corner::velocity:
        trim = least(room, [&](double d) {
          return blend_velocity(k, blend_of(route_.path, k - 1, d)) >= asked.value;
        });
        break;
      default:
        trim = trim_for(k, asked.value, room);
        fits = trim < room;
    }
    if (asked.corner != Corner::curvature && asked.corner != Corner::velocity) {
      const double least_time = fastest_trim(k, trim);
      if (least_time < trim) fits = true;
      trim = least_time;
    }
    Shape s;
    s.how = How::blend;
    s.trim = trim;
    s.velocity = blend_velocity(k, blend_of(route_.path, k - 1, trim));
    if (asked.corner == Corner::velocity) s.velocity = std::min(s.velocity, asked.value);
    if (!fits) s.note = JointNote::short_sides;
    return s;
  }

  /// The trim, at most `most`, whose blend takes the least time. The time on the blend and on the
  /// ramps to its velocity is compared with both sides at full velocity. A larger blend is passed
  /// faster, until its speed |r'| differs noticeably from 1.
  [[nodiscard]] double fastest_trim(std::size_t k, double most) const {
    const Box before = box(k - 1);
    const Box behind = box(k);
    const auto lost = [](double v, const Box& b, double a) {
      if (!(v < b.velocity) || !(b.velocity < none)) return 0.0;
      return ramp_time(b.velocity - v, a, b.jerk) -
             ramp_distance(v, b.velocity, a, b.jerk) / b.velocity;
    };
    const auto time = [&](double d) {
      const double v = blend_velocity(k, blend_of(route_.path, k - 1, d));
      return d * (2 / v - 1 / before.velocity - 1 / behind.velocity) +
             lost(v, before, before.deceleration) + lost(v, behind, behind.acceleration);
    };
    double best = most;
    double least = time(most);
    const double rounding =
        rounded_input * most / blend_velocity(k, blend_of(route_.path, k - 1, most));
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

  [[nodiscard]] Point corner(std::size_t k) const { return route_.path.point(k, 0); }

  /// The largest trim for which the blend is at most `deviation` from the corner and from both
  /// sides. In all tests the distance grew with the trim. The result keeps the deviation in any
  /// case, because it is the lower end of a bracket.
  [[nodiscard]] double trim_for(std::size_t k, double deviation, double room) const {
    const Point at = corner(k);
    const auto over = [&](double d) {
      const Blend blend = blend_of(route_.path, k - 1, d);
      return std::max(least_distance(blend.segments(), at, rates_.path_axes),
                      distance_from_sides(route_.path, k - 1, blend, rates_.path_axes)) -
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
    const double speed = greatest_speed(blend.segments(), rates_.path_axes);
    const double feed = speed > 0 ? cap(k) / std::max(speed, 1.0) : none;
    return std::min(blend_box(curved_, blend.segments()).velocity, feed);
  }

  /// The corners at both ends of a piece share its length, in proportion to their requests. If the
  /// plan rests at the other end, a corner gets at most half, because the law needs a distance to
  /// leave the rest.
  [[nodiscard]] double allowed(std::size_t k, std::size_t other, std::size_t side) const {
    const double length = piece(side).kind == PieceKind::arc ? whole(side) : piece(side).length;
    const Shape& there = shapes_[other];
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
    Shape& s = shapes_[k];
    if (s.how != How::turn && s.how != How::blend) return;
    if (settings(k).corner == Corner::velocity) return;
    const double feed = cap(k);
    if (s.velocity >= 0.3 * feed) return;
    const Box before = box(k - 1);
    const Box behind = box(k);
    const double a = std::min(before.deceleration, behind.acceleration);
    const double j = std::min(before.jerk, behind.jerk);
    const double half = std::min(piece(k - 1).length, piece(k).length) / 2;
    const double v = std::min(
        {before.velocity, behind.velocity, entry_velocity(half, 0, Ramp{a, j}).value_or(none)});
    if (!(v < none) || s.velocity >= v) return;
    const auto lost = [&](double from) {
      return 2 * (ramp_time(v - from, a, j) - ramp_distance(from, v, a, j) / v);
    };
    if (lost(s.velocity) + 2 * s.trim * (1 / s.velocity - 1 / v) > lost(0)) {
      s = Shape{};
      s.how = How::rest;
      s.note = JointNote::slower;
    }
  }

  [[nodiscard]] Box box(std::size_t k) const {
    if (piece(k).kind == PieceKind::line) return lines_.boxes[k];
    if (piece(k).kind == PieceKind::arc)
      return arc_box(curved_, settings(k), route_.path.numbers(k), piece(k).length, end_velocity(k),
                     end_velocity(k + 1));
    return curve_box(curved_, settings(k), derivatives_of(route_.path, k, rates_.path_axes),
                     run_length(k));
  }

  /// The greatest velocity at a joint, as far as its shape is known.
  [[nodiscard]] double end_velocity(std::size_t joint) const {
    return shapes_[joint].how == How::rest ? 0 : shapes_[joint].velocity;
  }

  /// The length that is assumed for a ramp on a curve: several successive pieces, because the
  /// pieces of a curve are short.
  [[nodiscard]] double run_length(std::size_t k) const { return 20 * piece(k).length; }

  /// True for a joint of lines that is passed although their directions differ by rounding. The
  /// velocities of the axes step there by up to 1e-9, which a table turns into jerk.
  [[nodiscard]] bool steps_at(std::size_t k) const {
    if (k == 0 || k >= route_.path.pieces().size() || shapes_[k].how != How::through) return false;
    if (!are_lines(k)) return false;
    double square = 0;
    for (std::size_t i = 0; i < n_; ++i)
      square += profiles_detail::square(direction(k)[i] - direction(k - 1)[i]);
    return square > path_detail::same_direction;
  }

  void require_ramps(const Box& b, std::size_t k) const {
    if (!(b.acceleration < none) || !(b.acceleration > 0))
      throw InputError(
          "acceleration", "",
          "is missing: add acceleration to the limits of each axis that moves, or to [path.limits]")
          .at({}, piece(k).line);
  }

  /// Reserves the memory of the result.
  void reserve(bool sharp) {
    const std::size_t count = route_.path.pieces().size();
    std::size_t corners = 0;
    std::size_t marks = route_.empty_lines.size();
    std::size_t numbers = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const Shape& s = shapes_[k];
      if (k > 0 && (s.how != How::through || s.note != JointNote::none)) ++marks;
      if (piece(k).kind == PieceKind::line) numbers += 2 * n_;
      if (s.how == How::turn) numbers += TurnNumbers::count(n_);
      if (s.how == How::turn || s.how == How::blend) ++corners;
    }
    joints_.reserve(marks);
    units_.reserve(count + corners);
    if (sharp) return;
    pieces_.reserve(count + corners);
    numbers_.reserve(numbers);
  }

  /// Appends the pieces of the result, unless all corners are sharp, and calls `add` for each unit.
  template <class Add>
  void assemble(bool sharp, Add add) {
    const std::size_t count = route_.path.pieces().size();
    const auto add_unit = [&](double length, const Box& b, std::size_t joint, double entry,
                              double dwell) {
      add({length, b, entry, dwell, placed_, 1, static_cast<std::uint32_t>(joint)});
    };
    for (std::size_t k = 0; k < count; ++k) {
      rates_.require_wanted();
      const Shape& here = shapes_[k];
      if (k > 0 && corner_of(k, here)) {
        Box b;
        b.constant = true;
        b.velocity = here.velocity;
        add_unit(placed_length(), b, k, none, 0);
        ++placed_;
      }
      double length = piece(k).length;
      if (!sharp) {
        const std::size_t before = pieces_.size();
        append_part(route_.path, k, here.trim, length - shapes_[k + 1].trim, pieces_, numbers_);
        if (pieces_.size() == before) continue;
        length = placed_length();
      }
      const bool rests = here.how == How::rest;
      const double entry = rests ? 0 : here.how == How::through && k > 0 ? cap(k) : none;
      const double dwell = rests ? route_.joints[k].dwell : 0;
      if (piece(k).kind == PieceKind::arc) {
        const ArcZones zones =
            arc_zones(curved_, settings(k), route_.path.numbers(k), piece(k).length, length,
                      end_velocity(k), end_velocity(k + 1));
        for (std::size_t i = 0; i < zones.count; ++i) {
          require_ramps(zones.zone[i].box, k);
          add_unit(zones.zone[i].length, zones.zone[i].box, k, i == 0 ? entry : none,
                   i == 0 ? dwell : 0);
        }
      } else {
        Box b = box(k);
        require_ramps(b, k);
        if (steps_at(k) || steps_at(k + 1))
          for (double* limit : {&b.acceleration, &b.deceleration, &b.jerk})
            *limit *= 1 - fit_share / 10;
        add_unit(length, b, k, entry, dwell);
      }
      ++placed_;
    }
  }

  /// Places the last appended piece after the previous one; returns its length.
  double placed_length() {
    PathPiece& last = pieces_.back();
    last.start = end_;
    end_ += last.length;
    return last.length;
  }

  /// Marks a joint and appends the piece that rounds its corner; returns false if none does.
  bool corner_of(std::size_t k, const Shape& s) {
    if (stop_ != nullptr && (s.how != How::through || s.note != JointNote::none))
      joints_.push_back({placed_, piece(k).line, s.note, s.how == How::rest});
    if (s.how == How::turn) {
      const Point from = route_.path.point(k - 1, piece(k - 1).length - s.trim);
      pieces_.push_back(
          {0, 2 * s.trim, numbers_.size(), piece(k).line, piece(k).settings, PieceKind::turn});
      numbers_.insert(numbers_.end(), from.begin(), from.begin() + static_cast<std::ptrdiff_t>(n_));
      for (const auto side : {direction(k - 1), direction(k)})
        numbers_.insert(numbers_.end(), side.begin(), side.end());
      numbers_.push_back(s.share);
    } else if (s.how == How::blend) {
      const Blend blend = blend_of(route_.path, k - 1, s.trim);
      pieces_.push_back(
          {0, 2 * s.trim, numbers_.size(), piece(k).line, piece(k).settings, PieceKind::blend});
      numbers_.push_back(5);
      for (const Segment& f : blend.segments())
        numbers_.insert(numbers_.end(), f.c.begin(), f.c.begin() + 6);
      numbers_.push_back(least_distance(blend.segments(), corner(k), rates_.path_axes));
      numbers_.push_back(distance_from_sides(route_.path, k - 1, blend, rates_.path_axes));
    } else {
      return false;
    }
    return true;
  }

  const Route& route_;
  const Lines& lines_;
  const Program& program_;
  const Rates& rates_;
  const Rates curved_;  ///< the same for pieces that are not lines
  const std::vector<bool>* stop_;
  std::size_t n_;
  std::vector<Shape> shapes_;
  std::vector<PathPiece> pieces_;  // parts of the result
  std::vector<double> numbers_;
  std::vector<Unit> units_;
  std::uint32_t placed_ = 0;  // number of placed pieces
  double end_ = 0;            // end of the last piece
  std::vector<JointMark> joints_;
};

}  // namespace

Lines lines_of(const Route& route, const Program& program, const Rates& rates) {
  const std::size_t n = rates.axes;
  const auto pieces = route.path.pieces();
  Lines lines;
  lines.directions.resize(n * pieces.size());
  lines.boxes.resize(pieces.size());
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (pieces[k].kind != PieceKind::line) continue;
    double* direction = lines.directions.data() + k * n;
    const double* step = route.path.numbers(k) + n;
    const double inverse = 1 / pieces[k].length;
    for (std::size_t i = 0; i < n; ++i) direction[i] = step[i] * inverse;
    lines.boxes[k] = line_box(rates, program.settings()[pieces[k].settings], direction);
  }
  return lines;
}

Rounded rounded(const Route& route, const Lines& lines, const Program& program, const Rates& rates,
                const std::vector<bool>& stop) {
  return Rounding(route, lines, program, rates, &stop).run();
}

void send_stopping_units(const Route& route, const Lines& lines, const Program& program,
                         const Rates& rates, UnitSink& to) {
  Rounding(route, lines, program, rates, nullptr).run_sharp(to);
}

}  // namespace jounce
