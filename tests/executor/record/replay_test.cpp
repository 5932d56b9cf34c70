// SPDX-License-Identifier: Apache-2.0
// A machine that gets random orders of all kinds over its link: its record is replayed to the last
// bit.
#include "jounce/executor/detail/replay.hpp"

#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/drive/simulated_drive.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/client.hpp"

#include "axis/tables.hpp"
#include "executor/site.hpp"
#include "support/random.hpp"

namespace jounce::replay_test {
namespace {

using namespace test;
using namespace std::chrono_literals;
using test::Random;

const Units over_time{.x = "s", .position = "mm"};
const Units over_master{.x = "mm", .position = "mm"};

Drive servo() {
  Drive drive = servo_400w();
  drive.position_per_rev = 10;
  return drive;
}

/// A feeder with a drive, a knife behind its setpoint, a press behind its actual position.
std::vector<ExecutorOptions> three_axes() {
  std::vector<ExecutorOptions> axes(3);
  const char* const names[] = {"feeder", "knife", "press"};
  for (std::size_t i = 0; i < 3; ++i) {
    axes[i] = axis_named(names[i], limits(1000, 1e5, 1e7), over_master);
    axes[i].axis.limits.position_min = -1e6;
    axes[i].axis.limits.position_max = 1e6;
    axes[i].adopt_start = i == 1;
  }
  axes[0].units = {"", "mm"};
  axes[0].drive = std::make_shared<SimulatedDrive>(servo(), 1e-3, 0);
  axes[1].follow = {.what = Follow::What::setpoint, .index = 0};
  axes[2].follow = {.what = Follow::What::actual, .index = 0};
  return axes;
}

/// The recorded machine and its random client. Time passes while the client waits.
class Recorded : public Site {
 public:
  explicit Recorded(std::uint64_t seed) : Site(three_axes(), {.recorded = true}), random_(seed) {
    network.on_wait = [this](Nanos time) { advance(time); };
  }

  void advance(Nanos time) {
    for (const Nanos end = clock() + time; clock() < end;) {
      if (random_.below(400) == 0) pacer.delay = random_.below(5) * 1'000'000;  // wakes up late
      cycle.once();
      if (random_.below(8) != 0) dispatcher.turn(0ns);
    }
  }

  void act() {
    const char* const names[] = {"feeder", "knife", "press"};
    const int axis = random_.below(3);
    const std::string name = names[axis];
    switch (random_.below(6)) {
      case 0:
        return count("table", play(name));
      case 1:
        return count("live cam", axis > 0 && live_cam(name));
      case 2:
        return count("rows", rows(name));
      case 3:
        return count("gear", axis > 0 && gear(name));
      default:
        return orders(name);
    }
  }

  std::map<std::string, int> done;

 private:
  void count(const std::string& what, bool ok) { done[what] += ok ? 1 : 0; }
  std::int64_t session() { return static_cast<std::int64_t>(random_.next() >> 2U) + 1; }

  bool streamed(const StreamPlan& plan) {
    StreamOptions options;
    options.total = 2s;
    const Nanos until = clock() + std::chrono::milliseconds(50 + random_.below(500));
    if (random_.below(3) == 0) options.cancelled = [this, until] { return clock() > until; };
    const auto outcome = stream_tables(link, plan, options, clock, session());
    advance(std::chrono::milliseconds(random_.below(300)));
    return outcome.ok();
  }

  bool play(const std::string& name) {
    const double reach = random_.uniform(-20, 20);
    return streamed({.executor = name,
                     .tables = {{*there_and_back(0, reach, random_.uniform(0.3, 0.8),
                                                 random_.below(2) == 0 ? Extrapolation::hold
                                                                       : Extrapolation::wrap),
                                 over_time}}});
  }

  bool live_cam(const std::string& name) {
    const double length = random_.uniform(5, 20);
    const auto cam =
        table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap,
              {{0, length / 2, length}, {0, random_.uniform(-3, 3), 0}, {0, 0, 0}, {0, 0, 0}});
    CouplingSpec coupling{.slave_absolute = false};
    if (random_.below(2) == 0)
      coupling = {.start = StartMode::ramp_in, .velocity_diff = 300, .acceleration = 3e4};
    const bool ok = streamed({.executor = name,
                              .tables = {{*cam, over_master}},
                              .mode = wire::ArmMode::follow_input,
                              .coupling = coupling});
    feed();
    return ok;
  }

  /// The master moves.
  void feed() {
    Client client(link, "feeder", {.patience = 300ms}, clock);
    std::ignore = client.reset();
    std::ignore = client.enable();
    std::ignore = client.command(command::MoveRelative{
        .distance = random_.uniform(-40, 40), .dynamics = {.velocity = random_.uniform(20, 400)}});
    std::ignore = client.release();
    advance(std::chrono::milliseconds(random_.below(300)));
  }

  bool gear(const std::string& name) {
    Client client(link, name, {.patience = 300ms}, clock);
    std::ignore = client.reset();
    std::ignore = client.enable();
    const bool ok = client
                        .command(command::GearIn{.numerator = 1 + random_.below(3),
                                                 .denominator = 1 + random_.below(3)})
                        .ok();
    if (random_.below(3) == 0)
      std::ignore =
          client.command(command::GearInPos{.numerator = 1,
                                            .denominator = 1 + random_.below(2),
                                            .master_sync_position = random_.uniform(-10, 10),
                                            .slave_sync_position = random_.uniform(-10, 10),
                                            .master_start_distance = random_.uniform(1, 5)});
    std::ignore = client.release();
    feed();
    if (random_.below(2) == 0) std::ignore = client.gear_out();
    std::ignore = client.command(command::Halt{});
    std::ignore = client.release();
    return ok;
  }

  /// Rows that come too late at times: the axis stops on its path, and goes on.
  bool rows(const std::string& name) {
    const auto count = static_cast<std::size_t>(5 + random_.below(60));
    const double step = random_.uniform(-1, 1);
    std::size_t given = 0;
    Nanos late{};
    RowPlan plan{.executor = name, .rows = {}, .resume = true};
    plan.queue = {.units = over_time,
                  .capacity = 8,
                  .prefill = 4,
                  .relative = true,
                  .lowest = -100,
                  .highest = 100};
    plan.rows = [&](std::size_t most) {
      std::vector<wire::Row> rows;
      if (clock() < late) return rows;
      if (given > 4 && random_.below(10) == 0) late = clock() + 600ms;
      for (; rows.size() < most && given < count; ++given) {
        const auto i = static_cast<double>(given);
        const double u = (i + 1) / static_cast<double>(count);
        const auto at = [&](double w) { return 10 * step * w * w * w * (10 + w * (6 * w - 15)); };
        const auto rate = [&](double w) {
          return 300 * step * w * w * (1 - w) * (1 - w) / (0.02 * static_cast<double>(count));
        };
        rows.push_back({.x_end = 0.02 * (i + 1),
                        .p_end = at(u),
                        .v_start = rate(i / static_cast<double>(count)),
                        .v_end = given + 1 == count ? 0 : rate(u),
                        .order = wire::RowOrder::cubic,
                        .last = given + 1 == count});
      }
      return rows;
    };
    RowOptions options;
    options.cancelled = [this, until = clock() + 4s] { return clock() > until; };
    const auto outcome = stream_rows(link, plan, options, clock, session());
    return outcome.ok();
  }

  void orders(const std::string& name) {
    Client client(link, name, {.patience = 300ms}, clock);
    std::ignore = client.reset();
    std::ignore = client.enable();
    const int how_many = 1 + random_.below(5);
    for (int i = 0; i < how_many; ++i) {
      count("order", order(client).ok());
      advance(std::chrono::milliseconds(random_.below(60)));
    }
    std::ignore = client.command(command::Override{1});
    std::ignore = client.command(command::Halt{});
    std::ignore = client.release();
  }

  CallOutcome order(Client& client) {
    const MoveDynamics pacing{.velocity = random_.uniform(10, 900)};
    switch (random_.below(13)) {
      case 0:
        return client.command(
            command::MoveAbsolute{.position = random_.uniform(-50, 50), .dynamics = pacing});
      case 1:
        return client.command(
            command::MoveRelative{.distance = random_.uniform(-50, 50), .dynamics = pacing});
      case 2:
        return client.command(
            command::MoveAdditive{.distance = random_.uniform(-5, 5), .dynamics = pacing});
      case 3:
        return client.command(
            command::MoveSuperimposed{.distance = random_.uniform(-5, 5), .dynamics = pacing});
      case 4:
        return client.command(command::MoveVelocity{.velocity = random_.uniform(-100, 100)});
      case 5:
        return client.command(command::Override{random_.uniform(0, 2)});
      case 6:
        return client.hold();
      case 7:
        return client.resume();
      case 8:
        return client.stop();
      case 9:
        return client.stop(wire::StopMode::abort);
      case 10:
        return client.command(
            command::SetPosition{.position = random_.uniform(-5, 5), .relative = true});
      case 11:
        return client.command(command::Home{.offset = random_.uniform(-5, 5),
                                            .method = command::Home::without_motion});
      default:
        return random_.below(3) == 0 ? client.disable() : client.enable();
    }
  }

  Random random_;
};

class RandomRun : public ::testing::Test {
 protected:
  std::string record(std::uint64_t seed, int actions) {
    Recorded run(seed);
    for (int i = 0; i < actions; ++i) run.act();
    for (const auto& [what, times] : run.done) done_[what] += times;
    return run.record();
  }

  Replay replayed(const std::string& bytes) {
    std::istringstream in(bytes);
    return replay(in, "run.lcmlog", [this](const RecordedCycle& cycle) {
      done_["underrun"] += cycle.tick.fault == Cause::underrun ? 1 : 0;
    });
  }

  std::map<std::string, int> done_;
};

TEST_F(RandomRun, IsReplayedToTheLastBitForAnyCommands) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    const Replay result = replayed(record(seed, 9));
    EXPECT_TRUE(result.same()) << result.shorter;
    if (result.difference)
      ADD_FAILURE() << "axis " << result.difference->axis << ", tick " << result.difference->tick
                    << ", " << result.difference->what.field << ": "
                    << result.difference->what.recorded << ", then "
                    << result.difference->what.replayed;
    EXPECT_EQ(result.compared, result.cycles);
  }
  for (const char* what : {"table", "live cam", "rows", "gear", "order", "underrun"})
    EXPECT_GT(done_[what], 0) << what << ": nothing was tried";
}

TEST_F(RandomRun, CutOffAnywhereIsReplayedThatFarOrRejected) {
  const std::string whole = record(3, 4);
  Random random(97);
  for (int i = 0; i < 25; ++i) {
    const std::size_t size = random.next() % whole.size();
    SCOPED_TRACE(::testing::Message() << size << " of " << whole.size() << " bytes");
    try {
      const Replay some = replayed(whole.substr(0, size));
      EXPECT_FALSE(some.difference);
      EXPECT_LE(some.compared, some.cycles);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr("run.lcmlog"));
    }
  }
}

TEST_F(RandomRun, DamagedIsAnErrorOrADifferenceAndNeverACrash) {
  const std::string whole = record(5, 4);
  Random random(98);
  for (int i = 0; i < 25; ++i) {
    std::string damaged = whole;
    const std::size_t at = random.next() % whole.size();
    const auto bit = static_cast<unsigned char>(1U << (random.next() % 8));
    damaged[at] = static_cast<char>(static_cast<unsigned char>(damaged[at]) ^ bit);
    SCOPED_TRACE(::testing::Message() << "byte " << at << ", bit " << static_cast<int>(bit));
    try {
      (void)replayed(damaged);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr("run.lcmlog"));
    }
  }
}

}  // namespace
}  // namespace jounce::replay_test
