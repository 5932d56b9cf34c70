// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/coupling/coupled.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/curve/roots.hpp"

namespace jounce {
namespace {

/// The master, extended at rest after its end until the correction is complete.
Trajectory lasting(const Trajectory& master, const Engaged& engaged) {
  const double end = engaged.time + engaged.correction.duration();
  if (!(end > master.end())) return with(master, Extrapolation::hold);
  const double at = master.jet(master.end(), Side::left)[0];
  return with(concatenated(master, Trajectory({line(end - master.end(), at, at)})),
              Extrapolation::hold);
}

/// True if the cam advances by the same distance as the placement.
bool advances_alike(const Cam& cam, const Placement& p) {
  const double own = value(cam.segments().back(), 1) - value(cam.segments().front(), 0);
  return p.advance == p.slave_scaling * own;
}

/// The cam over all periods that the master meets, each higher by `advance`; without an advance, a
/// cam that wraps.
Cam unrolled(const Cam& cam, const Placement& p, const Trajectory& master) {
  const Range travel = extrema(master, 0);
  const double first = spot(p.at(travel.min.value), cam.start(), cam.length(), true).period - 1;
  const double last = spot(p.at(travel.max.value), cam.start(), cam.length(), true).period + 1;
  require_few_periods(first, last, cam.breaks().size());
  std::vector<Segment> segments;
  for (double n = first; n <= last; ++n)
    for (const Segment& piece : cam.segments())
      segments.push_back(scaled(piece, p.slave_scaling, n * p.advance + p.slave_offset));
  return Cam(std::move(segments), cam.start() + first * cam.length(), Extrapolation::hold);
}

/// The cam over the master's own position, with all scalings and offsets.
Cam over_master(const Coupling& coupling, const Placement& p, const Trajectory& master) {
  const Cam& cam = coupling.cam();
  const auto in_place = [&] { return shifted(scaled(cam, p.slave_scaling), 0, p.slave_offset); };
  Cam placed = p.advance == 0           ? in_place()
               : advances_alike(cam, p) ? with(in_place(), Extrapolation::advance)
                                        : unrolled(cam, p, master);
  if (!p.periodic) placed = with(placed, Extrapolation::hold);
  const double k = p.master_scaling;
  if (k == 1 && p.master_offset == 0) return placed;
  return shifted(scaled(placed, 1, 1 / k), -p.master_offset / k);
}

/// The time at which the master is first `distance` away from the start of the correction.
std::optional<double> gone(const Cam& correction, const Trajectory& master) {
  std::optional<double> first;
  for (const double level : {correction.start(), correction.end()})
    for (const double t : crossings(master, 0, level))
      if (!first || t < *first) first = t;
  return first;
}

}  // namespace

Coupled::Coupled(const Coupling& coupling, const Engaged& engaged, const Trajectory& given)
    : cam_(over_master(coupling, engaged.placement, given), lasting(given, engaged)),
      in_sync_(cam_.start()) {
  add_breaks(cam_.breaks());
  const Correction& c = engaged.correction;
  if (c.duration() > 0) {
    over_time_ = shifted(c.profile().curve(), engaged.time);
    in_sync_ = over_time_->end();
    add_breaks(over_time_->breaks());
  } else if (c.follows_master()) {
    over_master_.emplace(c.curve(), cam_.master());
    in_sync_ = gone(over_master_->cam(), cam_.master());
    add_breaks(over_master_->breaks());
  }
}

void Coupled::add_breaks(std::span<const double> breaks) {
  breaks_.insert(breaks_.end(), breaks.begin(), breaks.end());
  std::sort(breaks_.begin(), breaks_.end());
  const double apart = 1e-12 * (end() - start());
  breaks_.erase(std::unique(breaks_.begin(), breaks_.end(),
                            [&](double a, double b) { return b - a <= apart; }),
                breaks_.end());
  while (breaks_.back() > end()) breaks_.pop_back();
  breaks_.back() = end();
}

Jet Coupled::jet(double t, Side side) const {
  Jet y = cam_.jet(t, side);
  if (in_sync_ && (t > *in_sync_ || (t == *in_sync_ && side == Side::right))) return y;
  const Jet c = over_time_     ? over_time_->jet(t, side)
                : over_master_ ? over_master_->jet(t, side)
                               : Jet{};
  for (std::size_t k = 0; k < y.size(); ++k) y[k] += c[k];
  return y;
}

}  // namespace jounce
