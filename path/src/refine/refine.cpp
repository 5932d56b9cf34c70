// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/refine.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "jounce/path/along.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/refine/speed_problem.hpp"
#include "path/src/timing/box.hpp"
#include "path/src/timing/laws.hpp"
#include "path/src/timing/not_limited.hpp"
#include "path/src/timing/window.hpp"

// A run is the motion between two rests. Let B = q'^2 at nodes along the run. Between two nodes, B
// is linear, so the acceleration a along the path is constant. The nodes are equally spaced in time,
// by w, for a law that is everywhere faster than the result, with the squared velocity B0 >= B. Then
// the law of the run is the average of these phases over w, with the jerk j = (a_k - a_k-1) / w, and
//
//   (1)  r' a + r'' B          within the limit of acceleration
//   (2)  r' j + 3 r'' sqrt(B0) a + r''' sqrt(B0) B    within the limit of jerk
//
// for each axis, are linear in B, and (2) is safe because B <= B0. The least duration under (1), (2)
// and the limits of velocity is a convex problem (speed_problem.cpp). A few such problems are solved,
// each with a B0 nearer to the last B. (1) and (2) are sampled. So the exact extrema of the axes are
// computed at the end. Where they exceed a limit, the limit is lowered for the next problem; the
// rest of the excess is removed by stretching the time of the run.

namespace jounce {
namespace {

using path_detail::unlimited;
using profiles_detail::rounded_input;
using profiles_detail::rounded_sum;

constexpr std::size_t pieces_a_node = 4;     ///< on curves
constexpr std::size_t nodes_a_stretch = 12;  ///< for each stretch of the law, on all other pieces
constexpr std::size_t least_nodes = 800;
constexpr std::size_t most_nodes = 30000;
constexpr std::size_t most_nodes_of_all_runs = 400'000;
/// B0 / B - 1 of the successive problems.
constexpr double margins[] = {1.5, 1, 0.8, 0.6, 0.4, 0.3, 0.2, 0.12, 0.06, 0.03};
constexpr double last_margin = 0.02;
constexpr int corrections = 3;       ///< rounds in which limits are lowered
constexpr double coarse_gap = 2e-2;  ///< share of the duration
constexpr double fine_gap = 1e-5;
constexpr double start_use = 0.9;      ///< greatest share of the limits of a start
constexpr double least_saving = 1e-6;  ///< share of the duration of a run
constexpr std::size_t orders = 3;

/// Squared velocities at places of a run; linear between them.
struct Speeds {
  std::vector<double> q, b;
};

/// A part of the plan from rest to rest.
struct LawRun {
  std::size_t begin = 0, end = 0;  ///< its stretches
  double start = 0, length = 0;    ///< q
  double time = 0, duration = 0;   ///< s
  std::size_t piece = 0, pieces = 0;
};

std::vector<LawRun> runs_of(std::span<const LawInterval> law) {
  std::vector<LawRun> runs;
  for (std::size_t i = 0; i < law.size();) {
    if (law[i].pieces == 0) {
      ++i;
      continue;
    }
    LawRun run{i, i + 1, law[i].start, 0, law[i].time, 0, law[i].piece, 0};
    while (run.end < law.size() && law[run.end].pieces > 0 && law[run.end].v0 > 0) ++run.end;
    const LawInterval& last = law[run.end - 1];
    run.length = last.start + last.length - run.start;
    run.duration = last.time + last.duration - run.time;
    run.pieces = last.piece + last.pieces - run.piece;
    runs.push_back(run);
    i = run.end;
  }
  return runs;
}

/// Duration of the part after node k.
double duration_of(const Speeds& speeds, std::size_t k) {
  return 2 * (speeds.q[k + 1] - speeds.q[k]) /
         (std::sqrt(speeds.b[k]) + std::sqrt(speeds.b[k + 1]));
}

/// Places with equal times between them, and the accelerations as B is there.
Speeds equal_times(const Speeds& speeds, std::size_t count) {
  std::vector<double> times{0};
  for (std::size_t k = 0; k + 1 < speeds.q.size(); ++k)
    times.push_back(times.back() + duration_of(speeds, k));
  Speeds out{{speeds.q.front()}, {0}};
  std::size_t k = 0;
  for (std::size_t i = 1; i < count; ++i) {
    const double t = times.back() * static_cast<double>(i) / static_cast<double>(count);
    while (k + 2 < times.size() && times[k + 1] <= t) ++k;
    const double h = times[k + 1] - times[k];
    const double v0 = std::sqrt(speeds.b[k]);
    const double a = (std::sqrt(speeds.b[k + 1]) - v0) / h;
    const double s = t - times[k];
    const double v = v0 + a * s;
    out.q.push_back(speeds.q[k] + s * (v0 + a * s / 2));
    out.b.push_back(v * v);
  }
  out.q.push_back(speeds.q.back());
  out.b.push_back(0);
  return out;
}

/// Factors up to 1 of the limits of acceleration and jerk of each axis, over equal parts of a run.
class Lowered {
 public:
  Lowered(const LawRun& run, std::size_t axes, std::size_t parts)
      : run_(run), parts_(parts), factors_(axes * parts * orders, 1.0), axes_(axes) {}

  [[nodiscard]] double at(std::size_t axis, std::size_t order, double q) const {
    return factors_[index(axis, order, part_at(q))];
  }
  void lower(std::size_t axis, std::size_t order, double q0, double q1, double factor) {
    const std::size_t last = std::min(part_at(q1) + 1, parts_ - 1);
    for (std::size_t k = part_at(q0); k <= last; ++k) {
      double& f = factors_[index(axis, order, k)];
      f = std::max(f * factor, 0.5);
    }
  }

 private:
  [[nodiscard]] std::size_t part_at(double q) const {
    const double share = std::clamp((q - run_.start) / run_.length, 0.0, 1.0);
    return std::min(static_cast<std::size_t>(share * static_cast<double>(parts_)), parts_ - 1);
  }
  [[nodiscard]] std::size_t index(std::size_t axis, std::size_t order, std::size_t part) const {
    return (part * axes_ + axis) * orders + order;
  }

  const LawRun& run_;
  std::size_t parts_;
  std::vector<double> factors_;
  std::size_t axes_;
};

/// The convex problem of a run.
class RunProblem {
 public:
  RunProblem(const Plan& plan, const LawRun& run, const Lowered& lowered)
      : plan_(plan),
        path_(plan.path()),
        run_(run),
        lowered_(lowered),
        rates_(reserved(rates_of(plan.given().limits, path_.axes(), plan.given().path_axes))),
        n_(path_.axes()) {
    for (std::size_t k = 0; k < run.pieces; ++k)
      speeds_.push_back(derivatives_of(path_, run.piece + k, rates_.path_axes).speed);
  }

  /// The problem with nodes at the places of `most`, whose velocities bound the result.
  SpeedProblem at(const Speeds& most, double window) {
    SpeedProblem p;
    const std::size_t cells = most.q.size() - 1;
    window_ = window;
    p.most = most.b;
    for (std::size_t k = 0; k < cells; ++k) p.cells.push_back(most.q[k + 1] - most.q[k]);
    piece_ = run_.piece;
    for (std::size_t k = 0; k <= cells; ++k) {
      const double from = k > 0 ? middle(most, k - 1) : most.q[0];
      const double to = k < cells ? middle(most, k) : most.q[cells];
      while (piece_ + 1 < run_.piece + run_.pieces && path_.pieces()[piece_ + 1].start <= from)
        ++piece_;
      if (piece_ > run_.piece) --piece_;
      const auto add_at = [&](double q, double share) {
        std::size_t m = piece_;
        while (m + 1 < run_.piece + run_.pieces && path_.pieces()[m + 1].start <= q) ++m;
        add(p, most, k, m, q, share);
      };
      add_at(from, 0);
      // The ends of pieces within the phase or just beside it, from both sides.
      const double beside = 0.05 * (to - from);
      for (std::size_t m = piece_; m + 1 < run_.piece + run_.pieces; ++m) {
        const double joint = path_.pieces()[m + 1].start;
        if (joint > to + beside) break;
        if (joint < from - beside) continue;
        const double share = std::clamp((joint - from) / (to - from), 0.0, 1.0);
        add(p, most, k, m, joint, share);
        add(p, most, k, m + 1, joint, share);
      }
      add_at(most.q[k], (most.q[k] - from) / (to - from));
      add_at(to, 1);
    }
    return p;
  }

 private:
  /// The place at half of the time of a cell.
  static double middle(const Speeds& s, std::size_t k) {
    const double v0 = std::sqrt(s.b[k]);
    const double v1 = std::sqrt(s.b[k + 1]);
    const double share = v0 + v1 > 0 ? (3 * v0 + v1) / (4 * (v0 + v1)) : 0.5;
    return s.q[k] + share * (s.q[k + 1] - s.q[k]);
  }

  /// Adds the limits at one place of the phase around node k: `share` from 0, where the
  /// acceleration is that of the cell before the node, to 1, where it is that of the cell after it.
  void add(SpeedProblem& p, const Speeds& most, std::size_t k, std::size_t piece_index, double q,
           double share) {
    const std::size_t cells = p.cells.size();
    const PathPiece& piece = path_.pieces()[piece_index];
    std::array<Jet, max_axes> jets{};
    path_.jets(piece_index, std::clamp(q - piece.start, 0.0, piece.length),
               std::span(jets).first(n_));
    const PathSettings& own = plan_.given().settings[piece.settings];
    // Coefficients of the three nodes from `first` on: of a, of j and of B.
    const std::size_t first = std::min(k > 0 ? k - 1 : 0, cells - 2);
    const std::size_t at = k - first;
    std::array<double, 3> a{}, j{}, b{};
    b[at] = 1;
    if (k > 0) {
      const double slope = 0.5 / p.cells[k - 1];
      a[at] += (1 - share) * slope;
      a[at - 1] -= (1 - share) * slope;
      j[at] -= slope / window_;
      j[at - 1] += slope / window_;
    }
    if (k < cells) {
      const double slope = 0.5 / p.cells[k];
      a[at] -= share * slope;
      a[at + 1] += share * slope;
      j[at] -= slope / window_;
      j[at + 1] += slope / window_;
    }
    // B at the place.
    if (share < 0.5 && k > 0) {
      b[at] = 0.5 + share;
      b[at - 1] = 0.5 - share;
    } else if (share > 0.5 && k < cells) {
      b[at] = 1.5 - share;
      b[at + 1] = share - 0.5;
    }
    double v = 0;
    for (std::size_t i = 0; i < 3; ++i) v += b[i] * most.b[first + i];
    v = std::sqrt(v);
    const auto row = [&](double of_a, double of_j, double of_b, double limit, double low) {
      if (!(limit < unlimited)) return;
      SpeedRow next{{}, low, static_cast<std::uint32_t>(first)};
      for (std::size_t i = 0; i < 3; ++i)
        next.c[i] = (of_a * a[i] + of_j * j[i] + of_b * b[i]) / limit;
      p.rows.push_back(next);
    };
    double fastest = std::min(feed_of(piece, plan_.given().settings), rates_.path.velocity);
    if (is_corner(piece) && own.corner == Corner::velocity) fastest = std::min(fastest, own.value);
    fastest /= speeds_[piece_index - run_.piece];
    double bend = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      const Jet& r = jets[i];
      if (i < rates_.path_axes) bend += r[2] * r[2];
      if (r[1] != 0) fastest = std::min(fastest, rates_.velocity[i] / std::abs(r[1]));
      row(r[1], 0, r[2], rates_.acceleration[i] * lowered_.at(i, 1, q), 1);
      const double jerk = rates_.jerk[i] * lowered_.at(i, 2, q);
      row(3 * r[2] * v, r[1], r[3] * v, jerk, 1);
      if (share == 1) row(3 * r[2] * v, 0, r[3] * v, jerk, 1);  // between two phases
    }
    for (std::size_t i = 0; i < 3; ++i)
      if (b[i] > 0 && first + i > 0 && first + i < cells)
        p.most[first + i] = std::min(p.most[first + i], fastest * fastest);
    const PathLimits& limits = rates_.path;
    double up = std::min({limits.acceleration, own.acceleration, limits.total_acceleration});
    double down = std::min({limits.deceleration, own.deceleration, limits.total_acceleration});
    if (up == unlimited) up = down;
    if (down == unlimited) down = up;
    row(1, 0, 0, up, down / up);
    row(0, 1, 0, std::min(limits.jerk, own.jerk), 1);
    bend = std::sqrt(bend);
    const double normal = std::min(limits.normal_acceleration, limits.total_acceleration);
    if (bend > 0) row(0, 0, bend, normal, 1);
    // The circle of the total acceleration is replaced by a polygon of sixteen sides within it.
    constexpr double inside = 0.98078528040323044913;  // cos(pi / 16)
    if (bend > 0 && limits.total_acceleration < unlimited)
      for (const double angle :
           {0.39269908169872415481, 0.78539816339744830962, 1.17809724509617246442})
        for (const double sign : {-1.0, 1.0})
          row(sign * std::cos(angle), 0, std::sin(angle) * bend, limits.total_acceleration * inside,
              1);
  }

  const Plan& plan_;
  const Path& path_;
  const LawRun& run_;
  const Lowered& lowered_;
  Rates rates_;
  std::size_t n_;
  std::vector<double> speeds_;  ///< bounds of |r'| of the pieces
  double window_ = 0;           ///< s
  std::size_t piece_ = 0;
};

/// Solves successive problems of one run.
class RunLaw {
 public:
  RunLaw(const Plan& plan, const LawRun& run, std::size_t count)
      : plan_(plan),
        run_(run),
        count_(count),
        lowered_(run, plan.path().axes(), count_),
        problem_(plan, run, lowered_) {
    speeds_.q.push_back(run.start);
    speeds_.b.push_back(0);
    for (std::size_t i = 1; i < count_; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(count_);
      const Motion m = plan.law().at(run.time + share * run.duration);
      if (!(m.position > speeds_.q.back()) || !(m.velocity > 0)) continue;
      speeds_.q.push_back(m.position);
      speeds_.b.push_back(m.velocity * m.velocity);
    }
    speeds_.q.push_back(run.start + run.length);
    speeds_.b.push_back(0);
  }

  [[nodiscard]] Lowered& lowered() { return lowered_; }

  /// Solves the problem of the nodes whose B0 is 1 + margin times the last B.
  void solve(double margin, double gap) {
    Speeds most = speeds_;
    for (double& b : most.b) b *= 1 + margin;
    most = equal_times(most, count_);
    window_ = unlimited;
    for (std::size_t k = 0; k < count_; ++k) window_ = std::min(window_, duration_of(most, k));
    const SpeedProblem problem = problem_.at(most, window_);
    std::vector<double> b = most.b;
    const double use = problem.use(b);
    for (double& x : b) x *= start_use / use;
    speeds_ = {most.q, fastest_speeds(problem, std::move(b), gap)};
  }

  [[nodiscard]] std::vector<LawInterval> law() const {
    std::vector<RawPhase> raw;
    for (std::size_t k = 0; k + 1 < speeds_.q.size(); ++k)
      raw.push_back(
          {duration_of(speeds_, k), std::sqrt(speeds_.b[k]), std::sqrt(speeds_.b[k + 1])});
    return stretches_of(plan_.path(), run_.piece, run_.pieces, averaged(raw, window_, run_.length))
        .unpacked();
  }

 private:
  const Plan& plan_;
  const LawRun& run_;
  std::size_t count_;
  Lowered lowered_;
  RunProblem problem_;
  Speeds speeds_;
  double window_ = 0;  ///< s
};

/// A phase of constant jerk over `factor` times its duration.
LawInterval slower(LawInterval s, double factor) {
  s.time *= factor;
  s.duration *= factor;
  for (double* v : {&s.v0, &s.peak, &s.v1}) *v /= factor;
  s.acceleration /= factor * factor;
  s.deceleration /= factor * factor;
  s.jerk /= factor * factor * factor;
  return s;
}

/// A plan with the laws of some runs replaced.
class Refinement {
 public:
  explicit Refinement(const Plan& plan)
      : plan_(plan), stretches_(plan.law().stretches().unpacked()), runs_(runs_of(stretches_)) {}

  Plan run() {
    laws_.resize(runs_.size());
    std::vector<std::size_t> longest_first(runs_.size());
    std::iota(longest_first.begin(), longest_first.end(), std::size_t{0});
    std::stable_sort(longest_first.begin(), longest_first.end(), [&](std::size_t a, std::size_t b) {
      return runs_[a].duration > runs_[b].duration;
    });
    std::size_t left = most_nodes_of_all_runs;
    for (const std::size_t k : longest_first) {
      const std::size_t nodes = nodes_of(runs_[k]);
      if (is_best(runs_[k]) || nodes > std::min(left, most_nodes)) continue;
      laws_[k] = faster(runs_[k], nodes);
      left -= nodes;
    }
    return with(laws_);
  }

 private:
  /// True for a single line, whose law is the fastest one.
  [[nodiscard]] bool is_best(const LawRun& run) const {
    return run.pieces == 1 && plan_.path().pieces()[run.piece].kind == PieceKind::line;
  }

  [[nodiscard]] std::size_t nodes_of(const LawRun& run) const {
    const auto stretches = std::span(stretches_).subspan(run.begin, run.end - run.begin);
    const bool window = std::any_of(stretches.begin(), stretches.end(),
                                    [](const LawInterval& s) { return s.is_phase(); });
    return std::max(least_nodes,
                    window ? run.pieces / pieces_a_node : stretches.size() * nodes_a_stretch);
  }

  /// A law that is faster than that of the plan; empty if none is found.
  [[nodiscard]] std::vector<LawInterval> faster(const LawRun& run, std::size_t nodes) const {
    RunLaw law(plan_, run, nodes);
    for (const double margin : margins) law.solve(margin, coarse_gap);
    std::vector<LawInterval> best;
    double least = run.duration * (1 - least_saving);
    for (int i = 0; i <= corrections; ++i) {
      law.solve(last_margin, fine_gap);
      std::vector<LawInterval> next = law.law();
      const double factor = excess(run, next, law.lowered());
      const double time = (next.back().time + next.back().duration) * factor;
      if (time < least) {
        least = time;
        for (LawInterval& s : next) s = slower(s, factor);
        best = std::move(next);
      }
    }
    return best;
  }

  /// The factor of the time with which a law of a run keeps all limits, by exact extrema. Lowers
  /// the limits where an axis exceeds them.
  double excess(const LawRun& run, const std::vector<LawInterval>& law, Lowered& lowered) const {
    const Plan trial = alone(run, law);
    const GroupLimits& limits = plan_.given().limits;
    double factor = 1;
    const auto stretch = [&](std::size_t order, double use) {
      const double f = order == 1 ? use : order == 2 ? std::sqrt(use) : std::cbrt(use);
      factor = std::max(factor, f);
    };
    const PlanAxes axes = to_axes(trial);
    for (std::size_t i = 0; i < axes.curves.size(); ++i) {
      const std::array given{limits.axes[i].velocity, limits.axes[i].acceleration,
                             limits.axes[i].jerk};
      const auto segments = axes.curves[i].segments();
      const auto breaks = axes.curves[i].breaks();
      for (std::size_t k = 0; k < segments.size(); ++k)
        for (std::size_t order = 1; order <= orders; ++order) {
          if (!given[order - 1]) continue;
          const double limit = *given[order - 1] * (1 - fit_share);
          const Range range =
              segment_range(segments[k], breaks[k], breaks[k + 1], static_cast<int>(order));
          const double use = (std::abs(range.peak().value) + axes.error[i][order]) / limit;
          if (!(use > 1)) continue;
          stretch(order, use);
          if (order > 1)
            lowered.lower(i, order - 1, trial.law().at(breaks[k]).position,
                          trial.law().at(breaks[k + 1]).position, 1 / use);
        }
    }
    for (const Finding& f : check_along(trial).findings) {
      if (!f.has_limit) continue;
      const double use = f.value / (f.limit * (1 - rounded_sum));
      if (use > 1) stretch(f.quantity == "velocity" ? 1 : f.quantity == "jerk" ? 3 : 2, use);
    }
    return factor;
  }

  /// The plan of the run alone, on the same path.
  [[nodiscard]] Plan alone(const LawRun& run, std::vector<LawInterval> law) const {
    for (LawInterval& s : law) s.start += run.start;
    return Plan(plan_.path(), TimingLaw(law), {}, 0, plan_.given());
  }

  [[nodiscard]] Plan with(const std::vector<std::vector<LawInterval>>& laws) const {
    std::vector<LawInterval> all;
    double time = 0;
    const auto append = [&](LawInterval s) {
      s.time = time;
      time += s.duration;
      all.push_back(s);
    };
    std::size_t next = 0;
    for (std::size_t i = 0; i < stretches_.size();) {
      if (next >= runs_.size() || i != runs_[next].begin || laws[next].empty()) {
        if (next < runs_.size() && i + 1 == runs_[next].end) ++next;
        append(stretches_[i++]);
        continue;
      }
      for (LawInterval s : laws[next]) {
        s.start += runs_[next].start;
        append(s);
      }
      i = runs_[next++].end;
    }
    const auto junctions = plan_.junctions();
    return Plan(plan_.path(), TimingLaw(all), {junctions.begin(), junctions.end()},
                plan_.stop_duration(), plan_.given());
  }

  const Plan& plan_;
  std::vector<LawInterval> stretches_;
  std::vector<LawRun> runs_;
  std::vector<std::vector<LawInterval>> laws_;  ///< one for each run; empty: that of the plan
};

}  // namespace

Plan refined(const Plan& plan) {
  if (limit_axes(plan.given().settings))
    throw InputError(
        "refine", "",
        "cannot be combined with limits of axes in a command: leave one of the two out");
  Plan result = Refinement(plan).run();
  return result.duration() < plan.duration() ? result : plan;
}

}  // namespace jounce
