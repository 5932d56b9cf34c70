// SPDX-License-Identifier: Apache-2.0
// Over bad links, through stream, dispatcher, cycle and axis: each tick of what is played is the
// table's own evaluation, to the last bit, for every rule and mode, and nothing else ever moves.
#include <bit>
#include <cmath>

#include <gtest/gtest.h>

#include "jounce/stream/sender/driver.hpp"
#include "jounce/stream/sender/stream_outcome.hpp"
#include "jounce/stream/sender/stream_plan.hpp"

#include "axis/tables.hpp"
#include "executor/site.hpp"
#include "stream/src/transport/lossy_transport.hpp"
#include "support/random.hpp"

namespace jounce::fault_play_test {
namespace {

using namespace std::chrono_literals;

const Units over_time{.x = "s", .position = "mm"};
const Units over_master{.x = "deg", .position = "mm"};
const Units of_master{.x = "s", .position = "deg"};

/// There and back, at rest at both ends: A (1 - cos wx) / 2 with exact derivatives at its knots.
Table lift(Domain axis, Interpolation rule, std::size_t knots, double length, double A = 10) {
  const double w = 6.283185307179586 / length;
  Columns columns;
  for (std::size_t i = 0; i < knots; ++i) {
    const double x = length * static_cast<double>(i) / static_cast<double>(knots - 1);
    columns.x.push_back(x);
    columns.p.push_back(A / 2 * (1 - std::cos(w * x)));
    if (rule != Interpolation::linear) columns.v.push_back(A / 2 * w * std::sin(w * x));
    if (rule == Interpolation::quintic_hermite)
      columns.a.push_back(A / 2 * w * w * std::cos(w * x));
  }
  columns.p.back() = 0;
  if (rule != Interpolation::linear) columns.v.front() = columns.v.back() = 0;
  return Table(axis, rule, Extrapolation::hold, std::move(columns));
}

/// The sent motion, and the setpoint that the axis must then have, s after its start.
struct Play {
  Table slave;
  std::optional<Table> master;

  [[nodiscard]] StreamPlan plan() const {
    StreamPlan plan{.executor = "feeder", .tables = {{slave, master ? over_master : over_time}}};
    if (master) {
      plan.tables.push_back({*master, of_master});
      plan.mode = wire::ArmMode::follow_table;
    }
    return plan;
  }
  [[nodiscard]] double duration() const { return master ? master->length() : slave.length(); }
  /// The tables' own evaluation; after their end their last point, from the left.
  [[nodiscard]] double at(double t) const {
    const Table& time = master ? *master : slave;
    const double x = t < duration() ? time.jet(t)[0] : time.jet(time.end(), Side::left)[0];
    return master ? slave.jet(x)[0] : x;
  }
};

ExecutorOptions feeder() {
  ExecutorOptions options = test::axis_named("feeder", test::limits(1e5, 1e8));
  options.stop_when_silent = false;
  return options;
}

/// A bad link to a site; every tick is compared.
class Played : public test::Site {
 public:
  Played(const Play& play, const LossSpec& spec)
      : test::Site({feeder()}), play_(play), bad_(link, spec, clock) {
    after = [this] { check(last()); };
    network.on_wait = [this](Nanos) { turn(); };
  }

  StreamOutcome stream() { return stream_tables(bad_, play_.plan(), {}, clock, 1); }
  void finish() {
    for (double t = 0; t < play_.duration() + 4; t += 1e-3) turn();
  }

  std::size_t compared = 0, different = 0, strays = 0;

 private:
  void check(const Tick& now) {
    if (now.tick == seen_) return;
    seen_ = now.tick;
    const bool moves = now.job != 0;
    if (moves && origin_ < 0) origin_ = now.tick;
    if (origin_ < 0) {
      strays += now.position != 0;  // it stands at 0 until a table is started
    } else if (moves) {
      ++compared;
      const double due = play_.at(static_cast<double>((now.tick - origin_) * 1'000'000) / 1e9);
      different += std::bit_cast<std::uint64_t>(due) != std::bit_cast<std::uint64_t>(now.position);
    } else {
      strays += now.position != play_.at(play_.duration());
    }
  }

  const Play& play_;
  LossyTransport bad_;
  std::int64_t origin_ = -1;
  std::int64_t seen_ = -1;
};

const LossSpec bad_links[] = {
    {},
    {.lost = 0.1},
    {.lost = 0.3},
    {.doubled = 0.5, .delayed = 0.5, .delay = 30ms},
    {.corrupted = 0.2},
    {.lost = 0.1, .doubled = 0.1, .corrupted = 0.05, .delayed = 0.2, .partitions = {{5ms, 305ms}}},
};

void expect_played(const Play& play, const char* label) {
  for (const LossSpec& spec : bad_links) {
    Played site(play, spec);
    const StreamOutcome outcome = site.stream();
    site.finish();
    EXPECT_TRUE(outcome.ok()) << label << ": " << outcome.reason;
    EXPECT_EQ(site.different, 0U) << label << ": ticks that are not the table's";
    EXPECT_EQ(site.strays, 0U) << label << ": motion without a table";
    EXPECT_GE(site.compared, static_cast<std::size_t>(play.duration() * 1000)) << label;
    EXPECT_EQ(site.last().finished, 1U) << label;
    EXPECT_EQ(site.last().fault, Cause::none) << label;
  }
}

TEST(FaultyLink, PlaysATableOverTimeToTheLastBit) {
  for (const Interpolation rule :
       {Interpolation::linear, Interpolation::cubic_hermite, Interpolation::quintic_hermite})
    for (const std::size_t knots : {10U, 1000U})
      expect_played({lift(Domain::time, rule, knots, 0.7317), {}}, name(rule));
}

TEST(FaultyLink, PlaysACamOverItsMasterToTheLastBit) {
  const Table master = *test::constant_master(720, 640);
  for (const Interpolation rule :
       {Interpolation::linear, Interpolation::cubic_hermite, Interpolation::quintic_hermite}) {
    const Table cam = lift(Domain::master, rule, 361, 720);
    expect_played({cam, master}, name(rule));
  }
}

// A link so bad that the stream may fail: then either nothing moved, or the whole table was played.
TEST(FaultyLink, NeverPlaysAnythingElse) {
  const Play play{lift(Domain::time, Interpolation::cubic_hermite, 3000, 0.5), {}};
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    jounce::test::Random random(seed);
    LossSpec spec{.seed = seed,
                  .lost = random.uniform(0, 0.9),
                  .doubled = random.uniform(0, 1),
                  .corrupted = random.uniform(0, 0.3),
                  .delayed = random.uniform(0, 1)};
    const Nanos cut(random.below(100'000'000));
    spec.partitions = {{cut, cut + Nanos(random.below(2'000'000'000)),
                        static_cast<Partition::Way>(random.below(3))}};
    Played site(play, spec);
    const StreamOutcome outcome = site.stream();
    site.finish();
    EXPECT_EQ(site.different + site.strays, 0U) << "seed " << seed << ", " << outcome.reason;
    EXPECT_TRUE(outcome.ok() || !outcome.reason.empty()) << "seed " << seed;
    if (outcome.ok()) {
      EXPECT_EQ(site.last().finished, 1U) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace jounce::fault_play_test
