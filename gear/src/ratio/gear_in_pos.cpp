// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/gear_in_pos.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "jounce/cam/algebra/algebra.hpp"
#include "jounce/cam/design/design.hpp"
#include "jounce/gear/gear.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

// The engagement over z in [0, 1] is h times the law from rest to the slope rho (VDI 2143: R-G).
// For the quintic, this law is
//
//   (2)  f(z) = (10 - 4 rho) z^3 - (15 - 7 rho) z^4 + (6 - 3 rho) z^5
//
// f' = z^2 (3 (10 - 4 rho) - 4 (15 - 7 rho) z + 5 (6 - 3 rho) z^2) stays >= 0 for 0 <= rho <= 5/2,
// and <= rho for rho >= 5/3. The code does not use (2) to detect a reversal: for every law, it
// tests the exact extrema of the slope.

namespace jounce {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_sum;

constexpr int most_turns = 5;

double ratio_of(const GearInPosSpec& spec) {
  const Gear gear = Gear::ratio(spec.numerator, spec.denominator);
  return static_cast<double>(gear.numerator()) / static_cast<double>(gear.denominator());
}

void require_valid(const GearInPosSpec& spec) {
  (void)Gear::ratio(spec.numerator, spec.denominator);
  if (spec.numerator == 0) throw InputError("numerator", "0", "must not be 0");
  require_finite("master_sync_position", spec.master_sync_position);
  require_finite("slave_sync_position", spec.slave_sync_position);
  require_finite("master_start_distance", spec.master_start_distance);
  require_finite("slave_start", spec.slave_start);
  require_finite("master_position", spec.master_position.value_or(0));
  require_positive("slave_period", spec.slave_period.value_or(1));
  require_positive("master_period", spec.master_period.value_or(1));
  if (spec.master_start_distance == 0)
    throw InputError("master_start_distance", "0",
                     "must not be 0: the slave needs a distance to reach the ratio");
  const Ends ends = info(spec.law).ends;
  if (ends != Ends::given && ends != Ends::moving)
    throw InputError("law", name(spec.law), "must accept a velocity at its end: try \"quintic\"");
}

/// The cam of the engagement between master_start (at rest) and master_sync (at the ratio), in
/// ascending order of the master.
Cam curve_of(const GearInPos& gear, Law law) {
  const CamKnot rest{gear.master_start, gear.slave_start, 0, 0};
  const CamKnot sync{gear.master_sync, gear.slave_sync, gear.ratio, 0};
  const bool forwards = rest.master < sync.master;
  CamSpec cam;
  cam.start = forwards ? rest : sync;
  cam.segments = {{law, forwards ? sync : rest, "engage"}};
  return with(design(cam).cam, Extrapolation::hold);
}

/// True if the slave moves anywhere against the direction of its gear.
bool reverses(const GearInPos& gear) {
  const double way = gear.ratio > 0 ? 1 : -1;
  const Range slope = extrema(*gear.curve, 1);
  const double back = way > 0 ? -slope.min.value : slope.max.value;
  return back > rounded_input * std::abs(slope.peak().value);
}

/// Number of turns of a modulo master until the start lies ahead.
double turns_ahead(const GearInPosSpec& spec, double start) {
  if (!spec.master_position || !spec.master_period) return 0;
  const double way = (*spec.master_position - start) / *spec.master_period;
  return spec.master_start_distance > 0 ? std::ceil(way) : std::floor(way);
}

bool passed(double start, double distance, double master) {
  return distance > 0 ? master > start : master < start;
}

/// Moves the sync position of the slave by whole turns in the direction of the gear, until the
/// slave does not reverse.
void avoid_reversal(GearInPos& gear, const GearInPosSpec& spec) {
  const double direction = gear.ratio * spec.master_start_distance > 0 ? 1 : -1;
  const double sync = gear.slave_sync;
  for (int n = 0; n <= most_turns; ++n) {
    gear.turns = static_cast<int>(direction) * n;
    gear.slave_sync = sync + gear.turns * spec.slave_period.value_or(0);
    gear.curve = curve_of(gear, spec.law);
    if (!reverses(gear)) return;
    if (!spec.slave_period) break;
  }
  gear.curve.reset();
  gear.status = spec.slave_period ? GearInPosStatus::reversal_unavoidable
                                  : GearInPosStatus::reversal_on_linear_axis;
}

Jet geared(double slave_sync, double ratio, double master_sync, const Jet& x) {
  return {slave_sync + ratio * (x[0] - master_sync), ratio * x[1], ratio * x[2], ratio * x[3]};
}

}  // namespace

const char* explain(GearInPosStatus status) {
  switch (status) {
    case GearInPosStatus::ok:
      return "";
    case GearInPosStatus::master_reversed:
      return "The master changed direction while the slave was connecting.";
    case GearInPosStatus::reversal_unavoidable:
      return "The slave would have to reverse, even with five more turns.";
    case GearInPosStatus::reversal_on_linear_axis:
      return "The slave would have to reverse, and a linear axis cannot add a turn instead.";
    case GearInPosStatus::start_passed:
      return "The master has passed the position at which the slave begins to engage.";
  }
  return "";
}

GearInPos gear_in_pos(const GearInPosSpec& spec) {
  require_valid(spec);
  GearInPos gear;
  gear.ratio = ratio_of(spec);
  const double start = spec.master_sync_position - spec.master_start_distance;
  const double lift = turns_ahead(spec, start) * spec.master_period.value_or(0);
  gear.master_start = start + lift;
  gear.master_sync = spec.master_sync_position + lift;
  gear.slave_start = spec.slave_start;
  gear.slave_sync = spec.slave_sync_position;
  if (spec.master_position && !spec.master_period &&
      passed(start, spec.master_start_distance, *spec.master_position))
    gear.status = GearInPosStatus::start_passed;
  else if (spec.avoid_reversal)
    avoid_reversal(gear, spec);
  else
    gear.curve = curve_of(gear, spec.law);
  return gear;
}

EngageWindow engage_window(const GearInPosSpec& spec) {
  require_valid(spec);
  const double k = ratio_of(spec);
  const double h = spec.slave_sync_position - spec.slave_start;
  EngageWindow window;
  window.rho =
      h == 0 ? std::numeric_limits<double>::infinity() : k * spec.master_start_distance / h;
  window.exists = window.rho > 0 && h != 0;
  if (!window.exists) {
    window.advice = h == 0 ? "the slave stands at its sync position: it must reverse to gain speed"
                           : "the slave moves against the gear: it must reverse";
    return window;
  }
  window.least = 5.0 / 3 * std::abs(h / k);
  window.greatest = 2.5 * std::abs(h / k);
  if (window.rho >= 5.0 / 3 * (1 - rounded_sum) && window.rho <= 2.5 * (1 + rounded_sum))
    return window;
  window.advice =
      "a start distance of " + number(window.least) + " to " + number(window.greatest) +
      " instead of " + number(std::abs(spec.master_start_distance)) +
      (window.rho > 2.5 ? ": the slave reverses" : ": the slave exceeds the velocity of the gear");
  return window;
}

SyncCam sync_cam(const GearInPos& gear, double from, double to) {
  assert(gear);
  const bool forwards = gear.master_start < gear.master_sync;
  const double first = gear.curve->start();
  const double last = gear.curve->end();
  if (!(from <= first))
    throw InputError(
        "master_start", from,
        "is past " + six_digits(first) +
            ", the start of the engagement (master_sync_position minus "
            "master_start_distance): begin there" +
            (last > from ? ", or give master_start_distance at most " + six_digits_down(last - from)
                         : ", or give a later master_sync_position"));
  if (!(to >= last))
    throw InputError("master_end", to,
                     "must not be before the end of the engagement, " + six_digits(last));
  SyncCam made{*gear.curve};
  std::vector<Segment> segments;
  const auto add = [&](double length, double y0, double slope, const char* name) {
    if (!(length > 0)) return;
    segments.push_back(line(length, y0, y0 + slope * length));
    made.segments.emplace_back(name);
  };
  const auto engage = [&] {
    for (const Segment& piece : gear.curve->segments()) {
      segments.push_back(piece);
      made.segments.emplace_back("engage");
    }
  };
  if (forwards) {
    add(first - from, gear.slave_start, 0, "hold");
    engage();
    add(to - last, gear.slave_sync, gear.ratio, "gear");
    if (to > last) made.zones.push_back({last, to, "gear"});
  } else {
    add(first - from, gear.slave_sync - gear.ratio * (first - from), gear.ratio, "gear");
    engage();
    add(to - last, gear.slave_start, 0, "hold");
    if (from < first) made.zones.push_back({from, first, "gear"});
  }
  made.cam = Cam(std::move(segments), from);
  return made;
}

GearInPosStep step(const GearInPos& gear, const GearInPosState& state, const Jet& master) {
  assert(gear);
  using Phase = GearInPosState::Phase;
  const double way = gear.master_sync > gear.master_start ? 1 : -1;
  const double u = way * (master[0] - gear.master_start);  // distance from the start, m
  const double before = way * (state.master - gear.master_start);
  GearInPosStep now;
  now.state = {state.phase, true, master[0]};
  Phase& phase = now.state.phase;
  if (phase == Phase::waiting && u >= 0 && (state.began ? before <= 0 : u == 0))
    phase = Phase::connecting;
  if (phase == Phase::connecting && u < 0) phase = Phase::waiting;
  if (phase == Phase::connecting && way * (master[0] - gear.master_sync) >= 0)
    phase = Phase::in_sync;
  const bool went_back = state.phase == Phase::connecting && u < before;
  if (went_back) now.status = GearInPosStatus::master_reversed;
  if (phase == Phase::waiting && u > 0) now.status = GearInPosStatus::start_passed;
  now.start_sync = phase != Phase::waiting;
  now.in_sync = phase == Phase::in_sync;
  if (now.in_sync)
    now.slave = geared(gear.slave_sync, gear.ratio, gear.master_sync, master);
  else if (phase == Phase::connecting)
    now.slave =
        chained(gear.curve->jet(master[0], backwards(master) ? Side::left : Side::right), master);
  else
    now.slave = {gear.slave_start, 0, 0, 0};
  return now;
}

namespace {

/// Time at which the master first reaches its sync position from the side of the start.
std::optional<double> sync_time(const GearInPos& gear, const Trajectory& master) {
  const auto times = crossings(master, 0, gear.master_sync);
  if (times.empty()) return std::nullopt;
  return times.front();
}

const Cam& engagement(const GearInPos& gear, const Trajectory& master) {
  assert(gear);
  const double way = gear.master_sync > gear.master_start ? 1 : -1;
  const double x = master.jet(master.start())[0];
  if (way * (x - gear.master_start) > 0)
    throw InputError("master", x,
                     "begins after the start of the engagement, " + number(gear.master_start));
  return *gear.curve;
}

}  // namespace

GearedInPos::GearedInPos(const GearInPos& gear, const Trajectory& master)
    : connecting_(engagement(gear, master), master),
      ratio_(gear.ratio),
      master_sync_(gear.master_sync),
      slave_sync_(gear.slave_sync),
      in_sync_(sync_time(gear, master)) {
  const double sync = in_sync_.value_or(end());
  for (const double t : connecting_.breaks())
    if (t < sync) breaks_.push_back(t);
  if (in_sync_ && sync > start() && sync < end()) breaks_.push_back(sync);
  for (const double t : master.breaks())
    if (t > sync || (t == end() && (breaks_.empty() || breaks_.back() < t))) breaks_.push_back(t);
}

Jet GearedInPos::jet(double t, Side side) const {
  const bool synchronous = in_sync_ && (side == Side::right ? t >= *in_sync_ : t > *in_sync_);
  if (!synchronous) return connecting_.jet(t, side);
  return geared(slave_sync_, ratio_, master_sync_, connecting_.master().jet(t, side));
}

}  // namespace jounce
