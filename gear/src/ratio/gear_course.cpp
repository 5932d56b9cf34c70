// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/gear_course.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "jounce/profiles/detail/entry_key.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using profiles_detail::entry_key;

/// Segments with their names. The values of each segment begin at the end value of the previous
/// one.
struct Chain {
  std::vector<Segment> segments = {};
  std::vector<std::string> names = {};
  double x = 0;
  double y = 0;

  void add(Segment f, const std::string& name) {
    segments.push_back(scaled(f, 1, y - value(f, 0)));
    names.push_back(name);
    x += f.length;
    y = value(segments.back(), 1);
  }
  /// Appends a straight line up to `end`, if `end` lies ahead.
  void run_to(double end, double ratio, const std::string& name) {
    const double length = end - x;
    if (length > 0) add(line(length, 0, ratio * length), name);
    x = end;
  }
};

/// The law from 0 to 1 over a distance.
std::vector<Segment> rise(Law law, double distance, const std::string& key_of_law) {
  if (!has_own_shape(law) || law == Law::dwell || law == Law::scca || reverses(info(law).ends))
    throw InputError(key_of_law, name(law), "must be a line or a law from rest to rest");
  std::vector<Segment> all = normalized(law);
  for (Segment& f : all) f.length *= distance;
  return all;
}

void require_valid(const GearCourse& c) {
  require_finite("master_start", c.master_start);
  require_finite("master_end", c.master_end);
  require_finite("slave_start", c.slave_start);
  require_finite("ratio", c.ratio);
  if (!(c.master_end > c.master_start))
    throw InputError("master_end", c.master_end,
                     "must be greater than master_start, " + number(c.master_start));
}

/// Requires a finite position inside the course.
void require_inside(const GearCourse& c, const char* list, std::size_t i, double at,
                    double distance) {
  require_finite(entry_key(list, i, "at").c_str(), at);
  require_finite(entry_key(list, i, "distance").c_str(), distance);
  if (at < c.master_start)
    throw InputError(entry_key(list, i, "at"), at,
                     "must be at least " + number(c.master_start) + ", the start");
  if (at + distance > c.master_end)
    throw InputError(entry_key(list, i, "distance"), distance,
                     "must be at most " + number(c.master_end - at) + ": the change begins at " +
                         six_digits(at) +
                         " and must end at or before master_end = " + number(c.master_end));
}

const char* name_of(double ratio) {
  return ratio == 0 ? "hold" : "gear";
}

/// Appends a clutch: equations (1) and (2) of gear_course.hpp.
void add_clutch(Chain& chain, double before, const RatioChange& change,
                const std::string& key_of_law) {
  for (const Segment& f : rise(change.law, change.distance, key_of_law)) {
    const auto way = integral(scaled(f, change.ratio - before, before), 0);
    if (!way) throw InputError(key_of_law, name(change.law), "has too high a degree for a ratio");
    chain.add(*way, "clutch");
  }
}

Chain ratios(const GearCourse& c) {
  Chain chain{.x = c.master_start, .y = c.slave_start};
  double ratio = c.ratio;
  for (std::size_t i = 0; i < c.changes.size(); ++i) {
    const RatioChange& change = c.changes[i];
    require_inside(c, "change", i, change.at, change.distance);
    require_finite(entry_key("change", i, "ratio").c_str(), change.ratio);
    require_not_negative(entry_key("change", i, "distance").c_str(), change.distance);
    if (change.at < chain.x)
      throw InputError(
          entry_key("change", i, "at"), change.at,
          "must be at least " + six_digits(chain.x) + ", the end of the previous change");
    chain.run_to(change.at, ratio, name_of(ratio));
    if (change.distance > 0) add_clutch(chain, ratio, change, entry_key("change", i, "law"));
    ratio = change.ratio;
  }
  chain.run_to(c.master_end, ratio, name_of(ratio));
  return chain;
}

Chain shift_of(const GearCourse& c, std::size_t i) {
  const PhaseShift& shift = c.shifts[i];
  require_inside(c, "shift", i, shift.at, shift.distance);
  require_finite(entry_key("shift", i, "shift").c_str(), shift.shift);
  require_positive(entry_key("shift", i, "distance").c_str(), shift.distance);
  if (shift.law == Law::line)
    throw InputError(entry_key("shift", i, "law"), "line", "must be a law from rest to rest");
  Chain chain{.x = c.master_start};
  chain.run_to(shift.at, 0, "");
  for (const Segment& f : rise(shift.law, shift.distance, entry_key("shift", i, "law")))
    chain.add(scaled(f, shift.shift), "phase");
  chain.run_to(c.master_end, 0, "");
  return chain;
}

/// The name of the segment of a chain that contains x.
std::string name_at(const Chain& chain, double start, double x) {
  double end = start;
  for (std::size_t i = 0; i < chain.names.size(); ++i)
    if ((end += chain.segments[i].length) > x) return chain.names[i];
  return chain.names.back();
}

bool rests(const Cam& cam) {
  return cam.jet(cam.start())[1] == 0 && cam.jet(cam.end(), Side::left)[1] == 0;
}

}  // namespace

SyncCam gear_course(const GearCourse& c) {
  require_valid(c);
  const Chain gear = ratios(c);
  SyncCam made{Cam(gear.segments, c.master_start)};
  std::vector<Chain> shifts;
  for (std::size_t i = 0; i < c.shifts.size(); ++i) {
    shifts.push_back(shift_of(c, i));
    made.cam = sum(made.cam, Cam(shifts.back().segments, c.master_start));
  }
  const auto breaks = made.cam.breaks();
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double middle = (breaks[i] + breaks[i + 1]) / 2;
    std::string name = name_at(gear, c.master_start, middle);
    for (const Chain& shift : shifts)
      if (name_at(shift, c.master_start, middle) == "phase") name = "phase";
    if (name == "gear") made.zones.push_back({breaks[i], breaks[i + 1], name});
    made.segments.push_back(std::move(name));
  }
  if (rests(made.cam)) made.cam = with(made.cam, Extrapolation::hold);
  return made;
}

}  // namespace jounce
