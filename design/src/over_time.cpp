// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/over_time.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/design/reference.hpp"
#include "jounce/design/sync_zones.hpp"
#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "design/src/master_check.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;

constexpr std::size_t most_zones = 200;

/// The time at which the master first passes x.
double time_at(const Trajectory& master, double x) {
  const std::vector<double> all = crossings(master, 0, x);
  return all.empty() ? master.end() : all.front();
}

/// The intervals of time in which the master is in the zones, for all periods.
std::vector<SyncZone> passed(const std::vector<SyncZone>& zones, const Cam& cam,
                             const Trajectory& master) {
  std::vector<SyncZone> all;
  const double first = master.jet(master.start())[0];
  const double last = master.jet(master.end(), Side::left)[0];
  const double turns = repeats(cam.outside()) ? std::floor((last - cam.start()) / cam.length()) : 0;
  if (turns * static_cast<double>(zones.size()) > most_zones) return all;
  for (double turn = 0; turn <= turns; ++turn)
    for (const SyncZone& zone : zones) {
      const double from = std::max(first, zone.from + turn * cam.length());
      const double to = std::min(last, zone.to + turn * cam.length());
      if (!(to > from)) continue;
      const double start = time_at(master, from);
      const bool goes_on = !all.empty() && all.back().name == zone.name &&
                           start - all.back().to <= rounded_input * master.length();
      if (goes_on)
        all.back().to = time_at(master, to);
      else
        all.push_back({start, time_at(master, to), zone.name});
    }
  return all;
}

/// For each piece of the motion, the name of the cam's segment.
std::vector<std::string> names_of(const Trajectory& slave, const Trajectory& master, const Cam& cam,
                                  const std::vector<std::string>& names) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < slave.segments().size(); ++i) {
    const double at = master.jet((slave.breaks()[i] + slave.breaks()[i + 1]) / 2)[0];
    const double x = repeats(cam.outside()) ? wrapped(at, cam.start(), cam.length())
                                            : std::clamp(at, cam.start(), cam.end());
    const auto after = std::upper_bound(cam.breaks().begin() + 1, cam.breaks().end() - 1, x);
    const auto segment = static_cast<std::size_t>(after - cam.breaks().begin()) - 1;
    all.push_back(segment < names.size() ? names[segment] : std::to_string(segment + 1));
  }
  return all;
}

}  // namespace

Input over_time(const Input& input) {
  const auto* cam = std::get_if<Cam>(&*input.curve);
  if (cam == nullptr) throw InputError("input", input.name, "is over time already");
  if (!input.spec) throw InputError("input", input.name, "is a table without a master");
  const Trajectory master = scaled(master_of(input), 1, 1 / seconds_per_unit(*input.spec));
  Trajectory motion = motion_over_time(input);
  Input slave = input;
  slave.limits = input.spec->slave;
  for (std::size_t k = 0; k < slave.rate_units.size(); ++k)
    slave.rate_units[k] = slave_rate_unit(*input.spec, static_cast<int>(k) + 1);
  slave.labels.units.x = input.spec->time_unit;
  slave.labels.over_master = false;
  slave.labels.segments = names_of(motion, master, *cam, input.labels.segments);
  slave.zones = passed(sync_zones(input), *cam, master);
  slave.curve = std::move(motion);
  slave.spec.reset();  // the segments of the spec are over the master
  return slave;
}

}  // namespace jounce
