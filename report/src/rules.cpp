// SPDX-License-Identifier: Apache-2.0
#include "jounce/report/rules.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "jounce/profiles/curve/jet.hpp"

namespace jounce {
namespace {

constexpr std::array rules{
    RuleInfo{"limit/position_min", "The position goes below its lowest permitted value.",
             "Shift or shorten the motion, or lower position_min if the machine permits it."},
    RuleInfo{"limit/position_max", "The position goes above its highest permitted value.",
             "Shift or shorten the motion, or raise position_max if the machine permits it."},
    RuleInfo{"limit/position", "The position leaves its permitted range.",
             "Shift or shorten the motion, or widen the range if the machine permits it."},
    RuleInfo{"limit/master_velocity",
             "At this velocity of the master the slave reaches one of its limits.",
             "Slow the master down, or give the cam more master travel at the named place."},
    RuleInfo{"limit/master_acceleration",
             "The ramps of the master take the slave above one of its limits.",
             "Lower the acceleration of the master, or its velocity."},
    RuleInfo{"limit/load_torque", "The peak torque at the load is above its limit.",
             "Lower the acceleration, or the inertia of the load."},
    RuleInfo{"limit/load_rms_torque", "The rms torque at the load is above its limit.",
             "Lower the acceleration, or add standstill to the cycle."},
    RuleInfo{"limit/acceleration_step",
             "The acceleration steps by more than the jerk limit permits within one cycle of 1 ms.",
             "Make the acceleration continuous, or raise the jerk limit; for a table, use the rule "
             "quintic_hermite."},
    RuleInfo{"limit/velocity_step",
             "The velocity of a table steps by more than the acceleration limit permits within one "
             "cycle of 1 ms.",
             "Use the rule cubic_hermite or quintic_hermite, or more knots."},
    RuleInfo{"limit/*", "The named quantity exceeds its limit. Its value is the exact extremum.",
             "Give the segment more time or master travel, choose another law (`jounce laws`), or "
             "let `jounce optimize` choose."},
    RuleInfo{"unlimited/*", "The named quantity has no limit; the finding states how far it goes.",
             "Give a limit if the machine has one."},
    RuleInfo{"objective/*", "The minimized figure has its value at this place.",
             "Nothing is wrong. To gain more, free knots or segments near this place."},
    RuleInfo{"continuity/*", "The named derivative steps at a joint of two segments.",
             "Make the values at the joint equal, or lower the required order with --continuity."},
    RuleInfo{"table/position", "The table differs from the exact curve by more than its tolerance.",
             "Use more knots: raise intervals or most in [table], or give a tolerance there."},
    RuleInfo{"joint/*",
             "The named derivative steps at a joint of two segments. The step is permitted, but it "
             "can excite vibration.",
             "Choose a law whose ends match, or give the knot a velocity and an acceleration."},
    RuleInfo{"kept/geo_jerk", "The jerk still steps where it stepped in the given cam.",
             "None. To remove the step, add ends = { jerk = 0 } to free."},
    RuleInfo{
        "fixed/*",
        "The result of an optimization misses a value that the spec fixes at an end of a shape.",
        "Give the search more time. If the finding stays, report a defect, with the spec."},
    RuleInfo{"constraint/*", "The best design of a search violates a constraint.",
             "Relax the constraint, or let more numbers of the spec change."},
    RuleInfo{"polydyne/geo_acceleration",
             "The acceleration of the load steps, so the cam itself would have to jump.",
             "Use a law with a continuous fourth derivative for the load."},

    RuleInfo{"warning/no_limits",
             "No limit is given: the check compares the motion with nothing, and cannot fail.",
             "Give [limits] in the spec, or --limit for a table."},
    RuleInfo{
        "warning/older_table",
        "The spec that the table names has changed since the table was made.",
        "Make the table again with the command of the finding, or compare it with `jounce check "
        "TABLE --against SPEC`."},
    RuleInfo{"warning/not_played",
             "The executor does not play the table: over time, none advances in each period.",
             "To play it, set outside to \"hold\" or \"wrap\"."},
    RuleInfo{"warning/overshoot", "The segment leaves the range between its end values.",
             "Move the knots, or lower the velocities at them."},
    RuleInfo{"warning/velocity_overshoot",
             "Within the segment, the velocity exceeds the velocity at the end of the segment.",
             "Change the velocity at one end, or the length of the segment."},
    RuleInfo{"warning/reversal", "The motion reverses within the segment.",
             "Change the velocities at the ends of the segment, or its length."},
    RuleInfo{"warning/ripple",
             "Within the segment, the acceleration has the opposite sign of the accelerations at "
             "both ends.",
             "Give velocities and accelerations that are the derivatives of the positions."},

    RuleInfo{"input/file", "The file cannot be read, or is not a file of Jounce.",
             "Follow the message: it names the place and the cause."},
    RuleInfo{"input/key",
             "A key is missing, is unknown, or has a value that breaks a rule of the file.",
             "Correct the key at the named line. docs/reference/keys.md lists all keys."},
    RuleInfo{"baseline/changed",
             "The motion differs from the accepted version beyond the tolerance, or a limit or "
             "another key of the spec differs.",
             "Accept the new version if the change is intended, or undo it."},
    RuleInfo{"baseline/added", "The file has no accepted version.",
             "None. The file is compared as soon as it has an accepted version."},
    RuleInfo{"baseline/removed", "An accepted file no longer exists.",
             "Remove the accepted version as well, or restore the file."},
    RuleInfo{"baseline/renamed", "The accepted version of the file has another name.",
             "None. The two files are compared."},

    RuleInfo{"bound/*",
             "The figure is compared with the least value that any such motion can have.",
             "None. The margin is the most that another law could gain."},
    RuleInfo{"identity/*", "An integral of the curve differs from its exact value.",
             "Report a defect of the program, with the spec."},

    RuleInfo{"coupling/begin", "The cam begins at a nonzero velocity, and the slave waits at rest.",
             "Let the cam begin at rest, or start with a ramp."},
    RuleInfo{"coupling/end",
             "The cam ends at a nonzero velocity, so the slave brakes after its end.",
             "Let the cam end at rest, repeat it, or stream it with --keep-velocity."},
    RuleInfo{"coupling/enter",
             "The cam moves where the master enters it, and the slave is at rest.",
             "Let the cam begin at rest."},
    RuleInfo{"coupling/period", "The slave jumps at the end of each period.",
             "Use slave_absolute = false, or end the cam where it begins."},
    RuleInfo{"coupling/ramp", "The largest value that the ramp adds while the slave engages.",
             "None. A longer ramp has lower values."},
    RuleInfo{"coupling/start", "The slave jumps when the coupling starts.",
             "Use start = \"ramp_in\", or place the slave on the cam first."},
    RuleInfo{"coupling/*", "The coupling cannot start from this position of the master.",
             "Follow the advice of the finding."},

    RuleInfo{"compare/latency", "The outputs fire late, by the named distance.",
             "Compensate the delay, or pass the points slower."},
    RuleInfo{"compare/merged", "Two pulses are closer than one pulse is long.",
             "Shorten the pulse, spread the points, or pass them slower."},
    RuleInfo{"compare/missed", "Some points of the comparison never fire.",
             "Give points that the motion passes, in its direction."},
    RuleInfo{"compare/speed", "The axis passes the points faster than the device can compare.",
             "Pass them slower, or spread the points."},

    RuleInfo{"disc/pressure_angle", "The pressure angle of the plate is above its limit.",
             "Enlarge the base circle, or give the rise more angle."},
    RuleInfo{"disc/profile_radius", "The convex profile is too sharp, or is undercut.",
             "Enlarge the base circle, or use a smaller roller."},
    RuleInfo{"disc/cutter_radius", "The hollow profile is sharper than the cutter.",
             "Use a smaller cutter, or a gentler law."},
    RuleInfo{"disc/interference", "The cutter or the roller cuts into another part of the profile.",
             "Use a smaller cutter or roller, or enlarge the base circle."},
    RuleInfo{"disc/corner", "The profile has a corner that no roller can follow.",
             "Make the velocity of the cam continuous there."},

    RuleInfo{"drive/torque", "The peak torque of the motor is above its limit.",
             "Use a gentler motion, or a stronger motor."},
    RuleInfo{"drive/rms_torque", "The rms torque of the motor is above its limit.",
             "Add standstill to the cycle, or use a gentler motion."},
    RuleInfo{"drive/rated_torque", "The rms torque is above the rated torque: the motor overheats.",
             "Add standstill to the cycle, or use a larger motor."},
    RuleInfo{"drive/current", "The peak current is above its limit.", "Use a gentler motion."},
    RuleInfo{"drive/velocity", "The motor is faster than its limit.",
             "Slow the motion down, or change the gear ratio."},
    RuleInfo{"drive/max_velocity", "The motion needs a higher speed than the motor can reach.",
             "Slow the motion down, or change the gear ratio."},
    RuleInfo{"drive/following_error", "The peak following error is above its limit.",
             "Use feed-forward, a stiffer loop, or a gentler motion."},
    RuleInfo{"drive/end_following_error", "The following error at the end is above its limit.",
             "Use feed-forward, a stiffer loop, or a law with a gentler end."},
    RuleInfo{"drive/sync_following_error",
             "The following error while the slave is in step is above its limit.",
             "Use feed-forward, a stiffer loop, or a longer approach."},
    RuleInfo{"drive/residual", "The load vibrates after the motion by more than its limit.",
             "Let `jounce optimize` choose a shape for this frequency, or use a shaper."},
    RuleInfo{"drive/settling_time", "The axis needs longer to settle than permitted.",
             "Use a stiffer loop, or a law with a gentler end."},
    RuleInfo{"drive/saturation", "The drive is at its torque limit and cannot follow.",
             "Lower the acceleration or the inertia."},
    RuleInfo{"drive/stability", "The control loop is unstable.",
             "Lower the gains. The finding states the poles and the margins of the loop."},
    RuleInfo{"drive/periodic", "The periodic run does not repeat itself.",
             "Report a defect, with the spec, unless the loop is unstable."},
    RuleInfo{"drive/integration", "The integration of the drive ended before the motion.",
             "Follow the reason of the finding. The usual cause is an unstable loop."},
    RuleInfo{"drive/exact", "Integration and exact solution of the drive differ.",
             "Report it with the spec: one of the two has a defect."},

    RuleInfo{"feasible/*",
             "At the highest velocity of the master the slave exceeds the named limit.",
             "Slow the master down to the stated velocity, or engage over a longer distance."},

    RuleInfo{"fill/monotone", "The velocities let the axis reverse between two points.",
             "Add a knot between the two points, or use velocities = \"monotone\"."},
    RuleInfo{"fill/convex", "The given velocities prevent a curve that bends as the points do.",
             "Add a knot between the two points."},
    RuleInfo{"fill/limits", "Between two knots, the limits need more time than the table gives.",
             "Lengthen this part of the table to the stated time."},

    RuleInfo{"follow/begin", "The master never passes the position at which the slave starts.",
             "Correct the start position: it is absolute, not a distance."},
    RuleInfo{"follow/end", "The segments do not add up to the end that the spec gives.",
             "Compare the segments with their source: one number is probably wrong."},
    RuleInfo{"follow/open_end", "The table ends with a ratio, so the slave stops abruptly.",
             "End with a stop segment, repeat the table, or add another table."},
    RuleInfo{"follow/ratio_step", "The ratio of the slave steps between two segments.",
             "Change the travel of the segment, or make its type normal."},
    RuleInfo{"follow/switch_step", "The ratio steps where one table replaces another.",
             "Begin the second table with a continue segment."},
    RuleInfo{"follow/wrap_step", "The ratio steps where the table repeats.",
             "Make the ratios at both ends equal."},
    RuleInfo{"follow/wrap_ratio", "The ratio at the end differs from pass to pass.",
             "End the table with the ratio that it begins with."},
    RuleInfo{"follow/reversal", "The slave reverses within a segment.",
             "Change the travel of the segment, or the ratio before it."},
    RuleInfo{"follow/backwards", "The slave moves backwards in the named piece.",
             "Change the ends of the piece, if this is not intended."},
    RuleInfo{"follow/whole_master", "A master position is not a whole number of counts.",
             "Round it: the controller takes whole counts."},

    RuleInfo{"follower/contact", "The spring does not hold the follower on the cam.",
             "Use a stiffer spring or more preload, or run slower."},
    RuleInfo{"follower/force", "The contact force is above its limit.",
             "Use a softer spring, a lighter follower, or a gentler cam."},
    RuleInfo{"follower/impact", "The follower lands with more than the permitted speed.",
             "Keep the follower in contact with the cam: see follower/contact."},
    RuleInfo{"follower/residual", "The follower vibrates in the dwell by more than its limit.",
             "Use a gentler law, or run slower."},
    RuleInfo{"follower/integration", "The integration of the follower ended early.",
             "Follow the reason of the finding."},

    RuleInfo{"gear/ratio_step", "The ratio steps where the slave engages.",
             "Engage over a distance greater than 0, or give from_ratio if the slave already moves "
             "with its master."},
    RuleInfo{"gear/reversal", "The slave reverses while it engages.",
             "Choose slave_start in the range that the finding states."},
    RuleInfo{"knife/contact", "The blade touches the web before it is in step.",
             "Enlarge sync_angle to the stated angle."},
    RuleInfo{"knife/reversal", "The knife reverses between two cuts: the pieces are long.",
             "Set dwell = true, so that the knife stops between the cuts."},
    RuleInfo{"knife/slip", "Along the web the blade is slower than the web while it cuts.",
             "Use matching = \"horizontal\", which leaves no slip."},
    RuleInfo{"shear/sync",
             "The carriage is in step for less than 1 % of the cut length, or for less than 1 ms.",
             "Lengthen the stroke, cut longer pieces, or slow the line down."},

    RuleInfo{"inverse/dwell", "The slave stands still there, so the inverse would jump.",
             "Invert the parts before and after the dwell separately."},
    RuleInfo{"inverse/jump", "The slave jumps there, so no master belongs to the values between.",
             "Make the cam continuous."},
    RuleInfo{"inverse/reversal", "The slave passes the same value twice.",
             "Choose a branch of the cam."},

    RuleInfo{"pt/velocity_step", "The velocity steps at a point of the table.",
             "Use a rule with a continuous velocity, or change the point."},
    RuleInfo{"pt/end_velocity", "The table ends at a nonzero velocity.",
             "End with a stop segment, or stream another table."},
    RuleInfo{"pt/oscillation", "The velocity alternates from point to point.",
             "Smooth the points, or use another rule."},
    RuleInfo{"pt/wrap", "The table does not end where it begins, so its repetition steps.",
             "Make the ends equal, or play it once."},

    RuleInfo{"tolerance/stability", "The loop is unstable in some of the drawn cases.",
             "Lower the gains, or narrow the tolerances."},
    RuleInfo{"tolerance/integration", "Some of the drawn cases were not integrated to their end.",
             "The figures exclude these cases. See the reason of the finding."},
    RuleInfo{"tolerance/*", "With its tolerances the named figure is above its limit.",
             "Narrow the tolerance that the finding names, or use a gentler motion."},

    RuleInfo{"witness/*", "The integration with SUNDIALS differs from the exact curve.",
             "Report it with the spec: one of the two has a defect."},
    RuleInfo{"played/gap", "Ticks are missing in the log.",
             "Use the complete log. An executor that was suspended also leaves out ticks."},
    RuleInfo{"played/complete", "The log ends before the motion does.",
             "Stream the table again, and wait for its end."},
    RuleInfo{"played/fault", "A fault of the axis ended the motion.",
             "The column `fault` of the log names the fault: run `jounce explain` with this name."},
    RuleInfo{"played/*", "The log of the executor differs from the table.",
             "Look for a late cycle or an override in the log. If there is none, report a defect."},
};

}  // namespace

std::span<const RuleInfo> all_rules() {
  return rules;
}

const RuleInfo* rule_info(std::string_view rule) {
  const auto named = [](std::string_view name) {
    return [name](const RuleInfo& one) { return one.rule == name; };
  };
  const auto own = std::find_if(rules.begin(), rules.end(), named(rule));
  if (own != rules.end()) return &*own;
  const std::string family = std::string(rule.substr(0, rule.find('/'))) + "/*";
  const auto whole = std::find_if(rules.begin(), rules.end(), named(family));
  return whole != rules.end() ? &*whole : nullptr;
}

std::vector<std::string> quantities_of(std::string_view family) {
  constexpr std::array<std::string_view, 6> families{"limit/*", "unlimited/*", "continuity/*",
                                                     "joint/*", "fixed/*",     "witness/*"};
  if (std::find(families.begin(), families.end(), family) == families.end()) return {};
  std::vector<std::string> words{"direction",  "curvature",  // geometry of a path
                                 "slave",      "value",
                                 "geo_jounce", "geo_crackle"};  // free shapes
  words.insert(words.end(), OverTime::names.begin(), OverTime::names.end());
  words.insert(words.end(), OverMaster::names.begin() + 1, OverMaster::names.end());
  if (family == "witness/*") words.emplace_back("integration");
  if (family != "limit/*") return words;
  const std::vector<std::string> peaks = words;
  for (const std::string& one : peaks)
    for (const char* end : {"_min", "_max", "_step"}) words.push_back(one + end);
  for (const char* own : {"deceleration", "normal_acceleration", "total_acceleration", "residual",
                          "ramped_geo_velocity", "ramped_geo_acceleration", "ramped_geo_jerk"})
    words.emplace_back(own);
  return words;
}

}  // namespace jounce
