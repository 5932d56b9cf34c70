// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/over_time.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/cam/algebra/algebra.hpp"
#include "jounce/design/detail/reference.hpp"
#include "jounce/design/detail/sync_zones.hpp"
#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "design/src/check/master_check.hpp"
#include "design/src/input/file_name.hpp"
#include "design/src/make/table_of.hpp"
#include "design/src/over_time/slave_motion.hpp"

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
    const std::size_t segment = segment_at(cam, at);
    all.push_back(segment < names.size() ? names[segment] : std::to_string(segment + 1));
  }
  return all;
}

/// Makes the table of the motion. The other requirements of [table] count in the unit of the
/// master.
void set_table(Input& slave, const Fitted<OverTime>& motion) {
  slave.options.intervals.reset();
  slave.options.target.reset();
  Sampled table = design_detail::table_of(motion.curve, slave.options, {slave.limits});
  slave.table.table = std::move(table.table);
  slave.table.units = slave.labels.units;
  slave.error = table.error;
  slave.fit += motion.error[0];
  slave.error->position += slave.fit;
  slave.error->velocity += motion.error[1];
  if (const auto* made = std::get_if<NamedCam>(&slave.spec->subject))
    slave.error->velocity += made->velocity_error * slave.spec->master->velocity;
  slave.binding = table.binding;
}

}  // namespace

Input over_time(const Input& input) {
  const auto* cam = std::get_if<Cam>(&*input.curve);
  if (cam == nullptr)
    throw InputError("FILE", design_detail::file_name(input), "is over time already");
  if (!input.spec)
    throw InputError("FILE", design_detail::file_name(input), "is a table without a master");
  const Trajectory master = scaled(master_of(input), 1, 1 / seconds_per_unit(*input.spec));
  const Fitted<OverTime> fitted = design_detail::slave_motion(input);
  const Trajectory& motion = fitted.curve;
  Input slave = input;
  slave.limits = input.spec->slave;
  slave.limits.position_min = input.spec->limits.position_min;
  slave.limits.position_max = input.spec->limits.position_max;
  for (std::size_t k = 0; k < slave.rate_units.size(); ++k)
    slave.rate_units[k] = slave_rate_unit(*input.spec, static_cast<int>(k) + 1);
  slave.labels.units.x = input.spec->time_unit;
  slave.labels.over_master = false;
  slave.labels.segments = names_of(motion, master, *cam, input.labels.segments);
  slave.zones = passed(sync_zones(input), *cam, master);
  set_table(slave, fitted);
  slave.curve = motion;
  slave.residuals.clear();
  slave.spec.reset();  // the segments of the spec are over the master
  return slave;
}

std::string master_speed_text(const Spec& spec) {
  const SpeedUnit unit = master_speed_unit(spec);
  return with_unit(spec.master->velocity / unit.size, unit.name);
}

Input over(const std::string& what, Input input) {
  const bool is_cam = input.labels.over_master;
  if (what == "master" && !is_cam)
    throw InputError(
        "over", what,
        design_detail::file_name(input) + " is over time, without a master: leave out --over");
  if (what != "time") return input;
  if (!is_cam)
    throw InputError("over", what,
                     design_detail::file_name(input) + " is over time already: leave out --over");
  if (!input.spec)
    throw InputError(
        "over", what,
        design_detail::file_name(input) + " is a table, which has no master: give its spec");
  return over_time(input);
}

}  // namespace jounce
