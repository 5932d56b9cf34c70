// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/job.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/pvt/check.hpp"
#include "jounce/pvt/detail/knot_rounding.hpp"

#include "axis/src/motion/largest_sum.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_digit;
using profiles_detail::rounded_input;
using profiles_detail::rounded_jerk;

void include(Ranges& ranges, std::size_t order, double value, double where, Side side) {
  Range& range = ranges[order];
  if (value < range.min.value) range.min = {value, where, side};
  if (value > range.max.value) range.max = {value, where, side};
}

/// The zero of the derivative of this order in (a, b), at whose ends its signs differ.
double turning_point(const Coupled& f, std::size_t order, double a, double b) {
  const bool rising = f.jet(a)[order] < 0;
  double middle = a + (b - a) / 2;
  while (middle > a && middle < b) {
    ((f.jet(middle)[order] < 0) == rising ? a : b) = middle;
    middle = a + (b - a) / 2;
  }
  return middle;
}

/// The time of a peak of the jerk's magnitude in [a, b], by the golden section: the fourth
/// derivative of a cam over a moving master is not known. After 24 steps, the interval is 1e-5 of its first length.
double jerk_peak(const Coupled& f, double a, double b, double sign) {
  constexpr double golden = 1 - 1 / std::numbers::phi;
  double left = a + golden * (b - a);
  double right = b - golden * (b - a);
  double at_left = sign * f.jet(left)[3];
  double at_right = sign * f.jet(right)[3];
  for (int i = 0; i < 24; ++i) {
    if (at_left > at_right) {
      b = std::exchange(right, left);
      at_right = at_left;
      left = a + golden * (b - a);
      at_left = sign * f.jet(left)[3];
    } else {
      a = std::exchange(left, right);
      at_left = at_right;
      right = b - golden * (b - a);
      at_right = sign * f.jet(right)[3];
    }
  }
  return at_left > at_right ? left : right;
}

/// Includes the peaks of the jerk between the ends of an interval whose jerk has these samples at
/// equal distances: each peak lies around a sample that exceeds its neighbors. Beside an end, it
/// has none on one side: a nearer point takes its place.
template <std::size_t N>
void survey_jerk(const Coupled& f, double a, double b, const std::array<double, N>& jerk,
                 Ranges& ranges) {
  const double step = (b - a) / (N - 1);
  const auto time = [&](std::size_t i) {
    return i + 1 == N ? b : a + step * static_cast<double>(i);
  };
  double largest = 0;
  for (const double j : jerk) largest = std::max(largest, std::abs(j));
  const auto exceeds = [&](double j, double other, double sign) {
    return sign * (j - other) > rounded_input * largest;
  };
  const auto search = [&](double from, double to, double sign) {
    const double peak = jerk_peak(f, from, to, sign);
    include(ranges, 3, f.jet(peak)[3], peak, Side::right);
  };
  const double first = f.jet(a + step / 64)[3];
  const double last = f.jet(b - step / 64)[3];
  for (const double sign : {1.0, -1.0}) {
    if (exceeds(first, jerk.front(), sign)) search(a, time(1), sign);
    if (exceeds(last, jerk.back(), sign)) search(time(N - 2), b, sign);
    for (std::size_t i = 1; i + 1 < N; ++i)
      if (exceeds(jerk[i], jerk[i - 1], sign) && !exceeds(jerk[i + 1], jerk[i], sign))
        search(time(i - 1), time(i + 1), sign);
  }
}

void survey(const Coupled& f, double a, double b, Ranges& ranges) {
  constexpr int points = 16;
  std::array<double, points + 1> jerk{};
  double t = a;
  Jet here = f.jet(a);
  jerk.front() = here[3];
  for (int i = 1; i <= points; ++i) {
    const double next_t = i == points ? b : a + (b - a) * i / points;
    const Jet next = f.jet(next_t, Side::left);
    for (std::size_t k = 0; k < 4; ++k) {
      include(ranges, k, here[k], t, Side::right);
      include(ranges, k, next[k], next_t, Side::left);
      if (k == 3 || here[k + 1] * next[k + 1] >= 0) continue;
      const double peak = turning_point(f, k + 1, t, next_t);
      include(ranges, k, f.jet(peak)[k], peak, Side::right);
    }
    jerk[static_cast<std::size_t>(i)] = next[3];
    t = next_t;
    here = f.jet(t);
  }
  survey_jerk(f, a, b, jerk, ranges);
}

Ranges survey(const Coupled& f) {
  const Jet first = f.jet(f.start());
  Ranges ranges;
  for (std::size_t k = 0; k < 4; ++k)
    ranges[k] = {{first[k], f.start(), Side::right}, {first[k], f.start(), Side::right}};
  for (std::size_t i = 0; i + 1 < f.breaks().size(); ++i)
    survey(f, f.breaks()[i], f.breaks()[i + 1], ranges);
  return ranges;
}

/// Every jump of the `order`th derivative, ascending; if the run repeats, also those in one tick
/// after its end.
template <Signal S>
std::vector<Jump> steps_of(const S& f, std::size_t order, bool repeats, double tick) {
  std::vector<Jump> steps;
  const auto add = [&](double left, double right, double where) {
    if (left != right) steps.push_back({right - left, where});
  };
  const std::span<const double> breaks = f.breaks();
  for (const double t : breaks.subspan(1, breaks.size() - 2))
    add(f.jet(t, Side::left)[order], f.jet(t)[order], t);
  if (!repeats) return steps;
  const std::size_t inside = steps.size();
  add(f.jet(f.end(), Side::left)[order], f.jet(f.start())[order], f.end());
  for (std::size_t i = 0; i < inside && steps[i].where < f.start() + tick; ++i)
    steps.push_back({steps[i].step, steps[i].where + f.end() - f.start()});
  return steps;
}

/// The largest sum of jumps within one tick, and its start.
template <Signal S>
Jump largest_step(const S& f, std::size_t order, bool repeats, double tick) {
  return largest_sum(steps_of(f, order, repeats, tick), tick);
}

/// The sign of the velocity half a tick into the first interval with motion; 0: none.
template <Signal S>
int first_direction(const S& f, double tick) {
  for (std::size_t i = 0; i + 1 < f.breaks().size(); ++i) {
    const double a = f.breaks()[i];
    const double v = f.jet(a + std::min(tick, f.breaks()[i + 1] - a) / 2)[1];
    if (v != 0) return v > 0 ? 1 : -1;
  }
  return 0;
}

/// The distance by which the scaled master leaves a cam that does not permit it; tolerates
/// rounding.
Extremum excess(const Table& cam, const Placement& placement, const Range& master) {
  if (cam.outside() != Extrapolation::refuse) return {};
  const double below = cam.start() - placement.at(master.min.value);
  const double above = placement.at(master.max.value) - cam.end();
  const Extremum worst = below > above ? Extremum{below, master.min.where, Side::right}
                                       : Extremum{above, master.max.where, Side::right};
  return worst.value > rounded_input * cam.length() ? worst : Extremum{};
}

Cause refusal_cause(CouplingStatus status) {
  switch (status) {
    case CouplingStatus::would_reverse:
      return Cause::would_reverse;
    case CouplingStatus::master_stands:
      return Cause::master_stands;
    default:
      return Cause::no_ramp;
  }
}

/// `ranges`: the extrema of the table. Most intervals need no extrema of their own: the sum of the
/// magnitudes of their terms is below the limit that another interval requires.
std::array<Job::Required, 3> required_by(const Table& table, const Trajectory& curve,
                                         const Ranges& ranges) {
  const pvt_detail::KnotRounding rounding(table);
  const auto breaks = curve.breaks();
  std::array<Job::Required, 3> required;
  const auto consider = [&](std::size_t k, std::size_t i) {
    const Range range =
        segment_range(curve.segments()[i], breaks[i], breaks[i + 1], static_cast<int>(k) + 1);
    const double limit = rounding.least_limit(k + 1, i, range.peak().value);
    if (limit > required[k].limit) required[k] = {range.peak(), limit};
  };
  for (std::size_t k = 0; k < required.size(); ++k) {
    const double where = ranges[k + 1].peak().where;
    const auto after = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, where);
    consider(k, static_cast<std::size_t>(after - breaks.begin()) - 1);
  }
  for (std::size_t i = 0; i < curve.segments().size(); ++i) {
    Segment of = curve.segments()[i];
    for (std::size_t k = 0; k < required.size(); ++k) {
      of = derivative(of);
      if (magnitude(of) > required[k].limit) consider(k, i);
    }
  }
  return required;
}

}  // namespace

Job::Job(std::uint64_t id, std::shared_ptr<const Table> time, std::shared_ptr<const Table> cam,
         double tick, const CouplingSpec& coupling, double position)
    : Movement(id, Course::path),
      time_(std::move(time)),
      cam_(std::move(cam)),
      in_sync_(time_->start()) {
  if (time_->outside() == Extrapolation::advance)
    throw InputError("outside", "advance",
                     "applies to cams only: let a table over time hold or wrap");
  if (cam_) {
    couple(coupling, position, tick);
  } else {
    turn_ = coupling.slave_period.value_or(0);
    if (!(turn_ >= 0 && std::isfinite(turn_)))
      throw InputError("slave_period", turn_, "must not be negative");
    const Trajectory trajectory = time_->curve<OverTime>();
    ranges_ = extrema(*time_);
    required_ = required_by(*time_, trajectory, ranges_);
    survey_steps(trajectory, tick);
  }
  first_ = follow(master(0), 0);
  last_ = follow(master(duration(), Side::left), duration());
}

void Job::couple(const CouplingSpec& spec, double position, double tick) {
  // Held instead of rejected, so that admit() can report a master that leaves the cam.
  const Cam curve = cam_->outside() == Extrapolation::refuse
                        ? with(cam_->curve<OverMaster>(), Extrapolation::hold)
                        : cam_->curve<OverMaster>();
  const Coupling coupling(curve, spec);
  const Engagement in = engage(coupling, {.position = position}, master(0), start());
  engaged_ = in.engaged;
  coupled_ = in.status;
  const Trajectory trajectory = time_->curve<OverTime>();
  const Coupled slave(coupling, engaged_, trajectory);
  least_ = slave.end() - start();
  in_sync_ = slave.in_sync();
  ranges_ = survey(slave);
  for (std::size_t k = 0; k < required_.size(); ++k) {
    const Extremum peak = ranges_[k + 1].peak();
    required_[k] = {peak, std::abs(peak.value) * (k == 2 ? 1 - rounded_jerk : 1)};
  }
  survey_steps(slave, tick);
  master_excess_ = excess(*cam_, engaged_.placement, extrema(trajectory, 0));
}

template <Signal S>
void Job::survey_steps(const S& slave, double tick) {
  for (std::size_t k = 0; k < 3; ++k) steps_[k] = largest_step(slave, k, repeats(), tick);
  direction_ = first_direction(slave, tick);
}

/// The value of the table over time at local time t; after its end it is at rest.
Jet Job::master(double t, Side side) const {
  if (side == Side::left && t == time_->length()) return time_->jet(time_->end(), side);
  if (repeats() || t < time_->length()) return time_->jet(start() + t);
  return {time_->jet(time_->end(), Side::left)[0], 0, 0, 0};
}

Setpoint Job::follow(const Jet& x, double t) const {
  if (!cam_) return {0, 0, x};
  const double now = start() + t;
  const bool in_sync = in_sync_ && now >= *in_sync_;
  return {x[0], x[1],
          in_sync ? placed(*cam_, engaged_.placement, x) : point(*cam_, engaged_, x, now)};
}

Setpoint Job::at(double t) const {
  if (repeats() || t < duration()) return follow(master(t), t);
  return {last_.master, 0, {last_.slave[0], 0, 0, 0}};
}

double Job::tolerance() const {
  const double stroke = ranges_[0].max.value - ranges_[0].min.value;
  return rounded_input * stroke + rounded_digit * std::abs(ranges_[0].peak().value);
}

double Job::turns_to(double position) const {
  return turn_ == 0 ? 0 : turn_ * std::round((position - first_.slave[0]) / turn_);
}

Cause Job::begin(const MotionState& axis, const Moment& now) noexcept {
  progress_ = Progress::running;
  (void)now;
  shift_ = turns_to(axis.position);
  const double near = tolerance() + rounded_digit * std::abs(shift_);
  const bool there = std::abs(first_.slave[0] + shift_ - axis.position) <= near;
  return there ? Cause::none : Cause::not_at_start;
}

Setpoint Job::at(const Moment& now) noexcept {
  progress_ = !repeats() && now.t >= duration() ? Progress::done : Progress::running;
  Setpoint next = at(now.t);
  next.slave[0] += shift_;
  return next;
}

double Job::known() const noexcept {
  return repeats() ? std::numeric_limits<double>::infinity() : duration();
}

Peaks Job::peaks() const noexcept {
  return {std::abs(ranges_[1].peak().value), std::abs(ranges_[2].peak().value),
          std::abs(ranges_[3].peak().value), std::abs(steps_[1].step)};
}

std::optional<MotionState> Job::end() const noexcept {
  const Jet& last = last_.slave;
  if (repeats()) return MotionState{last[0] + shift_, last[1], last[2]};
  return MotionState{last[0] + shift_, 0, 0};
}

std::optional<Refusal> Job::admit(const AxisConfig& config,
                                  const MotionState& from) const noexcept {
  return jounce::admit(*this, config, from);
}

std::optional<Refusal> admit(const Job& job, const AxisConfig& given, const MotionState& from) {
  const AxisConfig config = resolved(given);
  const Limits& limits = config.limits;
  const Range& p = job.ranges()[0];
  const auto& [p_step, v_step, a_step] = job.steps();
  const double dt = seconds(config.period);
  const double v_most = *limits.acceleration * dt;
  const double position = from.position;
  const double shift = job.turns_to(position);
  const double near = job.tolerance() + rounded_digit * std::abs(shift);
  const double p0 = job.first().slave[0] + shift;
  const double p1 = job.last().slave[0] + shift;
  const double end = job.start() + job.duration();

  std::optional<Refusal> refusal;
  const auto rule = [&](bool holds, Cause cause, double value, double limit, double where) {
    if (!holds && !refusal) refusal = Refusal{cause, value, limit, where - job.start()};
  };
  const auto within = [&](Cause cause, double value, double limit, double where) {
    rule(std::abs(value) <= limit * (1 + rounded_input), cause, value, limit, where);
  };
  const auto peak = [&](Cause cause, std::size_t order, const std::optional<double>& limit) {
    const auto& [most, required] = job.required()[order - 1];
    if (limit)
      rule(required <= *limit * (1 + rounded_input), cause, most.value, *limit, most.where);
  };

  rule(job.coupled() == CouplingStatus::ok, refusal_cause(job.coupled()), position, p0,
       job.start());
  rule(job.gets_in_sync(), Cause::not_in_sync, p1, position, end);
  within(Cause::master_outside_cam, job.master_excess().value, 0, job.master_excess().where);
  rule(std::abs(p0 - position) <= near, Cause::start_position, p0, position, job.start());
  within(Cause::start_velocity, job.first().slave[1] - from.velocity, v_most, job.start());
  if (job.repeats())
    rule(std::abs(p1 - p0) <= near && !job.ramps(), Cause::not_closed, p1, p0, end);
  if (!job.repeats()) within(Cause::end_velocity, job.last().slave[1], v_most, end);
  within(Cause::position_step, p_step.step, near, p_step.where);
  const double least = p.min.value + shift;
  const double greatest = p.max.value + shift;
  const double lowest = limits.position_min.value_or(least);
  const double highest = limits.position_max.value_or(greatest);
  rule(least >= lowest - near, Cause::position_limit, least, lowest, p.min.where);
  rule(greatest <= highest + near, Cause::position_limit, greatest, highest, p.max.where);
  peak(Cause::velocity_limit, 1, limits.velocity);
  peak(Cause::acceleration_limit, 2, limits.acceleration);
  peak(Cause::jerk_limit, 3, limits.jerk);
  within(Cause::velocity_step, v_step.step, v_most, v_step.where);
  if (!limits.jerk) return refusal;

  const double a_most = *limits.jerk * dt;
  const double a1 = job.repeats() ? 0 : job.last().slave[2];
  within(Cause::acceleration_step, job.first().slave[2] - from.acceleration, a_most, job.start());
  within(Cause::acceleration_step, a_step.step, a_most, a_step.where);
  within(Cause::acceleration_step, a1, a_most, end);
  return refusal;
}

}  // namespace jounce
