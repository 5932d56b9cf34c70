#include "jounce/cam/inverse.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/roots.hpp"

// With x = g(y) for y = f(x), differentiating f(g(y)) = y three times gives the inverse function's
// rule; with r2 = f''/f' and r3 = f'''/f' nothing overflows before g does:
//
//   (1)  g'   = 1 / f'
//   (2)  g''  = -f'' / f'^3                     = -r2 g'^2
//   (3)  g''' = (3 f''^2 - f' f''') / f'^5      = (3 r2^2 - r3) g'^3
//
// At a point of rest y - y0 ~ +-|x - x0|^n, n > 1, so x - x0 ~ +-|y - y0|^(1/n): every derivative is
// infinite. With d = +1 for a rise, -1 for a fall, the signs that (1) to (3) tend to are
//
//   (4)  g' -> d inf,   g'' -> -inf leaving the rest, +inf arriving at it,   g''' -> d inf
//
// f(s) = y is solved by Newton's method kept inside a bracket. Beside a rest at (sa, fa), where it
// would crawl, it runs on log|f - fa| over log|s - sa|, whose slope is n near the rest: one step
// solves a power of any n,
//
//   (5)  s - sa  <-  (s - sa) ((y - fa) / (f - fa))^(1/n),   n = f' (s - sa) / (f - fa)

namespace jounce {
namespace {

using Kind = CamRun::Kind;

/// A motion that is smaller than this share of a segment's magnitude is rounding.
constexpr double rounding = 1e-15;
/// So is a jump that is smaller than this share of the greatest magnitude, or a velocity.
constexpr double joint_rounding = 1e-14;

/// Part of a segment over which the slave moves one way.
struct Part {
  double s0 = 0;
  double s1 = 1;
  Kind kind = Kind::dwell;
};

Kind kind_of(double travel, double noise) {
  if (std::abs(travel) <= noise) return Kind::dwell;
  return travel > 0 ? Kind::rise : Kind::fall;
}

/// The segment cut where its velocity vanishes; parts that do not move join the one before.
std::vector<Part> parts(const Segment& f) {
  const double noise = rounding * magnitude(f);
  std::vector<double> cuts;
  if (noise > 0) roots(derivative(f), 2e-16 * magnitude(f) / f.length, cuts);
  std::vector<double> kept{0};
  const auto moves = [&](double a, double b) {
    return std::abs(value(f, b) - value(f, a)) > noise;
  };
  for (const double s : cuts)
    if (moves(kept.back(), s)) kept.push_back(s);
  if (kept.size() > 1 && !moves(kept.back(), 1)) kept.pop_back();
  kept.push_back(1);
  std::vector<Part> result;
  for (std::size_t i = 0; i + 1 < kept.size(); ++i)
    result.push_back(
        {kept[i], kept[i + 1], kind_of(value(f, kept[i + 1]) - value(f, kept[i]), noise)});
  return result;
}

double master_at(const Cam& cam, std::size_t segment, double s) {
  const double end = cam.breaks()[segment + 1];
  return s == 1 ? end : std::min(end, cam.breaks()[segment] + s * cam.segments()[segment].length);
}

double greatest_magnitude(const Cam& cam) {
  double greatest = 0;
  for (const Segment& f : cam.segments()) greatest = std::max(greatest, magnitude(f));
  return greatest;
}

bool jumps(const CamRun& before, const CamRun& after, double magnitude) {
  return std::abs(after.slave_from - before.slave_to) > joint_rounding * magnitude;
}

bool rests(const Segment& f, double s) {
  return std::abs(evaluate(f, s)[1]) <= joint_rounding * magnitude(derivative(f));
}

/// The end of a piece that an iteration measures from: the nearer one, in the slave's position.
struct Anchor {
  double s = 0;
  double value = 0;
  bool rests = false;
};

/// The next s after one with this f and slope f' by s: Newton's step, or beside a rest (5).
double improved(double s, double f, double slope, double y, const Anchor& anchor) {
  if (!anchor.rests) return s - (f - y) / slope;
  const double reached = f - anchor.value;
  const double from = s - anchor.s;
  return anchor.s + from * std::pow((y - anchor.value) / reached, reached / (slope * from));
}

/// s between low and high with f(s) = y, f monotone there. A step that leaves the bracket, or is
/// longer than the one before, is replaced by the middle.
double solved(const Segment& f, const Anchor& low, const Anchor& high, double y) {
  const bool rises = high.value > low.value;
  const double share = (y - low.value) / (high.value - low.value);
  if (!(share > 0)) return low.s;
  if (!(share < 1)) return high.s;
  const Anchor& anchor = share < 0.5 ? low : high;
  double lo = low.s;
  double hi = high.s;
  double s = lo + (hi - lo) * share;
  if (anchor.rests)  // as beside a jump of the jerk, n = 3
    s = share < 0.5 ? lo + (hi - lo) * std::cbrt(share) : hi - (hi - lo) * std::cbrt(1 - share);
  double step = hi - lo;
  for (int i = 0; i < 200; ++i) {
    const Jet here = evaluate(f, s);
    if (here[0] == y) return s;
    ((here[0] > y) == rises ? hi : lo) = s;
    double next = improved(s, here[0], here[1] * f.length, y, anchor);
    if (!(next > lo && next < hi) || !(std::abs(next - s) <= step)) next = lo + (hi - lo) / 2;
    step = std::abs(next - s);
    if (step <= std::numeric_limits<double>::epsilon() * s) return next;
    s = next;
  }
  return s;
}

/// (4)
Jet at_rest(double master, bool rises, bool leaving) {
  const double infinite = std::numeric_limits<double>::infinity();
  const double d = rises ? infinite : -infinite;
  return {master, d, leaving ? -infinite : infinite, d};
}

/// (1) to (3), each where it is finite and its direction is the branch's.
Jet by_slave(const Jet& f, const Jet& infinite) {
  const double g1 = 1 / f[1];
  if (f[1] == 0 || (f[1] > 0) != (infinite[1] > 0)) return infinite;
  const double r2 = f[2] * g1;
  Jet g{infinite[0], g1, -r2 * g1 * g1, (3 * r2 * r2 - f[3] * g1) * g1 * g1 * g1};
  for (std::size_t k = 1; k < g.size(); ++k)
    if (!std::isfinite(g[k])) g[k] = infinite[k];
  return g;
}

}  // namespace

std::vector<CamRun> runs(const Cam& cam) {
  std::vector<CamRun> found;
  const double scale = greatest_magnitude(cam);
  for (std::size_t i = 0; i < cam.segments().size(); ++i) {
    const Segment& f = cam.segments()[i];
    for (const Part& part : parts(f)) {
      const CamRun run{part.kind, master_at(cam, i, part.s0), master_at(cam, i, part.s1),
                       value(f, part.s0), value(f, part.s1)};
      if (found.empty() || found.back().kind != run.kind || jumps(found.back(), run, scale)) {
        found.push_back(run);
      } else {
        found.back().to = run.to;
        found.back().slave_to = run.slave_to;
      }
    }
  }
  return found;
}

Inverse::Inverse(std::shared_ptr<const Cam> cam, std::span<const CamRun> branch)
    : cam_(std::move(cam)),
      rises_(branch.front().kind == Kind::rise),
      master_from_(branch.front().from),
      master_to_(branch.back().to) {
  assert(branch.front().kind != Kind::dwell && branch.back().kind == branch.front().kind);
  for (const CamRun& run : branch)
    if (run.kind != Kind::dwell) add(run);
  if (!rises_) std::reverse(pieces_.begin(), pieces_.end());
  const auto slave = [&](const Piece& p, bool low) {
    return value(cam_->segments()[p.segment], low == rises_ ? p.s0 : p.s1);
  };
  breaks_.push_back(slave(pieces_.front(), true));
  std::erase_if(pieces_, [&](const Piece& piece) {  // rounding at a joint can hide a piece
    const double high = slave(piece, false);
    if (!(high > breaks_.back())) return true;
    breaks_.push_back(high);
    return false;
  });
}

void Inverse::add(const CamRun& run) {
  for (std::size_t i = 0; i < cam_->segments().size(); ++i) {
    if (cam_->breaks()[i + 1] <= run.from || cam_->breaks()[i] >= run.to) continue;
    const Segment& f = cam_->segments()[i];
    for (const Part& part : parts(f)) {
      const double middle = master_at(*cam_, i, (part.s0 + part.s1) / 2);
      if (part.kind != run.kind || middle < run.from || middle > run.to) continue;
      pieces_.push_back({i, part.s0, part.s1, part.s0 > 0 || rests(f, part.s0),
                         part.s1 < 1 || rests(f, part.s1)});
    }
  }
}

Jet Inverse::jet(double slave, Side side) const {
  assert(slave >= start() && slave <= end() && "query outside the branch");
  const auto first = breaks_.begin() + 1;
  const auto last = breaks_.end() - 1;
  const auto it = side == Side::right ? std::upper_bound(first, last, slave)
                                      : std::lower_bound(first, last, slave);
  const auto k = static_cast<std::size_t>(it - first);
  const Piece& p = pieces_[k];
  const Segment& f = cam_->segments()[p.segment];
  const bool at_low = slave <= breaks_[k];
  const bool at_high = slave >= breaks_[k + 1];
  const double s = at_low || at_high ? (at_low == rises_ ? p.s0 : p.s1)
                                     : solved(f, {p.s0, value(f, p.s0), p.rest0},
                                              {p.s1, value(f, p.s1), p.rest1}, slave);
  const bool rest = (s == p.s0 && p.rest0) || (s == p.s1 && p.rest1);
  const Jet infinite = at_rest(master_at(*cam_, p.segment, s), rises_, s - p.s0 < p.s1 - s);
  return rest ? infinite : by_slave(evaluate(f, s), infinite);
}

namespace {

std::string span_of(const CamRun& run) {
  return "from " + number(run.from) + " to " + number(run.to);
}

/// An obstacle: what the slave does from `value`'s run, where one inverse needs `limit`.
Finding obstacle(const char* rule, double where, double value, double limit, std::string advice) {
  Finding f;
  f.rule = rule;
  f.quantity = OverMaster::names[0];
  f.where = where;
  f.value = value;
  f.limit = limit;
  f.margin = -1;
  f.broken = true;
  f.advice = std::move(advice);
  return f;
}

/// What keeps the cam from having one inverse, in the order of the master.
Report obstacles(std::span<const CamRun> runs, double scale) {
  Report report;
  std::optional<Kind> forwards;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto& [kind, from, to, slave_from, slave_to] = runs[i];
    if (i > 0 && jumps(runs[i - 1], runs[i], scale))
      report.findings.push_back(obstacle("inverse/jump", from, slave_from, runs[i - 1].slave_to,
                                         "the slave jumps: no master between"));
    if (kind == Kind::dwell)
      report.findings.push_back(
          obstacle("inverse/dwell", from, slave_to, slave_from,
                   "the slave stands still " + span_of(runs[i]) + ": the master jumps"));
    else if (kind != forwards.value_or(kind))
      report.findings.push_back(
          obstacle("inverse/reversal", from, slave_to, slave_from,
                   "the slave runs back " + span_of(runs[i]) + ": choose a branch"));
    else
      forwards = kind;
  }
  return report;
}

}  // namespace

Inversion inverted(const Cam& cam) {
  const auto shared = std::make_shared<const Cam>(cam);
  const double scale = greatest_magnitude(cam);
  Inversion result;
  result.runs = runs(cam);
  const std::span<const CamRun> all(result.runs);
  for (std::size_t i = 0; i < all.size();) {
    if (all[i].kind == Kind::dwell) {
      ++i;
      continue;
    }
    std::size_t last = i;  // the last run that moves
    for (std::size_t k = i + 1; k < all.size() && !jumps(all[k - 1], all[k], scale); ++k) {
      if (all[k].kind == all[i].kind)
        last = k;
      else if (all[k].kind != Kind::dwell)
        break;
    }
    result.branches.emplace_back(shared, all.subspan(i, last - i + 1));
    i = last + 1;
  }
  result.report = obstacles(all, scale);
  return result;
}

const Inverse* Inversion::branch_at(double master) const {
  for (const Inverse& branch : branches)
    if (master >= branch.master_from() && master <= branch.master_to()) return &branch;
  return nullptr;
}

std::vector<MasterSpan> positions_for(const Cam& cam, double slave) {
  std::vector<MasterSpan> spans;
  for (const double x : crossings(cam, 0, slave)) spans.push_back({x, x});
  const double noise = joint_rounding * greatest_magnitude(cam);
  for (const CamRun& run : runs(cam)) {
    if (run.kind != Kind::dwell || std::abs(run.slave_from - slave) > noise) continue;
    std::erase_if(spans,
                  [&](const MasterSpan& at) { return at.from >= run.from && at.to <= run.to; });
    spans.push_back({run.from, run.to});
  }
  std::sort(spans.begin(), spans.end(),
            [](const MasterSpan& a, const MasterSpan& b) { return a.from < b.from; });
  if (cam.outside() == Outside::wrap && spans.size() > 1 && spans.front().from == cam.start() &&
      spans.back().from == cam.end())
    spans.pop_back();
  return spans;
}

}  // namespace jounce
