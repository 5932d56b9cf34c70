#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include <gtest/gtest.h>

#include "jounce/executor/axis.hpp"
#include "jounce/executor/job.hpp"

#include "executor/tables.hpp"

namespace jounce {
namespace {

using namespace test;

/// Steele, Lea and Flood's splitmix64: the same numbers on every machine.
struct SplitMix64 {
  std::uint64_t state;

  std::uint64_t next() {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111eb;
    return z ^ (z >> 31U);
  }
  double real(double low, double high) {
    return low + (high - low) * static_cast<double>(next() >> 11U) * 0x1p-53;
  }
  bool chance(double p) { return real(0, 1) < p; }
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(next() % static_cast<std::uint64_t>(high - low + 1));
  }
};

AxisConfig within_100() {
  AxisConfig config{.limits = limits(500, 2e4)};
  config.limits.position_min = -100;
  config.limits.position_max = 100;
  return config;
}

bool is_motion(State state) {
  return state == State::discrete_motion || state == State::synchronized_motion ||
         state == State::stopping;
}

/// Tables, good and bad, that begin near `from`.
std::unique_ptr<Job> random_job(SplitMix64& random, std::uint64_t id, double from) {
  if (random.chance(0.1)) from += random.real(-1, 1);
  const double reach = random.real(-12, 12);
  const double T = random.real(0.02, 0.2);
  switch (random.integer(0, 3)) {
    case 0:
      return std::make_unique<Job>(id, there_and_back(from, reach, T, Outside::wrap));
    case 1:
      return std::make_unique<Job>(id, there_and_back(from, reach, T, Outside::hold));
    case 2:
      return std::make_unique<Job>(id, table(Axis::time, Rule::cubic_hermite, Outside::hold,
                                             {{0, T, 2 * T},
                                              {from, from + reach / 2, from + reach},
                                              {0, random.chance(0.5) ? reach / T : 0, 0},
                                              {}}));
    default:
      return std::make_unique<Job>(
          id,
          table(Axis::time, Rule::quintic_hermite, Outside::hold,
                {{0, T}, {0, 500}, {0, 0}, {0, 0}}),
          table(Axis::master, Rule::quintic_hermite, Outside::wrap,
                {{0, 180, 360}, {from, from + reach, from}, {0, 0, 0}, {0, 0, 0}}));
  }
}

/// An axis under random commands, and what must be true of every tick.
class RandomRun {
 public:
  explicit RandomRun(std::uint64_t seed) : random_{seed} {}

  void step() {
    tick_ +=
        1 + (random_.chance(0.02) ? random_.integer(1, 5) : 0) + (random_.chance(2e-4) ? 150 : 0);
    const Command command = random_command();
    const Tick now = axis_.step(tick_, command);
    check_motion(command, now);
    check_start(command, now);
    check_fault(command, now);
    check_stop(now);
    for (const Movement* job : now.handed_back) {
      if (job == nullptr) continue;
      ASSERT_EQ(jobs_.count(job->id()), 1U) << "handed back twice";
      jobs_.erase(job->id());
    }
    ASSERT_EQ(now.job != 0 ? jobs_.count(now.job) : 1, 1U) << "handed back too early";
    ASSERT_EQ(now.armed != 0 ? jobs_.count(now.armed) : 1, 1U) << "handed back too early";
    ASSERT_LE(jobs_.size(), 2U) << "kept too long";
    states.insert(now.state);
    if (now.refused) refusals.insert(now.refused->cause);
    if (now.fault != Cause::none) faults.insert(now.fault);
    last_ = now;
  }

  std::set<State> states;
  std::set<Cause> refusals;
  std::set<Cause> faults;
  [[nodiscard]] const Tick& last() const { return last_; }

 private:
  Command random_command() {
    struct Weight {
      Kind kind;
      double share;
    };
    static constexpr std::array weights{
        Weight{Kind::enable, 0.02},       Weight{Kind::disable, 0.001},
        Weight{Kind::arm, 0.02},          Weight{Kind::disarm, 0.0005},
        Weight{Kind::start, 0.05},        Weight{Kind::stop, 0.002},
        Weight{Kind::abort, 0.0005},      Weight{Kind::reset, 0.02},
        Weight{Kind::set_position, 0.002}};
    Command command;
    double at = random_.real(0, 1);
    for (const auto& weight : weights) {
      if (at < weight.share) {
        command.kind = weight.kind;
        break;
      }
      at -= weight.share;
    }
    if (command.kind == Kind::arm && !random_.chance(0.05)) {
      auto job = random_job(random_, ++ids_, last_.position);
      stop_ticks_[ids_ % stop_ticks_.size()] =
          stop_duration(job->peaks(), axis_.config()) * 1000 + 2;
      command.movement = (jobs_[ids_] = std::move(job)).get();
    }
    if (command.kind == Kind::start && random_.chance(0.3))
      command.at = tick_ + random_.integer(-2, 20);
    if (command.kind == Kind::set_position)
      command.position = random_.chance(0.1) ? NAN : random_.real(-50, 50);
    return command;
  }

  void check_motion(const Command& command, const Tick& now) {
    const double elapsed = static_cast<double>(now.skipped + 1) / 1000;
    const bool ended = now.finished + now.stopped > last_.finished + last_.stopped;
    const bool shifted = command.kind == Kind::set_position && !now.refused;
    const double moved = std::abs(now.position - last_.position);
    if (!shifted) {
      ASSERT_LE(moved, 500 * elapsed * (1 + 1e-9) + 3e-8);
      if (!is_motion(now.state) && !ended) {
        ASSERT_EQ(moved, 0);
      }
    }
    if (!is_motion(now.state)) {
      ASSERT_EQ(now.velocity, 0);
      ASSERT_EQ(now.acceleration, 0);
    }
    ASSERT_LE(std::abs(now.velocity), 500 * (1 + 1e-9));
    // The velocity is continuous, at an end too, except where a fault freezes the setpoint.
    if (now.fault == Cause::none) {
      ASSERT_LE(std::abs(now.velocity - last_.velocity), 4e4 * elapsed * (1 + 1e-9));
    }
    ASSERT_EQ(is_motion(now.state), now.job != 0);
  }

  void check_start(const Command& command, const Tick& now) const {
    if (!is_motion(now.state) || now.job == last_.job) return;
    ASSERT_EQ(now.job, last_.armed);
    ASSERT_TRUE(last_.waiting || (command.kind == Kind::start && !now.refused));
    ASSERT_EQ(last_.state, State::standstill);
    ASSERT_EQ(last_.fault, Cause::none);
  }

  void check_fault(const Command& command, const Tick& now) const {
    if (last_.fault != Cause::none && command.kind != Kind::reset) {
      ASSERT_EQ(now.fault, last_.fault);
    }
    if (now.state == State::error_stop) {
      ASSERT_TRUE(is_fault(now.fault));
    }
    if (now.fault != Cause::none) {
      ASSERT_TRUE(now.state == State::error_stop || now.state == State::disabled);
    }
    if (is_motion(last_.state) && now.state == State::disabled) {
      ASSERT_EQ(now.fault, Cause::disabled_in_motion);
    }
  }

  void check_stop(const Tick& now) {
    if (now.state != State::stopping) {
      stop_began_ = -1;
      return;
    }
    if (stop_began_ < 0) stop_began_ = now.tick;
    ASSERT_LE(static_cast<double>(now.tick - stop_began_),
              stop_ticks_[now.job % stop_ticks_.size()]);
  }

  SplitMix64 random_;
  MotionAxis axis_{within_100()};
  std::int64_t tick_ = -1;
  std::int64_t stop_began_ = -1;
  std::uint64_t ids_ = 0;
  std::map<std::uint64_t, std::unique_ptr<Job>> jobs_;
  std::array<double, 4096> stop_ticks_{};  // of the job with that number
  Tick last_;
};

TEST(MotionAxisProperty, AMillionRandomCommands) {
  constexpr std::uint64_t seed = 0x6a6f756e6365;
  RandomRun run(seed);
  for (int i = 0; i < 1'000'000; ++i) {
    run.step();
    ASSERT_FALSE(::testing::Test::HasFatalFailure()) << "seed " << seed << ", step " << i;
  }
  // The run was worth something: it met every state, and what there is to meet of faults and
  // refusals by commands alone (overspeed and out_of_range need a table that changes after it was
  // admitted).
  EXPECT_EQ(run.states.size(), 6U);
  EXPECT_GT(run.last().finished, 1000U);
  EXPECT_GT(run.last().stopped, 300U);
  EXPECT_EQ(run.faults, (std::set{Cause::aborted, Cause::disabled_in_motion, Cause::stalled}));
  for (const Cause cause :
       {Cause::not_enabled, Cause::in_error, Cause::in_motion, Cause::not_armed,
        Cause::not_at_start, Cause::too_late, Cause::no_value, Cause::start_position,
        Cause::velocity_limit, Cause::acceleration_limit})
    EXPECT_EQ(run.refusals.count(cause), 1U) << name(cause);
}

}  // namespace
}  // namespace jounce
