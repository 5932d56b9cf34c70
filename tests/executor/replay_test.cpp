// A machine that is told at random, over its link, all that it can be told: the record of it is replayed to
// the last bit.
#include "jounce/executor/replay.hpp"

#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/drive/simulated_drive.hpp"
#include "jounce/executor/dispatcher.hpp"
#include "jounce/executor/recorder.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/client.hpp"
#include "jounce/stream/memory_transport.hpp"

#include "axis/tables.hpp"
#include "executor/virtual_pacer.hpp"
#include "support/random.hpp"

namespace jounce {
namespace {

using namespace test;
using namespace std::chrono_literals;
using testing::Random;

const Units over_time{.x = "s", .position = "mm"};
const Units over_master{.x = "mm", .position = "mm"};

Drive servo() {
  Drive drive = servo_400w();
  drive.position_per_rev = 10;
  return drive;
}

/// A feeder with a drive, a knife behind its setpoint, a press behind where its drive says that it is.
std::vector<ExecutorOptions> three_axes() {
  std::vector<ExecutorOptions> axes(3);
  const char* const names[] = {"feeder", "knife", "press"};
  for (std::size_t i = 0; i < 3; ++i) {
    axes[i].axis.limits = limits(1000, 1e5, 1e7);
    axes[i].axis.limits.position_min = -1e6;
    axes[i].axis.limits.position_max = 1e6;
    axes[i].receiver.executor = names[i];
    axes[i].units = over_master;
    axes[i].adopt_start = i == 1;
  }
  axes[0].units = {"", "mm"};
  axes[0].drive = std::make_shared<SimulatedDrive>(servo(), 1e-3, 0);
  axes[1].follow = {.what = Follow::What::setpoint, .index = 0};
  axes[2].follow = {.what = Follow::What::actual, .index = 0};
  return axes;
}

/// It, recorded, and whoever talks to it at random. Time passes while somebody waits.
class Recorded {
 public:
  Recorded(std::uint64_t seed, std::filesystem::path log) : random_(seed), log_(std::move(log)) {
    std::vector<RecordedAxis> recorded;
    for (const auto& axis : axes_)
      recorded.push_back({.axis = recorded.size(),
                          .name = axis.receiver.executor,
                          .units = axis.units,
                          .config = resolved(axis.axis)});
    recorder_ = std::make_unique<Recorder>(RecorderOptions{.log = log_}, recorded, *tape_);
    for (auto& axis : axes_) axis.recorder = recorder_.get();
    machine_ = std::make_unique<Machine>(machine_of(axes_));
    dispatcher_ = std::make_unique<Dispatcher>(own_link_, axes_, post_, clock_);
    cycle_ = std::make_unique<Cycle>(
        *machine_, pacer_, post_,
        CycleOptions{.drives = {axes_[0].drive.get(), nullptr, nullptr}, .tape = tape_.get()});
    network_.on_wait = [this](Nanos time) { advance(time); };
  }

  void advance(Nanos time) {
    for (const Nanos end = clock_() + time; clock_() < end;) {
      if (random_.below(400) == 0) pacer_.delay = random_.below(5) * 1'000'000;  // wakes up late
      cycle_->once();
      if (random_.below(8) != 0) dispatcher_->turn(0ns);
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

  /// The record's bytes.
  std::string finish() {
    advance(20ms);
    dispatcher_->turn(0ns);
    dispatcher_->close();
    recorder_->close();
    EXPECT_EQ(recorder_->trouble(), "");
    EXPECT_EQ(recorder_->lost(), 0);
    std::ifstream file(log_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  std::map<std::string, int> done;

 private:
  void count(const std::string& what, bool ok) { done[what] += ok ? 1 : 0; }
  std::int64_t session() { return static_cast<std::int64_t>(random_.next() >> 2U) + 1; }

  bool stream(const StreamPlan& plan) {
    StreamOptions options;
    options.total = 2s;
    const Nanos until = clock_() + std::chrono::milliseconds(50 + random_.below(500));
    if (random_.below(3) == 0) options.cancelled = [this, until] { return clock_() > until; };
    const auto outcome = stream_tables(link_, plan, options, clock_, session());
    advance(std::chrono::milliseconds(random_.below(300)));
    return outcome.ok();
  }

  bool play(const std::string& name) {
    const double reach = random_.uniform(-20, 20);
    return stream(
        {.executor = name,
         .tables = {{*there_and_back(0, reach, random_.uniform(0.3, 0.8),
                                     random_.below(2) == 0 ? Outside::hold : Outside::wrap),
                     over_time}}});
  }

  bool live_cam(const std::string& name) {
    const double length = random_.uniform(5, 20);
    const auto cam =
        table(Axis::master, Rule::quintic_hermite, Outside::wrap,
              {{0, length / 2, length}, {0, random_.uniform(-3, 3), 0}, {0, 0, 0}, {0, 0, 0}});
    CouplingSpec coupling{.slave_absolute = false};
    if (random_.below(2) == 0)
      coupling = {.start = StartMode::ramp_in, .velocity_diff = 300, .acceleration = 3e4};
    const bool ok = stream({.executor = name,
                            .tables = {{*cam, over_master}},
                            .mode = wire::ArmMode::follow_input,
                            .coupling = coupling});
    feed();
    return ok;
  }

  /// The master moves.
  void feed() {
    Client client(link_, "feeder", {.patience = 300ms}, clock_);
    client.reset();
    client.enable();
    client.move_relative(random_.uniform(-40, 40), {.velocity = random_.uniform(20, 400)});
    client.release();
    advance(std::chrono::milliseconds(random_.below(300)));
  }

  bool gear(const std::string& name) {
    Client client(link_, name, {.patience = 300ms}, clock_);
    client.reset();
    client.enable();
    const bool ok = client.gear_in(1 + random_.below(3), 1 + random_.below(3)).ok();
    if (random_.below(3) == 0)
      client.gear_in_pos(1, 1 + random_.below(2), random_.uniform(-10, 10),
                         random_.uniform(-10, 10), random_.uniform(1, 5));
    client.release();
    feed();
    if (random_.below(2) == 0) client.gear_out();
    client.halt();
    client.release();
    return ok;
  }

  /// Rows that come too late at times: the axis stops on its path, and goes on.
  bool rows(const std::string& name) {
    const auto count = static_cast<std::size_t>(5 + random_.below(60));
    const double step = random_.uniform(-1, 1);
    std::size_t given = 0;
    Nanos late{};
    RowPlan plan{.executor = name, .rows = {}, .resume = true};
    plan.queue = {.units = over_time, .capacity = 8, .prefill = 4};
    plan.rows = [&](std::size_t most) {
      std::vector<wire::Row> rows;
      if (clock_() < late) return rows;
      if (given > 4 && random_.below(10) == 0) late = clock_() + 600ms;
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
    options.cancelled = [this, until = clock_() + 4s] { return clock_() > until; };
    const auto outcome = stream_rows(link_, plan, options, clock_, session());
    return outcome.ok();
  }

  void orders(const std::string& name) {
    Client client(link_, name, {.patience = 300ms}, clock_);
    client.reset();
    client.enable();
    const int how_many = 1 + random_.below(5);
    for (int i = 0; i < how_many; ++i) {
      count("order", order(client).ok());
      advance(std::chrono::milliseconds(random_.below(60)));
    }
    client.override_(1);
    client.halt();
    client.release();
  }

  CallOutcome order(Client& client) {
    const Pacing pacing{.velocity = random_.uniform(10, 900)};
    switch (random_.below(13)) {
      case 0:
        return client.move_absolute(random_.uniform(-50, 50), pacing);
      case 1:
        return client.move_relative(random_.uniform(-50, 50), pacing);
      case 2:
        return client.move_additive(random_.uniform(-5, 5), pacing);
      case 3:
        return client.move_superimposed(random_.uniform(-5, 5), pacing);
      case 4:
        return client.move_velocity(random_.uniform(-100, 100));
      case 5:
        return client.override_(random_.uniform(0, 2));
      case 6:
        return client.hold();
      case 7:
        return client.resume();
      case 8:
        return client.stop();
      case 9:
        return client.stop(wire::StopMode::abort);
      case 10:
        return client.set_position(random_.uniform(-5, 5), true);
      case 11:
        return client.home(random_.uniform(-5, 5));
      default:
        return random_.below(3) == 0 ? client.disable() : client.enable();
    }
  }

  Random random_;
  std::filesystem::path log_;
  std::vector<ExecutorOptions> axes_ = three_axes();
  std::unique_ptr<Tape> tape_ = std::make_unique<Tape>();
  std::unique_ptr<Recorder> recorder_;
  MemoryNetwork network_;
  MemoryTransport own_link_{network_};
  MemoryTransport link_{network_};
  VirtualPacer pacer_;
  Clock clock_ = [this] { return Nanos(pacer_.now()); };
  Post post_{3};
  std::unique_ptr<Machine> machine_;
  std::unique_ptr<Dispatcher> dispatcher_;
  std::unique_ptr<Cycle> cycle_;
};

class RandomRun : public ::testing::Test {
 protected:
  RandomRun() { std::filesystem::create_directories(folder_); }
  ~RandomRun() override { std::filesystem::remove_all(folder_); }

  std::string record(std::uint64_t seed, int actions) {
    Recorded run(seed, folder_ / "run.lcmlog");
    for (int i = 0; i < actions; ++i) run.act();
    for (const auto& [what, times] : run.done) done_[what] += times;
    return run.finish();
  }

  Replay replayed(const std::string& bytes) {
    std::istringstream in(bytes);
    return replay(in, "run.lcmlog", [this](const RecordedCycle& cycle) {
      done_["underrun"] += cycle.tick.fault == Cause::underrun ? 1 : 0;
    });
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("jounce-replay-" + std::to_string(getpid()));
  std::map<std::string, int> done_;
};

TEST_F(RandomRun, IsReplayedToTheLastBitWhateverTheAxesAreTold) {
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

TEST_F(RandomRun, CutOffAnywhereIsReplayedThatFarOrRefused) {
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
}  // namespace jounce
