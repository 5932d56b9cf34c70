#include "jounce/axis/fifo_movement.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "jounce/axis/detail/live.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

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

/// What a state of the FIFOs means for what is played.
Progress progress_of(SegmentFifos::State state) {
  switch (state) {
    case SegmentFifos::State::ended:
      return Progress::done;
    case SegmentFifos::State::cut_off:
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

// ---- over time -----------------------------------------------------------------------------------

FifoPath::FifoPath(std::uint64_t id, const FifoSpec& spec)
    : Movement(id, Course::path), fifos_(valid_each(spec)), from_(spec.from) {
  fifos_.reset(layout(spec));
  fifos_.set_loops(spec.loops);
}

bool FifoPath::misplaced(const MotionState& axis) const {
  if (!from_) return false;
  const double near = 1e-12 * (1 + std::abs(from_->position));
  return !(std::abs(axis.position - from_->position) <= near);
}

std::optional<Refusal> FifoPath::admit(const AxisConfig& config,
                                       const MotionState& axis) const noexcept {
  if (fifos_.visible(fifos_.stream() ? 0 : first_.load()) == 0)
    return Refusal{Cause::no_movement, 0, 1, 0};
  if (misplaced(axis)) return Refusal{Cause::start_position, from_->position, axis.position, 0};
  const double most = *config.limits.acceleration * static_cast<double>(config.period) / 1e9;
  if (!(std::abs(axis.velocity) <= most))
    return Refusal{Cause::start_velocity, axis.velocity, most, 0};
  const RowPeaks f = fifos_.peaks();
  if (!(f.velocity <= *config.limits.velocity * (1 + 1e-9)))
    return Refusal{Cause::velocity_limit, f.velocity, *config.limits.velocity, 0};
  if (!(f.acceleration <= *config.limits.acceleration * (1 + 1e-9)))
    return Refusal{Cause::acceleration_limit, f.acceleration, *config.limits.acceleration, 0};
  return std::nullopt;
}

Cause FifoPath::begin(const MotionState& axis, const Moment& now) noexcept {
  if (misplaced(axis)) return Cause::start_position;
  if (fresh_) fifos_.give_back();
  fresh_ = fifos_.take(first_.load());
  if (!fresh_) return Cause::no_movement;
  fifos_.start(now.t, from_ ? from_->position : axis.position);
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
    if (progress_ != Progress::broken) return last_ = {0, 0, f};
  }
  progress_ = Progress::broken;
  cause_ = Cause::underrun;
  return last_;
}

double FifoPath::known() const noexcept {
  if (fifos_.moving() || fifos_.stream()) return fifos_.known();
  return std::numeric_limits<double>::infinity();
}

/// The axis asks once, when it begins: of what is still to come, the limits are all that is known.
Peaks FifoPath::peaks() const noexcept {
  const RowPeaks f = fifos_.peaks();
  const RowLimits& most = fifos_.layout().limits;
  const auto of = [&](double so_far, double limit) {
    return fifos_.growing() && std::isfinite(limit) ? limit : so_far;
  };
  return {of(f.velocity, most.velocity), of(f.acceleration, most.acceleration),
          of(f.jerk, most.jerk), of(f.velocity_step, most.velocity_step)};
}

// ---- over a live master --------------------------------------------------------------------------

FifoFollow::FifoFollow(std::uint64_t id, const FifoSpec& spec, const FollowRun& run)
    : Movement(id, Course::live), fifos_(valid_each(spec)), run_(run) {
  require_valid(run.event);
  if (std::abs(run.dir) > 1) throw InputError("dir", std::to_string(run.dir), "must be -1, 0 or 1");
  fifos_.reset(layout(spec));
  fifos_.set_loops(spec.loops);
}

Cause FifoFollow::begin(const MotionState& axis, const Moment& now) noexcept {
  if (!detail::usable(now.master)) return Cause::no_master_input;
  if (fresh_) fifos_.give_back();
  fresh_ = fifos_.take(first_.load());
  if (!fresh_) return Cause::no_movement;
  jounce::begin(run_, fifos_, now.master[0], axis.position);
  before_ = {now.t, now.master};
  progress_ = run_.waiting ? Progress::waiting : Progress::running;
  cause_ = Cause::none;
  last_ = detail::setpoint(now.master, {axis.position, 0, 0, 0});
  return Cause::none;
}

Setpoint FifoFollow::at(const Moment& now) noexcept {
  if (progress_ >= Progress::done) return last_;
  fresh_ = false;
  const bool lost = !detail::usable(now.master);
  if (!lost) {
    const Sample sample{now.t, now.master};
    const Jet f = step(run_, fifos_, before_, sample);
    before_ = sample;
    progress_ = progress_of(fifos_.state());
    if (progress_ != Progress::broken)
      return last_ = detail::setpoint(now.master, chained(f, now.master));
  }
  progress_ = Progress::broken;
  cause_ =
      lost || fifos_.state() == SegmentFifos::State::lost ? Cause::master_lost : Cause::underrun;
  return last_;
}

}  // namespace jounce
