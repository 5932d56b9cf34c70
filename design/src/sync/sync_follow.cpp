// SPDX-License-Identifier: Apache-2.0
#include "design/src/sync/sync_follow.hpp"

#include <fmt/format.h>

#include "jounce/base/units.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/report/report_text.hpp"

namespace jounce {
namespace {

/// The spec's master from 0, in its own time unit.
Trajectory master_of(const MasterSpec& master) {
  const double to = master.distance;
  if (!master.acceleration) return Trajectory({line(to / master.velocity, 0, to)});
  return trapezoid({.to = to, .velocity = master.velocity, .acceleration = *master.acceleration})
      .curve();
}

Finding beginning(const FollowStart& start, const Spec& spec) {
  const auto t = begin_of(start, master_of(*spec.master), 0);
  Finding f;
  f.rule = "follow/begin";
  f.quantity = "the master";
  f.unit = spec.units.x;
  f.where_unit = spec.time_unit;
  f.where = t.value_or(0);
  f.value = t ? start.position : 0;
  f.limit = start.position;
  f.margin = t ? 1 : -1;
  f.broken = !t;
  if (!t)
    f.advice = "the master moves from 0 to " + number(spec.master->distance) + " " + spec.units.x +
               ", but the slave waits until its master passes this position" +
               (start.direction > 0 ? " forwards" : " backwards") +
               ". The position is absolute, not a distance: correct it, or [master]";
  return f;
}

/// Adds the velocity of the slave to the advice for tables that end at a ratio.
void add_speed(Report& report, const Spec& spec) {
  for (Finding& f : report.findings)
    if (f.rule == "follow/open_end" && spec.master)
      f.advice =
          fmt::format("at the master velocity {} {}, the slave moves at {} {} there; {}",
                      rounded(spec.master->velocity), rate_unit(spec.units.x, spec.time_unit, 1),
                      rounded(f.value * spec.master->velocity),
                      rate_unit(spec.units.position, spec.time_unit, 1), f.advice);
}

Report checked(const FollowPart& part, const Spec& spec) {
  Report report = std::visit([](const auto& slave) { return check(slave); }, part.slave);
  add_speed(report, spec);
  if (part.start.event == FollowEvent::pass && spec.master)
    report.findings.push_back(beginning(part.start, spec));
  return report;
}

}  // namespace

Report check_follow(const Spec& spec) {
  const auto* sync = std::get_if<SyncSpec>(&spec.subject);
  const auto* part = sync != nullptr ? std::get_if<FollowPart>(sync) : nullptr;
  if (part == nullptr) return {};
  try {
    Report report = checked(*part, spec);
    for (Finding& f : report.findings) f.advice = with_units(f.advice, spec.document.nouns);
    return report;
  } catch (const InputError& error) {
    throw spec.document.located(error);
  }
}

}  // namespace jounce
