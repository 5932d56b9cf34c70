// SPDX-License-Identifier: Apache-2.0
#include "profiles/src/sequences/stretches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "profiles/src/sequences/sign.hpp"
#include "profiles/src/solver/brake.hpp"

// At an interior knot k, the velocity v and the acceleration a of axis i may differ from 0 as
// follows; d is the sign of its displacement before and after the knot:
//
//   (1)  d before = d after:   v d >= 0, a of either sign
//   (2)  they are opposite:    v = 0, a towards the next point: it brakes and speeds up in one
//   (3)  one of them is 0:     v = a = 0
//
// The search changes one knot at a time, which affects two stretches. The scale of its steps comes
// from the motion that stops at every knot. If that motion takes T for a distance h from rest to
// rest,
//
//   (4)  v scale = 2 h/T,   a scale = 4 h/T^2
//
// The search starts from the weighted harmonic mean of the mean velocities on both sides, which
// keeps a cubic interpolation monotone (F. N. Fritsch, J. Butland, SIAM J. Sci. Stat. Comput. 5
// (1984) 300-304):
//
//   (5)  v = (w1 + w2) / (w1/m1 + w2/m2),   w1 = T1 + 2 T2,   w2 = 2 T1 + T2,   m = h/T
//
// The search ends near states at which a phase of the profile vanishes, so phases of a microsecond
// are common. A table needs a knot at each end of a phase. If P is the greatest position, rounding
// of the positions gives a quintic of length L
//
//   (6)  a jerk of up to 120 e P / L^3
//
// The search rejects a state with a phase so short that (6) exceeds a thousandth of the axis' jerk
// j. A phase below 2^-44 of its stretch counts as none, because its knot can be omitted.

namespace jounce::profiles_detail {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

/// The least velocity of a profile in the direction d, and its greatest magnitude.
struct Reach {
  double least = none;
  double greatest = 0;

  void see(double v, double d) {
    least = std::min(least, v * d);
    greatest = std::max(greatest, std::abs(v));
  }
};

bool turns_back(const Profile& profile, double d) {
  Reach reach;
  reach.see(profile.start().velocity, d);
  reach.see(profile.end().velocity, d);
  double t = 0;
  for (std::size_t i = 0; i < profile.phases(); ++i) {
    const Profile::Phase phase = profile.phase(i);
    const Motion m = profile.at(t);
    if (i > 0) reach.see(m.velocity, d);
    // Time of the velocity's extremum. m.jerk may still be that of the previous phase.
    const double jerk = profile.order() == 3 ? phase.value : 0;
    const double level = jerk == 0 ? -1 : -m.acceleration / jerk;
    if (level > 0 && level < phase.duration) reach.see(m.velocity + m.acceleration * level / 2, d);
    t += phase.duration;
  }
  return reach.least < -0x1p-40 * reach.greatest;
}

/// True if the axis is within its bounds in this state, and can continue without leaving them.
bool is_inside(const MotionState& s, const Bounds& b) {
  constexpr double most = 1 + 0x1p-40;
  const auto within = [](double x, double min, double max) {
    return x <= max * most && x >= min * most;
  };
  return within(s.velocity, b.velocity_min, b.velocity_max) &&
         within(natural_velocity(s, b), b.velocity_min, b.velocity_max) &&
         within(s.acceleration, b.acceleration_min, b.acceleration_max);
}

/// The length for which (6) is a thousandth of the jerk; 0 if the jerk is not limited.
double shortest_phase(const Bounds& b, double largest) {
  const double jerk = std::min(b.jerk_max, -b.jerk_min);
  if (!std::isfinite(jerk)) return 0;
  return std::cbrt(120 * std::numeric_limits<double>::epsilon() * largest / (1e-3 * jerk));
}

bool has_short_phase(const Profile& profile, double shortest) {
  const double nothing = 0x1p-44 * profile.duration();
  for (std::size_t i = 0; i < profile.phases(); ++i)
    if (const double d = profile.phase(i).duration; d > nothing && d < shortest) return true;
  return false;
}

class ScaleSearch {
 public:
  ScaleSearch(const StretchBounds& bounds, std::span<Knot> knots)
      : bounds_(bounds),
        axes_(knots.front().size()),
        knots_(knots),
        rest_(profiles_detail::durations(bounds, knots)),
        time_(rest_),
        largest_(axes_, 0) {
    for (const Knot& knot : knots)
      for (std::size_t i = 0; i < axes_; ++i)
        largest_[i] = std::max(largest_[i], std::abs(knot[i].position));
  }

  void start();
  void refine(bool bends);

 private:
  [[nodiscard]] double way(std::size_t stretch, std::size_t axis) const {
    return knots_[stretch + 1][axis].position - knots_[stretch][axis].position;
  }
  /// The common direction by (1); 0 if the axis cannot pass.
  [[nodiscard]] double passing(std::size_t knot, std::size_t axis) const {
    const double before = sign(way(knot - 1, axis));
    return before == sign(way(knot, axis)) ? before : 0;
  }
  [[nodiscard]] bool turning(std::size_t knot, std::size_t axis) const {
    return way(knot - 1, axis) * way(knot, axis) < 0;
  }
  [[nodiscard]] double velocity_scale(std::size_t knot, std::size_t axis) const;
  [[nodiscard]] double acceleration_scale(std::size_t knot, std::size_t axis) const;
  [[nodiscard]] double harmonic(std::size_t knot, std::size_t axis) const;

  [[nodiscard]] std::vector<Knot> directions(std::size_t knot, bool bends) const;
  bool advance(std::size_t knot, const Knot& direction, double step);
  bool accept(std::size_t knot, const Knot& candidate);
  /// The duration of a stretch between two knots; infinite if there is none without very short
  /// phases.
  [[nodiscard]] double duration(std::size_t stretch, const Knot& from, const Knot& to) const;

  const StretchBounds& bounds_;
  std::size_t axes_;
  std::span<Knot> knots_;
  std::vector<double> rest_;     ///< durations of the motion at the start of the search
  std::vector<double> time_;     ///< present durations
  std::vector<double> largest_;  ///< greatest magnitude of each axis' position
};

double ScaleSearch::velocity_scale(std::size_t knot, std::size_t axis) const {  // (4)
  return 2 * std::max(std::abs(way(knot - 1, axis)) / rest_[knot - 1],
                      std::abs(way(knot, axis)) / rest_[knot]);
}

double ScaleSearch::acceleration_scale(std::size_t knot, std::size_t axis) const {  // (4)
  return 2 * velocity_scale(knot, axis) / std::min(rest_[knot - 1], rest_[knot]);
}

double ScaleSearch::harmonic(std::size_t knot, std::size_t axis) const {  // (5)
  if (passing(knot, axis) == 0) return 0;
  const double t1 = rest_[knot - 1];
  const double t2 = rest_[knot];
  return 3 * (t1 + t2) /
         ((t1 + 2 * t2) * t1 / way(knot - 1, axis) + (2 * t1 + t2) * t2 / way(knot, axis));
}

/// For each knot in turn: the greatest part of (5) that is faster than a stop there.
void ScaleSearch::start() {
  for (std::size_t k = 1; k + 1 < knots_.size(); ++k)
    for (double share = 1; share > 0x1p-6; share /= 2) {
      Knot candidate = knots_[k];
      for (std::size_t i = 0; i < axes_; ++i) candidate[i].velocity = share * harmonic(k, i);
      if (accept(k, candidate)) break;
    }
}

/// Varies the velocities at the knots and, with `bends`, also the accelerations. The first call is
/// without them, because an acceleration keeps a velocity from its bound.
void ScaleSearch::refine(bool bends) {
  constexpr double finest = 0x1p-14;
  constexpr int sweeps = 400;
  std::vector<std::vector<Knot>> directions(knots_.size());
  for (std::size_t k = 1; k + 1 < knots_.size(); ++k) directions[k] = this->directions(k, bends);
  double step = 0.25;
  for (int sweep = 0; sweep < sweeps && step >= finest; ++sweep) {
    bool better = false;
    for (std::size_t k = 1; k + 1 < knots_.size(); ++k)
      for (const Knot& direction : directions[k])
        better = advance(k, direction, step) || advance(k, direction, -step) || better;
    if (!better) step /= 2;
  }
}

/// The directions of the search: all velocities together; each velocity alone and, if requested,
/// each acceleration; both values of one axis, in the same and in opposite directions.
std::vector<Knot> ScaleSearch::directions(std::size_t knot, bool bends) const {
  const Knot nothing(axes_);
  std::vector<Knot> all{nothing};
  for (std::size_t i = 0; i < axes_; ++i) {
    const double v = passing(knot, i) * velocity_scale(knot, i);
    const bool limited =
        std::isfinite(bounds_[knot - 1][i].jerk_max) && std::isfinite(bounds_[knot][i].jerk_max);
    const bool free = bends && limited && (v != 0 || turning(knot, i));
    const double a = free ? acceleration_scale(knot, i) : 0;
    all[0][i].velocity = v;
    const auto add = [&](const MotionState& change) {
      all.push_back(nothing);
      all.back()[i] = change;
    };
    if (v != 0) add({0, v, 0});
    if (a != 0) add({0, 0, a});
    if (v != 0 && a != 0) {
      add({0, v, a});
      add({0, v, -a});
    }
  }
  return all;
}

bool ScaleSearch::advance(std::size_t knot, const Knot& direction, double step) {
  Knot candidate = knots_[knot];
  for (std::size_t i = 0; i < axes_; ++i) {
    candidate[i].velocity += step * direction[i].velocity;
    candidate[i].acceleration += step * direction[i].acceleration;
  }
  return accept(knot, candidate);
}

double ScaleSearch::duration(std::size_t stretch, const Knot& from, const Knot& to) const {
  const auto& bounds = bounds_[stretch];
  const Hop hop = profiles_detail::stretch(bounds, from, to);
  for (std::size_t i = 0; i < hop.profiles.size(); ++i)
    if (has_short_phase(hop.profiles[i], shortest_phase(bounds[i], largest_[i]))) return none;
  return hop.duration;
}

/// Accepts the candidate if it shortens the two adjacent stretches by more than rounding.
bool ScaleSearch::accept(std::size_t knot, const Knot& candidate) {
  for (std::size_t i = 0; i < axes_; ++i)
    if (candidate[i].velocity * passing(knot, i) < 0) return false;
  const double now = time_[knot - 1] + time_[knot];
  const double before = duration(knot - 1, knots_[knot - 1], candidate);
  if (!(before < now)) return false;
  const double after = duration(knot, candidate, knots_[knot + 1]);
  if (!(before + after < now * (1 - 0x1p-40))) return false;
  knots_[knot] = candidate;
  time_[knot - 1] = before;
  time_[knot] = after;
  return true;
}

}  // namespace

Hop stretch(std::span<const Bounds> axes, const Knot& from, const Knot& to) {
  std::vector<AxisMove> moves(axes.size());
  Hop result{none, std::vector<Profile>(axes.size())};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    moves[i] = {from[i], to[i], axes[i]};
    if (!is_inside(from[i], axes[i])) return result;
  }
  const Synchronized all = synchronize(moves, Sync::time, result.profiles);
  if (all.status != MoveStatus::ok) return result;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (turns_back(result.profiles[i], sign(to[i].position - from[i].position))) return result;
  result.duration = all.duration;
  return result;
}

std::vector<double> durations(const StretchBounds& bounds, std::span<const Knot> knots) {
  std::vector<double> all;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k)
    all.push_back(stretch(bounds[k], knots[k], knots[k + 1]).duration);
  return all;
}

void shorten(const StretchBounds& bounds, std::span<Knot> knots) {
  if (knots.size() < 3) return;
  ScaleSearch search(bounds, knots);
  search.start();
  search.refine(false);
  search.refine(true);
}

}  // namespace jounce::profiles_detail
