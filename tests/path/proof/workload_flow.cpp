// SPDX-License-Identifier: Apache-2.0
// A plan that is held, resumed, overridden or driven back: its path stays the same.

#include "jounce/path/hold.hpp"
#include "jounce/path/override.hpp"

#include "path/proof/workloads.hpp"

namespace jounce::path_proof {
namespace {

Case any(Random& r) {
  const int kind = r.below(8);
  return kind < 5 ? lines(r) : kind < 7 ? arcs(r) : averages(r);
}

double end_of(const Plan& motion) {
  const LawInterval& last = motion.law().stretches().back();
  return last.start + last.length;
}

Outcome failed(const Case& c, const std::string& why, const std::string& comment) {
  return {why + ", " + comment, spec_of(c, {}, "# " + comment + "\n")};
}

std::string judge_hold(const Case& c, const Plan& made, double t, Worst& worst) {
  const Plan held = halted(made, t);
  if (!(held.path() == made.path())) return "the path of the hold differs";
  if (std::string why = judge_motion(c, made, held, 0, worst); !why.empty()) return why;
  // Near its end, a stop covers j t^3 / 6: rounding of the place changes the time by its cube root.
  const double last = std::abs(held.law().stretches().back().jerk);
  const double rounding = std::cbrt(6e-16 * made.path().length() / last);
  if (!(held.duration() <= made.duration() * (1 + 1e-12) + (last > 0 ? rounding : 0)))
    return "rests behind the plan's end, at " + text(held.duration()) + " s";
  const double before = made.law().at(t / 2).position;
  if (!(std::abs(held.law().at(t / 2).position - before) <= 1e-11 * made.path().length()))
    return "does not follow the plan before the hold";
  if (end_of(held) >= made.path().length() * (1 - 1e-12)) return {};
  const Plan rest = resumed(made, held);
  if (!(rest.path() == made.path())) return "the path of the rest differs";
  return judge_motion(c, made, rest, end_of(held), worst);
}

std::string judge_override(const Case& c, const Plan& made,
                           const std::vector<FactorRequest>& factors, Worst& worst) {
  const Plan motion = played(made, factors);
  if (!(motion.path() == made.path())) return "the path differs";
  if (std::string why = judge_motion(c, made, motion, 0, worst); !why.empty()) return why;
  const double missing = made.path().length() - end_of(motion);
  return std::abs(missing) <= 1e-11 * made.path().length()
             ? ""
             : "the end is not reached by " + text(missing);
}

Outcome overridden(Random& r, const Case& c, const Plan& made, Worst& worst) {
  const std::vector<FactorRequest> factors = steps(r, made.duration());
  const std::string why = judge_override(c, made, factors, worst);
  if (why.empty()) return {};
  std::string all = "override = [";
  for (const FactorRequest& f : factors)
    all += "{ time = " + text(f.time) + ", factor = " + text(f.factor) + " }, ";
  return {why, spec_of(c, {}, all + "]\n")};
}

Outcome held(Random& r, const Case& c, const Plan& made, Worst& worst) {
  const double t = made.duration() * r.uniform(0, 1);
  const std::string why = judge_hold(c, made, t, worst);
  return why.empty() ? Outcome{} : failed(c, why, "halted at " + text(t) + " s");
}

/// Any place before `end`, often within a corner or at its start.
double place_before(Random& r, const Plan& made, double end) {
  const double q = end * r.uniform(0, 0.99);
  const int kind = r.below(4);
  for (const PathPiece& p : made.path().pieces())
    if (kind < 2 && (p.kind == PieceKind::turn || p.kind == PieceKind::blend) &&
        p.start + p.length > q && p.start + p.length < end)
      return p.start + (kind == 0 ? p.length * r.uniform(0, 1) : 0);
  return q;
}

/// Back to any place, and on to the end.
Outcome retreated_and_resumed(Random& r, const Case& c, Worst& worst) {
  const Plan made = plan(program_of(c), c.limits);
  const double t = made.duration() * r.uniform(0.1, 1);
  const Plan held = halted(made, t);
  if (end_of(held) == 0 || end_of(held) >= made.path().length() * (1 - 1e-12)) return {};
  const double to = place_before(r, made, end_of(held));
  const Plan back = retreated(made, held, to);
  const double length = made.path().length();
  std::string why = judge_motion(c, back, back, length - end_of(held), worst);
  if (why.empty() && !(std::abs(length - end_of(back) - to) <= 1e-9 * length))
    why = "the retreat ends at " + text(length - end_of(back));
  for (const double q : {to, end_of(held)})
    if (why.empty() &&
        !(distance(point_at_length(made.path(), q), point_at_length(back.path(), length - q)) <=
          1e-10 * (length + distance(c.start, {}))))
      why = "the way back has another path";
  if (why.empty()) why = judge_motion(c, made, resumed(made, to), to, worst);
  return why.empty() ? Outcome{}
                     : failed(c, why, "halted at " + text(t) + " s, back to " + text(to));
}

}  // namespace

Outcome holds(Random& r, Worst& worst) {
  const Case c = any(r);
  return held(r, c, plan(program_of(c), c.limits), worst);
}

Outcome overrides(Random& r, Worst& worst) {
  const Case c = any(r);
  return overridden(r, c, plan(program_of(c), c.limits), worst);
}

Outcome flows_of_dense(Random& r, Worst& worst) {
  const Case c = dense(r);
  const Plan made = plan(program_of(c), c.limits);
  const Outcome found = held(r, c, made, worst);
  return found.why.empty() ? overridden(r, c, made, worst) : found;
}

Outcome retreats(Random& r, Worst& worst) {
  return retreated_and_resumed(r, r.below(8) > 0 ? any(r) : dense(r), worst);
}

Outcome flow_of_limited(Random& r, Worst& worst) {
  const Case c = limited(r);
  const int kind = r.below(3);
  if (kind == 2) return retreated_and_resumed(r, c, worst);
  const Plan made = plan(program_of(c), c.limits);
  return kind == 1 ? overridden(r, c, made, worst) : held(r, c, made, worst);
}

}  // namespace jounce::path_proof
