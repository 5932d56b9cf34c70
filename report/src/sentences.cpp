// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "jounce/profiles/detail/digits_beside.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/report/report_text.hpp"

// The sentences of all findings, by the family of their rule. The meaning and the remedy of each rule: rules.cpp.

namespace jounce {
namespace {

constexpr double just_met = 1e-9;  ///< a smaller margin, as a share, is none

/// True for a value beyond a limit that is not broken: the rounding of knots causes it. A smaller excess
/// shows in none of six digits.
bool is_beyond_by_rounding(const Finding& f) {
  constexpr double shown = 1e-6;
  return !f.broken && f.margin == 0 && f.rule.family() == RuleFamily::limit &&
         std::abs(f.value) > std::abs(f.limit) * (1 + shown) &&
         !f.rule.name().starts_with("position");
}

std::string place(const Finding& finding, const Labels& labels) {
  const std::string segment = labels.segment_of(finding);
  return with_unit(finding.where,
                   finding.where_unit.empty() ? labels.units.x : finding.where_unit) +
         (segment.empty() ? "" : " (segment " + segment + ")");
}

std::string percent(double share) {
  return fmt::format("{:.3g} %", 100 * std::abs(share));
}

/// True if the limit is a lower one: a radius that a disc cam must have.
bool is_least(const Finding& finding) {
  return finding.rule == "disc/profile_radius" || finding.rule == "disc/cutter_radius";
}

/// True for a limit of the position: its margin is a share of the travel.
bool is_position_limit(const Finding& finding) {
  return finding.rule.family() == RuleFamily::limit && finding.rule.name().starts_with("position");
}

/// The finding without rounding: a position near 0 is 0 if it is only rounding beside the travel or
/// its limit.
Finding tidy(Finding f) {
  if (f.rule.family() != RuleFamily::warning && !is_position_limit(f)) return f;
  double scale = std::max(std::abs(f.value), std::abs(f.limit));
  // The margin of a position is a share of the travel.
  if (f.margin != 0 && std::isfinite(f.margin))
    scale = std::max(scale, std::abs((f.value - f.limit) / f.margin));
  if (!std::isfinite(scale)) return f;
  for (double* number : {&f.value, &f.limit})
    if (std::abs(*number) <= profiles_detail::rounded_input * scale) *number = 0;
  return f;
}

/// True for a limit that a value must not be below.
bool is_lower(const Finding& f) {
  if (is_position_limit(f)) return f.rule.name() == "position_min";
  return is_least(f) || f.rule == "follower/contact" || f.limit < 0;
}

/// The limit without its unit, rounded so that a motion at this number keeps it.
std::string limit_number(const Finding& f) {
  return is_lower(f) ? six_digits_up(f.limit) : six_digits_down(f.limit);
}

/// The value without its unit; beside a limit that it breaks, with as many digits as show the
/// difference.
std::string value_number(const Finding& f) {
  return f.broken || is_beyond_by_rounding(f) ? digits_beside(f.value, limit_number(f))
                                              : rounded(f.value);
}

std::string in_unit(const std::string& number, const std::string& unit) {
  return unit.empty() ? number : number + " " + unit;
}

/// Verdict of a curve against a limit, with its margin.
std::string verdict(const Finding& finding, const std::string& unit) {
  // The limit of a master is not in the spec: it follows from those of the slave.
  const bool derived = finding.rule.text().starts_with("limit/master_");
  const std::string limit =
      in_unit(limit_number(finding), unit) + (derived ? " (from limits.slave)" : "");
  if (std::isinf(finding.limit) && !finding.broken) return "has no limit";
  if (derived && finding.broken && finding.limit == 0)
    return "is not possible: the slave exceeds a limit here at any speed of the master";
  if (finding.broken && is_position_limit(finding))
    return fmt::format("{} the limit {} by {}",
                       finding.value > finding.limit ? "exceeds" : "is below", limit,
                       with_unit(std::abs(finding.value - finding.limit), unit));
  if (finding.rule == "follower/contact")  // its margin is no share of the limit
    return finding.broken && finding.limit == 0
               ? "shows that the follower lifts off"
               : fmt::format("is {} the minimum {}", finding.broken ? "below" : "above", limit);
  if (is_least(finding))
    return fmt::format("is {} {} the minimum {}", percent(finding.margin),
                       finding.broken ? "below" : "above", limit);
  if (finding.margin < -1000) return "is more than 1000 times the limit " + limit;
  if (finding.margin < -10)
    return fmt::format("is {:.3g} times the limit {}", 1 - finding.margin, limit);
  if (finding.broken && finding.value < finding.limit &&
      std::abs(finding.value) < std::abs(finding.limit))
    return fmt::format("is {} below the lower limit {}", percent(finding.margin), limit);
  if (finding.broken)
    return fmt::format("exceeds the limit {} by {}", limit, percent(finding.margin));
  if (is_beyond_by_rounding(finding))
    return fmt::format("exceeds the limit {} by {}, through the rounding of its knots", limit,
                       percent(finding.value / finding.limit - 1));
  if (std::abs(finding.margin) < just_met) return fmt::format("just meets the limit {}", limit);
  if (is_position_limit(finding))
    return fmt::format("stays within the limit {} by {} of the travel", limit,
                       percent(finding.margin));
  return fmt::format("is {} below the limit {}", percent(finding.margin), limit);
}

/// Distance above the proven bound.
std::string of_bound(const Finding& f, const std::string& where) {
  if (f.rule == "bound/duration")
    return fmt::format("{} = {} is {} {} {}, the greatest possible value", f.quantity,
                       rounded(f.value), percent(f.margin), f.broken ? "above" : "below",
                       rounded(f.limit));
  if (f.rule.family() == RuleFamily::identity)
    return fmt::format("{} of the rise from {} is {}; for every motion it is {}", f.quantity, where,
                       rounded(f.value), rounded(f.limit));
  const char* whose = f.rule == "bound/acceleration_for_jerk" ? "for its jerk" : "of any motion";
  return fmt::format("{} {} at {} is {} {} {}, the minimum {}", f.quantity, rounded(f.value), where,
                     percent(f.margin), f.broken ? "below" : "above", rounded(f.limit), whose);
}

/// Findings that are allowed but perhaps not intended.
std::string of_warning(const Finding& f, const std::string& value, const std::string& where,
                       const std::string& unit) {
  if (f.rule == "warning/no_limits" && f.quantity != "limits")
    return f.quantity + " is not checked: the check compares the motion with nothing";
  if (f.rule == "warning/no_limits")
    return "no limit is given: the check compares the motion with nothing";
  if (f.rule == "warning/not_played")
    return "the executor does not play this table: over time, outside = \"advance\" is not "
           "possible";
  if (f.rule == "warning/older_table")
    return "the table is older than its spec: " + f.quantity +
           " has changed since the table was made";
  if (f.rule == "warning/overshoot")
    return fmt::format("position {} at {} is beyond the segment's end {} by {}", value, where,
                       with_unit(f.limit, unit), with_unit(std::abs(f.value - f.limit), unit));
  if (f.rule == "warning/velocity_overshoot")
    return fmt::format("{} {} at {} exceeds {}, the {} at the end of the segment", f.quantity,
                       value, where, with_unit(f.limit, unit), f.quantity);
  if (f.rule == "warning/reversal")
    return fmt::format("the segment reverses: {} is {} at {}", f.quantity, value, where);
  return fmt::format("{} {} at {} has the opposite sign of the {} at both ends of the segment",
                     f.quantity, value, where, f.quantity);
}

/// Warnings of a table over time.
std::string of_table(const Finding& f, const std::string& value, const std::string& where) {
  if (f.rule == "pt/oscillation")
    return fmt::format(
        "{} alternates from point to point: it changes by {} up to {}, and then back", f.quantity,
        value, where);
  if (f.rule == "pt/end_velocity")
    return fmt::format("{} is {} at the end, {}", f.quantity, value, where);
  return fmt::format("{} is {} at {}", f.quantity, value, where);
}

/// Findings that prevent an output from firing as intended.
std::string of_compare(const Finding& f, const std::string& value, const std::string& where) {
  if (f.rule == "compare/missed")
    return fmt::format("{} of {} points fire", rounded(f.value), rounded(f.limit));
  if (f.rule == "compare/merged")
    return fmt::format("the points at {1} are only {0} apart, less than the length of the pulse",
                       value, where);
  return fmt::format("the output fires late, by up to {} at {}", value, where);
}

/// Findings of a coupling without a limit: a step, a figure, or a start that it refuses.
std::string of_coupling(const Finding& f, const std::string& value, const std::string& where) {
  const bool steps = f.broken;
  if (f.rule == "coupling/start")
    return steps ? fmt::format("{} steps by {} where the slave engages, at {}", f.quantity, value,
                               where)
                 : fmt::format("{} is continuous where the slave engages", f.quantity);
  if (f.rule == "coupling/period")
    return steps ? fmt::format("{} steps by {} at the end of each period", f.quantity, value)
                 : fmt::format("{} is continuous from period to period", f.quantity);
  if (f.rule == "coupling/enter")
    return fmt::format("the cam already has the velocity {} where the master enters it, at {}",
                       value, where);
  if (f.rule == "coupling/end" || f.rule == "coupling/begin")
    return fmt::format("the cam {} in motion, with {} {} at {}",
                       f.rule == "coupling/end" ? "ends" : "begins", f.quantity, value, where);
  if (f.rule == "coupling/ramp")
    return fmt::format("the ramp reaches {} {} {} {}", f.quantity, value,
                       f.where_unit.empty() ? "at" : "after", where);
  return fmt::format("the slave cannot engage while its master is at {}", where);
}

/// Findings of a slave in step: knives, shears, gears.
std::string of_sync(const Finding& f, const std::string& where) {
  if (f.rule == "shear/sync")
    return fmt::format(
        "the carriage is in step for only {} {}, from {} on; at least {} {} is recommended",
        rounded(f.value), f.unit, where, rounded(f.limit), f.unit);
  if (f.rule == "knife/reversal")
    return f.broken ? fmt::format("the knife reverses at {}", where)
                    : fmt::format("the knife never reverses; it is slowest at {}", where);
  if (f.rule == "gear/ratio_step")
    return fmt::format("the ratio steps from {} to {} {} at {}, where the slave engages",
                       rounded(f.limit), rounded(f.value), f.unit, where);
  if (f.rule == "gear/reversal")
    return fmt::format("the slave moves backwards while it engages, fastest at {}", where);
  if (f.rule == "knife/slip")
    return fmt::format("along the web, the blade is {:.3g} % too slow at {}", 100 * f.value, where);
  if (f.broken)
    return fmt::format("the blade is in the web for {} {}, but in step for only {} {}",
                       rounded(f.limit), f.unit, rounded(f.value), f.unit);
  return fmt::format("the blade is in step for {} {}, and in the web for {} {}", rounded(f.value),
                     f.unit, rounded(f.limit), f.unit);
}

/// Findings of velocities that are filled in.
std::string of_fill(const Finding& f, const std::string& value, const std::string& where,
                    const Labels& labels) {
  if (f.rule == "fill/limits")
    return fmt::format(
        "no velocities at the knots keep the limits between {} and the next knot, {} later", where,
        with_unit(f.value, labels.units.x));
  return fmt::format("from {} on, the {} {} at a knot {}", where, f.quantity, value,
                     f.rule == "fill/convex" ? "prevents a curve that bends as the points do"
                                             : "makes the motion reverse");
}

/// A quantity at a place; for a step, its size.
std::string at_its_place(const Finding& f, const std::string& value, const std::string& where) {
  constexpr std::string_view step = "step of ";
  if (!f.quantity.starts_with(step)) return fmt::format("{} is {} at {}", f.quantity, value, where);
  return fmt::format("{} steps by {} at {}", f.quantity.substr(step.size()), value, where);
}

/// Findings of a slave that follows its master.
std::string of_follow(const Finding& f, const std::string& value, const std::string& where,
                      const std::string& unit) {
  if (f.rule == "follow/backwards" || f.rule == "follow/reversal")
    return fmt::format("the slave {}, with {} {} at {}",
                       f.rule == "follow/reversal" ? "reverses" : "moves backwards", f.quantity,
                       value, where);
  if (f.rule == "follow/open_end")
    return fmt::format("the table ends in motion, with {} {} at {}", f.quantity, value, where);
  if (f.rule == "follow/wrap_ratio")
    return fmt::format("{} at the end differs from pass to pass, and is {} at {}", f.quantity,
                       value, where);
  if (f.rule == "follow/end")
    return "the segments end at " + where + ", but not at the end that the spec gives";
  if (f.rule == "follow/begin" && f.broken)
    return "the master never passes " + with_unit(f.limit, unit) + ", where the slave starts";
  return at_its_place(f, value, where);
}

/// A step at a joint, against the required order.
std::string of_step(const Finding& f, const std::string& value, const std::string& where) {
  return f.broken ? at_its_place(f, value, where)
                  : fmt::format("{} is continuous (largest step {})", f.quantity.substr(8), value);
}

std::string of_unstable_loop(const Finding& f, const std::string& where) {
  return fmt::format("the loop is unstable: {} grows by the factor e = 2.718 every {} ms",
                     f.where > 0 ? "an oscillation at " + where : "an error",
                     rounded(1e3 / f.value));
}

/// A quantity against its limit.
std::string of_limit(const Finding& f, const Labels& labels, const std::string& where) {
  const bool met = !f.broken && std::abs(f.margin) < just_met && !is_beyond_by_rounding(f);
  const bool of_whole = f.quantity.starts_with("rms ");  // an rms has no place
  return fmt::format("{} {} {} {}", f.quantity,
                     in_unit(met ? limit_number(f) : value_number(f), labels.unit_of(f)),
                     of_whole ? "over the whole motion" : "at " + where,
                     verdict(f, labels.unit_of(f)));
}

}  // namespace

std::string sentence(const Finding& exact, const Labels& labels) {
  const Finding f = tidy(exact);
  const std::string value = with_unit(f.value, labels.unit_of(f));
  const std::string where = place(f, labels);
  const auto is_at = [&] { return at_its_place(f, value, where); };
  if (f.rule.name() == "integration") return fmt::format("the integration ended at {}", where);
  if (f.rule == "played/fault") return fmt::format("a fault ended the motion at {}", where);
  switch (f.rule.family()) {
    case RuleFamily::table:
      return fmt::format("the table differs from the exact curve by {} at {}; {} is permitted",
                         value, where, with_unit(f.limit, labels.unit_of(f)));
    case RuleFamily::continuity:
      return of_step(f, value, where);
    case RuleFamily::joint:
      return is_at();
    case RuleFamily::follow:
      return of_follow(f, value, where, labels.unit_of(f));
    case RuleFamily::bound:
    case RuleFamily::identity:
      return of_bound(f, where);
    case RuleFamily::warning:
      return of_warning(f, value, where, labels.unit_of(f));
    case RuleFamily::fill:
      return of_fill(f, value, where, labels);
    case RuleFamily::pt:
      return of_table(f, value, where);
    case RuleFamily::knife:
    case RuleFamily::shear:
    case RuleFamily::gear:
      return of_sync(f, where);
    case RuleFamily::coupling:
      return of_coupling(f, value, where);
    case RuleFamily::unlimited:
      return fmt::format("{} has no limit; its peak is {} at {}", f.quantity, value, where);
    case RuleFamily::compare:
      if (f.rule == "compare/speed") break;
      return of_compare(f, value, where);
    case RuleFamily::disc:
      if (f.rule == "disc/corner") return of_step(f, value, where);
      if (f.rule == "disc/interference") return is_at();
      if (f.rule == "disc/profile_radius" && f.limit == 0)
        return is_at() + "; it must be greater than 0";
      break;
    case RuleFamily::drive:
      if (f.rule == "drive/stability") return of_unstable_loop(f, where);
      if (f.rule == "drive/saturation" && f.broken)
        return fmt::format("the torque reaches the limit {} at {}", value, where);
      if (f.rule == "drive/settling_time" && f.broken && f.value <= f.limit)
        return fmt::format("the load does not settle in the {} that are simulated after the motion",
                           value);
      break;
    case RuleFamily::tolerance:
      if (f.rule == "tolerance/stability")
        return "the loop is unstable in " + rounded(f.value) + (f.value == 1 ? " case" : " cases");
      break;
    default:
      break;
  }
  return f.has_limit ? of_limit(f, labels, where) : is_at();
}

}  // namespace jounce
