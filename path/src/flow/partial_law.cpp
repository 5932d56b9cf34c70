// SPDX-License-Identifier: Apache-2.0
#include "path/src/flow/partial_law.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/plan/drawn.hpp"
#include "path/src/timing/turn_chains.hpp"
#include "path/src/tolerances.hpp"

namespace jounce {

double lowest_end(const Box& box, double length, double v) {
  const auto way = [&](double drop) {
    return ramp_distance(v, v - drop, box.deceleration, box.jerk);
  };
  if (way(v) <= length * (1 + profiles_detail::rounded_root)) return 0;  // but for rounding
  double low = 0;  // the distance grows with the drop up to here
  double high = std::max(2 * v / 3, v - box.deceleration * box.deceleration / (2 * box.jerk));
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    if (middle == low || middle == high) break;
    (way(middle) <= length ? low : high) = middle;
  }
  // The drop is rounded to a digit of the velocity, which may be a large share of a small drop.
  double end = v - low;
  while (end < v && way(v - end) > length) end = std::nextafter(end, v);
  return end;
}

void PartialLaw::phase(const LawInterval& whole, double at, double duration, const Motion& m) {
  if (!(duration > 0)) return;
  LawInterval s = whole;
  s.deceleration = 0;
  s.start = whole.start + at;
  s.duration = duration;
  s.v0 = m.velocity;
  s.acceleration = m.acceleration;
  s.jerk = m.jerk;
  s.length = duration * (m.velocity + duration * (m.acceleration / 2 + duration * m.jerk / 6));
  s.v1 = s.peak = m.velocity + duration * (m.acceleration + duration * m.jerk / 2);
  add(s);
}

void PartialLaw::until(const LawInterval& whole, double t) {
  std::array<LawPhase, 7> phases_of;
  const std::size_t count = phases(whole, phases_of);
  double gone = 0;
  for (std::size_t i = 0; i < count && gone < t; ++i) {
    const LawPhase& p = phases_of[i];
    phase(whole, p.position, std::min(p.duration, t - gone),
          {0, p.velocity, p.acceleration, p.jerk});
    gone += p.duration;
  }
}

void PartialLaw::rest(const Path& path, double q, double duration) {
  if (!(duration > 0)) return;
  const auto pieces = path.pieces();
  const auto next = std::upper_bound(pieces.begin() + 1, pieces.end(), q,
                                     [](double x, const PathPiece& p) { return x < p.start; });
  LawInterval s;
  s.start = q;
  s.duration = duration;
  s.piece = static_cast<std::uint32_t>(next - pieces.begin() - 1);
  add(s);
}

namespace {

/// The settings of both commands of a corner: the lower one of each limit.
PathSettings both(const PathSettings& before, const PathSettings& behind) {
  const auto deceleration = [](const PathSettings& s) {
    return s.deceleration < PathSettings::none ? s.deceleration : s.acceleration;
  };
  PathSettings lower = behind;
  lower.velocity = std::min(before.velocity, behind.velocity);
  lower.acceleration = std::min(before.acceleration, behind.acceleration);
  lower.deceleration = std::min(deceleration(before), deceleration(behind));
  lower.jerk = std::min(before.jerk, behind.jerk);
  return lower;
}

}  // namespace

void open_end_corners(std::vector<Unit>& units, const Plan& plan) {
  if (units.empty() || !(units.front().box.constant || units.back().box.constant)) return;
  const Plan::Given& given = plan.given();
  const Rates rates = reserved(rates_of(given.limits, plan.path().axes(), given.path_axes));
  const std::vector<std::size_t> drawn = drawn_pieces(plan);
  const auto open = [&](Unit& unit) {
    const PathPiece& corner = plan.drawn().pieces()[drawn[unit.piece]];
    const double length = plan.path().pieces()[unit.piece].length;
    const Box box =
        curve_box(rates_on(rates, corner, given.settings, true),
                  both(given.settings[corner.settings_before], given.settings[corner.settings]),
                  derivatives_of(plan.path(), unit.piece, rates.path_axes), length);
    const double velocity = unit.box.velocity;
    unit.box = box;
    unit.box.velocity = std::min(box.velocity, velocity);
  };
  // With joints of a robot, one corner has several pieces.
  const auto open_from = [&](auto first, auto last) {
    if (!first->box.constant) return;
    const std::size_t corner = drawn[first->piece];
    for (; first != last && first->box.constant && drawn[first->piece] == corner; ++first)
      open(*first);
  };
  open_from(units.begin(), units.end());
  open_from(units.rbegin(), units.rend());
}

Unit unit_of(const LawInterval& s) {
  Unit unit;
  unit.length = s.length;
  unit.box = {s.peak, s.acceleration, s.deceleration, s.jerk, is_corner(s)};
  unit.entry = s.v0;
  unit.piece = s.piece;
  unit.pieces = s.pieces;
  return unit;
}

PlannedUnits units_of(const Plan& plan) {
  PlannedUnits all;
  double dwell = 0;
  for (const LawInterval& s : plan.law().stretches()) {
    if (s.pieces == 0) {
      dwell += s.duration;
      continue;
    }
    Unit unit = unit_of(s);
    unit.dwell = dwell;
    if (dwell > 0) unit.entry = 0;
    dwell = 0;
    all.units.push_back(unit);
    all.starts.push_back(s.start);
  }
  all.starts.push_back(plan.path().length());
  all.last_dwell = dwell;
  return all;
}

namespace {

using profiles_detail::rounded_sum;

/// Plans the law of a path again by stations, with other feeds.
class Replanned {
 public:
  Replanned(const Plan& plan, double factor)
      : plan_(plan),
        path_(plan.path()),
        n_(path_.axes()),
        rates_(rates_of(plan.given().limits, n_, plan.given().path_axes)),
        curved_(reserved(rates_)),
        settings_(plan.given().settings),
        drawn_(drawn_pieces(plan)) {
    for (PathSettings& s : settings_) {
      s.velocity *= factor;
      if (s.corner == Corner::velocity) s.value *= factor;
    }
    velocity_.assign(path_.pieces().size(), PathSettings::none);
    find_rests();
    for (std::size_t k = 0; k < path_.pieces().size(); ++k)
      if (is_corner_piece(k)) velocity_[k] = corner_velocity(k);
  }

  [[nodiscard]] Plan run() const {
    PartialLaw out;
    std::vector<Unit> units;
    double start = 0;
    const auto flush = [&] {
      if (units.empty()) return;
      const double time = out.time();
      double end = start;
      for (LawInterval s : stations(units)) {
        s.time += time;
        s.start += start;
        end = s.start + s.length;
        out.law.push_back(s);
      }
      start = end;
      units.clear();
    };
    const std::size_t count = path_.pieces().size();
    std::vector<Unit> all;
    all.reserve(count);
    for (std::size_t k = 0; k < count; ++k) all.push_back(unit(k));
    open_chains(all, path_, rates_, settings_);
    for (std::size_t k = 0; k < count; ++k) {
      if (rests_[k]) {
        flush();
        start = path_.pieces()[k].start;
        out.rest(path_, start, dwells_[k]);
      }
      units.push_back(all[k]);
    }
    flush();
    out.rest(path_, path_.length(), dwells_[count]);
    return {path_,
            TimingLaw(out.law),
            {plan_.junctions().begin(), plan_.junctions().end()},
            plan_.stop_duration(),
            plan_.given()};
  }

 private:
  [[nodiscard]] const PathPiece& piece(std::size_t k) const { return path_.pieces()[k]; }
  [[nodiscard]] bool is_corner_piece(std::size_t k) const {
    const PieceKind kind = plan_.drawn().pieces()[drawn_[k]].kind;
    return kind == PieceKind::turn || kind == PieceKind::blend;
  }

  /// `rates` within the limits of the command of piece k, or of both commands of a corner.
  [[nodiscard]] Rates rates_at(std::size_t k, const Rates& rates) const {
    return rates_on(rates, plan_.drawn().pieces()[drawn_[k]], settings_, is_corner_piece(k));
  }

  void find_rests() {
    const auto pieces = path_.pieces();
    rests_.assign(pieces.size() + 1, false);
    dwells_.assign(pieces.size() + 1, 0.0);
    rests_.front() = rests_.back() = true;
    for (const LawInterval& s : plan_.law().stretches()) {
      if (s.pieces > 0 && s.v0 != 0) continue;
      const auto at =
          std::lower_bound(pieces.begin(), pieces.end(), s.start - rounded_sum * path_.length(),
                           [](const PathPiece& p, double q) { return p.start < q; });
      const auto k = static_cast<std::size_t>(at - pieces.begin());
      rests_[k] = true;
      if (s.pieces == 0) dwells_[k] += s.duration;
    }
  }

  /// The lower feed of both sides of the start of piece k, or of the corner there.
  [[nodiscard]] double feed_before(std::size_t k) const {
    double before = PathSettings::none;
    if (!is_corner_piece(k) && k > 0) before = settings_[piece(k - 1).settings].velocity;
    const PathPiece& drawn = plan_.drawn().pieces()[drawn_[k]];
    return std::min({before, feed_of(drawn, settings_), rates_.path.velocity});
  }

  [[nodiscard]] double corner_velocity(std::size_t k) const {
    const PathSettings& asked = settings_[piece(k).settings];
    double most = feed_before(k);
    if (asked.corner == Corner::velocity) most = std::min(most, asked.value);
    const Rates rates = rates_at(k, piece(k).kind == PieceKind::turn ? rates_ : curved_);
    const Derivatives bounds = derivatives_of(path_, k, plan_.given().path_axes);
    return std::min(most / bounds.speed, velocity_with(rates, bounds, 0, 0));
  }

  /// The greatest velocity at the start of piece k.
  [[nodiscard]] double at_start(std::size_t k) const {
    if (rests_[k]) return 0;
    if (k > 0 && is_corner_piece(k - 1)) return velocity_[k - 1];
    return k < velocity_.size() ? velocity_[k] : PathSettings::none;
  }

  [[nodiscard]] Unit unit(std::size_t k) const {
    Unit unit;
    unit.length = piece(k).length;
    unit.piece = static_cast<std::uint32_t>(k);
    unit.box = box(k);
    const bool through = k > 0 && !is_corner_piece(k) && !is_corner_piece(k - 1);
    unit.entry = rests_[k] ? 0 : through ? feed_before(k) : PathSettings::none;
    return unit;
  }

  [[nodiscard]] Box box(std::size_t k) const {
    const PathSettings& settings = settings_[piece(k).settings];
    if (is_corner_piece(k)) {
      Box b;
      b.constant = true;
      b.velocity = velocity_[k];
      return b;
    }
    if (piece(k).kind == PieceKind::arc)
      return arc_box(rates_at(k, curved_), settings, path_.numbers(k), piece(k).length, at_start(k),
                     at_start(k + 1));
    if (piece(k).kind == PieceKind::curve)
      return curve_box(rates_at(k, curved_), settings,
                       derivatives_of(path_, k, plan_.given().path_axes), 20 * piece(k).length);
    Point u{};
    for (std::size_t i = 0; i < n_; ++i) u[i] = path_.numbers(k)[n_ + i] / piece(k).length;
    Box b = line_box(rates_at(k, rates_), settings, u.data());
    if (steps_at(k) || steps_at(k + 1))
      for (double* limit : {&b.acceleration, &b.deceleration, &b.jerk})
        *limit *= 1 - fit_share / 10;
    return b;
  }

  /// True for a joint of lines that is passed although their directions differ by rounding
  /// (decision 0090, 15).
  [[nodiscard]] bool steps_at(std::size_t k) const {
    if (rests_[k] || piece(k - 1).kind != PieceKind::line || piece(k).kind != PieceKind::line)
      return false;
    double square = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      const double before = path_.numbers(k - 1)[n_ + i] / piece(k - 1).length;
      const double step = path_.numbers(k)[n_ + i] / piece(k).length - before;
      square += step * step;
    }
    return square > path_detail::same_direction;
  }

  const Plan& plan_;
  const Path& path_;
  std::size_t n_;
  Rates rates_;
  Rates curved_;
  std::vector<PathSettings> settings_;
  std::vector<std::size_t> drawn_;  ///< for each piece, the drawn piece of which it is a part
  std::vector<double> velocity_;    ///< velocity of each corner
  std::vector<bool> rests_;  ///< true if the plan rests: at the start of each piece, and at the end
  std::vector<double> dwells_;
};

}  // namespace

Plan by_stations(const Plan& plan, double factor) {
  const bool window = std::ranges::any_of(plan.law().stretches(), &LawInterval::is_phase);
  if (factor == 1 && !window) return plan;
  return Replanned(plan, factor).run();
}

}  // namespace jounce
