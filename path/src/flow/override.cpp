// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/override.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "jounce/profiles/curve/query.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/flow/partial_law.hpp"
#include "path/src/plan/drawn.hpp"
#include "path/src/timing/not_limited.hpp"
#include "path/src/tolerances.hpp"

// The plan divides the path into units, each with a box (v, a, d, j): every law within the boxes
// keeps all limits. An override only lowers the velocities; for factors above 1, the units are
// those of a plan with the greatest factor. At each step of the override, the rest of the law is
// computed again, from a place with acceleration 0:
//
//   (1)  backward  b_k = min(c_k, F(b_k+1, L_k)),   c_k: the lowered velocities of the units
//   (2)  a descent, while the velocity is above that of the unit: one ramp down to it; or, if the
//        unit is too short, to the lowest velocity that it permits
//   (3)  forward   v_k+1 = min(b_k+1, F(v_k, L_k)),   as in stations.cpp
//
// The law that the step interrupts is itself within the boxes. The descent is at no place faster
// (hold.cpp), so it passes every corner and rest at most as fast as the interrupted law. The place
// with acceleration 0 is found by ending the current ramp with the greatest jerk. If (2) then
// fails, the ramp is completed instead, as in the interrupted law.

namespace jounce {
namespace {

using profiles_detail::rounded_digit;
using profiles_detail::rounded_sum;

using path_detail::unlimited;
constexpr double rounding = 1e-13;  ///< relative tolerance of velocities and lengths

void require_valid(std::span<const FactorRequest> steps) {
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const std::string key = "override[" + std::to_string(k + 1) + "]";
    const double before = k > 0 ? steps[k - 1].time : 0;
    if (!(steps[k].time >= before) || (k > 0 && steps[k].time == before) ||
        !std::isfinite(steps[k].time))
      throw InputError(key + ".time", steps[k].time,
                       k > 0
                           ? "must be greater than " + number(before) + ", that of the step before"
                           : "must not be negative");
    if (!(steps[k].factor >= 0 && steps[k].factor <= 2))
      throw InputError(key + ".factor", steps[k].factor, "must be 0 to 2");
  }
}

/// A place of a law at which the acceleration is zero.
struct Place {
  std::size_t unit = 0;
  double within = 0;  ///< q from the start of the unit
  double velocity = 0;
  double time = 0;
};

class Player {
 public:
  Player(const Plan& base, std::span<const FactorRequest> steps)
      : base_(base), steps_(steps), all_(units_of(base)) {
    find_speeds();
  }

  Plan run() {
    Place at;
    while (at.unit < all_.units.size()) {
      if (at.velocity == 0) {
        if (at.within == 0)
          out_.rest(base_.path(), all_.starts[at.unit], all_.units[at.unit].dwell);
        at.time = out_.time();
        if (factor_at(at.time) == 0 && !wait(at)) return made();
      }
      const std::vector<LawInterval> law = *law_from(at, factor_at(at.time));
      at = follow(law, at);
    }
    out_.rest(base_.path(), base_.path().length(), all_.last_dwell);
    return made();
  }

 private:
  [[nodiscard]] Plan made() const {
    PartialLaw law = out_;
    if (law.law.empty()) law.rest(base_.path(), 0, path_detail::shortest_rest * base_.duration());
    return {base_.path(),
            TimingLaw(law.law),
            {base_.junctions().begin(), base_.junctions().end()},
            base_.stop_duration(),
            base_.given()};
  }

  /// Computes the feed and the limit of velocity of each unit.
  void find_speeds() {
    const Path& path = base_.path();
    const Plan::Given& given = base_.given();
    const Rates rates = rates_of(given.limits, path.axes(), given.path_axes);
    std::vector<double> feeds;
    std::vector<double> limits;
    const auto drawn = base_.drawn().pieces();
    const std::vector<std::size_t> drawn_of = drawn_pieces(base_);
    for (std::size_t k = 0; k < path.pieces().size(); ++k) {
      const Derivatives bounds = derivatives_of(path, k, given.path_axes);
      const PathPiece& piece = drawn[drawn_of[k]];
      const Rates here = rates_on(rates, piece, given.settings, is_corner(piece));
      double limit = rates.path.velocity;
      for (std::size_t i = 0; i < path.axes(); ++i)
        if (bounds.first[i] > 0) limit = std::min(limit, here.velocity[i] / bounds.first[i]);
      feeds.push_back(feed_of(piece, given.settings));
      limits.push_back(limit);
    }
    for (const Unit& unit : all_.units) {
      const auto least = [&](const std::vector<double>& of) {
        const auto first = of.begin() + static_cast<std::ptrdiff_t>(unit.piece);
        return *std::min_element(first, first + static_cast<std::ptrdiff_t>(unit.pieces));
      };
      feed_.push_back(least(feeds));
      limit_.push_back(least(limits));
    }
  }

  [[nodiscard]] double factor_at(double t) const {
    double factor = 1;
    for (const FactorRequest& s : steps_)
      if (s.time <= t * (1 + rounded_digit)) factor = s.factor;
    return factor;
  }
  /// The time after t of the next step of the factor.
  [[nodiscard]] double next_change(double t) const {
    const double now = factor_at(t);
    for (const FactorRequest& s : steps_)
      if (s.time > t * (1 + rounded_digit) && s.factor != now) return s.time;
    return unlimited;
  }

  /// Rests until the override is above 0; false if it never is.
  bool wait(Place& at) {
    double until = at.time;
    while (until < unlimited && factor_at(until) == 0) until = next_change(until);
    if (until == unlimited) return false;
    out_.rest(base_.path(), all_.starts[at.unit] + at.within, until - at.time);
    at.time = until;
    return true;
  }

  [[nodiscard]] double speed(std::size_t k, double factor) const {
    const double wish = factor <= 1 ? factor * std::min(feed_[k], limit_[k]) : factor * feed_[k];
    return std::min(all_.units[k].box.velocity, wish);
  }

  /// The part of a unit after a place.
  [[nodiscard]] Unit part(std::size_t k, double within, double velocity) const {
    Unit unit = all_.units[k];
    unit.length -= within;
    unit.box.velocity = velocity;
    return unit;
  }

  /// Equation (1) at the start of each unit from `first` to the next rest.
  [[nodiscard]] std::vector<double> backward(std::size_t first, double factor) const {
    std::size_t last = first + 1;
    while (last < all_.units.size() && all_.units[last].entry > 0) ++last;
    std::vector<double> b(last - first + 1, 0.0);
    for (std::size_t k = last; k-- > first + 1;) {
      const Unit& unit = all_.units[k];
      const double cap = std::min({unit.entry, speed(k, factor), speed(k - 1, factor)});
      const double next = b[k + 1 - first];
      b[k - first] =
          unit.box.constant ? std::min(cap, next)
          : next >= cap
              ? cap
              : std::min(cap, reached(unit.length, next, unit.box.deceleration, unit.box.jerk));
    }
    return b;
  }

  static double reached(double length, double v, double acceleration, double jerk) {
    return std::max(v, entry_velocity(length, v, Ramp{acceleration, jerk}).value_or(v) *
                           (1 - path_detail::entry_rounding));
  }

  /// The law from a place to the next rest with this factor; nullopt if the velocity at the place
  /// is too high for it.
  [[nodiscard]] std::optional<std::vector<LawInterval>> law_from(const Place& from,
                                                                 double factor) const {
    PartialLaw law;
    double q = all_.starts[from.unit] + from.within;
    const auto add = [&](const Unit& unit, double v0, double v1) {
      LawInterval s = stretch_of(unit, v0, v1);
      s.start = q;
      q += s.length;
      law.add(s);
    };
    const std::vector<double> b = backward(from.unit, factor);
    double v = from.velocity;
    double within = from.within;
    for (std::size_t k = from.unit; k < from.unit + b.size() - 1; ++k, within = 0) {
      const Unit& planned = all_.units[k];
      if (v > planned.box.velocity * (1 + rounding)) return std::nullopt;
      const double next = b[k + 1 - from.unit];
      const double wish = speed(k, factor);
      Unit rest = part(k, within, wish);
      if (!(rest.length > rounding * planned.length)) continue;
      if (planned.box.constant) {
        rest.box.velocity = v;
        add(rest, v, v);
        continue;
      }
      const auto down = [&](double to) {
        return ramp_distance(v, to, planned.box.deceleration, planned.box.jerk);
      };
      const bool fits = v <= next || down(next) <= rest.length;
      if (v > wish * (1 + rounding) || !fits) {  // (2)
        double to = wish;
        const auto reaches = [&](double end) {
          return down(end) + ramp_distance(end, std::min(end, next), planned.box.deceleration,
                                           planned.box.jerk) <=
                 rest.length;
        };
        if (!(v > to) || !reaches(to)) to = next;
        const bool whole = !(v > to) || !(down(to) <= rest.length);
        if (whole) {
          to = lowest_end(planned.box, rest.length, v);
        }
        Unit ramp = rest;
        if (!whole || to == 0) ramp.length = std::min(rest.length, down(to));
        ramp.box.velocity = v;
        const double left = rest.length - ramp.length;
        add_ramp(ramp, v, to, q, law);
        v = to;
        if (v == 0) return std::move(law.law);  // a hold, or the end of the run
        rest.length = left;
        if (!(rest.length > rounding * planned.length)) continue;
      }
      const double end =
          v < next
              ? std::min(next, reached(rest.length, v, planned.box.acceleration, planned.box.jerk))
              : next;
      add(rest, v, end);
      v = end;
    }
    if (v > 0) return std::nullopt;  // no rest can be reached
    return std::move(law.law);
  }

  /// Appends one ramp over the whole length of a unit.
  static void add_ramp(const Unit& unit, double v0, double v1, double& q, PartialLaw& law) {
    LawInterval s;
    s.start = q;
    s.length = unit.length;
    s.v0 = s.peak = v0;
    s.v1 = v1;
    s.acceleration = unit.box.acceleration;
    s.deceleration = unit.box.deceleration;
    s.jerk = unit.box.jerk;
    s.piece = unit.piece;
    s.pieces = unit.pieces;
    std::array<LawPhase, 7> phase;
    const std::size_t count = phases(s, phase);
    for (std::size_t i = 0; i < count; ++i) s.duration += phase[i].duration;
    q += s.length;
    law.add(s);
  }

  /// Follows a law until the override changes or the law ends; returns the place from which to
  /// continue.
  Place follow(const std::vector<LawInterval>& law, const Place& from) {
    const double change = next_change(from.time);
    for (const LawInterval& s : law) {
      if (out_.time() + s.duration > change) {
        if (const auto left = leave(s, std::max(change - out_.time(), 0.0))) return *left;
        out_.add(s);
        const Place end = place(s.start + s.length, s.v1);
        if (end.velocity == 0 || goes_on(end)) return end;
      } else {
        out_.add(s);
      }
    }
    const LawInterval& last = law.back();
    return place(last.start + last.length, last.v1);
  }

  [[nodiscard]] bool goes_on(const Place& at) const {
    return at.unit < all_.units.size() && law_from(at, factor_at(at.time));
  }

  /// Leaves a stretch at t after its start, at a place within it where the acceleration is zero;
  /// nullopt if there is none.
  std::optional<Place> leave(const LawInterval& s, double t) {
    if (is_corner(s)) return std::nullopt;
    std::array<LawPhase, 7> phase;
    const std::size_t count = phases(s, phase);
    std::size_t i = 0;
    double begin = 0;
    while (i + 1 < count && begin + phase[i].duration <= t) begin += phase[i++].duration;
    const double change = out_.time() + t;
    const bool slower = factor_at(change) < factor_at(change * (1 - rounded_sum));
    const Motion now = motion_in(s, t);
    const double a = now.acceleration;
    if (a == 0 || (a > 0) == slower) {
      const double ending = std::isinf(s.jerk) ? 0 : std::abs(a) / s.jerk;
      const double v = now.velocity + (std::isinf(s.jerk) ? 0 : a * ending / 2);
      const double q = now.position + ending * (now.velocity + ending * a / 3);
      const Place there = located(s.start + q, v, change + ending);
      if (q < s.length && v > 0 && goes_on(there)) {
        out_.until(s, t);
        if (ending > 0)
          out_.phase(s, now.position, ending, {0, now.velocity, a, a > 0 ? -s.jerk : s.jerk});
        return Place{there.unit, there.within, v, out_.time()};
      }
    }
    // The end of the ramp to the peak.
    double end = begin + phase[i].duration;
    while (++i < count && phase[i].velocity != s.peak) end += phase[i].duration;
    if (i == count) return std::nullopt;
    const Place there = located(s.start + phase[i].position, s.peak, out_.time() + end);
    if (!goes_on(there)) return std::nullopt;
    out_.until(s, end);
    return Place{there.unit, there.within, s.peak, out_.time()};
  }

  [[nodiscard]] Place place(double q, double v) const { return located(q, v, out_.time()); }

  [[nodiscard]] Place located(double q, double v, double time) const {
    const auto next =
        std::upper_bound(all_.starts.begin(), all_.starts.end(), q + rounding * all_.starts.back());
    const auto k = static_cast<std::size_t>(next - all_.starts.begin()) - 1;
    if (k >= all_.units.size()) return {k, 0, v, time};
    const double within = std::max(0.0, q - all_.starts[k]);
    return {k, within <= rounding * all_.starts.back() ? 0 : within, v, time};
  }

  const Plan& base_;
  std::span<const FactorRequest> steps_;
  PlannedUnits all_;
  std::vector<double> feed_, limit_;  ///< one for each unit
  PartialLaw out_;
};

}  // namespace

Plan played(const Plan& plan, std::span<const FactorRequest> steps) {
  require_valid(steps);
  double greatest = 1;
  double first = unlimited;
  for (const FactorRequest& s : steps) {
    greatest = std::max(greatest, s.factor);
    if (s.factor != 1) first = std::min(first, s.time);
  }
  if (!(first < plan.duration())) return plan;
  const Plan base = by_stations(plan, greatest);
  return Player(base, steps).run();
}

}  // namespace jounce
