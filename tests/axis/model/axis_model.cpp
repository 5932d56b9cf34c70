// SPDX-License-Identifier: Apache-2.0
#include "axis/model/axis_model.hpp"

#include <cmath>
#include <sstream>

namespace jounce::test {
namespace {

bool is_motion(State state) {
  return state == State::discrete_motion || state == State::synchronized_motion ||
         state == State::stopping || state == State::continuous_motion;
}

/// A fault that freezes the setpoint, at any velocity.
bool freezes(Cause cause, const AxisConfig& config) {
  return cause == Cause::stalled || reaction_to(cause) == Reaction::power_off ||
         (cause == Cause::aborted && config.abort_acceleration == 0);
}

std::string broken(const char* what, double value, double limit) {
  std::ostringstream text;
  text.precision(17);
  text << what << ": " << value << ", limit " << limit;
  return text.str();
}

}  // namespace

AxisModel::AxisModel(const AxisConfig& config, bool has_drive)
    : config_(resolved(config)), has_drive_(has_drive), axis_(config) {}

std::string AxisModel::step(Seed seed) {
  test::Random random(seed);
  const auto chance = [&](double p) { return random.uniform(0, 1) < p; };
  tick_ += 1 + (chance(0.02) ? 1 + random.below(5) : 0) + (chance(2e-4) ? 150 : 0);
  inputs_ = random_inputs(random);
  command_ = random_command(random);
  const Tick now = axis_.step(tick_, command_, inputs_);
  states.insert(now.state);
  if (now.refused) refusals.insert(now.refused->cause);
  if (now.fault != Cause::none) faults.insert(now.fault);
  for (auto& [id, kept] : kept_)
    if (kept.feed && chance(0.05)) kept.feed->supply = chance(0.5) ? 2e-3 : 0;
  std::string wrong = check_numbers(now);
  if (wrong.empty()) wrong = check_motion(command_, now);
  if (wrong.empty()) wrong = check_faults(command_, now);
  if (wrong.empty()) wrong = check_stop(command_, now);
  if (wrong.empty()) wrong = check_slots(now);
  drive_ = now.position - now.offset;
  last_ = now;
  return wrong;
}

Movement* AxisModel::random_movement(test::Random& random) {
  double from = last_.position;
  if (random.below(10) == 0) from += random.uniform(-1, 1);
  const std::uint64_t id = ++ids_;
  const double reach = random.uniform(-12, 12);
  const double T = random.uniform(0.02, 0.2);
  Kept kept;
  switch (random.below(6)) {
    case 0:
      kept.movement =
          std::make_unique<Job>(id, there_and_back(from, reach, T, Extrapolation::wrap));
      break;
    case 1:
      kept.movement =
          std::make_unique<Job>(id, there_and_back(from, reach, T, Extrapolation::hold));
      break;
    case 2:
      kept.movement = std::make_unique<Job>(
          id, table(Domain::time, Interpolation::cubic_hermite, Extrapolation::hold,
                    {{0, T, 2 * T},
                     {from, from + reach / 2, from + reach},
                     {0, random.below(2) ? reach / T : 0, 0},
                     {}}));
      break;
    case 3:
      kept.movement = std::make_unique<Job>(
          id,
          table(Domain::time, Interpolation::quintic_hermite, Extrapolation::hold,
                {{0, T}, {0, 500}, {0, 0}, {0, 0}}),
          table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap,
                {{0, 180, 360}, {from, from + reach, from}, {0, 0, 0}, {0, 0, 0}}));
      break;
    case 4: {
      auto feed = std::make_unique<Feed>(id, from, reach / 4, random.uniform(5, 30));
      feed->prefill(random.uniform(0, 1));
      feed->supply = 2e-3;
      kept.feed = feed.get();
      kept.movement = std::move(feed);
      break;
    }
    default: {
      auto gear = std::make_unique<Gear>(id, random.uniform(-2, 2));
      if (random.below(3) == 0) gear->ends_at = random.uniform(0, 0.3);
      kept.movement = std::move(gear);
    }
  }
  return (kept_[id] = std::move(kept)).movement.get();
}

AnyCommand AxisModel::random_command(test::Random& random) {
  struct Weight {
    Kind kind;
    double share;
  };
  static constexpr std::array weights{Weight{Kind::enable, 0.02},
                                      Weight{Kind::disable, 0.001},
                                      Weight{Kind::arm, 0.02},
                                      Weight{Kind::disarm, 0.0005},
                                      Weight{Kind::start, 0.04},
                                      Weight{Kind::stop, 0.002},
                                      Weight{Kind::abort, 0.0005},
                                      Weight{Kind::reset, 0.02},
                                      Weight{Kind::set_position, 0.002},
                                      Weight{Kind::home, 0.001},
                                      Weight{Kind::hold, 0.002},
                                      Weight{Kind::resume, 0.01},
                                      Weight{Kind::override_, 0.003},
                                      Weight{Kind::finish, 0.002},
                                      Weight{Kind::move_absolute, 0.005},
                                      Weight{Kind::move_relative, 0.003},
                                      Weight{Kind::move_additive, 0.003},
                                      Weight{Kind::move_superimposed, 0.005},
                                      Weight{Kind::move_velocity, 0.002},
                                      Weight{Kind::halt, 0.002},
                                      Weight{Kind::gear_in, 0.004},
                                      Weight{Kind::gear_out, 0.001},
                                      Weight{Kind::cam_out, 0.0005},
                                      Weight{Kind::phasing_absolute, 0.001},
                                      Weight{Kind::phasing_relative, 0.002},
                                      Weight{Kind::change_velocity, 0.002},
                                      Weight{Kind::move_repetitive, 0.002}};
  AnyCommand command;
  double at = random.uniform(0, 1);
  for (const auto& weight : weights) {
    if (at < weight.share) {
      command.kind = weight.kind;
      break;
    }
    at -= weight.share;
  }
  const auto some = [&](double most) {
    if (random.below(50) == 0) return 0.0;  // refused
    return random.below(3) == 0 ? most * random.log_uniform(0.02, 1.1) : as_configured;
  };
  if (command.kind == Kind::arm || command.kind == Kind::gear_in)
    if (random.below(20) != 0) command.movement = random_movement(random);
  command.start_at = static_cast<StartAt>(std::max(random.below(8) - 5, 0));
  const bool later = command.kind == Kind::start || command.kind == Kind::gear_in ||
                     command.kind == Kind::hold || command.kind == Kind::resume ||
                     command.kind == Kind::override_ || command.kind == Kind::stop ||
                     command.kind == Kind::halt || command.kind == Kind::move_relative ||
                     command.kind == Kind::move_additive || command.kind == Kind::move_velocity ||
                     command.kind == Kind::gear_out;
  if (later && random.below(3) == 0) command.at = tick_ + random.below(22) - 2;
  command.position = random.below(50) == 0 ? NAN : random.uniform(-50, 50);
  if (command.kind == Kind::move_superimposed) command.position /= 10;
  if (command.kind == Kind::move_velocity)
    command.position = random.below(6) == 0 ? random.uniform(-1, 1) < 0 ? -0.0 : 0.0
                                            : random.uniform(-1.1, 1.1) * *config_.limits.velocity;
  if (command.start_at == StartAt::master_position)
    command.position = master_ + random.uniform(-20, 20);
  command.relative = random.below(2) == 0;
  if (command.kind == Kind::set_position && command.relative) command.position /= 1e3;
  command.factor = random.below(40) == 0 ? -1 : random.below(2) ? 1 : random.uniform(0, 2);
  if (command.kind != Kind::stop)
    command.dynamics = {some(*config_.limits.velocity), some(*config_.limits.acceleration),
                        some(*config_.limits.acceleration), some(1e6)};
  if (command.kind == Kind::phasing_absolute || command.kind == Kind::phasing_relative)
    command.distance = random.uniform(-10, 10);
  if (command.kind == Kind::move_repetitive) command.timeout = random.uniform(0, 0.02);
  command.direction = static_cast<Direction>(random.below(5) - 1);
  if (random.below(3) == 0) command.buffer = static_cast<BufferMode>(random.below(6));
  return command;
}

Inputs AxisModel::random_inputs(test::Random& random) {
  const auto chance = [&](double p) { return random.uniform(0, 1) < p; };
  Inputs inputs;
  const double dt = static_cast<double>(tick_ - last_.tick) * 1e-3;
  const double acceleration = random.uniform(-2000, 2000);
  const double before = master_velocity_;
  master_velocity_ = 0.99 * before + acceleration * dt;
  master_ += (before + master_velocity_) / 2 * dt;
  if (chance(3e-4)) master_ += random.uniform(-50, 50);
  if (chance(3e-4)) master_velocity_ = random.uniform(-150, 150);
  if (chance(1e-3)) master_lost_ = !master_lost_ && chance(0.3);
  if (!master_lost_) inputs.master = {master_, master_velocity_, 0, 0};
  inputs.watchdog = chance(2e-4);
  inputs.positive_switch = chance(2e-4);
  inputs.negative_switch = chance(2e-4);
  if (!has_drive_) return inputs;
  inputs.feedback.position = drive_ + (chance(3e-4) ? random.uniform(-5, 5) : 0);
  if (chance(1e-3)) inputs.feedback.position = NAN;
  inputs.feedback.fault = chance(1e-4);
  inputs.feedback.ready = !chance(2e-4);
  return inputs;
}

std::string AxisModel::check_numbers(const Tick& now) const {
  for (const double x : {now.position, now.velocity, now.acceleration, now.rate, now.override_})
    if (!std::isfinite(x)) return "not finite";
  if (now.velocity != 0 && !is_motion(now.state) && now.state != State::error_stop)
    return broken("moves in a state of rest", now.velocity, 0);
  if (now.job != 0 && !is_motion(now.state) && now.state != State::error_stop)
    return "a job at rest";
  return {};
}

std::string AxisModel::check_motion(const Command& command, const Tick& now) const {
  const double v_most = *config_.limits.velocity;
  const double a_most = config_.stop_acceleration;
  const double tick = 1e-3;
  const double elapsed = static_cast<double>(now.skipped + 1) * tick;
  if (std::abs(now.velocity) > v_most * (1 + 1e-8)) return broken("velocity", now.velocity, v_most);
  const bool renamed =
      (command.kind() == CommandKind::set_position || command.kind() == CommandKind::home) &&
      !now.refused;
  const bool led = last_.state == State::disabled;  // by the drive
  if (renamed || led) return {};
  const double moved = now.position - last_.position;
  if (std::abs(moved) > v_most * elapsed * (1 + 1e-8) + 1e-9)
    return broken("way in a tick", moved, v_most * elapsed);
  if (now.fault != Cause::none && (last_.fault == Cause::none || now.velocity == 0) &&
      (freezes(now.fault, config_) || now.state == State::disabled || now.skipped > 90))
    return {};
  if (command.kind() == CommandKind::abort || now.state == State::disabled) return {};
  if (std::abs(now.acceleration) > a_most * (1 + 1e-8))
    return broken("acceleration", now.acceleration, a_most);
  const double joint = *config_.limits.acceleration * tick;
  const double most = a_most * elapsed + joint;
  const double change = now.velocity - last_.velocity;
  if (std::abs(change) > most * (1 + 1e-8)) return broken("change of velocity", change, most);
  // A jump of the position shows beside the velocities at both ends.
  const double middle = (now.velocity + last_.velocity) / 2 * elapsed;
  if (std::abs(moved - middle) > most * elapsed + 1e-9)
    return broken("way beside the velocity", moved - middle, most * elapsed);
  const double range = 100 * (1 + 1e-8);  // a set_position may be outside
  if (std::abs(now.position) > range && std::abs(last_.position) <= range)
    return broken("position", now.position, 100);
  return {};
}

std::string AxisModel::check_faults(const Command& command, const Tick& now) const {
  const bool reset = command.kind() == CommandKind::reset;
  if (last_.fault != Cause::none && !reset && now.fault != last_.fault)
    return "a fault was not latched";
  if (now.state == State::error_stop && !is_fault(now.fault)) return "error_stop without a fault";
  if (now.fault != Cause::none && now.state != State::error_stop && now.state != State::disabled)
    return "a fault outside error_stop";
  if (is_motion(last_.state) && now.state == State::disabled && now.fault == Cause::none)
    return "disabled in motion without a fault";
  if (last_.state == State::disabled && is_motion(now.state) &&
      command.kind() != CommandKind::enable)
    return "moves without having been enabled";
  if (last_.state == State::error_stop && !reset && is_motion(now.state))
    return "moves on without a reset";
  return {};
}

/// From a stop to rest: as long as the slowest change of a rate takes, or a stop by a move.
std::string AxisModel::check_stop(const Command& /*command*/, const Tick& now) {
  if (now.state != State::stopping) {
    stop_began_ = -1;
    return {};
  }
  if (stop_began_ < 0) {
    stop_began_ = now.tick;
    stop_bound_ = 0.05 + 2 * *config_.limits.velocity / config_.stop_acceleration;
    if (config_.limits.jerk) stop_bound_ += 3 * config_.stop_acceleration / config_.stop_jerk;
    const auto played = kept_.find(now.job);
    if (played != kept_.end() && played->second.movement->course() == Course::path) {
      const Peaks peaks = played->second.movement->peaks();
      const double h = highest_rate(peaks, config_);
      stop_bound_ = std::max(stop_bound_, h * 1.5 / rate_slope(peaks, config_, h) + 0.01);
    }
  }
  const auto took = static_cast<double>(now.tick - stop_began_) * 1e-3;
  if (took > stop_bound_) return broken("a stop does not end", took, stop_bound_);
  return {};
}

std::string AxisModel::check_slots(const Tick& now) {
  for (const Movement* movement : now.handed_back)
    if (movement && kept_.erase(movement->id()) != 1) return "handed back twice";
  if (now.job != 0 && kept_.count(now.job) != 1) return "handed back too early";
  if (now.armed != 0 && kept_.count(now.armed) != 1) return "handed back too early";
  if (kept_.size() != (now.job != 0) + static_cast<std::size_t>(now.armed != 0))
    return "kept too long";
  return {};
}

std::string AxisModel::told() const {
  std::ostringstream text;
  text << "tick " << last_.tick << " (+" << last_.skipped << "): " << name(command_.kind);
  if (command_.movement)
    text << (last_.job || last_.armed ? " #" + std::to_string(ids_) : std::string(" a movement"));
  text << ' ' << command_.position << " start_at " << static_cast<int>(command_.start_at) << " at "
       << command_.at << " factor " << command_.factor;
  if (last_.refused) text << " refused: " << last_.refused->text();
  text << "; " << name(last_.state) << " p " << last_.position << " v " << last_.velocity << " a "
       << last_.acceleration << " rate " << last_.rate << " job " << last_.job << " armed "
       << last_.armed << " fault " << name(last_.fault);
  if (inputs_.watchdog) text << " [watchdog]";
  if (inputs_.positive_switch) text << " [+switch]";
  if (inputs_.negative_switch) text << " [-switch]";
  if (inputs_.feedback.fault) text << " [drive fault]";
  if (!inputs_.feedback.ready) text << " [not ready]";
  return text.str();
}

}  // namespace jounce::test
