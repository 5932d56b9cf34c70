// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/overlap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/corners/blend.hpp"
#include "path/src/geometry/route.hpp"
#include "path/src/geometry/vector.hpp"
#include "path/src/timing/not_limited.hpp"
#include "path/src/timing/stations.hpp"
#include "path/src/timing/stretch.hpp"

// Leg k moves from rest to rest by s_k(t). If the next leg begins tau before its end, an axis is at
//
//   (1)  r = B - u a(t) + w b(t),     a: what is left of leg k,   b: what leg k + 1 has done
//
// a falls and b grows. The distance from the two lines is |u x w| min(a, b), which is greatest
// where a = b: one root. The distance from B is an extremum of degree 5 on each common phase. The
// jerk of an axis is at most |u_i| j + |w_i| j', and its acceleration likewise. So legs with
//
//   (2)  j <= J_i / (|u_i| + |w_i|),   a <= A_i / (|u_i| + |w_i|)
//
// may overlap by any time, within their velocity limits.

namespace jounce {
namespace {

using profiles_detail::rounded_root;
using profiles_detail::rounded_value;

using path_detail::unlimited;

constexpr double overlap_resolution = 1e-14;  ///< relative, of a bisection
/// Share of the greatest one: a shorter overlap saves no time.
constexpr double least_overlap = 1e-9;

struct Leg {
  Point start{}, direction{};
  LawInterval law;
  double up = 0, down = 0;  ///< s, durations of its first and last ramp
  double dwell = 0;         ///< s, dwell before it
  std::int32_t line = 0;
};

/// The part of a phase from a time after its start, with the given duration.
LawPhase part_of(const LawPhase& p, double from, double duration) {
  const Motion m = motion_of(std::span(&p, 1), from);
  return {duration, m.position, m.velocity, m.acceleration, p.jerk};
}

/// Phases of s(t) between two times of a leg.
std::vector<LawPhase> law_between(const LawInterval& law, double from, double to) {
  std::array<LawPhase, 7> phase;
  std::vector<LawPhase> out;
  double begin = 0;
  for (const LawPhase& p : std::span(phase).first(phases(law, phase))) {
    const double low = std::max(from, begin);
    const double high = std::min(to, begin + p.duration);
    if (high - low > rounded_value * law.duration)
      out.push_back(low > begin || high < begin + p.duration ? part_of(p, low - begin, high - low)
                                                             : p);
    begin += p.duration;
  }
  return out;
}

/// Both laws over the overlap, divided at the phases of both. The phases are divided in time: the coefficients of a
/// segment that is a tiny share of another one would have few digits.
struct Common {
  Segment before, behind;
};
std::vector<Common> common_phases(const Leg& a, const Leg& b, double overlap) {
  std::vector<LawPhase> f = law_between(a.law, a.law.duration - overlap, a.law.duration);
  std::vector<LawPhase> g = law_between(b.law, 0, overlap);
  std::vector<Common> out;
  std::size_t i = 0;
  std::size_t k = 0;
  while (i < f.size() && k < g.size()) {
    const double h = std::min(f[i].duration, g[k].duration);
    const auto take = [&](std::vector<LawPhase>& all, std::size_t& n) {
      LawPhase first = all[n];
      const double left = first.duration - h;
      if (left <= rounded_root * overlap)
        ++n;
      else
        all[n] = part_of(first, h, left);
      first.duration = h;
      return segment_of(first);
    };
    const Segment before = take(f, i);
    out.push_back({before, take(g, k)});
  }
  return out;
}

class Overlapping {
 public:
  Overlapping(const Program& program, const GroupLimits& limits, const OverlapOptions& options)
      : options_(options),
        route_(route_of(program)),
        settings_(program.settings().begin(), program.settings().end()),
        n_(program.axes()),
        m_(program.path_axes()),
        rates_(rates_of(limits, n_, m_)) {
    for (const PathPiece& p : route_.path.pieces())
      if (!settings_[p.settings].axes.empty())
        throw InputError("overlap", "",
                         "cannot be combined with limits of axes in a command: leave them out")
            .at({}, p.line);
    for (const PathPiece& p : route_.path.pieces())
      if (p.kind != PieceKind::line)
        throw InputError(
            "overlap", "",
            "is possible between lines only, and this command is not a line: leave out overlap")
            .at({}, p.line);
  }

  /// Plans the legs. `shared`: their rates are reduced by (2).
  [[nodiscard]] Overlapped run(bool shared) const {
    const std::vector<Leg> legs = legs_of(shared);
    std::vector<double> overlaps(legs.size() + 1, 0.0);  // overlap before each leg
    for (std::size_t k = 1; k < legs.size(); ++k)
      if (!route_.joints[k].rests) overlaps[k] = longest(legs[k - 1], legs[k]);
    return joined(legs, overlaps);
  }

 private:
  [[nodiscard]] std::vector<Leg> legs_of(bool shared) const {
    const auto pieces = route_.path.pieces();
    std::vector<Leg> legs(pieces.size());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const double* numbers = route_.path.numbers(k);
      for (std::size_t i = 0; i < n_; ++i) {
        legs[k].start[i] = numbers[i];
        legs[k].direction[i] = numbers[n_ + i] / pieces[k].length;
      }
      legs[k].line = pieces[k].line;
      legs[k].dwell = route_.joints[k].dwell;
    }
    for (std::size_t k = 0; k < legs.size(); ++k) {
      Unit unit;
      unit.length = pieces[k].length;
      unit.box = line_box(rates_, settings_[pieces[k].settings], legs[k].direction.data());
      if (!(unit.box.acceleration > 0 && unit.box.acceleration < unlimited))
        throw InputError("acceleration", unit.box.acceleration,
                         "is missing: add acceleration to the limits of each axis that moves, or "
                         "to [path.limits]")
            .at({}, pieces[k].line);
      if (shared) {
        if (k > 0 && !route_.joints[k].rests) lower(unit.box, legs[k - 1], legs[k]);
        if (k + 1 < legs.size() && !route_.joints[k + 1].rests)
          lower(unit.box, legs[k], legs[k + 1]);
      }
      LawInterval& law = legs[k].law = stretch_of(unit, 0, 0);
      legs[k].up = ramp_time(law.peak, law.acceleration, law.jerk);
      legs[k].down = ramp_time(law.peak, law.deceleration, law.jerk);
    }
    return legs;
  }

  void lower(Box& box, const Leg& a, const Leg& b) const {
    for (std::size_t i = 0; i < n_; ++i) {
      const double both = std::abs(a.direction[i]) + std::abs(b.direction[i]);
      if (!(both > 0)) continue;
      box.acceleration = std::min(box.acceleration, rates_.acceleration[i] / both);
      box.deceleration = std::min(box.deceleration, rates_.acceleration[i] / both);
      box.jerk = std::min(box.jerk, rates_.jerk[i] / both);
    }
  }

  [[nodiscard]] Segment axis(std::size_t i, const Leg& a, const Leg& b, const Common& c) const {
    const Segment first = scaled(c.before, a.direction[i], a.start[i]);
    return *sum(first, scaled(c.behind, b.direction[i]));
  }

  /// The longest overlap that keeps the limits and the deviation: the lower end of a bracket.
  [[nodiscard]] double longest(const Leg& a, const Leg& b) const {
    const double most = options_.share * std::min(a.down, b.up);
    if (!(most > 0)) return 0;
    if (holds(a, b, most)) return most;
    double low = 0;
    double high = most;
    for (int i = 0; i < 60 && high - low > overlap_resolution * most; ++i) {
      const double middle = (low + high) / 2;
      (holds(a, b, middle) ? low : high) = middle;
    }
    return low > least_overlap * most ? low : 0;
  }

  [[nodiscard]] bool holds(const Leg& a, const Leg& b, double overlap) const {
    const std::vector<Common> common = common_phases(a, b, overlap);
    for (const Common& c : common)
      for (std::size_t i = 0; i < n_; ++i) {
        const Segment f = axis(i, a, b, c);
        const double limits[] = {rates_.velocity[i], rates_.acceleration[i], rates_.jerk[i]};
        for (int order = 1; order <= 3; ++order)
          if (std::abs(segment_range(f, 0, f.length, order).peak().value) >
              limits[order - 1] * (1 + rounded_root))
            return false;
      }
    return !(options_.deviation < unlimited) || deviation(a, b, common) <= options_.deviation;
  }

  [[nodiscard]] double deviation(const Leg& a, const Leg& b,
                                 const std::vector<Common>& common) const {
    double least = unlimited;
    for (const Common& c : common) {
      std::array<Segment, max_axes> axes;
      for (std::size_t i = 0; i < n_; ++i) axes[i] = axis(i, a, b, c);
      least = std::min(least, least_distance(std::span(axes).first(n_), b.start, m_));
    }
    return least;
  }

  /// The greatest distance from the nearer line: |u x w| a at the instant at which a = b.
  [[nodiscard]] double one_sided(const Leg& a, const Leg& b, double overlap) const {
    const double begin = a.law.duration - overlap;
    double low = 0;
    double high = overlap;
    const auto left = [&](double t) { return a.law.length - motion_in(a.law, begin + t).position; };
    for (int i = 0; i < 100; ++i) {
      const double middle = (low + high) / 2;
      (left(middle) > motion_in(b.law, middle).position ? low : high) = middle;
    }
    const double cosine = vec::dot(a.direction, b.direction, m_);
    return std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine))) * left(low);
  }

  [[nodiscard]] Overlapped joined(const std::vector<Leg>& legs,
                                  const std::vector<double>& overlaps) const {
    std::vector<std::vector<Segment>> axes(n_);
    Overlapped out;
    double time = 0;
    const auto rest = [&](double dwell, const Point& at) {
      if (!(dwell > 0)) return;
      for (std::size_t i = 0; i < n_; ++i) axes[i].push_back(line(dwell, at[i], at[i]));
      time += dwell;
    };
    for (std::size_t k = 0; k < legs.size(); ++k) {
      const Leg& leg = legs[k];
      rest(leg.dwell, leg.start);
      out.stop_duration += leg.dwell + leg.law.duration;
      const double from = overlaps[k];
      const double to = leg.law.duration - overlaps[k + 1];
      for (const LawPhase& p : law_between(leg.law, from, to))
        for (std::size_t i = 0; i < n_; ++i)
          axes[i].push_back(scaled(segment_of(p), leg.direction[i], leg.start[i]));
      time += to - from;
      if (k + 1 == legs.size()) break;
      const Leg& next = legs[k + 1];
      OverlapRecord record{next.line, time, overlaps[k + 1], 0, 0};
      if (record.overlap > 0) {
        const std::vector<Common> common = common_phases(leg, next, record.overlap);
        for (const Common& c : common)
          for (std::size_t i = 0; i < n_; ++i) axes[i].push_back(axis(i, leg, next, c));
        record.deviation = deviation(leg, next, common);
        record.one_sided = one_sided(leg, next, record.overlap);
        time += record.overlap;
      }
      out.corners.push_back(record);
    }
    const Leg& last = legs.back();
    rest(route_.joints.back().dwell, vec::sum(last.start, last.direction, last.law.length));
    out.stop_duration += route_.joints.back().dwell;
    out.duration = time;
    for (std::vector<Segment>& segments : axes)
      out.axes.emplace_back(std::move(segments), 0, Extrapolation::hold);
    return out;
  }

  OverlapOptions options_;
  Route route_;
  std::vector<PathSettings> settings_;
  std::size_t n_, m_;
  Rates rates_;
};

}  // namespace

Overlapped overlapped(const Program& program, const GroupLimits& limits,
                      const OverlapOptions& options) {
  if (!(options.deviation > 0))
    throw InputError("deviation", options.deviation, "must be greater than 0");
  if (!(options.share >= 0 && options.share <= 1))
    throw InputError("share", options.share, "must be 0 to 1");
  const Overlapping motion(program, limits, options);
  Overlapped full = motion.run(false);
  Overlapped shared = motion.run(true);
  shared.stop_duration = full.stop_duration;
  return shared.duration < full.duration ? shared : full;
}

}  // namespace jounce
