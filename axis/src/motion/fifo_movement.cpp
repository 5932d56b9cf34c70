// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/fifo_movement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/src/follow/live.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_sum;

constexpr std::size_t most_rows = 1'000'000;

std::size_t valid_each(const FifoSpec& spec) {
  if (spec.each < 1 || spec.each > most_rows)
    throw InputError("each", std::to_string(spec.each), "must be from 1 to 1e6 rows");
  return spec.each;
}

SegmentFifos::Layout layout(const FifoSpec& spec) {
  if (spec.from) {
    require_finite("from", spec.from->x);
    require_finite("from", spec.from->position);
  }
  return {.each = spec.each,
          .total = spec.total.value_or(2 * spec.each),
          .stream = spec.stream,
          .open = spec.stream,
          .base = spec.stream ? spec.from.value_or(RowStart{}) : RowStart{},
          .limits = spec.limits};
}

std::optional<double> origin_of(const FifoSpec& spec) {
  if (spec.origin) require_finite("origin", *spec.origin);
  if (!(spec.range.lowest <= 0)) throw InputError("lowest", spec.range.lowest, "must be at most 0");
  if (!(spec.range.highest >= 0))
    throw InputError("highest", spec.range.highest, "must be at least 0");
  if (spec.origin || !spec.from) return spec.origin;
  return spec.from->position;
}

/// Range of the motion relative to its start: rows of a stream beyond it are rejected.
SegmentFifos::Reach range_of(const FifoSpec& spec) {
  if (!spec.stream) return spec.range;
  const double begin = spec.from ? spec.from->position : 0;
  return {std::max(spec.range.lowest, spec.limits.position_min - begin),
          std::min(spec.range.highest, spec.limits.position_max - begin)};
}

/// Tolerance for equal positions: rounding, and 1e-9 of the stroke, as for a whole table.
double near_of(const SegmentFifos::Reach& range, double origin) {
  const double stroke = range.highest - range.lowest;
  return rounded_sum * (1 + std::abs(origin)) +
         (std::isfinite(stroke) ? rounded_input * stroke : 0);
}

/// True if an axis at `position` does not stand at the start of the rows.
bool misplaced(const std::optional<double>& origin, const SegmentFifos::Reach& range,
               double position) {
  return origin && !(std::abs(position - *origin) <= near_of(range, *origin));
}

/// Progress of the movement for a state of the FIFOs.
Progress progress_of(SegmentFifos::State state) {
  switch (state) {
    case SegmentFifos::State::ended:
      return Progress::done;
    case SegmentFifos::State::cut_off:
    case SegmentFifos::State::left:
    case SegmentFifos::State::lost:
      return Progress::broken;
    case SegmentFifos::State::taken:
      return Progress::waiting;
    case SegmentFifos::State::idle:
    case SegmentFifos::State::moving:
      break;
  }
  return Progress::running;
}

}  // namespace

RowLimits row_limits(const AxisConfig& given, bool absolute) {
  const AxisConfig config = resolved(given);
  const Limits& limits = config.limits;
  const double tick = static_cast<double>(config.period) / 1e9;
  RowLimits rows{.velocity = *limits.velocity,
                 .acceleration = *limits.acceleration,
                 .jerk = limits.jerk.value_or(RowLimits::none),
                 .velocity_step = *limits.acceleration * tick};
  if (absolute) {
    rows.position_min = limits.position_min.value_or(rows.position_min);
    rows.position_max = limits.position_max.value_or(rows.position_max);
  }
  return rows;
}

// ---- over time ----------------------------------------------------------------------------------

FifoPath::FifoPath(std::uint64_t id, const FifoSpec& spec)
    : Movement(id, Course::path),
      fifos_(valid_each(spec)),
      origin_(origin_of(spec)),
      range_(range_of(spec)) {
  fifos_.reset(layout(spec));
  fifos_.set_loops(spec.loops);
}

/// Compares the announced range with that of the axis, if it has one.
std::optional<Refusal> FifoPath::leaves(const AxisConfig& config, double from) const {
  const double lowest = from + range_.lowest;
  const double highest = from + range_.highest;
  const double near = near_of(range_, from);
  const Limits& most = config.limits;
  if (most.position_max && !(highest <= *most.position_max + near))
    return Refusal{Cause::position_limit, highest, *most.position_max};
  if (most.position_min && !(lowest >= *most.position_min - near))
    return Refusal{Cause::position_limit, lowest, *most.position_min};
  return std::nullopt;
}

bool FifoPath::within(const SegmentFifos::Reach& pass) const {
  const double near = near_of(range_, begun_at_);
  return pass.lowest >= begun_at_ + range_.lowest - near &&
         pass.highest <= begun_at_ + range_.highest + near;
}

/// For tables: a pass that leaves the range breaks the movement. The axis supervises the pass
/// before it, and a pass whose rates were not available when it was filled.
void FifoPath::supervise() {
  if (fifos_.stream() || !fifos_.moving()) return;
  const SegmentFifos::Reach pass = fifos_.reach();
  const bool known = std::isfinite(pass.lowest) && std::isfinite(pass.highest);
  if (known && !within(pass)) {
    progress_ = Progress::broken;
    cause_ = Cause::out_of_range;
    return;
  }
  const auto next = fifos_.next_reach();
  bounded_ = known && (!next || within(*next));
}

std::optional<Refusal> FifoPath::admit(const AxisConfig& config,
                                       const MotionState& axis) const noexcept {
  if (fifos_.visible(fifos_.stream() ? 0 : first_.load()) == 0)
    return Refusal{Cause::no_movement, 0, 1};
  if (misplaced(origin_, range_, axis.position))
    return Refusal{Cause::start_position, *origin_, axis.position};
  if (auto refusal = leaves(config, origin_.value_or(axis.position))) return refusal;
  const double most = *config.limits.acceleration * static_cast<double>(config.period) / 1e9;
  if (!(std::abs(axis.velocity) <= most))
    return Refusal{Cause::start_velocity, axis.velocity, most};
  const RowPeaks f = fifos_.peaks();
  if (!(f.velocity <= *config.limits.velocity * (1 + rounded_input)))
    return Refusal{Cause::velocity_limit, f.velocity, *config.limits.velocity};
  if (!(f.acceleration <= *config.limits.acceleration * (1 + rounded_input)))
    return Refusal{Cause::acceleration_limit, f.acceleration, *config.limits.acceleration};
  return std::nullopt;
}

Cause FifoPath::begin(const MotionState& axis, const Moment& now) noexcept {
  if (misplaced(origin_, range_, axis.position)) return Cause::start_position;
  if (fresh_) fifos_.give_back();
  fresh_ = fifos_.take(first_.load());
  if (!fresh_) return Cause::no_movement;
  begun_at_ = origin_.value_or(axis.position);
  bounded_ = true;
  fifos_.start(now.t, begun_at_);
  progress_ = Progress::running;
  cause_ = Cause::none;
  last_ = {0, 0, {axis.position, 0, 0, 0}};
  return Cause::none;
}

Setpoint FifoPath::at(const Moment& now) noexcept {
  if (progress_ >= Progress::done) return last_;
  fresh_ = false;
  const bool dry = fifos_.growing() && now.t > fifos_.known();
  if (!dry) {
    const Jet f = fifos_.at(now.t);
    progress_ = progress_of(fifos_.state());
    supervise();
    if (progress_ != Progress::broken) return last_ = {0, 0, f};
  }
  progress_ = Progress::broken;
  if (cause_ == Cause::none) cause_ = Cause::underrun;
  return last_;
}

double FifoPath::known() const noexcept {
  if (fifos_.moving() || fifos_.stream()) return fifos_.known();
  return std::numeric_limits<double>::infinity();
}

/// The axis reads this once, when it begins: for later rows only the limits are available.
Peaks FifoPath::peaks() const noexcept {
  const RowPeaks f = fifos_.peaks();
  const RowLimits& most = fifos_.layout().limits;
  const auto of = [&](double so_far, double limit) {
    return fifos_.growing() && std::isfinite(limit) ? limit : so_far;
  };
  return {of(f.velocity, most.velocity), of(f.acceleration, most.acceleration),
          of(f.jerk, most.jerk), of(f.velocity_step, most.velocity_step)};
}

// ---- over a live master -------------------------------------------------------------------------

FifoFollow::FifoFollow(std::uint64_t id, const FifoSpec& spec, const FollowRun& run)
    : Movement(id, Course::live),
      fifos_(valid_each(spec)),
      origin_(origin_of(spec)),
      range_(spec.range),
      run_(run) {
  require_valid(run.event);
  if (std::abs(run.dir) > 1) throw InputError("dir", std::to_string(run.dir), "must be -1, 0 or 1");
  fifos_.reset(layout(spec));
  fifos_.set_loops(spec.loops);
}

std::optional<Refusal> FifoFollow::admit(const AxisConfig& /*config*/,
                                         const MotionState& axis) const noexcept {
  if (misplaced(origin_, range_, axis.position))
    return Refusal{Cause::start_position, *origin_, axis.position};
  return std::nullopt;
}

Cause FifoFollow::begin(const MotionState& axis, const Moment& now) noexcept {
  if (!axis_detail::usable(now.master)) return Cause::no_master_input;
  if (misplaced(origin_, range_, axis.position)) return Cause::start_position;
  if (fresh_) fifos_.give_back();
  fresh_ = fifos_.take(first_.load());
  if (!fresh_) return Cause::no_movement;
  jounce::begin(run_, fifos_, now.master[0], axis.position);
  before_ = {now.t, now.master};
  progress_ = run_.waiting ? Progress::waiting : Progress::running;
  cause_ = Cause::none;
  last_ = axis_detail::setpoint(now.master, {axis.position, 0, 0, 0});
  return Cause::none;
}

std::optional<MotionState> FifoFollow::first_setpoint(const Moment& now) const noexcept {
  const auto first = first_step(run_, fifos_, {now.t, now.master});
  if (!first) return std::nullopt;
  return state_of(axis_detail::setpoint(now.master, chained(*first, now.master)));
}

Setpoint FifoFollow::at(const Moment& now) noexcept {
  events_.clear();
  if (progress_ >= Progress::done) return last_;
  const bool lost = !axis_detail::usable(now.master);
  if (!lost) {
    const Sample sample{now.t, now.master};
    const bool begins = fresh_ && !run_.waiting;  // without an event
    const bool waited = run_.waiting;
    const int table = fifos_.active() + 1;
    Jet f = step(run_, fifos_, before_, sample);
    if (begins || (waited && !run_.waiting))
      note(ProfileEvent::Kind::begin, table, run_.origin, sample);
    note_passes(table, sample);
    before_ = sample;
    progress_ = progress_of(fifos_.state());
    if (fifos_.state() == SegmentFifos::State::cut_off && !fifos_.stream()) {
      f = beyond(now.master[0]);
      progress_ = Progress::done;
    }
    fresh_ = false;
    if (progress_ != Progress::broken)
      return last_ = axis_detail::setpoint(now.master, chained(f, now.master));
  }
  fresh_ = false;
  progress_ = Progress::broken;
  cause_ =
      lost || fifos_.state() == SegmentFifos::State::lost ? Cause::master_lost : Cause::underrun;
  return last_;
}

/// Adds an event at a position of the master, with its instant between the previous step and `now`.
void FifoFollow::note(ProfileEvent::Kind kind, std::int64_t number, double master,
                      const Sample& now) {
  const auto at = master == before_.master[0] ? before_ : passing(before_, now, master);
  events_.add({kind, number, at ? at->t : now.t, master});
}

void FifoFollow::note_passes(int table, const Sample& now) {
  if (run_.waiting) return;
  for (const SegmentFifos::PassEnd& end : fifos_.pass_ends()) {
    const double master = run_.origin + (run_.dir < 0 ? -end.x : end.x);
    note(ProfileEvent::Kind::pass_end, end.passes, master, now);
    if (end.switched) note(ProfileEvent::Kind::begin, 3 - table, master, now);
  }
}

/// The slave and its derivatives with respect to the master, along the line beyond the end of the
/// tables.
Jet FifoFollow::beyond(double master) const noexcept {
  const SegmentFifos::End& end = fifos_.end();
  const double travel = run_.dir == 0 ? master - run_.origin : run_.furthest;
  const double sign = run_.dir < 0 ? -1 : 1;  // travel counts against the master's direction
  return {end.position + end.rate * (travel - end.x), sign * end.rate, 0, 0};
}

std::array<double, 3> FifoFollow::slopes() const noexcept {
  const RowPeaks f = fifos_.peaks();
  return {f.velocity, f.acceleration, f.jerk};
}

}  // namespace jounce
