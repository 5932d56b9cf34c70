// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "jounce/profiles/curve/query.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "path/src/geometry/pieces.hpp"
#include "path/src/timing/box.hpp"
#include "path/src/timing/stretch.hpp"

// On an arc an axis is  r = m sin(k q + p) + h q + const  (k the angle per q, m > 0):
//
//   r' = m k cos + h,   r'' = -m k^2 sin,   r''' = -m k^3 cos,
//
// With M = m k, a = |q''| and j = |q'''|, its acceleration and its jerk are within their limits if
//
//   (1)  M sqrt(a^2 + (k v^2)^2) + |h| a                              <= A
//   (2)  M sqrt((j + k^2 v^3)^2 + (3 k v a)^2) + |h| j                <= J
//
// (Cauchy and Schwarz; r''' and r' have opposite signs, so j + k^2 v^3 is the worse case). A law of
// stations reaches its greatest velocity V without acceleration, so everywhere
//
//   (3)  v + a^2 / 2j <= V
//
// and it has less acceleration where it is faster. Let y = a^2 / 2j for the greatest acceleration;
// it is at most V / 2. Let A and J be reduced by what the drift h needs. Then it is sufficient that
//
//   (4)  k V^2 <= A / M,   a^2 + (k (V - y)^2)^2 <= (A / M)^2
//        (because (1) is convex in v if (3) is an equality)
//   (5)  (j + k^2 v^3)^2 + 18 k^2 j v^2 (V - v) <= (J / M)^2   for v in [0, V]
//
// For a ramp over dv, y is at most dv / 2. (5) is greatest at V, or at the smaller root of k^2 v^4
// - 8 j v + 6 j V, which is beyond 3 V / 4; its greatest value is convex in j. Of several
// velocities and jerks, the code takes the pair with the least duration of the motion over the arc
// between the velocities of its ends, including the time that its neighbors lose.
//
// One box for the whole ramp has the acceleration that is possible at its fastest place. Several
// boxes permit more: the ramp is divided at some velocities, and each part has its own box.

namespace jounce {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_sum;

/// Share of a square: the next step of Newton's is below rounding.
constexpr double newton_rest = 1e-12;
constexpr double last_place_step = 1e-8;  ///< share of the velocity
constexpr double least_cruise = 1e-6;     ///< share of the length of an arc
constexpr double least_gain = 1e-6;       ///< share of the time that makes stairs worth their zones
/// The limits of an arc, as limits of the law on it.
class ArcRates {
 public:
  ArcRates(const Rates& rates, const ArcNumbers& arc, double length) : k_(arc.sweep() / length) {
    std::array<double, max_axes> M{};
    std::array<double, max_axes> h{};
    most_acceleration_ = rates.path.total_acceleration;
    for (std::size_t i = 0; i < rates.axes; ++i) {
      M[i] = std::hypot(arc.cosine(i), arc.sine(i)) * k_;
      h[i] = std::abs(arc.drift(i)) / length;
      const double slope = M[i] + h[i];
      if (!(slope > 0)) continue;
      velocity_ = std::min(velocity_, rates.velocity[i] / slope);
      most_acceleration_ = std::min(most_acceleration_, rates.acceleration[i] / slope);
      most_jerk_ = std::min(most_jerk_, rates.jerk[i] / slope);
    }
    acceleration_ = rates.path.total_acceleration;
    for (std::size_t i = 0; i < rates.axes; ++i) {
      if (!(M[i] > 0)) continue;
      const auto left = [&](double limit,
                            double most) {  // at least by rounding what a drift of M leaves
        return std::max((limit - h[i] * most) / M[i], limit / (M[i] + h[i]));
      };
      if (rates.acceleration[i] < PathSettings::none)
        acceleration_ = std::min(acceleration_, left(rates.acceleration[i], most_acceleration_));
      if (rates.jerk[i] < PathSettings::none)
        jerk_ = std::min(jerk_, left(rates.jerk[i], most_jerk_));
    }
    velocity_ = std::min({velocity_,
                          std::sqrt(std::min(acceleration_, rates.path.normal_acceleration) / k_),
                          std::cbrt(jerk_ / (k_ * k_))});
  }

  /// The jerk that corresponds to the curvature at V. With jerks of this size, (4) leaves an
  /// acceleration at every velocity.
  [[nodiscard]] double natural_jerk(double V) const { return k_ * k_ * V * V * V; }
  /// The greatest constant velocity.
  [[nodiscard]] double velocity() const { return velocity_; }
  /// The rates of a slow motion.
  [[nodiscard]] double most_acceleration() const { return most_acceleration_; }
  [[nodiscard]] double most_jerk() const { return most_jerk_; }

  /// The greatest jerk j by (5); not positive if there is none.
  [[nodiscard]] double jerk(double V) const {
    if (jerk_ == PathSettings::none) return most_jerk_;
    const double normal = natural_jerk(V);
    double j = std::min(jerk_ - normal, most_jerk_);
    for (int step = 0; step < 30 && j > 0; ++step) {  // Newton, from above
      const double v = place_of_most_jerk(V, j);
      const double sum = j + k_ * k_ * v * v * v;
      const double room = 18 * k_ * k_ * v * v * (V - v);
      const double excess = sum * sum + room * j - jerk_ * jerk_;
      if (excess <= newton_rest * jerk_ * jerk_) break;
      j -= excess / (2 * sum + room);
    }
    return j;
  }

  /// The greatest acceleration a by (4) that a ramp over dv up to V may reach; not positive if
  /// there is none.
  [[nodiscard]] double acceleration(double V, double dv, double j) const {
    if (acceleration_ == PathSettings::none) return most_acceleration_;
    const double square = acceleration_ * acceleration_;
    if (j == PathSettings::none)
      return std::min(most_acceleration_,
                      std::sqrt(std::max(square - profiles_detail::square(k_ * V * V), 0.0)));
    const auto excess = [&](double y) {
      return 2 * j * y + profiles_detail::square(k_ * (V - y) * (V - y)) - square;
    };
    double y = dv / 2;
    double over = excess(y);
    for (int step = 0; step < 60 && over > newton_rest * square;
         ++step) {  // Newton, from above: convex
      const double v = V - y;
      const double slope = 2 * j - 4 * k_ * k_ * v * v * v;
      if (!(slope > 0) || !(over < slope * y)) return 0;
      y -= over / slope;
      over = excess(y);
    }
    return std::min(most_acceleration_, std::sqrt(2 * j * y));
  }

 private:
  /// The velocity at which the left side of (5) is greatest.
  [[nodiscard]] double place_of_most_jerk(double V, double j) const {
    double v = 0.75 * V;
    for (int step = 0; step < 20; ++step) {  // Newton, from below: convex
      const double cube = k_ * k_ * v * v * v;
      const double slope = 4 * cube - 8 * j;
      if (!(slope < 0)) return V;
      const double next = v - (cube * v - 8 * j * v + 6 * j * V) / slope;
      if (!(next < V)) return V;
      if (next - v <= last_place_step * V) break;
      v = next;
    }
    const double inside = j + k_ * k_ * v * v * v;
    const double at_top = j + k_ * k_ * V * V * V;
    const double room = 18 * k_ * k_ * v * v * (V - v) * j;
    return inside * inside + room > at_top * at_top ? v : V;
  }

  double k_;
  double velocity_ = PathSettings::none;
  double acceleration_ = PathSettings::none, jerk_ = PathSettings::none;  ///< A / M, J / M
  double most_acceleration_ = PathSettings::none, most_jerk_ = PathSettings::none;
};

/// A part of an arc on which the law covers `length` between two greatest velocities; a velocity of
/// 0 is a rest.
struct ArcWay {
  double length, entry, exit;
};

/// The search for the boxes of an arc.
class ArcSearch {
 public:
  ArcSearch(const ArcRates& limits, const Box& path, const ArcWay& way)
      : limits_(limits),
        path_(path),
        way_(way),
        slow_a_(std::min(limits.most_acceleration(), path.acceleration)),
        slow_j_(std::min(limits.most_jerk(), path.jerk)),
        best_(path) {
    const double most = std::min(path.velocity, limits.velocity());
    possible_ = slow_a_ > 0 && slow_j_ > 0 && std::isfinite(slow_a_) && std::isfinite(most);
    if (!possible_) return;
    beyond_ = std::min(path.velocity, 2 * most);
    fastest_ = most;
    if (rests() > 0)
      fastest_ = std::min(
          most, entry_velocity(way.length / rests(), 0, Ramp{slow_a_, slow_j_}).value_or(most));
  }

  [[nodiscard]] bool possible() const { return possible_; }

  /// The fastest box for the whole arc.
  [[nodiscard]] Box box() {
    if (!possible_) return path_;
    for (const double share : {1.0, 0.99, 0.97, 0.94, 0.9, 0.8, 0.7, 0.6, 0.5, 0.35, 0.2, 0.1, 0.05,
                               0.02, 0.01, 0.001}) {
      const double v = share * fastest_;
      if (way_.length / v > shortest_) break;
      for (const double j : jerks(v)) consider(v, j);
    }
    if (shortest_ == PathSettings::none) consider_slow_ends();
    for (const double step : {0.1, 0.05, 0.025, 0.0125, 0.006, 0.003, 0.0015})
      for (int round = 0; round < 2; ++round)
        for (const double faster : {1 - step, 1.0, 1 + step}) {
          const double v = std::min(fastest_, best_v_ * faster);
          const double most = most_jerk(v);
          for (const double more : {1 - step, 1.0, 1 + step})
            consider(v, std::min(most, best_j_ * more));
        }
    return best_;
  }

  /// Several zones (stairs), if they are faster than the single box.
  [[nodiscard]] ArcZones zones() {
    const Box whole = box();
    ArcZones best;
    best.add(way_.length, whole);
    if (!possible_ || shortest_ <= 1.02 * least_time()) return best;
    double best_top = 0;
    for (const double top : {1.0, 0.93, 0.85})
      if (climb(top * fastest_, {{0.7, 0.92, 1}, 3}, best)) best_top = top;
    if (best_top == 0) return best;
    for (const double top : {best_top, best_top * 0.97})
      for (const Steps& steps : {Steps{{0.8, 1}, 2}, Steps{{0.6, 0.85, 0.96, 1}, 4}})
        climb(top * fastest_, steps, best);
    return best;
  }

 private:
  /// Shares of the ramp at which its steps end.
  struct Steps {
    std::array<double, 4> share;
    std::size_t count;
  };
  struct Stairs {
    ArcZones zones;
    double time = 0, length = 0;
  };

  /// Keeps stairs up to the velocity v if they are faster than the best so far.
  bool climb(double v, const Steps& steps, ArcZones& best) {
    const Stairs up = stairs(way_.entry, v, steps);
    const Stairs down = stairs(way_.exit, v, steps);
    const double cruise = way_.length - up.length - down.length;
    if (!(cruise > least_cruise * way_.length) || up.zones.count + down.zones.count == 0)
      return false;
    const double time = up.time + down.time + cruise / v + lost(std::min(way_.entry, v)) +
                        lost(std::min(way_.exit, v));
    if (!(time < shortest_ * (1 - least_gain))) return false;
    shortest_ = time;
    best = {};
    for (std::size_t k = 0; k < up.zones.count; ++k) best.add(up.zones.zone[k]);
    best.add(cruise, (up.zones.count > 0 ? up : down).zones.last().box);
    for (std::size_t k = down.zones.count; k-- > 0;) best.add(down.zones.zone[k]);
    return true;
  }

  [[nodiscard]] int rests() const { return (way_.entry == 0) + (way_.exit == 0); }

  [[nodiscard]] double most_jerk(double v) const { return std::min(limits_.jerk(v), path_.jerk); }

  /// Jerks to be tried at the velocity v, the greatest first: shares of it, and below it multiples
  /// of the natural jerk.
  [[nodiscard]] std::array<double, 10> jerks(double v) const {
    const double most = most_jerk(v);
    std::array<double, 10> all{1, 0.85, 0.7, 0.5, 0.35, 0.2, 0.1, 0.05, 0.03, 0.02};
    for (double& j : all) j *= most;
    const double natural = limits_.natural_jerk(v);
    if (natural < 0.5 * most)
      for (std::size_t i = 0; i < 6; ++i)
        all[i + 4] = std::min(most, natural * std::array{3.0, 2.0, 1.6, 1.3, 1.0, 0.7}[i]);
    return all;
  }

  /// Time lost on a neighbor, because the velocity here is only v.
  [[nodiscard]] double lost(double v) const {
    if (!(v > 0)) return 0;
    return ramp_time(beyond_ - v, slow_a_, slow_j_) -
           ramp_distance(v, beyond_, slow_a_, slow_j_) / beyond_;
  }

  /// Duration with the accelerations and jerks of a slow motion.
  [[nodiscard]] double least_time() const {
    double time = way_.length / fastest_;
    for (const double v : {std::min(way_.entry, fastest_), std::min(way_.exit, fastest_)})
      time += lost(v) + ramp_time(fastest_ - v, slow_a_, slow_j_) -
              ramp_distance(v, fastest_, slow_a_, slow_j_) / fastest_;
    return time;
  }

  /// The box for ramps over dv up to v with this jerk; its acceleration is 0 if there is none.
  [[nodiscard]] Box with(double v, double dv, double j) const {
    const double a = j > 0 ? limits_.acceleration(v, dv, j) : 0;
    return {v, std::min(a, path_.acceleration), std::min(a, path_.deceleration), j};
  }

  void consider(double v, double jerk) {
    if (!(v <= fastest_) || !(way_.length / v < shortest_)) return;
    const Box box = with(v, v, jerk);
    const auto [velocity, a, d, j, constant] = box;
    if (!(a > 0)) return;
    const double v0 = std::min(v, way_.entry);
    const double v1 = std::min(v, way_.exit);
    double cruise = way_.length - ramp_distance(v0, v, a, j) - ramp_distance(v1, v, d, j);
    // The velocity that the length just permits has no cruise, also with rounding.
    if (std::abs(cruise) <= rounded_sum * way_.length) cruise = 0;
    double time = 0;
    if (cruise >= 0) {
      time = ramp_time(v - v0, a, j) + ramp_time(v - v1, d, j) + cruise / v + lost(v0) + lost(v1) +
             (rests() < 2 ? 0.01 * ramp_time(v, std::min(a, d), j) : 0);  // other ramps
    } else if (rests() == 2) {                                            // v is not reached
      const double least = std::min(a, d);
      time =
          2 * ramp_time(entry_velocity(way_.length / 2, 0, Ramp{least, j}).value_or(v), least, j);
    } else {
      return;  // a slower box reaches its velocity
    }
    if (!(time < shortest_ * (1 - rounded_input))) return;  // more than rounding
    shortest_ = time;
    best_v_ = v;
    best_j_ = jerk;
    best_ = box;
  }

  /// A short part of an arc next to a very slow corner: the velocity at its slower end needs no ramp there.
  void consider_slow_ends() {
    const double slow =
        rests() == 0 ? std::min(way_.entry, way_.exit) : std::max(way_.entry, way_.exit);
    for (const double share : {1.0, 0.5, 0.2, 0.1}) {
      const double v = share * std::min(slow, fastest_);
      for (const double j : jerks(v)) consider(v, j);
    }
  }

  /// The steps from one velocity up to v; empty if there is no solution.
  [[nodiscard]] Stairs stairs(double from, double v, const Steps& steps) const {
    Stairs result;
    double low = from;
    if (low >= v * (1 - rounded_input)) return result;  // a step of rounding needs no zone
    for (std::size_t k = 0; k < steps.count && low < v; ++k) {
      const double high = from + steps.share[k] * (v - from);
      Box best;
      double least = PathSettings::none;
      for (const double jerk : jerks(high)) {
        const Box box = with(high, high - low, jerk);
        const double a = std::min(box.acceleration, box.deceleration);
        if (!(a > 0)) continue;
        const double loss =
            ramp_time(high - low, a, box.jerk) - ramp_distance(low, high, a, box.jerk) / v;
        if (!(loss < least)) continue;
        least = loss;
        best = box;
      }
      if (least == PathSettings::none) {
        result.length = PathSettings::none;
        return result;
      }
      const double a = std::min(best.acceleration, best.deceleration);
      const double length = ramp_distance(low, high, a, best.jerk) * (1 + rounded_sum);
      // A law that is slower than expected needs the acceleration for its longer ramp. It is possible at this jerk.
      const Box wide = with(high, high, best.jerk);
      best.acceleration = std::max(best.acceleration, wide.acceleration);
      best.deceleration = std::max(best.deceleration, wide.deceleration);
      result.zones.add(length, best);
      result.length += length;
      result.time += ramp_time(high - low, a, best.jerk);
      low = high;
    }
    return result;
  }

  const ArcRates& limits_;
  Box path_;
  ArcWay way_;
  double slow_a_, slow_j_;
  bool possible_ = false;
  double fastest_ = 0, beyond_ = 0;
  double shortest_ = PathSettings::none;
  double best_v_ = 0, best_j_ = 0;
  Box best_;
};

}  // namespace

Box arc_box(const Rates& rates, const PathSettings& settings, const double* numbers, double length,
            double entry, double exit) {
  const ArcRates limits(rates, ArcNumbers(numbers, rates.axes), length);
  return ArcSearch(limits, path_box(rates, settings), {length, entry, exit}).box();
}

ArcZones arc_zones(const Rates& rates, const PathSettings& settings, const double* numbers,
                   double whole, double length, double entry, double exit) {
  const ArcRates limits(rates, ArcNumbers(numbers, rates.axes), whole);
  return ArcSearch(limits, path_box(rates, settings), {length, entry, exit}).zones();
}

}  // namespace jounce
