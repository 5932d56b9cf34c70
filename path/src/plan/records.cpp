// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "jounce/path/plan.hpp"
#include "jounce/profiles/detail/six_digits.hpp"

#include "path/src/corners/blend.hpp"
#include "path/src/corners/turn.hpp"
#include "path/src/geometry/pieces.hpp"
#include "path/src/geometry/vector.hpp"
#include "path/src/plan/drawn.hpp"
#include "path/src/timing/box.hpp"
#include "path/src/timing/stretch.hpp"

namespace jounce {
namespace {

constexpr double smallest_turn = 1e-9;  ///< rad; a smaller angle is rounding

class Records {
 public:
  explicit Records(const Plan& plan)
      : plan_(plan), path_(plan.drawn()), n_(path_.axes()), m_(plan.given().path_axes) {}

  [[nodiscard]] CornerRecord record(const JunctionMark& mark) const {
    const PathPiece& piece = path_.pieces()[mark.piece];
    // A corner may replace the whole piece that begins with a step of the curvature.
    const bool steps = mark.note == JunctionNote::steps;
    const bool corner = is_corner(piece) && !steps;
    const PathSettings& settings =
        plan_.given().settings[steps && is_corner(piece) ? piece.settings_before : piece.settings];
    CornerRecord c;
    c.line = mark.line;
    c.stop = mark.rests;
    c.note = mark.note;
    c.asked = settings.corner;
    c.value = settings.value;
    if (mark.note != JunctionNote::no_distance && (corner || mark.piece > 0)) {
      c.angle = steps ? 0 : angle(mark.piece);
      c.where = piece.start + (corner ? piece.length / 2 : 0);
    }
    if (corner) c.trim = piece.length / 2;
    if (corner && piece.kind == PieceKind::turn) of_turn(mark.piece, c);
    if (corner && piece.kind == PieceKind::blend) of_blend(mark.piece, c);
    if (!c.stop && mark.note != JunctionNote::no_distance) c.velocity = velocity(c.where);
    c.text = explain(c);
    return c;
  }

 private:
  /// Direction of a piece at u, which may be outside [0, 1]: the formula continues.
  [[nodiscard]] Point direction(std::size_t piece, double u) const {
    std::array<Jet, max_axes> jets{};
    path_.jets(piece, u, std::span(jets).first(n_));
    Point w{};
    for (std::size_t i = 0; i < n_; ++i) w[i] = jets[i][1];
    return w;
  }

  /// Angle at a corner, or at the start of a piece. A blend replaces a part of both neighbors (the
  /// trim), so they are extended to the joint. If a corner replaces a whole neighbor, the direction
  /// at that end of the blend counts.
  [[nodiscard]] double angle(std::size_t k) const {
    const auto pieces = path_.pieces();
    const double trim = pieces[k].length / 2;
    Point u;
    Point w;
    if (pieces[k].kind == PieceKind::turn) {  // begins and ends with the directions of its sides
      u = direction(k, 0);
      w = direction(k, pieces[k].length);
    } else if (!is_corner(pieces[k])) {
      u = direction(k - 1, pieces[k - 1].length);
      w = direction(k, 0);
    } else {
      const bool before = k > 0 && !is_corner(pieces[k - 1]);
      const bool behind = k + 1 < pieces.size() && !is_corner(pieces[k + 1]);
      u = before ? direction(k - 1, pieces[k - 1].length + trim) : direction(k, 0);
      w = behind ? direction(k + 1, -trim) : direction(k, pieces[k].length);
    }
    const double turn = 2 * std::atan2(vec::distance(u, w, m_), vec::norm(vec::sum(u, w), m_));
    return turn > smallest_turn ? turn : 0;
  }

  void of_turn(std::size_t k, CornerRecord& c) const {
    const PathPiece& piece = path_.pieces()[k];
    const TurnNumbers turn(path_.numbers(k), n_);
    Point change{};
    for (std::size_t i = 0; i < n_; ++i) change[i] = turn.after(i) - turn.before(i);
    double bend = vec::norm(change, m_);
    if (!(bend > smallest_turn)) bend = vec::norm(change, n_);
    const double cosine = std::cos(c.angle / 2);
    c.deviation = bend * piece.length * turn_offset(turn.share());
    c.one_sided = c.deviation * cosine;
    c.curvature = bend / ((1 - turn.share()) * piece.length * cosine * cosine);
  }

  void of_blend(std::size_t k, CornerRecord& c) const {
    const double* data = path_.numbers(k);
    const std::size_t count = polynomial_count(n_, static_cast<int>(data[0]));
    c.deviation = data[count];
    c.one_sided = data[count + 1];
    std::array<Segment, max_axes> axes;
    std::vector<Segment> one;
    for (std::size_t i = 0; i < n_; ++i) {
      one.clear();
      path_.segments(k, i, one);
      axes[i] = one.front();
    }
    c.curvature = greatest_curvature(std::span(axes).first(n_), m_);
  }

  /// Velocity of the law at a place.
  [[nodiscard]] double velocity(double where) const {
    const LawInterval s = *plan_.law().stretches().last_where(
        [where](const LawInterval& stretch) { return stretch.start <= where; });
    if (s.v0 == s.peak && s.v1 == s.peak) return s.peak;
    double low = 0;  // within a longer ramp: by bisection of the time
    double high = s.duration;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (motion_in(s, middle).position < where - s.start ? low : high) = middle;
    }
    return motion_in(s, low).velocity;
  }

  const Plan& plan_;
  const Path& path_;
  std::size_t n_, m_;
};

/// A requested value as text: "a deviation of 0.05 mm".
std::string request(const CornerRecord& c, std::string_view unit) {
  const std::string value = " of " + six_digits(c.value);
  switch (c.asked) {
    case Corner::stop:
      break;
    case Corner::deviation:
      return "a deviation" + value + std::string(unit);
    case Corner::distance:
      return "a distance" + value + std::string(unit);
    case Corner::curvature:
      return "a curvature" + value;
    case Corner::velocity:
      return "a velocity" + value;
    case Corner::average:
      return "an average" + value + std::string(unit);
  }
  return "the request";
}

}  // namespace

std::string explain(const CornerRecord& corner, std::string_view length_unit) {
  const std::string unit = length_unit.empty() ? "" : " " + std::string(length_unit);
  switch (corner.note) {
    case JunctionNote::none:
      return "";
    case JunctionNote::turns_back:
      return "The path turns back by " + six_digits(corner.angle * 180 / std::numbers::pi) +
             " degrees: the motion stops here.";
    case JunctionNote::short_sides:
      return "The sides are too short for " + request(corner, unit) + ": a corner with a trim of " +
             six_digits(corner.trim) + unit + " and a deviation of " +
             six_digits(corner.deviation) + unit + " is used.";
    case JunctionNote::slower:
      return "Rounding within " + request(corner, unit) +
             " takes longer than a stop: the motion stops here.";
    case JunctionNote::steps:
      return std::string("The curvature steps here, and the acceleration with it. ") +
             (corner.asked == Corner::stop ? "A `corner` other than stop"
                                           : "A jerk limit of the axes") +
             " rounds the step.";
    case JunctionNote::no_distance:
      return "This command covers no distance and is left out.";
  }
  return "";
}

std::vector<std::size_t> drawn_pieces(const Plan& plan) {
  const auto drawn = plan.drawn().pieces();
  std::vector<std::size_t> all;
  all.reserve(plan.path().pieces().size());
  std::size_t d = 0;
  for (const PathPiece& piece : plan.path().pieces()) {
    if (!plan.given().drawn) {
      all.push_back(all.size());
      continue;
    }
    const double middle = piece.start + piece.length / 2;
    while (d + 1 < drawn.size() && drawn[d + 1].start <= middle) ++d;
    all.push_back(d);
  }
  return all;
}

std::vector<CornerRecord> Plan::corners() const {
  std::vector<CornerRecord> out;
  out.reserve(junctions_.size());
  const Records records(*this);
  for (const JunctionMark& mark : junctions_) out.push_back(records.record(mark));
  return out;
}

}  // namespace jounce
