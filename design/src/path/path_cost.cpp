// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/path_cost.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_sum;
/// Greatest magnitude of the derivative of an axis with respect to q on a piece.
double steepest(const Path& path, std::size_t piece, std::size_t axis,
                std::vector<Segment>& segments) {
  const PathPiece& of = path.pieces()[piece];
  std::array<Jet, max_axes> jets{};
  if (of.kind == PieceKind::line) {
    path.jets(piece, 0, std::span(jets).first(path.axes()));
    return std::abs(jets[axis][1]);
  }
  segments.clear();
  path.segments(piece, axis, segments);
  double start = of.start;
  double greatest = 0;
  for (const Segment& segment : segments) {
    const double end = start + segment.length;
    greatest = std::max(greatest, std::abs(segment_range(segment, start, end, 1).peak().value));
    start = end;
  }
  return greatest;
}

/// Full speed on a piece.
double full_speed(const Plan& plan, std::size_t piece, std::vector<Segment>& segments) {
  const Plan::Given& given = plan.given();
  const PathPiece& of = plan.path().pieces()[piece];
  double speed = std::min(given.settings[of.settings].velocity, given.limits.path.velocity);
  for (std::size_t i = 0; i < plan.path().axes(); ++i) {
    if (!given.limits.axes[i].velocity) continue;
    const double direction = steepest(plan.path(), piece, i, segments);
    if (direction > 0) speed = std::min(speed, *given.limits.axes[i].velocity / direction);
  }
  return speed;
}

std::size_t piece_at(std::span<const PathPiece> pieces, double q) {
  const auto behind = std::upper_bound(pieces.begin(), pieces.end(), q,
                                       [](double at, const PathPiece& p) { return at < p.start; });
  return behind == pieces.begin() ? 0 : static_cast<std::size_t>(behind - pieces.begin()) - 1;
}

/// Duration at full speed from the start to any place of the path.
class FullSpeed {
 public:
  explicit FullSpeed(const Plan& plan) : pieces_(plan.path().pieces()) {
    std::vector<Segment> segments;
    times_.reserve(pieces_.size() + 1);
    times_.push_back(0);
    for (std::size_t k = 0; k < pieces_.size(); ++k)
      times_.push_back(times_.back() + pieces_[k].length / full_speed(plan, k, segments));
  }

  [[nodiscard]] double until(double q) const {
    const std::size_t k = piece_at(pieces_, q);
    const PathPiece& piece = pieces_[k];
    const double share = std::clamp((q - piece.start) / piece.length, 0.0, 1.0);
    return times_[k] + share * (times_[k + 1] - times_[k]);
  }
  [[nodiscard]] double whole() const { return times_.back(); }

 private:
  std::span<const PathPiece> pieces_;
  std::vector<double> times_;
};

/// A place of the timing law. Between two successive places the speed is monotone.
struct LawPlace {
  double time = 0, q = 0, velocity = 0;
};

/// The ends of all phases, and the places within phases where the acceleration changes its sign.
std::vector<LawPlace> places_of(const TimingLaw& law) {
  std::vector<LawPlace> places;
  std::array<LawPhase, 7> phase;
  for (const LawInterval& stretch : law.stretches()) {
    double time = stretch.time;
    for (const LawPhase& p : std::span(phase).first(phases(stretch, phase))) {
      const auto add = [&](double t) {
        places.push_back({time + t,
                          stretch.start + p.position +
                              t * (p.velocity + t * (p.acceleration / 2 + t * p.jerk / 6)),
                          p.velocity + t * (p.acceleration + t * p.jerk / 2)});
      };
      add(0);
      const double turns = p.jerk == 0 ? 0 : -p.acceleration / p.jerk;
      if (turns > 0 && turns < p.duration) add(turns);
      time += p.duration;
    }
    places.push_back({stretch.time + stretch.duration, stretch.start + stretch.length, stretch.v1});
  }
  return places;
}

LawPlace middle(const LawPlace& a, const LawPlace& b) {
  return {(a.time + b.time) / 2, (a.q + b.q) / 2, a.velocity};
}

/// A local extremum of the speed: places [first, last] of the same speed.
struct Plateau {
  std::size_t first = 0, last = 0;
  bool least = false;
};

/// The local extrema along the law, alternating: rest, maximum, minimum, ..., rest. Speeds that
/// differ by at most `same` count as equal.
std::vector<Plateau> extrema_of(std::span<const LawPlace> places, double same) {
  std::vector<Plateau> all{{0, 0, true}};
  for (std::size_t i = 1; i < places.size(); ++i) {
    Plateau& last = all.back();
    const double step = places[i].velocity - places[last.last].velocity;
    if (std::abs(step) <= same) {
      last.last = i;
    } else if (all.size() > 1 && (step > 0) == !last.least) {
      last = {i, i, last.least};  // the speed continues in the same direction
    } else {
      all.push_back({i, i, step < 0});
    }
  }
  return all;
}

/// The corners that are on the path, in its order.
class Corners {
 public:
  Corners(std::span<const CornerRecord> all, double length)
      : all_(all), margin_(rounded_input * length) {
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].note != JunctionNote::no_distance) order_.push_back(i);
  }

  [[nodiscard]] std::optional<std::size_t> between(double from, double to) const {
    const auto first = std::lower_bound(order_.begin(), order_.end(), from - margin_,
                                        [&](std::size_t i, double q) { return all_[i].where < q; });
    if (first == order_.end() || all_[*first].where > to + margin_) return std::nullopt;
    return *first;
  }
  [[nodiscard]] const CornerRecord& operator[](std::size_t i) const { return all_[i]; }

 private:
  std::span<const CornerRecord> all_;
  std::vector<std::size_t> order_;
  double margin_;
};

/// Determines cause and line of the slowest place.
void explain(const Plan& plan, const Corners& corners, const LawPlace& a, const LawPlace& b,
             SpeedLoss& loss) {
  const auto pieces = plan.drawn().pieces();
  const PathPiece& piece = pieces[piece_at(pieces, loss.where)];
  const bool in_corner = piece.kind == PieceKind::turn || piece.kind == PieceKind::blend;
  loss.line = piece.line;
  loss.corner = in_corner ? corners.between(piece.start, piece.start + piece.length)
                          : corners.between(a.q, b.q);
  if (!loss.corner) {
    loss.cause = loss.velocity == 0              ? LossCause::stop
                 : piece.kind == PieceKind::line ? LossCause::limit
                                                 : LossCause::curve;
    return;
  }
  const CornerRecord& corner = corners[*loss.corner];
  loss.line = corner.line;
  loss.where = corner.where;
  loss.cause = loss.velocity == 0 ? LossCause::stop : LossCause::corner;
}

}  // namespace

const char* name(LossCause cause) {
  constexpr std::array<const char*, loss_causes> names{"start", "end",   "stop", "corner",
                                                       "curve", "limit", "dwell"};
  return names[static_cast<std::size_t>(cause)];
}

double PathCost::of(LossCause cause) const {
  double sum = 0;
  for (const SpeedLoss& loss : losses)
    if (loss.cause == cause) sum += loss.loss;
  return sum;
}

PathCost cost_of(const Plan& plan, std::span<const CornerRecord> corner_records) {
  const FullSpeed full(plan);
  const Corners corners(corner_records, plan.path().length());
  const std::vector<LawPlace> places = places_of(plan.law());
  double rounding = 0;
  for (const LawPlace& place : places)
    rounding = std::max(rounding, rounded_input * place.velocity);
  const std::vector<Plateau> turns = extrema_of(places, rounding);
  PathCost cost{.at_full_speed = full.whole(), .losses = {}};
  LawPlace from = places.front();
  for (std::size_t k = 0; k < turns.size(); ++k) {
    if (!turns[k].least) continue;
    const LawPlace& a = places[turns[k].first];
    const LawPlace& b = places[turns[k].last];
    const bool ends = k + 1 >= turns.size();
    const LawPlace to =
        ends ? places.back() : middle(places[turns[k + 1].first], places[turns[k + 1].last]);
    LawPlace slowest = middle(a, b);
    if (slowest.velocity <= rounding) slowest.velocity = 0;
    const double rest = slowest.velocity == 0 ? b.time - a.time : 0;
    SpeedLoss loss{.cause = LossCause::start,
                   .line = plan.path().pieces().front().line,
                   .where = slowest.q,
                   .time = slowest.time,
                   .velocity = slowest.velocity,
                   .loss = to.time - from.time - rest - (full.until(to.q) - full.until(from.q))};
    if (ends) {
      loss.cause = LossCause::end;
      loss.line = plan.path().pieces().back().line;
    } else if (k > 0) {
      explain(plan, corners, a, b, loss);
    }
    cost.losses.push_back(loss);
    if (rest > rounded_sum * plan.duration()) {
      loss.cause = LossCause::dwell;
      loss.loss = rest;
      loss.corner.reset();
      cost.losses.push_back(loss);
    }
    from = to;
  }
  return cost;
}

}  // namespace jounce
