// SPDX-License-Identifier: Apache-2.0
// Several axes, against the witness.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "jounce/profiles/sequences/synchronize.hpp"

#include "profiles/proof/judge.hpp"

namespace jounce::proof {

namespace {

Case of(const AxisMove& axis) {
  return {axis.from, axis.to, axis.bounds, {}};
}

/// All axes' questions, for people.
std::string line_of(std::span<const AxisMove> axes, double least) {
  std::string text = "not before " + jounce::proof::text(least) + ":";
  for (const AxisMove& axis : axes) text += "\n    " + reproducer(of(axis));
  return text;
}

/// Every axis checked on its own; false if one failed.
bool check_axes(std::span<const AxisMove> axes, std::span<const Profile> profiles, double T,
                Tally& tally) {
  bool ok = true;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    Case c = of(axes[i]);
    c.duration = T;
    const Verdict verdict = check(profiles[i], c);
    tally.note(verdict, c);
    ok = ok && verdict.ok();
  }
  return ok;
}

/// The earliest T, not before `least`, that is possible for all.
Real common(const std::vector<std::vector<Span>>& axes, Real least) {
  std::size_t rounds = 1;  // each but the last begins at another span
  for (const std::vector<Span>& spans : axes) rounds += spans.size();
  for (; rounds > 0; --rounds) {
    Real T = least;
    for (const std::vector<Span>& spans : axes) {
      const auto next =
          std::find_if(spans.begin(), spans.end(), [T](const Span& s) { return s.to >= T; });
      if (next == spans.end()) return std::numeric_limits<Real>::infinity();
      T = std::max(T, next->from);
    }
    if (T == least) return T;
    least = T;
  }
  throw std::logic_error("the spans of the axes are not in order");
}

}  // namespace

void sync_time(Random& r, Tally& tally) {
  const int n = 1 + r.below(7);
  const char* const kinds[] = {"test",    "bench",  "ties",     "residual", "directional",
                               "decades", "second", "discrete", "outside",  "lowered"};
  const char* const kind = kinds[r.below(10)];
  std::vector<AxisMove> axes;
  for (int i = 0; i < n; ++i) {
    const Case c = draw(kind, r);
    axes.push_back({c.from, c.to, c.bounds});
  }
  const double least = r.below(3) == 0 ? r.uniform(0, 10) : 0;
  std::vector<Profile> out(axes.size());
  const Synchronized s = synchronize(axes, Sync::time, out, least);
  ++tally.cases;
  if (s.status != MoveStatus::ok)
    return tally.fail(std::string("sync of ") + kind + " refused: " + explain(s.status) +
                          ", axis " + std::to_string(s.axis + 1),
                      line_of(axes, least));
  if (!check_axes(axes, out, s.duration, tally)) return;
  compare(
      s.duration,
      [&](Real share) {
        std::vector<std::vector<Span>> spans;
        for (std::size_t i = 0; i < axes.size(); ++i) {
          const Verdict move =
              check(move_to(axes[i].from, axes[i].to, axes[i].bounds).profile, of(axes[i]));
          spans.push_back(reachable(of(axes[i]), move, share));
        }
        return common(spans, least);
      },
      [&] { return line_of(axes, least); }, tally);
}

namespace {

/// Axes that are integer multiples of one parameter, in exact arithmetic.
struct Line {
  Case parameter;  ///< the move along the line, with the bounds that all axes leave it
  std::vector<AxisMove> axes;
  std::vector<int> factors;
};

Bounds times(const Bounds& b, double f) {
  return within(f * b.velocity_max, f * b.acceleration_max, f * b.jerk_max);
}

Line line_drawn(Random& r) {
  const auto grid = [&r](double of) { return std::ldexp(r.below(1 << 21) - (1 << 20), -20) * of; };
  const bool rest = r.below(2) == 0;
  Line line;
  Case& c = line.parameter;
  c.from = {0, rest ? 0 : grid(2), rest ? 0 : grid(2)};
  c.to = {grid(8), rest ? 0 : grid(1), rest ? 0 : grid(1)};
  c.bounds = within(Bounds::none, Bounds::none, Bounds::none);
  const int n = 2 + r.below(6);
  for (int i = 0; i < n; ++i) {
    const int u = r.below(2) == 0 ? 1 + r.below(20) : -1 - r.below(20);
    const double p0 = grid(4);
    const auto multiple = [u, p0](const MotionState& s) {
      return MotionState{p0 + u * s.position, u * s.velocity, u * s.acceleration};
    };
    const Bounds own = within(r.uniform(1, 16), r.uniform(1, 16), r.uniform(1, 16));
    line.axes.push_back({multiple(c.from), multiple(c.to), times(own, std::abs(u))});
    line.factors.push_back(u);
    c.bounds = within(std::min(c.bounds.velocity_max, own.velocity_max),
                      std::min(c.bounds.acceleration_max, own.acceleration_max),
                      std::min(c.bounds.jerk_max, own.jerk_max));
  }
  return line;
}

bool inside_its_own(const AxisMove& axis) {
  return safe_start(axis.from, axis.bounds);
}

/// The motion of the parameter keeps its envelopes, and an axis that is inside its own bounds keeps
/// those as well.
bool check_line(const Line& line, std::span<const Profile> out, double T, Tally& tally) {
  bool ok = true;
  for (std::size_t i = 0; i < line.axes.size(); ++i) {
    const AxisMove& axis = line.axes[i];
    Case common = of(axis);
    common.duration = T;
    common.bounds = times(line.parameter.bounds, std::abs(line.factors[i]));
    std::vector<Case> cases{common};
    if (inside_its_own(axis)) cases.push_back(of(axis));
    for (const Case& c : cases) {
      const Verdict verdict = check(out[i], c);
      tally.note(verdict, c);
      ok = ok && verdict.ok();
    }
  }
  return ok;
}

/// All are as far along the line.
void expect_straight(const Line& line, std::span<const Profile> out, double t, Tally& tally) {
  const auto way = [&](std::size_t i) {
    return (out[i].at(t).position - line.axes[i].from.position) / line.factors[i];
  };
  const auto scale = [&](std::size_t i) {
    return static_cast<double>(check(out[i], of(line.axes[i])).scale.position) /
           std::abs(line.factors[i]);
  };
  for (std::size_t i = 1; i < out.size(); ++i)
    if (std::abs(way(i) - way(0)) > 1e-12 * (scale(i) + scale(0)))
      tally.fail("leaves the line", line.parameter);
}

/// True if the parameter starts outside although every axis is inside: the line cannot be kept.
bool must_refuse(const Line& line) {
  return !safe_start(line.parameter.from, line.parameter.bounds) &&
         std::all_of(line.axes.begin(), line.axes.end(), inside_its_own);
}

/// True if the parameter's own move, brought inside, would make an axis pass bounds that it keeps
/// now.
bool breaks_an_axis(const Line& line) {
  const Case& c = line.parameter;
  const Profile f = move_to(c.from, c.to, c.bounds).profile;
  for (std::size_t i = 0; i < line.axes.size(); ++i) {
    const AxisMove& axis = line.axes[i];
    if (inside_its_own(axis) &&
        !check(f.scaled(line.factors[i], axis.from, axis.to), of(axis)).ok())
      return true;
  }
  return false;
}

}  // namespace

void sync_phase(Random& r, Tally& tally) {
  const Line line = line_drawn(r);
  const Case& c = line.parameter;
  if (!safe_target(c.to, c.bounds) || c.to.position == 0) return;
  std::vector<Profile> out(line.axes.size());
  const Synchronized s = synchronize(line.axes, Sync::phase, out);
  ++tally.cases;
  const auto asked = [&] { return line_of(line.axes, 0); };
  if (must_refuse(line)) {
    if (s.status != MoveStatus::not_straight)
      tally.fail("the line cannot be kept, answered: " + std::string(explain(s.status)), asked());
    return;
  }
  if (s.status == MoveStatus::not_straight && breaks_an_axis(line)) return;
  if (s.status != MoveStatus::ok)
    return tally.fail(std::string("a straight line is refused: ") + explain(s.status), asked());
  if (!check_line(line, out, s.duration, tally)) return;
  expect_straight(line, out, s.duration * r.uniform(0, 1), tally);
  const Verdict move = check(move_to(c.from, c.to, c.bounds).profile, c);
  compare(
      s.duration, [&](Real share) { return minimum(reachable(c, move, share)); }, c, tally);
}

}  // namespace jounce::proof
