// Several axes, against the witness.
#include <algorithm>
#include <cmath>

#include "jounce/profiles/synchronise.hpp"

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
  for (;;) {
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
}

}  // namespace

void sync_time(Random& r, Tally& tally) {
  const int n = 1 + r.below(7);
  const char* const kinds[] = {"test",        "bench",   "ties",   "residual",
                               "directional", "decades", "second", "discrete"};
  const char* const kind = kinds[r.below(8)];
  std::vector<AxisMove> axes;
  for (int i = 0; i < n; ++i) {
    const Case c = draw(kind, r);
    axes.push_back({c.from, c.to, c.bounds});
  }
  const double least = r.below(3) == 0 ? r.uniform(0, 10) : 0;
  std::vector<Profile> out(axes.size());
  const Synchronised s = synchronise(axes, Sync::time, out, least);
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

/// States on one line: all axes are integer multiples of one of them, in exact arithmetic.
void sync_phase(Random& r, Tally& tally) {
  const int n = 2 + r.below(6);
  const auto grid = [&r](double of) { return std::ldexp(r.below(1 << 21) - (1 << 20), -20) * of; };
  const bool rest = r.below(2) == 0;
  const double d = grid(8);
  const MotionState from{0, rest ? 0 : grid(1), rest ? 0 : grid(1)};
  const MotionState to{d, rest ? 0 : grid(1), rest ? 0 : grid(1)};
  Bounds least;  // of the common parameter
  std::vector<AxisMove> axes;
  for (int i = 0; i < n; ++i) {
    const int u = r.below(2) == 0 ? 1 + r.below(20) : -1 - r.below(20);
    const double p0 = grid(4);
    const auto times = [u, p0](const MotionState& s) {
      return MotionState{p0 + u * s.position, u * s.velocity, u * s.acceleration};
    };
    const double f = std::abs(u);
    const Bounds b = within(f * r.uniform(1, 16), f * r.uniform(1, 16), f * r.uniform(1, 16));
    axes.push_back({times(from), times(to), b});
    least.velocity_max = std::min(least.velocity_max, b.velocity_max / f);
    least.acceleration_max = std::min(least.acceleration_max, b.acceleration_max / f);
    least.jerk_max = std::min(least.jerk_max, b.jerk_max / f);
  }
  least = within(least.velocity_max, least.acceleration_max, least.jerk_max);
  if (!safe_target(to, least) || !safe_start(from, least) || d == 0) return;
  std::vector<Profile> out(axes.size());
  const Synchronised s = synchronise(axes, Sync::phase, out);
  ++tally.cases;
  const Case line{from, to, least, {}};
  if (s.status != MoveStatus::ok)
    return tally.fail(std::string("a straight line is refused: ") + explain(s.status), line);
  if (!check_axes(axes, out, s.duration, tally)) return;
  const double t = s.duration * r.uniform(0, 1);
  const auto way = [&](std::size_t i) {
    return (out[i].at(t).position - axes[i].from.position) /
           (axes[i].to.position - axes[i].from.position);
  };
  for (std::size_t i = 1; i < axes.size(); ++i)
    if (std::abs(way(i) - way(0)) >
        1e-12 * static_cast<double>(check(out[i], of(axes[i])).scale.position /
                                        std::abs(axes[i].to.position - axes[i].from.position) +
                                    check(out[0], of(axes[0])).scale.position /
                                        std::abs(axes[0].to.position - axes[0].from.position)))
      tally.fail("leaves the line", line);
  const Verdict move = check(move_to(from, to, least).profile, line);
  compare(
      s.duration, [&](Real share) { return minimum(reachable(line, move, share)); }, line, tally);
}

}  // namespace jounce::proof
