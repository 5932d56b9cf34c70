// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/algebra/inverse.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/src/design/parts.hpp"

// Let x = g(y) for y = f(x). Differentiating f(g(y)) = y three times gives the rule for inverse
// functions. In terms of r2 = f''/f' and r3 = f'''/f', nothing overflows before g does:
//
//   (1)  g'   = 1 / f'
//   (2)  g''  = -f'' / f'^3                     = -r2 g'^2
//   (3)  g''' = (3 f''^2 - f' f''') / f'^5      = (3 r2^2 - r3) g'^3
//
// At a point of rest, y - y0 ~ +-|x - x0|^n with n > 1, so x - x0 ~ +-|y - y0|^(1/n): every
// derivative is infinite. With d = +1 for a rise and -1 for a fall, the signs of the limits of (1)
// to (3) are
//
//   (4)  g' -> d inf,   g'' -> -inf leaving the rest, +inf arriving at it,   g''' -> d inf
//
// Newton's method inside a bracket solves f(s) = y. Near a rest at (sa, fa) it would converge
// slowly. There it runs on log|f - fa| over log|s - sa|, whose slope is n near the rest: one step
// solves a power of any n,
//
//   (5)  s - sa  <-  (s - sa) ((y - fa) / (f - fa))^(1/n),   n = f' (s - sa) / (f - fa)
//
// n is limited to 1 to 11: very near to the rest, f - fa is rounding and n would be arbitrary.

namespace jounce {
namespace {

using cam_detail::greatest_magnitude;
using cam_detail::joint_rounding;
using cam_detail::jumps;
using cam_detail::master_at;
using Kind = CamRun::Kind;

bool rests(const Segment& f, double s) {
  return std::abs(evaluate(f, s)[1]) <= joint_rounding * magnitude(derivative(f));
}

/// The end of a piece from which an iteration measures: the one whose slave position is nearer.
struct Anchor {
  double s = 0;
  double value = 0;
  bool rests = false;
};

/// The next s after an iterate with the value f and the slope f' (with respect to s): Newton's
/// step, or (5) near a rest.
double improved(double s, double f, double slope, double y, const Anchor& anchor) {
  if (!anchor.rests) return s - (f - y) / slope;
  const double reached = f - anchor.value;
  const double from = s - anchor.s;
  const double n = std::clamp(slope * from / reached, 1.0, double{Segment::max_degree});
  return anchor.s + from * std::pow((y - anchor.value) / reached, 1 / n);
}

/// The position at which a straight line reaches `share` of the travel; near a rest, the cube of a
/// motion with constant jerk instead.
double guess(const Anchor& low, const Anchor& high, double share) {
  const double width = high.s - low.s;
  if (share < 0.5) return low.s + width * (low.rests ? std::cbrt(share) : share);
  return high.s - width * (high.rests ? std::cbrt(1 - share) : 1 - share);
}

/// Returns s between low and high with f(s) = y, for f monotone there. If a Newton step leaves the
/// bracket, or is longer than the previous step, the middle of the bracket replaces it. The error
/// after a step is about its square divided by the distance from the anchor, so a short step is the
/// last.
double solved(const Segment& f, const Anchor& low, const Anchor& high, double y) {
  constexpr double short_step = 1e-9;
  const bool rises = high.value > low.value;
  const double share = (y - low.value) / (high.value - low.value);
  if (!(share > 0)) return low.s;
  if (!(share < 1)) return high.s;
  const Anchor& anchor = share < 0.5 ? low : high;
  double lo = low.s;
  double hi = high.s;
  double s = guess(low, high, share);
  for (double step = hi - lo; hi - lo > std::numeric_limits<double>::epsilon() * lo;) {
    const Jet here = evaluate(f, s);
    if (here[0] == y) break;
    ((here[0] > y) == rises ? hi : lo) = s;
    const double next = improved(s, here[0], here[1] * f.length, y, anchor);
    if (std::abs(next - s) <= short_step * std::abs(s - anchor.s)) return std::clamp(next, lo, hi);
    const bool sound = next > lo && next < hi && std::abs(next - s) <= step;
    const double before = s;
    s = sound ? next : lo + (hi - lo) / 2;
    step = std::abs(s - before);
  }
  return s;
}

/// Equation (4).
Jet at_rest(double master, bool rises, bool leaving) {
  const double infinite = std::numeric_limits<double>::infinity();
  const double d = rises ? infinite : -infinite;
  return {master, d, leaving ? -infinite : infinite, d};
}

/// Equations (1) to (3). A value that is not finite, or has the wrong direction, is replaced by
/// `infinite`.
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

Inverse::Inverse(std::shared_ptr<const Cam> cam, std::span<const CamRun> branch)
    : cam_(std::move(cam)),
      rises_(branch.front().kind == Kind::rise),
      master_from_(branch.front().from),
      master_to_(branch.back().to) {
  assert(branch.front().kind != Kind::dwell && branch.back().kind == branch.front().kind);
  for (const CamRun& run : branch)
    if (run.kind != Kind::dwell) add(run);
  if (!rises_) std::reverse(pieces_.begin(), pieces_.end());
  breaks_.push_back(rises_ ? pieces_.front().slave0 : pieces_.front().slave1);
  std::erase_if(pieces_, [&](const Piece& piece) {  // rounding at a joint can hide a piece
    const double high = rises_ ? piece.slave1 : piece.slave0;
    if (!(high > breaks_.back())) return true;
    breaks_.push_back(high);
    return false;
  });
}

void Inverse::add(const CamRun& run) {
  for (std::size_t i = 0; i < cam_->segments().size(); ++i) {
    if (cam_->breaks()[i + 1] <= run.from || cam_->breaks()[i] >= run.to) continue;
    const Segment& f = cam_->segments()[i];
    for (const cam_detail::Part& part : cam_detail::parts(f)) {
      const double middle = master_at(*cam_, i, (part.s0 + part.s1) / 2);
      if (part.kind != run.kind || middle < run.from || middle > run.to) continue;
      pieces_.push_back({i, part.s0, part.s1, value(f, part.s0), value(f, part.s1),
                         part.s0 > 0 || rests(f, part.s0), part.s1 < 1 || rests(f, part.s1)});
    }
  }
}

Jet Inverse::jet(double slave, Side side) const {
  if (!(slave >= start() && slave <= end())) {
    assert(false && "query outside the branch");
    return {jet(slave < start() ? start() : end())[0], 0, 0, 0};
  }
  const auto first = breaks_.begin() + 1;
  const auto last = breaks_.end() - 1;
  const auto it = side == Side::right ? std::upper_bound(first, last, slave)
                                      : std::lower_bound(first, last, slave);
  const auto k = static_cast<std::size_t>(it - first);
  const Piece& p = pieces_[k];
  const Segment& f = cam_->segments()[p.segment];
  const bool at_low = slave <= breaks_[k];
  const bool at_high = slave >= breaks_[k + 1];
  const double s = at_low || at_high
                       ? (at_low == rises_ ? p.s0 : p.s1)
                       : solved(f, {p.s0, p.slave0, p.rest0}, {p.s1, p.slave1, p.rest1}, slave);
  const bool rest = (s == p.s0 && p.rest0) || (s == p.s1 && p.rest1);
  const Jet infinite = at_rest(master_at(*cam_, p.segment, s), rises_, s - p.s0 < p.s1 - s);
  return rest ? infinite : by_slave(evaluate(f, s), infinite);
}

namespace {

std::string span_of(const CamRun& run) {
  return "from " + number(run.from) + " to " + number(run.to);
}

/// A finding for an obstacle: the slave moves to `value`, but a single inverse requires `limit`.
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

/// Reasons why the cam has not exactly one inverse, in the order of the master.
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
    std::size_t last = i;  // the last run with motion
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

std::string Inversion::ranges_text() const {
  std::string text;
  for (const Inverse& branch : branches)
    text += (text.empty() ? "" : ", ") + six_digits(branch.master_from()) + " to " +
            six_digits(branch.master_to());
  return text.empty() ? "none" : text;
}

}  // namespace jounce
