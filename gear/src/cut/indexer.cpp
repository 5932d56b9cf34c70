// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/indexer.hpp"

#include <string>
#include <utility>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "gear/src/ratio/rest_to_rest.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_sum;

void require_valid(const Indexer& spec) {
  require_finite("distance", spec.distance);
  if (spec.distance == 0) throw InputError("distance", spec.distance, "must not be 0");
  require_positive("cycle", spec.cycle);
  require_positive("motion", spec.motion);
  require_not_negative("before", spec.before);
  if (spec.count < 1) throw InputError("count", std::to_string(spec.count), "must be at least 1");
  const double room = spec.cycle / spec.count;
  if (!(spec.before < room))
    throw InputError(
        "before", spec.before,
        "must be less than " + six_digits_down(room) + ", the time for one step: cycle / count");
  // The rounding of cycle / count is not a dwell.
  if (spec.before + spec.motion > room * (1 + rounded_sum))
    throw InputError(
        "motion", spec.motion,
        "must be at most " + six_digits_down(room - spec.before) +
            ", the time for one step: cycle / count - before, where cycle = " + number(spec.cycle) +
            ", count = " + std::to_string(spec.count) + " and before = " + number(spec.before));
  gear_detail::require_rest_to_rest("law", spec.law, spec.form);
}

/// The cam under construction. All positions are on the grid of the cycle, so it closes to the bit.
struct IndexerBuild {
  const Indexer& spec;
  double master = 0;
  double slave = 0;
  std::vector<Segment> segments = {};
  std::vector<std::string> names = {};
  std::vector<SyncZone> zones = {};

  void dwell(double to) {
    if (!(to - master > rounded_sum * spec.cycle)) return;
    segments.push_back(line(to - master, slave, slave));
    names.emplace_back("dwell");
    zones.push_back({master, to, "dwell"});
    master = to;
  }

  void index(double to, double target) {
    for (const Segment& piece :
         gear_detail::moved(spec.law, spec.form, master, to - master, spec.cycle, slave, target)) {
      segments.push_back(piece);
      names.emplace_back("index");
    }
    master = to;
    slave = target;
  }
};

}  // namespace

SyncCam indexer(const Indexer& spec) {
  require_valid(spec);
  IndexerBuild build{.spec = spec};
  const double room = spec.cycle / spec.count;
  for (int i = 0; i < spec.count; ++i) {
    const double part_end = i + 1 == spec.count ? spec.cycle : (i + 1) * room;
    const auto grid = [&](double x) { return gear_detail::on_grid(x, spec.cycle); };
    build.dwell(grid(i * room + spec.before));
    const double moved = grid(i * room + spec.before + spec.motion);
    const bool full = part_end - moved <= rounded_sum * spec.cycle;
    build.index(full ? grid(part_end) : moved, (i + 1) * spec.distance);
    if (!full) build.dwell(grid(part_end));
  }
  return {Cam(std::move(build.segments), 0, Extrapolation::advance), std::move(build.names),
          std::move(build.zones)};
}

}  // namespace jounce
