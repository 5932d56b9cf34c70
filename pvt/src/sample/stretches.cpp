// SPDX-License-Identifier: Apache-2.0
#include "pvt/src/sample/stretches.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"

#include "pvt/src/sample/longest.hpp"
#include "pvt/src/sample/whole_steps.hpp"

// A machine relies on two properties that a tolerance does not cover: a slave that dwells stands
// still, and a slave in step keeps its ratio. So the straight parts of a curve are intervals of its
// table. Neighboring segments on one line are one stretch. A stretch is kept if
//
//   (1)  the curve is bent on one side of it: then it is part of the design;
//   (2)  or it stands still for at least 1/64 of the curve. (Between straight lines, the curve is a
//        table itself, which may have been recorded in whole counts: its steps are not dwells.)
//
// The ends move inwards to steps of x. A stretch without two such steps is not kept.
namespace jounce::pvt_detail {
namespace {

using profiles_detail::rounded_sum;

constexpr double least_part = 1.0 / 64;
constexpr double rounded_terms = 4e-15;  // share of the sum of a segment's terms

bool is_straight(const Segment& f) {
  double bend = 0;
  for (std::size_t i = 2; i < f.c.size(); ++i) bend += std::abs(f.c[i]);
  return f.sines == 0 && bend <= rounded_terms * magnitude(f);
}

/// Successive segments on one straight line: [first, last).
struct Run {
  std::size_t first = 0;
  std::size_t last = 0;
  double travel = 0;  ///< travel; 0: a dwell
};

/// True if g continues the line of f.
bool goes_on(const Segment& f, const Segment& g) {
  const double allowed = rounded_terms * (magnitude(f) + magnitude(g));
  const double rate = f.c[1] / f.length - g.c[1] / g.length;
  return std::abs(value(f, 1) - value(g, 0)) <= allowed &&
         std::abs(rate) * std::min(f.length, g.length) <= allowed;
}

template <class Over>
std::vector<Run> runs(const Curve<Over>& f) {
  std::vector<Run> all;
  const auto segments = f.segments();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (!is_straight(segments[i])) continue;
    const bool on = !all.empty() && all.back().last == i && goes_on(segments[i - 1], segments[i]);
    if (!on) all.push_back({i, i, 0});
    all.back().last = i + 1;
  }
  for (Run& run : all) {
    const double from = value(segments[run.first], 0);
    const double travel = value(segments[run.last - 1], 1) - from;
    const bool stands = std::abs(travel) <= rounded_terms * magnitude(segments[run.first]);
    run.travel = stands ? 0 : travel;
  }
  return all;
}

template <class Over>
bool is_kept(const Curve<Over>& f, const Run& run) {
  const auto segments = f.segments();
  const bool bent_before = run.first > 0 && !is_straight(segments[run.first - 1]);
  const bool bent_behind = run.last < segments.size() && !is_straight(segments[run.last]);
  const double length = f.breaks()[run.last] - f.breaks()[run.first];
  return bent_before || bent_behind || (run.travel == 0 && length >= least_part * f.length());
}

/// The multiple of the step at x; otherwise the next one to the right (towards = 1) or to the left
/// (-1).
double step_from(double x, double step, double towards) {
  if (step == 0 || is_whole(x, step)) return x;
  const double k = towards > 0 ? std::ceil(x / step) : std::floor(x / step);
  return steps(k, step);
}

template <class Over>
Straight knots_of(const Curve<Over>& f, const Target& target, const Run& run) {
  const double begin = step_from(f.breaks()[run.first], target.x_step, 1);
  const double end = step_from(f.breaks()[run.last], target.x_step, -1);
  Straight made{held_at(f, target, begin, Side::right), held_at(f, target, end, Side::left),
                run.travel == 0};
  if (!made.dwell) return made;
  // A dwell at the end of a period has the position that closes the period.
  const Knot& level = end == f.end() && begin != f.start() ? made.end : made.begin;
  made.begin.jet = made.end.jet = {level.jet[0], 0, 0, 0};
  return made;
}

/// True if two different knots are far enough apart.
bool apart(double x, double next, double spacing) {
  return next == x || next - x >= spacing * (1 - rounded_sum);
}

}  // namespace

template <class Over>
std::vector<Straight> kept_stretches(const Curve<Over>& f, const Target& target) {
  std::vector<Straight> all;
  for (const Run& run : runs(f)) {
    if (!is_kept(f, run)) continue;
    const Straight made = knots_of(f, target, run);
    if (made.dwell && !all.empty() && !all.back().dwell &&
        !apart(all.back().end.x, made.begin.x, target.spacing))
      all.pop_back();  // the dwell has priority
    const double before = all.empty() ? f.start() : all.back().end.x;
    if (made.end.x > made.begin.x && apart(made.begin.x, made.end.x, target.spacing) &&
        apart(before, made.begin.x, target.spacing) && apart(made.end.x, f.end(), target.spacing))
      all.push_back(made);
  }
  return all;
}

template std::vector<Straight> kept_stretches(const Curve<OverTime>&, const Target&);
template std::vector<Straight> kept_stretches(const Curve<OverMaster>&, const Target&);

}  // namespace jounce::pvt_detail
