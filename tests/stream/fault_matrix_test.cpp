// SPDX-License-Identifier: Apache-2.0
// Streamer and executor over every kind of bad link, for tables of every size: what is played is the
// table that was sent, bit for bit, or nothing; and every transfer ends, done or with a named error.
#include <gtest/gtest.h>

#include "stream/faults.hpp"
#include "stream/harness.hpp"
#include "support/random.hpp"

namespace jounce::fault_matrix_test {
namespace {

using namespace std::chrono_literals;
using test::Fault;
using test::faults;
using test::sine_table;
using test::text;
using test::World;
using Way = Partition::Way;

/// One streamer over one bad link, and an axis that checks each table it is given.
struct Trial {
  StreamOutcome outcome;
  std::size_t wrong = 0;  // tables that were stored or armed and are not the one that was sent
  bool armed = false;     // the axis was given the table
  bool idle = false;      // afterwards the axis has no owner
  Nanos time{};
};

Trial attempt(const Table& table, const LossSpec& spec, Nanos restart = Nanos::max()) {
  World world;
  LossyTransport link(world.link, spec, world.clock);
  Trial trial;
  bool restarted = false;
  const auto check = [&] {
    for (const std::string& word : world.executor->log) trial.armed |= word == "arm 1";
    const auto& tables = world.store();
    const auto stored = tables.find(content_hash(table, test::move_units));
    if (stored && !test::same(*stored->table, table)) ++trial.wrong;
    if (trial.armed && !restarted && !stored) ++trial.wrong;
  };
  world.each_turn = [&] {
    if (restarted || world.now < restart) return;
    check();
    restarted = true;
    world.boot(101);
  };
  trial.outcome = stream_tables(link, test::plan_of(table), {}, world.clock, 1);
  trial.time = world.now;
  check();
  world.pass(3s);
  trial.idle = world.executor->pump.receiver().session() == 0;
  return trial;
}

/// The violated condition among those that hold on every link; empty: none.
std::string broken(const Trial& trial) {
  const StreamOutcome& outcome = trial.outcome;
  if (trial.wrong > 0) return "a wrong or incomplete table was armed";
  if (outcome.ok() && !(outcome.downloaded && outcome.armed && outcome.started))
    return "success, but not done";
  if (outcome.ok() && outcome.progress.arrived != outcome.progress.chunks)
    return "success, but not all arrived";
  if (!outcome.ok() && (outcome.error == StreamError::none || outcome.reason.empty()))
    return "an error without a name";
  if (trial.time > 61s) return "it did not end in time";
  if (!trial.idle) return "the axis is still owned";
  return {};
}

// ---- the matrix ---------------------------------------------------------------------------------

class FaultMatrix : public ::testing::TestWithParam<std::size_t> {};

TEST_P(FaultMatrix, TheTableArrivesWholeOrNothingIsArmed) {
  const std::size_t knots = GetParam();
  constexpr Interpolation rules[] = {Interpolation::linear, Interpolation::cubic_hermite,
                                     Interpolation::quintic_hermite};
  for (std::size_t i = 0; i < faults().size(); ++i) {
    const Fault& fault = faults()[i];
    const Table table = sine_table(knots, knots < 100'000 ? rules[i % 3] : Interpolation::linear);
    for (std::uint64_t seed = 1; seed <= (knots < 100'000 ? 5U : 1U); ++seed) {
      LossSpec spec = fault.spec;
      spec.seed = seed;
      const Trial trial = attempt(table, spec);
      EXPECT_EQ(broken(trial), "") << fault.label << " " << text(spec);
      if (fault.completes) {
        EXPECT_TRUE(trial.outcome.ok())
            << fault.label << ", seed " << seed << ": " << name(trial.outcome.error) << ", "
            << trial.outcome.reason;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Knots, FaultMatrix, ::testing::Values(10, 1'000, 100'000),
                         ::testing::PrintToStringParamName());

// A million knots take as long as all others together: the faults that matter, one a test.
class FaultMatrixOfAMillion : public ::testing::TestWithParam<std::size_t> {};

TEST_P(FaultMatrixOfAMillion, TheTableArrivesWholeOrNothingIsArmed) {
  const Fault& fault = faults()[GetParam()];
  const Trial trial = attempt(sine_table(1'000'000, Interpolation::linear), fault.spec);
  EXPECT_EQ(broken(trial), "");
  if (fault.completes) {
    EXPECT_TRUE(trial.outcome.ok()) << name(trial.outcome.error) << ", " << trial.outcome.reason;
  }
}

INSTANTIATE_TEST_SUITE_P(Faults, FaultMatrixOfAMillion, ::testing::Values(0, 2, 3, 5, 7, 8, 9, 10),
                         [](const auto& each) { return faults()[each.param].label; });

// ---- random schedules ---------------------------------------------------------------------------

struct Schedule {
  LossSpec spec;
  std::size_t knots = 2;
  Nanos restart = Nanos::max();
};

Schedule random_schedule(std::uint64_t seed) {
  jounce::test::Random random(seed);
  Schedule schedule;
  LossSpec& spec = schedule.spec;
  spec.seed = seed;
  const auto share = [&](double most) {
    return random.below(2) == 0 ? 0 : random.uniform(0, most);
  };
  const auto time = [&](double most) {
    return Nanos(static_cast<std::int64_t>(random.uniform(0, most) * 1e9));
  };
  spec.lost = share(0.6);
  spec.doubled = share(1);
  spec.corrupted = share(0.3);
  spec.delayed = share(1);
  spec.delay = time(0.2);
  for (int i = random.below(4); i > 0; --i) {
    const Nanos from = time(0.5);
    spec.partitions.push_back(
        {from, from + time(random.below(4) == 0 ? 8 : 0.4), static_cast<Way>(random.below(3))});
  }
  schedule.knots = static_cast<std::size_t>(random.log_uniform(2, 20'000));
  if (random.below(4) == 0) schedule.restart = time(0.3);
  return schedule;
}

std::string broken(const Schedule& schedule) {
  return broken(attempt(sine_table(schedule.knots), schedule.spec, schedule.restart));
}

/// The schedule made simpler, fault by fault, as long as it still fails.
Schedule shrunk(Schedule schedule) {
  const auto keep = [&](auto change) {
    Schedule simpler = schedule;
    change(simpler);
    if (!broken(simpler).empty()) schedule = simpler;
  };
  keep([](Schedule& s) { s.spec.lost = 0; });
  keep([](Schedule& s) { s.spec.doubled = 0; });
  keep([](Schedule& s) { s.spec.corrupted = 0; });
  keep([](Schedule& s) { s.spec.delayed = 0; });
  keep([](Schedule& s) { s.restart = Nanos::max(); });
  for (std::size_t i = 0; i < 4; ++i)
    keep([](Schedule& s) {
      if (!s.spec.partitions.empty()) s.spec.partitions.pop_back();
    });
  for (std::size_t i = 0; i < 12; ++i)
    keep([](Schedule& s) { s.knots = std::max<std::size_t>(2, s.knots / 2); });
  return schedule;
}

TEST(FaultSchedules, EndWholeOrWithANamedError) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Schedule schedule = random_schedule(seed);
    const std::string what = broken(schedule);
    if (what.empty()) continue;
    const Schedule least = shrunk(schedule);
    FAIL() << "seed " << seed << ": " << what << "; simplest: " << broken(least) << " with "
           << least.knots << " knots, restart at " << least.restart.count() << " ns, "
           << text(least.spec);
  }
}

}  // namespace
}  // namespace jounce::fault_matrix_test
