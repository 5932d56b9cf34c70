// SPDX-License-Identifier: Apache-2.0
#include "path/src/timing/stations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "jounce/profiles/curve/query.hpp"
#include "jounce/profiles/detail/large_pages.hpp"
#include "jounce/profiles/detail/ramps.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "path/src/cube_root.hpp"
#include "path/src/kept_memory.hpp"
#include "path/src/timing/stretch.hpp"
#include "path/src/tolerances.hpp"

// A station is a place where the acceleration is zero. Let F(v, L) be the greatest velocity that
// one ramp reaches from v over L. With caps c_k at the stations,
//
//   (1)  backward  v_k = min(c_k, F(v_k+1, L_k)),     forward  v_k+1 = min(v_k+1, F(v_k, L_k)).
//
// Every stretch is then long enough for its ramp. Proof: the forward pass lowers v_k+1 only to
// F(v_k) >= v_k, where the ramp takes all of L_k. If it does not lower v_k+1 and v_k+1 >= v_k, the
// ramp is shorter, because its distance grows with the larger end. If v_k+1 < v_k, v_k+1 still has
// its backward value and v_k is at most its own. A stretch at constant velocity has F(v) = v, for
// which the same holds.
//
// F is not monotone in v: it falls until F = 3 v. So the result is a feasible law, but not always
// the fastest. Stations are therefore omitted if the boxes on both sides are equal, and if one ramp
// over both sides is faster.

namespace jounce {
namespace {

using profiles_detail::reserve_large;
using profiles_detail::rounded_input;
using profiles_detail::rounded_value;

constexpr double no_ramp = 1e-10;  ///< share of the velocity
constexpr std::size_t not_limited = std::numeric_limits<std::uint32_t>::max();  ///< pieces

Ramp up(const Box& box) {
  return {box.acceleration, box.jerk};
}

/// F, rounded down so that the ramp fits; F is accurate to 1e-14.
double reached(double length, double v, const Ramp& ramp) {
  return std::max(v,
                  entry_velocity(length, v, ramp).value_or(v) * (1 - path_detail::entry_rounding));
}

/// The ramps from v0 to a peak, and from there to v1.
struct Ramps {
  double time = 0, length = 0;
};
Ramps ramps_of(const Box& box, double v0, double peak, double v1) {
  const double up = ramp_time(peak - v0, box.acceleration, box.jerk);
  const bool alike = v0 == v1 && box.acceleration == box.deceleration;
  const double down = alike ? up : ramp_time(peak - v1, box.deceleration, box.jerk);
  return {up + down, 0.5 * ((v0 + peak) * up + (peak + v1) * down)};
}

/// Less than the length of ramps_of(): without a jerk limit.
double least_ramps_length(const Box& box, double v0, double peak, double v1) {
  return 0.5 * ((v0 + peak) * (peak - v0) / box.acceleration +
                (peak + v1) * (peak - v1) / box.deceleration);
}

/// The greatest velocity of a law from v0 to v1 over L that does not reach the velocity limit of
/// the box.
double peak_of(const Box& box, double length, double v0, double v1) {
  const double least = std::max(v0, v1);
  const bool alike = box.acceleration == box.deceleration;
  if (alike && least == 0) {  // L = p^2 / a + p a / j, or (p / j)^(1/2) 2 p where a is not reached
    const double edge = box.acceleration / box.jerk;
    const double p = 2 * length / (edge + std::sqrt(edge * edge + 4 * length / box.acceleration));
    return p >= box.acceleration * edge ? p
                                        : path_detail::cube_root(box.jerk * length * length / 4);
  }
  if (alike) return std::max(least, peak_velocity(length, {v0, v1}, up(box)).value_or(least));
  const auto move =
      profiles_detail::ramped(profiles_detail::JerkLaw{box.acceleration, box.jerk}, v0,
                              profiles_detail::JerkLaw{box.deceleration, box.jerk}, v1,
                              std::max(box.velocity, least), length);
  return move ? v0 + move->dv0 : least;
}

/// Writes the fastest stretch over a unit from v0 to v1, without its time and its start.
void write_stretch(const Unit& unit, double v0, double v1, LawInterval& s) {
  const Box& box = unit.box;
  s.length = unit.length;
  s.v0 = v0;
  s.v1 = v1;
  s.acceleration = box.acceleration;
  s.deceleration = box.deceleration;
  s.jerk = box.jerk;
  s.piece = unit.piece;
  s.pieces = unit.pieces;
  const double least = std::max(v0, v1);
  s.peak = least;
  if (box.constant) {
    s.duration = s.length / s.peak;
    return;
  }
  Ramps ramps{0, PathSettings::none};  // of the greatest velocity, if the length permits it
  if (box.velocity > least) {
    const double most = box.velocity;
    if (most < PathSettings::none &&
        least_ramps_length(box, v0, most, v1) <= s.length * (1 + rounded_input))
      ramps = ramps_of(box, v0, most, v1);
    s.peak = ramps.length <= s.length ? most : peak_of(box, s.length, v0, v1);
  }
  // Ramps so small take no time worth having, and their phases are too short to be fitted on an arc.
  if (s.peak - least <= no_ramp * s.peak) s.peak = least;
  if (!(ramps.length <= s.length) || s.peak == least) ramps = ramps_of(box, v0, s.peak, v1);
  // For a ramp over a few units in the last place of the velocity, rounding changes the length by a
  // large share. The peak is rounded down until the ramps fit; the cruise takes the rest of the
  // length.
  for (double back = 2e-16; ramps.length > s.length && s.peak > least; back *= 2) {
    s.peak = std::max(least, s.peak * (1 - back));
    ramps = ramps_of(box, v0, s.peak, v1);
  }
  const double cruise = s.length - ramps.length;
  s.duration = ramps.time + (cruise > rounded_value * s.length ? cruise / s.peak : 0);
}

/// The velocity that a ramp from v reaches over a unit, at most `cap`, which is the usual result.
double reached_within(const Unit& unit, double v, double cap, double acceleration) {
  if (!(cap > v) || unit.box.constant) return std::min(v, cap);
  if (ramp_distance(v, cap, acceleration, unit.box.jerk) <= unit.length * (1 - rounded_value))
    return cap;
  return std::min(cap, reached(unit.length, v, {acceleration, unit.box.jerk}));
}

/// v of (1) at the start of each unit, and at the end.
std::vector<double> velocities(const std::vector<Unit>& units) {
  const std::size_t n = units.size();
  std::vector<double> v = path_detail::with_kept_memory<double>(n + 1);
  v.resize(n + 1);
  for (std::size_t k = n; k-- > 1;) {
    const double cap = std::min({units[k].entry, units[k].box.velocity, units[k - 1].box.velocity});
    v[k] = reached_within(units[k], v[k + 1], cap, units[k].box.deceleration);
  }
  for (std::size_t k = 0; k < n; ++k)
    if (v[k + 1] > v[k])
      v[k + 1] = reached_within(units[k], v[k], v[k + 1], units[k].box.acceleration);
  return v;
}

bool alike(double a, double b) {
  return a == b || std::abs(a - b) <= fit_share / 5 * std::max(a, b);
}

Box both(const Box& a, const Box& b) {
  return {std::min(a.velocity, b.velocity), std::min(a.acceleration, b.acceleration),
          std::min(a.deceleration, b.deceleration), std::min(a.jerk, b.jerk), false};
}

bool alike(const Box& a, const Box& b) {
  return !a.constant && !b.constant && alike(a.velocity, b.velocity) &&
         alike(a.acceleration, b.acceleration) && alike(a.deceleration, b.deceleration) &&
         alike(a.jerk, b.jerk);
}

/// The box of a unit for a ramp that crosses its joint, slightly reduced: the directions at a
/// tangential joint may differ by up to 1e-9, and so may the accelerations of the axes there.
Box across_joint(const Unit& unit) {
  Box box = unit.box;
  if (unit.pieces > 1) return box;
  for (double* limit : {&box.acceleration, &box.deceleration, &box.jerk})
    *limit *= 1 - fit_share / 10;
  return box;
}

Unit joined(const Unit& a, const Unit& b) {
  Unit unit = a;
  unit.length += b.length;
  unit.box = both(across_joint(a), across_joint(b));
  unit.pieces = b.piece + b.pieces - a.piece;
  return unit;
}

/// Joins units with the same box if nothing limits the velocity between them. Returns the number of units at constant
/// velocity.
std::size_t join_alike(std::vector<Unit>& units) {
  std::size_t last = 0;
  std::size_t constant = units.front().box.constant ? 1 : 0;
  for (std::size_t k = 1; k < units.size(); ++k) {
    const Unit& unit = units[k];
    if (unit.box.constant) ++constant;
    if (unit.entry >= unit.box.velocity && unit.entry > 0 && alike(units[last].box, unit.box))
      units[last] = joined(units[last], unit);
    else if (++last != k)
      units[last] = unit;
  }
  units.resize(last + 1);
  return constant;
}

/// True if one ramp over both units may be faster: they meet at v, which both boxes exceed.
bool may_join(const Unit& before, const Unit& unit, double v) {
  return !before.box.constant && !unit.box.constant && v > 0 && unit.entry >= unit.box.velocity &&
         v < std::min(unit.box.velocity, before.box.velocity) * (1 - rounded_input);
}

/// `constant`: number of units at constant velocity.
LawStretches timed(const std::vector<Unit>& units, const std::vector<double>& v,
                   std::size_t constant) {
  LawStretches law;
  law.reserve(units.size(), constant * LawStretches::numbers_at_constant_velocity +
                                (units.size() - constant) * LawStretches::numbers_of_ramps);
  LawInterval s;
  for (std::size_t k = 0; k < units.size(); ++k) {
    write_stretch(units[k], v[k], v[k + 1], s);
    law.push_back(s);
    s.time += s.duration;
    s.start += s.length;
  }
  return law;
}

std::size_t count_constant(const std::vector<Unit>& units) {
  return static_cast<std::size_t>(
      std::ranges::count_if(units, [](const Unit& unit) { return unit.box.constant; }));
}

bool may_join_any(const std::vector<Unit>& units, const std::vector<double>& v) {
  for (std::size_t k = 1; k < units.size(); ++k)
    if (may_join(units[k - 1], units[k], v[k])) return true;
  return false;
}

/// Joins units with different boxes if one ramp over both is not slower. Most velocities stay the same in all rounds, so
/// the durations and refusals of earlier rounds are used again.
class Joins {
 public:
  /// `v`: velocities at the ends of the units; `law`: their stretches.
  Joins(std::vector<Unit> units, std::vector<double> v, const LawStretches& law, std::size_t most)
      : units_(std::move(units)), v_(std::move(v)) {
    known_ = path_detail::with_kept_memory<Known>(units_.size());
    auto stretch = law.begin();
    for (std::size_t k = 0; k < units_.size(); ++k, ++stretch) {
      Known& known = path_detail::append_blank(known_);
      known.v0 = v_[k];
      known.v1 = v_[k + 1];
      known.duration = stretch->duration;
      known.first = static_cast<std::uint32_t>(k);
    }
    run(most);
    for (std::size_t k = 0; k < units_.size(); ++k)
      duration_ += duration_of(units_[k], v_[k], v_[k + 1], known_[k]);
    path_detail::keep_memory(std::move(known_));
  }
  Joins(const Joins&) = delete;
  Joins& operator=(const Joins&) = delete;
  ~Joins() {
    path_detail::keep_memory(std::move(units_));
    path_detail::keep_memory(std::move(v_));
  }

  [[nodiscard]] double duration() const { return duration_; }
  [[nodiscard]] LawStretches law() const { return timed(units_, v_, count_constant(units_)); }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// A join that was refused: the first original unit of the unit before, and the velocities at the three ends.
  struct Refusal {
    double from = 0, start = 0, end = 0;
    std::uint32_t first = none;
    bool operator==(const Refusal&) const = default;
  };

  /// What is known of a unit.
  struct Known {
    double v0 = 0, v1 = 0, duration = 0;  ///< its last stretch
    std::uint32_t first = 0;              ///< the first of the original units that it consists of
    Refusal refused = {};                 ///< its last join with the unit before
  };

  static double duration_of(const Unit& unit, double v0, double v1, Known& known) {
    if (known.v0 == v0 && known.v1 == v1) return known.duration;
    known.v0 = v0;
    known.v1 = v1;
    return known.duration = stretch_of(unit, v0, v1).duration;
  }

  /// The duration of the stretch over two joined units; none if two stretches are faster. `join`: the velocities.
  static std::optional<double> joined_duration(const Unit& before, const Unit& unit,
                                               const Unit& longer, const Refusal& join,
                                               Known& known_before, Known& known) {
    const auto& [from, start, end, first] = join;
    // Rounding does not decide: an end at the velocity of one box is often that of the other box, too.
    if (std::max(from, end) > longer.box.velocity * (1 + rounded_input)) return std::nullopt;
    const double direct = ramp_distance(
        from, end, end > from ? longer.box.acceleration : longer.box.deceleration, longer.box.jerk);
    if (direct > longer.length) return std::nullopt;
    const double apart =
        duration_of(before, from, start, known_before) + duration_of(unit, start, end, known);
    const double together = stretch_of(longer, from, end).duration;
    if (together > apart * (1 + rounded_value)) return std::nullopt;
    return together;
  }

  /// Makes all joins. At first, a stretch gets at most `most` pieces, and then twice as many in each round: which ramp is
  /// faster depends on the velocities at its ends, and these change with the shorter ramps. A stretch that grows at once
  /// often extends to a slow place far away.
  void run(std::size_t most) {
    for (bool limited = true; limited; most = std::min(2 * most, not_limited)) {
      const std::size_t count = units_.size();
      limited = join(most);
      if (units_.size() == count) continue;  // the velocities stay the same
      path_detail::keep_memory(std::move(v_));
      v_ = velocities(units_);
      limited = true;
    }
  }

  /// One round. Returns true if a stretch with more than `most` pieces is possible.
  bool join(std::size_t most) {
    bool limited = false;
    std::size_t count = 0;  // units_[i] begins at v_[i]
    for (std::size_t k = 0; k < units_.size(); ++k, ++count) {
      double start = v_[k];
      const double end = v_[k + 1];
      Unit& unit = units_[k];
      Known& known = known_[k];
      while (count > 0 && may_join(units_[count - 1], unit, start)) {
        const Unit& before = units_[count - 1];
        if (before.pieces + unit.pieces > most) {
          limited = true;
          break;
        }
        Known& known_before = known_[count - 1];
        const Refusal join{v_[count - 1], start, end, known_before.first};
        if (known.refused == join) break;
        const Unit longer = joined(before, unit);
        const auto together = joined_duration(before, unit, longer, join, known_before, known);
        if (!together) {
          known.refused = join;
          break;
        }
        unit = longer;
        start = join.from;
        known = {.v0 = start, .v1 = end, .duration = *together, .first = join.first};
        --count;
      }
      v_[count] = start;
      if (count == k) continue;
      units_[count] = unit;
      known_[count] = known;
    }
    v_[count] = v_[units_.size()];
    units_.resize(count);
    known_.resize(count);
    v_.resize(count + 1);
    return limited;
  }

  std::vector<Unit> units_;
  std::vector<double> v_;
  std::vector<Known> known_;
  double duration_ = 0;
};

}  // namespace

LawInterval stretch_of(const Unit& unit, double v0, double v1) {
  LawInterval s;
  write_stretch(unit, v0, v1, s);
  return s;
}

LawStretches stations(std::vector<Unit> units) {
  const std::size_t constant = join_alike(units);
  std::vector<double> v = velocities(units);
  LawStretches best = timed(units, v, constant);
  if (!may_join_any(units, v)) {
    path_detail::keep_memory(std::move(units));
    path_detail::keep_memory(std::move(v));
    return best;
  }
  const Joins gradual(units, v, best, 2);
  const Joins at_once(std::move(units), std::move(v), best, not_limited);
  const Joins& faster = at_once.duration() < gradual.duration() ? at_once : gradual;
  if (!(faster.duration() < best.end_time())) return best;
  best = {};
  return faster.law();
}

}  // namespace jounce
