// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/follow_run.hpp"

#include <algorithm>
#include <cmath>

namespace jounce {
namespace {

void follow_from(FollowRun& run, SegmentFifos& fifos, double master) {
  run.waiting = false;
  run.origin = master;
  run.furthest = 0;
  fifos.start(0, run.slave);
}

/// Travel of the slave along its tables. If only one direction counts, it is the greatest travel so
/// far.
double travel(FollowRun& run, double master) {
  const double gone = master - run.origin;
  if (run.dir == 0 || !std::isfinite(gone)) return gone;
  run.furthest = std::max(run.furthest, run.dir * gone);
  return run.furthest;
}

/// True while a slave that follows one direction waits for the master to come back. Call it before
/// travel().
bool is_back(const FollowRun& run, const Sample& now) {
  const double behind = run.furthest - run.dir * (now.master[0] - run.origin);
  return run.dir != 0 && (behind > 0 || (behind == 0 && run.dir * now.master[1] < 0));
}

/// The values of the tables, with respect to the master.
Jet over_master(const FollowRun& run, const Jet& f, bool back) {
  if (back) return {f[0], 0, 0, 0};
  // Derivatives with respect to a master that moves backwards.
  return run.dir < 0 ? Jet{f[0], -f[1], f[2], -f[3]} : f;
}

}  // namespace

void begin(FollowRun& run, SegmentFifos& fifos, double master, double slave) {
  run.slave = slave;
  run.waiting = run.event.event == FollowEvent::pass;
  if (!run.waiting) follow_from(run, fifos, master);
}

Jet step(FollowRun& run, SegmentFifos& fifos, const Sample& before, const Sample& now) {
  if (run.waiting)
    if (const auto at = begin_of(run.event, before, now)) follow_from(run, fifos, at->master[0]);
  if (run.waiting) return {run.slave, 0, 0, 0};
  const bool back = is_back(run, now);
  return over_master(run, fifos.at(travel(run, now.master[0])), back);
}

std::optional<Jet> first_step(FollowRun run, const SegmentFifos& fifos, const Sample& now) {
  if (run.waiting) return std::nullopt;
  const bool back = is_back(run, now);
  const auto f = fifos.first(travel(run, now.master[0]));
  return f ? std::optional(over_master(run, *f, back)) : std::nullopt;
}

}  // namespace jounce
