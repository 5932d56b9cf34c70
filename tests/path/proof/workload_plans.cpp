// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "jounce/path/overlap.hpp"
#include "jounce/path/refine.hpp"
#include "jounce/profiles/error.hpp"

#include "path/proof/workloads.hpp"

namespace jounce::path_proof {
namespace {

/// Positions far from the origin, whose distances are as small as 1e-12, are rounded.
constexpr double rounding_of_narrow = 8 * std::numeric_limits<double>::epsilon();

Outcome planned(const Case& c, Worst& worst, double rounding = 0) try {
  return outcome(c, judge_plan(c, plan(program_of(c), c.limits), worst, rounding));
} catch (const InputError& error) {
  return outcome(c, std::string("rejected: ") + error.what());
}

}  // namespace

Outcome plans_of_lines(Random& r, Worst& worst) {
  return planned(lines(r), worst);
}

Outcome plans_of_arcs(Random& r, Worst& worst) {
  return planned(arcs(r), worst);
}

Outcome plans_of_curves(Random& r, Worst& worst) {
  return planned(curves(r), worst);
}

Outcome plans_of_averages(Random& r, Worst& worst) {
  const Case c = averages(r);
  const Plan made = plan(program_of(c), c.limits);
  const std::string why = judge_plan(c, made, worst);
  return outcome(c, why.empty() ? judge_average(c, made, worst) : why);
}

Outcome plans_of_limited(Random& r, Worst& worst) {
  return planned(limited(r), worst);
}

/// Rejecting a program is correct only if it does not move.
Outcome plans_of_narrow(Random& r, Worst& worst) {
  return planned(narrow(r), worst, rounding_of_narrow);
}

/// One plan of all lines does not take longer than the plans of two parts, with a rest between them. At a corner so
/// slow that a rest is faster, it may take longer by this share: the plan compares both only by the sides of the corner
/// (decision 0152).
constexpr double rest_at_slow_corner = 0.1;

Outcome halves_of_dense(Random& r, Worst& worst) {
  const Case c = dense(r);
  const Program all = program_of(c);
  const Plan made = plan(all, c.limits);
  std::string why = judge_plan(c, made, worst);
  const std::size_t count = all.commands().size();
  if (!why.empty() || count < 2) return outcome(c, why);
  const std::size_t cut = 1 + static_cast<std::size_t>(r.below(static_cast<int>(count) - 1));
  const double parts =
      plan(all.part(0, cut), c.limits).duration() + plan(all.part(cut, count), c.limits).duration();
  if (!(made.duration() <= parts * (1 + rest_at_slow_corner)))
    why = "lasts " + text(made.duration()) + " s, with a rest before line " +
          std::to_string(cut + 1) + ": " + text(parts);
  return outcome(c, why);
}

Outcome overlaps(Random& r, Worst& worst) {
  Case c = lines(r);
  for (Leg& leg : c.legs) leg.settings.corner = Corner::stop;
  const OverlapOptions options{
      .deviation = r.below(2) > 0 ? r.log_uniform(1e-3, 10) : OverlapOptions{}.deviation,
      .share = r.below(3) > 0 ? 1 : r.uniform(0, 1)};
  const Overlapped motion = overlapped(program_of(c), c.limits, options);
  Demand demand{.from = c.start, .to = c.legs.back().to, .duration = motion.duration};
  for (std::size_t k = 0; k < c.legs.size(); ++k)
    demand.size += distance(c.from(k), c.legs[k].to) + distance(c.from(k), {});
  std::string why =
      judge_axes({motion.axes, std::vector<Jet>(c.axes, Jet{})}, c.limits, demand, worst);
  if (why.empty() && !(motion.duration <= motion.stop_duration * (1 + 1e-12)))
    why = "lasts " + text(motion.duration) + " s, with stops " + text(motion.stop_duration);
  if (why.empty() && !(motion.stop_duration <= time_with_stops(c) * (1 + 1e-9)))
    why = "lasts " + text(motion.stop_duration) + " s with stops, not " + text(time_with_stops(c));
  for (const OverlapRecord& corner : motion.corners)
    if (why.empty() && !(corner.deviation <= options.deviation * (1 + 1e-9)))
      why = "line " + std::to_string(corner.line) + " deviates by " + text(corner.deviation);
  if (why.empty()) return {};
  std::string key = "overlap = { share = " + text(options.share);
  if (std::isfinite(options.deviation)) key += ", deviation = " + text(options.deviation);
  for (Leg& leg : c.legs) leg.settings.corner = Corner::stop;
  return {why, spec_of(c, key + " }\n")};
}

Outcome refinements(Random& r, Worst& worst) {
  const Case c = r.below(2) > 0 ? lines(r) : arcs(r);
  const Plan made = plan(program_of(c), c.limits);
  const Plan better = refined(made);
  std::string why = judge_plan(c, better, worst);
  if (why.empty() && !(better.duration() <= made.duration()))
    why = "lasts " + text(better.duration()) + " s, before " + text(made.duration());
  return why.empty() ? Outcome{} : Outcome{why, spec_of(c, "refine = true\n")};
}

}  // namespace jounce::path_proof
