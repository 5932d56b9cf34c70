// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/axis/live_cam.hpp"
#include "jounce/axis/live_gear.hpp"

#include "axis/model/limits_of_log.hpp"
#include "axis/tables.hpp"
#include "support/random.hpp"

// Random orders of every kind, and a checker that uses only the log and the limits. JOUNCE_ORDERS:
// factor on the number of steps (1: 6e5).

namespace jounce::random_orders_test {
namespace {

/// Number of kinds without the last six: cuts, which need a plan of cuts, touch probes, and
/// compensations, which need a table.
inline int motion_kinds() {
  return static_cast<int>(test::axis_kinds().size()) - 6;
}

using namespace test;

AxisConfig configured(std::uint64_t seed) {
  test::Random random(seed);
  const double v = random.uniform(50, 1000);
  const double a = v * random.log_uniform(5, 50);
  AxisConfig config{.limits = limits(v, a)};
  if (random.below(4) != 0) config.limits.jerk = a * random.log_uniform(20, 200);
  config.limits.position_min = -random.uniform(20, 200);
  config.limits.position_max = random.uniform(20, 200);
  if (random.below(2) == 0) config.stop_acceleration = a * random.uniform(1.1, 3);
  if (random.below(2) == 0) config.limit_acceleration = a * random.uniform(0.3, 1.5);
  if (random.below(2) == 0) config.abort_acceleration = a * random.uniform(0.5, 4);
  return config;
}

/// An operator who orders anything at any time, behind a master that never leaps.
class Operator {
 public:
  explicit Operator(std::uint64_t seed)
      : random_(seed), pause_(10 + random_.below(200)), config_(configured(seed)), axis_(config_) {}

  const AxisConfig& config() const { return config_; }
  const std::map<Kind, int>& told() const { return told_; }
  const std::vector<std::string>& story() const { return story_; }

  Tick step() {
    const std::int64_t ticks = 1 + (random_.below(100) == 0 ? random_.below(6) : 0);
    tick_ += ticks;
    const AnyCommand command = random_.below(pause_) == 0 ? order() : AnyCommand{};
    Inputs inputs;
    inputs.master = master(static_cast<double>(ticks) * 1e-3);
    const Tick now = axis_.step(tick_, command, inputs);
    if (command.kind != Kind::none) {
      if (!now.refused) ++told_[command.kind];
      story_.push_back(std::to_string(tick_) + " " + name(command.kind) + " " +
                       std::to_string(command.position) +
                       (now.refused ? " refused " + now.refused->text() : "") + " at " +
                       std::to_string(now.position) + " v " + std::to_string(now.velocity) + " a " +
                       std::to_string(now.acceleration));
    }
    for (const Movement* movement : now.handed_back)
      if (movement != nullptr) movements_.erase(movement->id());
    last_ = now;
    return now;
  }

 private:
  Jet master(double dt) {
    const double v = *config_.limits.velocity;
    const double before = master_velocity_;
    master_velocity_ = std::clamp(before + random_.uniform(-1, 1) * v / 50, -v, v);
    master_ += (before + master_velocity_) / 2 * dt;
    return {master_, master_velocity_, 0, 0};
  }

  double place() {
    const double low = *config_.limits.position_min;
    const double high = *config_.limits.position_max;
    switch (random_.below(4)) {
      case 0:
        return low;
      case 1:
        return high;
      default:
        return random_.uniform(1.02 * low, 1.02 * high);
    }
  }

  MoveDynamics dynamics() {
    const auto some = [&](double limit) {
      return random_.below(3) == 0 ? limit * random_.log_uniform(0.05, 1) : as_configured;
    };
    const auto& [low, high, v, a, j] = config_.limits;
    return {some(*v), some(*a), some(*a), some(j.value_or(1e6))};
  }

  Movement* movement() {
    const std::uint64_t id = ++ids_;
    const double to = place();
    const double way = std::abs(to - last_.position);
    const auto& [low, high, v, a, j] = config_.limits;
    // The time that the 3-4-5 polynomial needs, with a margin.
    double T = std::max(1.875 * way / *v, std::sqrt(5.78 * way / *a));
    if (j) T = std::max(T, std::cbrt(60 * way / *j));
    T *= 2 * random_.uniform(1, 2);
    if (!(T > 0.01)) T = 0.01;
    std::unique_ptr<Movement> made;
    switch (random_.below(5)) {
      case 0:
        made = std::make_unique<LiveGear>(id, GearInSpec{.numerator = random_.below(5) - 2,
                                                         .denominator = 2,
                                                         .acceleration = *a,
                                                         .jerk = j.value_or(0)});
        break;
      case 1:
        made = std::make_unique<LiveCam>(
            id,
            table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap,
                  {{0, *v, 2 * *v}, {0, way / 3, 0}, {0, 0, 0}, {0, 0, 0}}),
            CouplingSpec{.master_absolute = false, .slave_absolute = false});
        break;
      default:
        made = std::make_unique<Job>(
            id, there_and_back(last_.position, to - last_.position, T,
                               random_.below(2) == 0 ? Extrapolation::wrap : Extrapolation::hold));
    }
    return (movements_[id] = std::move(made)).get();
  }

  AnyCommand order() {
    if (last_.state == State::disabled) return {.kind = Kind::enable};
    if (last_.state == State::error_stop && random_.below(3) != 0) return {.kind = Kind::reset};
    if (last_.armed != 0 && random_.below(2) == 0)
      return {.kind = Kind::start, .start_at = static_cast<StartAt>(random_.below(3) / 2)};
    static constexpr std::array rare{Kind::abort, Kind::disable, Kind::set_position, Kind::home};
    // Without the last four kinds.
    Kind kind = axis_kinds()[1 + static_cast<std::size_t>(random_.below(motion_kinds() - 1))];
    if (last_.state == State::synchronized_motion && random_.below(4) == 0)  // otherwise rejected
      kind = random_.below(2) == 0 ? Kind::phasing_absolute : Kind::phasing_relative;
    for (const Kind seldom : rare)
      if (kind == seldom && random_.below(5) != 0) kind = Kind::move_absolute;
    AnyCommand command{.kind = kind, .position = place(), .factor = random_.uniform(0, 1.3)};
    if (random_.below(4) == 0) command.factor = 1;
    if (kind == Kind::set_position || kind == Kind::home)
      command.position = random_.uniform(-10, 10);
    if (kind == Kind::move_relative || kind == Kind::move_additive) command.position /= 3;
    if (kind == Kind::move_superimposed) command.position /= 10;
    if (kind == Kind::move_velocity)
      command.position = *config_.limits.velocity * (random_.below(8) - 4) / 4.0;
    if (kind == Kind::arm || kind == Kind::gear_in) command.movement = movement();
    if (kind != Kind::stop) command.dynamics = dynamics();
    if (kind == Kind::phasing_absolute || kind == Kind::phasing_relative) {
      command.distance = random_.uniform(-5, 5);
      if (random_.below(4) != 0) command.dynamics = {};  // default: within the limits
    }
    if (kind == Kind::move_repetitive) {
      command.timeout = random_.below(2) == 0 ? 0 : random_.uniform(0, 0.05);
      command.method = random_.below(4);
    }
    if (kind == Kind::change_velocity) {
      command.dynamics.velocity = *config_.limits.velocity * random_.uniform(0.05, 1);
      if (random_.below(2) == 0) command.position = NAN;
    }
    if (random_.below(2) == 0) command.buffer = static_cast<BufferMode>(random_.below(6));
    return command;
  }

  test::Random random_;
  int pause_;  // ticks between orders, in the mean
  AxisConfig config_;
  MotionAxis axis_;
  Tick last_;
  std::int64_t tick_ = -1;
  std::uint64_t ids_ = 0;
  double master_ = 0, master_velocity_ = 0;
  std::map<std::uint64_t, std::unique_ptr<Movement>> movements_;
  std::map<Kind, int> told_;
  std::vector<std::string> story_;
};

std::string tail(const std::vector<std::string>& story) {
  std::string text;
  for (std::size_t i = story.size() - std::min<std::size_t>(story.size(), 12); i < story.size();
       ++i)
    text += story[i] + "\n";
  return text;
}

TEST(RandomOrders, TheLogKeepsTheLimits) {
  const char* const times = std::getenv("JOUNCE_ORDERS");
  const int runs = 120 * (times != nullptr ? std::atoi(times) : 1);
  std::map<Kind, int> told;
  int finished = 0, stopped = 0, limits_met = 0, findings = 0;
  for (int run = 0; run < runs; ++run) {
    const std::uint64_t seed = 0x6f7264657273 + static_cast<std::uint64_t>(run);
    Operator hand(seed);
    LimitsOfLog checker(hand.config());
    Tick tick;
    for (int i = 0; i < 5000; ++i) {
      tick = hand.step();
      limits_met += tick.fault == Cause::positive_soft_limit && tick.velocity == 0;
      const std::string wrong = checker.see(tick);
      if (wrong.empty()) continue;
      ADD_FAILURE() << "seed " << seed << ": " << wrong << " (" << name(tick.state) << ", fault "
                    << name(tick.fault) << ")\n"
                    << tail(hand.story());
      if (++findings > 5) return;
      break;
    }
    finished += static_cast<int>(tick.finished);
    stopped += static_cast<int>(tick.stopped);
    for (const auto& [kind, count] : hand.told()) told[kind] += count;
  }
  for (int k = 1; k < motion_kinds(); ++k) {
    const Kind kind = axis_kinds()[static_cast<std::size_t>(k)];
    EXPECT_TRUE(told.contains(kind)) << name(kind) << " was never obeyed";
  }
  EXPECT_GT(finished, 2 * runs);
  EXPECT_GT(stopped, runs);
  EXPECT_GT(limits_met, runs);
}

}  // namespace
}  // namespace jounce::random_orders_test
