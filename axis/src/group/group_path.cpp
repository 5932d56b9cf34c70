// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/detail/group_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "jounce/axis/detail/path_clock.hpp"

namespace jounce {
GroupPath::GroupPath(std::uint64_t id, GroupProgram program)
    : Movement(id, Course::path),
      program_(std::move(program)),
      cursor_(*program_.plan),
      peaks_(peaks_of(program_.plan->law())) {
  seek(0);
}

void GroupPath::seek(double t) {
  std::array<Motion, max_axes> motion;
  cursor_.at(t, std::span(motion).first(program_.first + program_.axes.size()));
  for (std::size_t k = 0; k < program_.axes.size(); ++k) {
    const Motion& axis = motion[program_.first + k];
    parts_[k] = {axis.position, axis.velocity, axis.acceleration, axis.jerk};
  }
}

Cause GroupPath::begin(const MotionState& group, const Moment& /*now*/) noexcept {
  origin_ = group.position;
  return played_ ? Cause::no_movement : Cause::none;
}

Setpoint GroupPath::at(const Moment& now) noexcept {
  const double end = program_.plan->duration();
  const double t = std::clamp(now.t, 0.0, end);
  played_ = true;
  seek(t);
  const Motion q = program_.plan->law().at(t);
  Setpoint next{0, 0, {origin_ + q.position, q.velocity, q.acceleration, q.jerk}};
  if (now.t < end) return next;
  progress_ = Progress::done;
  const LawInterval last = program_.plan->law().stretches().back();
  // A replay has only the law: its length differs from that of a fitted path by rounding.
  next.slave = {origin_ + (last.start + last.length), 0, 0, 0};
  for (Jet& part : parts_) part = {part[0], 0, 0, 0};
  return next;
}

std::span<const PathSwitch> GroupPath::switches(double from, double to) const noexcept {
  const std::span<const PathSwitch> all = program_.switches;
  if (all.empty()) return all;
  const auto since = [&](double time) {
    return std::lower_bound(all.begin(), all.end(), time,
                            [](const PathSwitch& one, double at) { return one.time < at; });
  };
  const auto end = to >= program_.plan->duration() ? all.end() : since(to);
  const auto first = since(from);
  return first < end ? std::span(first, end) : std::span<const PathSwitch>();
}

PathPlace GroupPath::along(double time) const noexcept {
  const double end = program_.plan->duration();
  const Motion q = program_.plan->law().at(std::clamp(time, 0.0, end));
  if (!program_.length) return {q.position, q.velocity};
  const auto [length, slope] = program_.length->at(q.position);
  return {length, slope * q.velocity};
}

double GroupPath::highest_rate() const noexcept {
  double rate = 2;
  for (const GroupAxis& axis : program_.axes)
    rate = std::min(rate, jounce::highest_rate(axis.peaks, axis.config));
  return rate;
}

double GroupPath::rate_slope(double highest) const noexcept {
  double slope = std::numeric_limits<double>::infinity();
  for (const GroupAxis& axis : program_.axes)
    slope = std::min(slope, jounce::rate_slope(axis.peaks, axis.config, highest));
  return slope;
}

}  // namespace jounce
