// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/along.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "jounce/path/axes_by_stretch.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/limit_check.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "path/src/corners/blend.hpp"
#include "path/src/corners/turn.hpp"
#include "path/src/geometry/pieces.hpp"
#include "path/src/geometry/vector.hpp"
#include "path/src/plan/drawn.hpp"
#include "path/src/timing/box.hpp"
#include "path/src/timing/stretch.hpp"

// Let v = q', a = q'', and k the curvature of a circle or helix, whose direction has length 1. The
// acceleration has the components a along the path and k v^2 across it. On a phase of the law, v is
// quadratic in time, so a^2 + (k v^2)^2 has degree 8: its extrema are exact. If a turn is passed
// at constant v, its acceleration is at most v^2 |D| / ((1 - b) l), in the middle, across the path. On
// other pieces, and if v changes on a turn, with |r'| <= R, |r''| <= S, |r' r''| <= P:
//
//   (1)  speed <= R v,   normal <= S v^2,   total^2 <= R^2 a^2 + 2 P |a| v^2 + S^2 v^4
//
// On a turn, R = 1 and P = S |D| / 2, because u D = -|D|^2 / 2 and w D = |D|^2 / 2.

namespace jounce {
namespace {

using profiles_detail::rounded_sum;
/// Bounds of the derivatives of a piece, for the quantities along the path.
struct PieceShape {
  double speed = 1;
  double curvature = 0;  ///< factor of v^2 in the normal acceleration
  bool exact = true;
  bool turn = false;   ///< exact at constant velocity only
  Derivatives bounds;  ///< if the values are not exact
};

PieceShape shape_of(const Plan& plan, std::size_t piece) {
  const Path& path = plan.path();
  const std::size_t m = plan.given().path_axes;
  const PathPiece& p = path.pieces()[piece];
  PieceShape shape;
  if (p.kind == PieceKind::line) return shape;
  if (p.kind == PieceKind::arc) {
    std::array<Jet, max_axes> jets{};
    path.jets(piece, 0, std::span(jets).first(path.axes()));
    double square = 0;
    for (std::size_t i = 0; i < m; ++i) square += jets[i][2] * jets[i][2];
    shape.curvature = std::sqrt(square);
    return shape;
  }
  if (p.kind == PieceKind::turn) {
    const TurnNumbers turn(path.numbers(piece), path.axes());
    double square = 0;
    for (std::size_t i = 0; i < m; ++i)
      square += profiles_detail::square(turn.after(i) - turn.before(i));
    shape.curvature = std::sqrt(square) / ((1 - turn.share()) * p.length);
    shape.turn = true;
    shape.bounds.bend = shape.curvature;
    shape.bounds.along = shape.curvature * std::sqrt(square) / 2;
    return shape;
  }
  shape.exact = false;
  shape.bounds = derivatives_of(path, piece, m);
  shape.speed = shape.bounds.speed;
  if (p.kind == PieceKind::blend) {
    std::vector<Segment> axes;
    for (std::size_t i = 0; i < m; ++i) path.segments(piece, i, axes);
    shape.speed = std::max(1.0, greatest_speed(axes, m));
    shape.bounds.bend = greatest_bend(axes);
  }
  shape.curvature = shape.bounds.bend;
  return shape;
}

/// The greatest use of a limit.
struct Use {
  const char* quantity;
  double value = 0, limit = PathSettings::none, where = 0;
  std::int32_t line = 0;

  [[nodiscard]] double margin() const { return (limit - value) / limit; }
  void consider(double v, double l, double t, std::int32_t from) {
    if (l == PathSettings::none || (limit < PathSettings::none && !(v * limit > value * l))) return;
    value = v;
    limit = l;
    where = t;
    line = from;
  }
};

using Uses = std::array<Use, 6>;
constexpr Uses unused{{{"velocity"},
                       {"acceleration"},
                       {"deceleration"},
                       {"jerk"},
                       {"normal_acceleration"},
                       {"total_acceleration"}}};

constexpr std::array<Use, 3> unused_axis{{{"velocity"}, {"acceleration"}, {"jerk"}}};

class Along {
 public:
  Along(const Plan& plan, double feed_factor)
      : plan_(plan), feed_factor_(feed_factor), drawn_(drawn_pieces(plan)) {}

  Report run() {
    std::array<LawPhase, 7> phase;
    for (const LawInterval& interval : plan_.law().stretches()) {
      if (interval.pieces == 0) continue;
      double t = interval.time;
      std::size_t piece = interval.piece;
      for (LawPhase p : std::span(phase).first(phases(interval, phase))) {
        while (piece + 1 < interval.piece + interval.pieces) {
          const double left = plan_.path().pieces()[piece + 1].start - interval.start - p.position;
          const double h = time_over(p, left);
          if (!(h < p.duration)) break;
          consider(piece++, {h, p.position, p.velocity, p.acceleration, p.jerk}, t);
          p.position += left;
          p.velocity += h * (p.acceleration + h * p.jerk / 2);
          p.acceleration += h * p.jerk;
          p.duration -= h;
          t += h;
        }
        consider(piece, p, t);
        t += p.duration;
      }
    }
    consider_axes();
    return report();
  }

 private:
  enum { velocity, acceleration, deceleration, jerk, normal_acceleration, total_acceleration };

  /// Time in which a phase covers a distance; its whole duration if it covers less.
  static double time_over(const LawPhase& p, double distance) {
    const auto covered = [&](double t) {
      return t * (p.velocity + t * (p.acceleration / 2 + t * p.jerk / 6));
    };
    if (covered(p.duration) <= distance) return p.duration;
    double low = 0;
    double high = p.duration;
    for (double t = high / 2; t > low && t < high; t = low + (high - low) / 2)
      (covered(t) < distance ? low : high) = t;
    return low;
  }

  /// Takes the limits of axes in commands into account.
  void consider_axes() {
    if (!limit_axes(plan_.given().settings)) return;
    axis_.assign(plan_.path().axes(), unused_axis);
    AxesByStretch motion(plan_);
    for (const LawInterval& interval : plan_.law().stretches()) {
      motion.next();
      for (std::size_t i = 0; i < axis_.size(); ++i) {
        double t = interval.time;
        for (std::size_t k = 0; k < motion.segments(i).size(); ++k) {
          const Segment& f = motion.segments(i)[k];
          consider(i, f, motion.pieces(i)[k], t);
          t += f.length;
        }
      }
    }
  }

  /// Takes one segment of an axis on one piece into account, from t on. A rounded corner has the limits
  /// of both commands.
  void consider(std::size_t axis, const Segment& f, std::size_t piece, double t) {
    const PathPiece& of = plan_.drawn().pieces()[drawn_[piece]];
    const bool corner = of.kind == PieceKind::turn || of.kind == PieceKind::blend;
    for (const std::uint32_t settings : {of.settings, corner ? of.settings_before : of.settings}) {
      const std::vector<AxisRates>& rates = plan_.given().settings[settings].axes;
      if (axis >= rates.size()) continue;
      const std::array limits{rates[axis].velocity, rates[axis].acceleration, rates[axis].jerk};
      for (std::size_t k = 0; k < limits.size(); ++k) {
        if (limits[k] == PathSettings::none) continue;
        const Extremum most = segment_range(f, t, t + f.length, static_cast<int>(k) + 1).peak();
        axis_[axis][k].consider(std::abs(most.value), limits[k], most.where, of.line);
      }
    }
  }

  /// Takes one phase of the law on one piece into account, from t on.
  void consider(std::size_t piece, const LawPhase& p, double t) {
    if (!(p.duration > 0)) return;
    if (piece != shaped_) shape_ = shape_of(plan_, shaped_ = piece);
    const auto drawn = plan_.drawn().pieces();
    const PathPiece& of = drawn[drawn_[piece]];
    const PathLimits& limits = plan_.given().limits.path;
    PathSettings own = plan_.given().settings[of.settings];
    own.velocity = feed_of(of, plan_.given().settings) * feed_factor_;
    const double h = p.duration;
    // The fastest place of the phase: an end, or the place where the acceleration changes its sign.
    const auto v_at = [&](double x) { return p.velocity + x * (p.acceleration + x * p.jerk / 2); };
    double fastest = v_at(0) >= v_at(h) ? 0 : h;
    const double turns = p.jerk == 0 ? 0 : -p.acceleration / p.jerk;
    if (turns > 0 && turns < h && v_at(turns) > v_at(fastest)) fastest = turns;
    const double v = v_at(fastest);
    const double end = p.acceleration + h * p.jerk;
    const double up = std::max(p.acceleration, end);
    const double down = -std::min(p.acceleration, end);
    const auto add = [&](std::size_t use, double value, double limit, double command, double x) {
      path_[use].consider(value, limit, t + x, of.line);
      command_[use].consider(value, command, t + x, of.line);
    };
    add(velocity, v * shape_.speed, limits.velocity, own.velocity, fastest);
    if (up > 0) add(acceleration, up, limits.acceleration, own.acceleration, up == end ? h : 0);
    if (down > 0)
      add(deceleration, down, limits.deceleration, own.deceleration, down == -end ? h : 0);
    add(jerk, std::abs(p.jerk), limits.jerk, own.jerk, 0);
    add(normal_acceleration, shape_.curvature * v * v, limits.normal_acceleration,
        PathSettings::none, fastest);
    if (limits.total_acceleration < PathSettings::none) {
      const auto [value, x] = total(p, std::max(up, down), v, fastest);
      add(total_acceleration, value, limits.total_acceleration, PathSettings::none, x);
    }
  }

  /// The greatest total acceleration on a phase, and its time after the start of the phase.
  [[nodiscard]] std::pair<double, double> total(const LawPhase& p, double a, double v,
                                                double fastest) const {
    if (!shape_.exact || (shape_.turn && a > 0))
      return {std::sqrt(shape_.bounds.acceleration_squared(a, v)), fastest};  // (1)
    const double h = p.duration;
    const double speed[] = {p.velocity, p.acceleration * h, p.jerk * h * h / 2};
    const double rate[] = {p.acceleration, p.jerk * h};
    std::array<double, 5> across{};  // k v^2
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) across[i + k] += shape_.curvature * speed[i] * speed[k];
    Segment square;
    square.length = h;
    square.degree = 8;
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t k = 0; k < 5; ++k) square.c[i + k] += across[i] * across[k];
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k = 0; k < 2; ++k) square.c[i + k] += rate[i] * rate[k];
    const Extremum most = segment_range(square, 0, h, 0).max;
    return {std::sqrt(std::max(most.value, 0.0)), most.where};
  }

  /// The finding of a limit; nullopt if there is none, or if a command's is kept.
  static std::optional<Finding> finding(const Use& use, bool of_command, double rounding) {
    if (use.limit == PathSettings::none) return std::nullopt;
    Finding f;
    f.rule = Rule(RuleFamily::limit, use.quantity);
    f.quantity = use.quantity;
    f.where = use.where;
    f.value = use.value;
    f.limit = use.limit;
    f.margin = use.margin();
    f.broken = use.value > use.limit * (1 + rounding);
    if (of_command && !f.broken) return std::nullopt;
    if (of_command) f.advice = "the limit is that of line " + std::to_string(use.line);
    return f;
  }

  [[nodiscard]] Report report() const {
    Report report;
    for (const Uses* uses : {&path_, &command_})
      for (const Use& use : *uses)
        if (auto f = finding(use, uses == &command_, rounded_sum))
          report.findings.push_back(*std::move(f));
    for (std::size_t i = 0; i < axis_.size(); ++i)
      for (const Use& use : axis_[i])
        if (auto f = finding(use, true, profiles_detail::forgiven)) {
          f->axis = std::to_string(i + 1);
          report.findings.push_back(*std::move(f));
        }
    sort(report);
    return report;
  }

  const Plan& plan_;
  double feed_factor_;
  std::vector<std::size_t> drawn_;
  std::size_t shaped_ = static_cast<std::size_t>(-1);
  PieceShape shape_;
  Uses path_ = unused, command_ = unused;
  std::vector<std::array<Use, 3>> axis_;
};

}  // namespace

Report check_along(const Plan& plan, double feed_factor) {
  return Along(plan, feed_factor).run();
}

}  // namespace jounce
