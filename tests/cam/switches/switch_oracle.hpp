// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "jounce/cam/switches/cam_switch.hpp"

/// The edges of cam switches by brute force: time goes in small steps, in long double, along a
/// motion in closed form; what was passed within a step is bisected. Written from the text of
/// cam_switch.hpp alone, for tests; it misses two passages within one of its steps.
namespace jounce::test {

using Real = long double;

/// x(t) = polynomial + sines, over [0, length].
struct ClosedForm {
  Real length = 1;
  std::vector<Real> c;                     // coefficients in t
  std::vector<std::array<Real, 3>> waves;  // amplitude, rad/s, rad

  [[nodiscard]] Real x(Real t) const {
    Real sum = 0;
    for (std::size_t k = c.size(); k-- > 0;) sum = sum * t + c[k];
    for (const auto& [a, w, p] : waves) sum += a * std::sin(w * t + p);
    return sum;
  }
  [[nodiscard]] Real v(Real t) const {
    Real sum = 0;
    for (std::size_t k = c.size(); k-- > 1;) sum = sum * t + c[k] * static_cast<Real>(k);
    for (const auto& [a, w, p] : waves) sum += a * w * std::cos(w * t + p);
    return sum;
  }
};

/// The motion on a grid of instants, evaluated once.
struct Grid {
  explicit Grid(const ClosedForm& motion, Real dt) {
    const auto n = std::llround(motion.length / dt);
    for (long long i = 0; i <= n; ++i) {
      t.push_back(motion.length * Real(i) / Real(n));
      x.push_back(motion.x(t.back()));
      v.push_back(motion.v(t.back()));
    }
  }
  std::vector<Real> t, x, v;
};

/// The value of something from each instant on.
using History = std::vector<std::pair<Real, long>>;

class SwitchOracle {
 public:
  SwitchOracle(const CamSwitchSpec& spec, const ClosedForm& motion, const Grid& grid)
      : spec_(spec), motion_(motion), grid_(grid) {}

  [[nodiscard]] std::map<int, std::vector<SwitchEdge>> edges() const {
    std::map<int, std::vector<std::size_t>> tracks;
    for (std::size_t i = 0; i < spec_.switches.size(); ++i)
      tracks[spec_.switches[i].track].push_back(i);
    std::map<int, std::vector<SwitchEdge>> all;
    for (const auto& [track, members] : tracks) all[track] = edges_of(track, members);
    return all;
  }

 private:
  using Function = std::function<Real(Real)>;

  /// x - c v, where c depends on the direction.
  struct Compensated {
    Real forwards, backwards;
    [[nodiscard]] Real operator()(Real x, Real v) const {
      return x - (v > 0 ? forwards : backwards) * v;
    }
  };

  /// The first instant in (a, b] with f > 0, where f <= 0 at a and > 0 at b.
  static Real bisect(const Function& f, Real a, Real b) {
    for (int i = 0; i < 60; ++i) {
      const Real middle = (a + b) / 2;
      (f(middle) > 0 ? b : a) = middle;
    }
    return b;
  }

  /// Number of p, p + P, ... that are behind, by the rule of hysteresis.
  [[nodiscard]] History passed(const Compensated& y, Real p, Real h) const {
    const Real P = spec_.period.value_or(0);
    const auto below = [&](Real value) -> long {
      return P > 0 ? std::lround(std::floor((value - p) / P)) + 1 : (value > p ? 1 : 0);
    };
    const auto f = [&](Real t) { return y(motion_.x(t), motion_.v(t)); };
    History history{{0, below(f(0))}};
    bool near = false;
    Real at = 0;  // the boundary that it is near to
    long up = 0;  // count of those passed above it
    for (std::size_t i = 1; i < grid_.t.size(); ++i) {
      const Real b = grid_.t[i];
      const Real now = y(grid_.x[i], grid_.v[i]);
      for (Real from = grid_.t[i - 1];;) {
        const long n = history.back().second;
        const Real upper = near ? at + h : (P > 0 ? p + Real(n) * P : (n == 0 ? p : infinite));
        const Real lower = near ? at - h : (P > 0 ? p + Real(n - 1) * P : (n == 1 ? p : -infinite));
        const bool rises = now > upper;
        if (!rises && !(now < lower)) break;
        from = rises ? bisect([&](Real s) { return f(s) - upper; }, from, b)
                     : bisect([&](Real s) { return lower - f(s); }, from, b);
        if (near) {
          near = false;
          if (n != (rises ? up : up - 1)) history.emplace_back(from, rises ? up : up - 1);
        } else {
          near = h > 0;
          at = rises ? upper : lower;
          up = rises ? n + 1 : n;
          history.emplace_back(from, rises ? n + 1 : n - 1);
        }
      }
    }
    return history;
  }

  /// 1 forwards, -1 backwards, 0 not known.
  [[nodiscard]] History heading(Real h) const {
    History history{{0, 0}};
    Real low = motion_.x(0);
    Real high = low;
    for (std::size_t i = 1; i < grid_.t.size(); ++i) {
      const Real t = grid_.t[i - 1];
      const Real b = grid_.t[i];
      const Real x = grid_.x[i];
      if ((grid_.v[i - 1] > 0) != (grid_.v[i] > 0)) {  // the extreme lies between
        const Real extreme = motion_.x(turn(i, t));
        low = std::min(low, extreme);
        high = std::max(high, extreme);
      }
      const long sign = history.back().second;
      if (sign <= 0 && x > low + h) {
        history.emplace_back(
            h > 0 ? bisect([&](Real s) { return motion_.x(s) - low - h; }, t, b) : around(i), 1);
        high = x;
      } else if (sign >= 0 && x < high - h) {
        history.emplace_back(
            h > 0 ? bisect([&](Real s) { return high - h - motion_.x(s); }, t, b) : around(i), -1);
        low = x;
      }
      low = std::min(low, x);
      high = std::max(high, x);
    }
    return history;
  }

  [[nodiscard]] Real around(std::size_t i) const { return turn(i, grid_.t[i < 2 ? 0 : i - 2]); }

  /// The reversal between a and the end of step i: the zero of the velocity, or the step's start.
  [[nodiscard]] Real turn(std::size_t i, Real a) const {
    const Real b = grid_.t[i];
    if ((motion_.v(a) > 0) == (motion_.v(b) > 0)) return grid_.t[i - 1];
    const Real sign = motion_.v(b) > 0 ? 1 : -1;
    return bisect([&](Real s) { return sign * motion_.v(s); }, a, b);
  }

  static long value(const History& history, Real t) {
    long now = history.front().second;
    for (const auto& [time, n] : history)
      if (time <= t) now = n;
    return now;
  }

  [[nodiscard]] std::vector<SwitchEdge> edges_of(int track,
                                                 const std::vector<std::size_t>& members) const {
    const SwitchTrack options = spec_.options(track);
    const Real h = options.hysteresis;
    const double on = options.on_compensation;
    const double off = options.off_compensation;
    const History sign = heading(h);
    std::vector<std::function<long(Real)>> states;  // 1 on, 0 off, -1 not known
    std::vector<Real> times;
    const auto remember = [&](const History& history) {
      for (const auto& entry : history) times.push_back(entry.first);
    };
    remember(sign);
    for (const std::size_t i : members) {
      const CamSwitch& s = spec_.switches[i];
      const long asked = s.axis_direction == AxisDirection::positive ? 1 : -1;
      const bool both = s.axis_direction == AxisDirection::both;
      if (s.mode == CamSwitchMode::time) {
        const History history = passed({on, on}, s.first_on_position, h);
        std::vector<std::pair<Real, Real>> pulses;
        for (std::size_t k = 1; k < history.size(); ++k)
          if (both || history[k].second - history[k - 1].second == asked) {
            pulses.emplace_back(history[k].first, history[k].first + *s.duration + off - on);
            times.push_back(pulses.back().first);
            times.push_back(pulses.back().second);
          }
        states.push_back([pulses](Real t) {
          return std::any_of(pulses.begin(), pulses.end(),
                             [t](const auto& p) { return t >= p.first && t < p.second; })
                     ? 1L
                     : 0L;
        });
        continue;
      }
      Real last = *s.last_on_position;
      if (last < s.first_on_position) last += *spec_.period;
      const History lower = passed({on, off}, s.first_on_position, h);
      const History upper = passed({off, on}, last, h);
      remember(lower);
      remember(upper);
      states.push_back([=](Real t) -> long {
        if (value(lower, t) <= value(upper, t)) return 0;
        if (both || value(sign, t) == asked) return 1;
        return value(sign, t) == 0 ? -1 : 0;
      });
    }
    const auto level = [&](Real t) {
      bool any = false;
      bool unknown = false;
      for (const auto& state : states) {
        any = any || state(t) == 1;
        unknown = unknown || state(t) == -1;
      }
      if (!options.enabled) return false;
      return !any && unknown ? options.initial : any != options.inverted;
    };
    std::sort(times.begin(), times.end());
    std::vector<SwitchEdge> edges;
    bool now = level(0);
    for (const Real t : times)
      if (t > 0 && t <= motion_.length && level(t) != now) {
        now = !now;
        edges.push_back({static_cast<double>(t), track, now});
      }
    return edges;
  }

  static constexpr Real infinite = std::numeric_limits<Real>::infinity();
  const CamSwitchSpec& spec_;
  const ClosedForm& motion_;
  const Grid& grid_;
};

}  // namespace jounce::test
