// SPDX-License-Identifier: Apache-2.0
// A replay computes masters again from their recorded input, to the last bit, and detects a
// difference from the values that the cycle used. The record also holds the reports about orders
// that did not begin.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/executor/detail/cycle.hpp"
#include "jounce/executor/detail/dispatcher.hpp"
#include "jounce/executor/detail/recorder.hpp"
#include "jounce/executor/detail/replay.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/tables.hpp"
#include "executor/cycle/virtual_pacer.hpp"
#include "executor/src/record/run_record.hpp"
#include "support/random.hpp"

namespace jounce::master_replay_test {
namespace {

using namespace test;

constexpr TrackerSpec tracker{
    .velocity = 3, .acceleration = 40, .time_constant = 10e-3, .order = 3, .longest_age = 0.05};

/// A recorded run of two masters: a line on a bad bus and an encoder with gaps.
class RecordedRun {
 public:
  RecordedRun()
      : log_(std::filesystem::path(::testing::TempDir()) /
             ("remade-" + std::to_string(getpid()) + ".lcmlog")) {
    axes_[0].axis.limits = limits(10, 100);
    axes_[0].receiver.executor = "knife";
    axes_[0].follow = {.what = Follow::What::master, .index = 0};
    masters_ = {
        {"line", "mm", line_},
        {"web", "mm", std::make_shared<EncoderMaster>(tracker, [this] { return reading_; })},
        {"table", "mm",
         std::make_shared<TableMaster>(there_and_back(0, 1, 1, Extrapolation::wrap))}};
  }
  ~RecordedRun() { std::filesystem::remove(log_); }

  /// `altered`: changes the masters in the record.
  Replay play(void (*altered)(std::vector<RecordedMaster>&) = [](auto&) {}) {
    auto masters = executor_detail::recorded_masters(masters_, axes_);
    altered(masters);
    RecordBuffer& buffer = *buffer_;
    Recorder recorder({.log = log_},
                      {{.axis = 0, .name = "knife", .config = resolved(axes_[0].axis)}}, buffer,
                      masters);
    Machine machine(machine_of(axes_), 3);
    VirtualPacer pacer;
    MachineExchange exchange(1, 3);
    CycleOptions options{.record = buffer_.get()};
    for (const auto& master : masters_) options.masters.push_back(master.source.get());
    Cycle cycle(machine, pacer, exchange, options);
    for (std::int64_t k = 0; k < 3000; ++k) {
      feed(static_cast<double>(k) * 1e-3);
      order(k, exchange);
      cycle.once();
      recorder.turn();
      for (Tick tick; exchange.axes[0]->ticks.pop(tick);) dropped_ += tick.dropped.has_value();
      for (Answer answer; exchange.axes[0]->answers.pop(answer);) {
      }
    }
    recorder.close();
    std::ifstream file(log_, std::ios::binary);
    return replay(
        file, "remade.lcmlog",
        [this](const RecordedCycle& c) { recorded_dropped_ += c.tick.dropped.has_value(); },
        [this](const RecordedSight& s) { lost_ += s.sight.lost() && s.master < 2; });
  }
  [[nodiscard]] int lost() const { return lost_; }
  [[nodiscard]] int dropped() const { return dropped_; }
  [[nodiscard]] int recorded_dropped() const { return recorded_dropped_; }

 private:
  /// Up to five samples in a cycle, late, doubled, invalid, of another epoch; readings that fail.
  void feed(double now) {
    const auto chance = [&](double p) { return random_.uniform(0, 1) < p; };
    if (chance(2e-3)) ++epoch_;
    if (chance(2e-3)) silent_until_ = now + 0.1;
    for (int n = now < silent_until_ ? 0 : random_.below(6); n > 0; --n) {
      const double then = now - random_.uniform(0, 5e-3);
      line_->receive({.stamp_ns = std::llround((then + 1234.5) * 1e9),
                      .clock = epoch_,
                      .received = now,
                      .position = 1 - std::cos(then) + random_.uniform(-1e-5, 1e-5),
                      .valid = !chance(1e-3)});
    }
    reading_ = now < silent_until_ ? NAN : std::sin(now) + random_.uniform(-1e-5, 1e-5);
  }
  /// Moves that wait and are taken back: something is dropped every now and then.
  void order(std::int64_t k, MachineExchange& exchange) {
    Command command;
    if (k == 10) command = {command::Enable{}};
    if (k > 10 && k % 100 == 0) command = {command::MoveRelative{.distance = 1}};
    if (k > 10 && k % 100 == 3)
      command = {command::MoveRelative{.distance = 2, .buffer = BufferMode::buffered}};
    if (k > 10 && k % 100 == 6) command = {command::Disarm{}};
    if (command.kind() != CommandKind::none) {
      EXPECT_TRUE(exchange.axes[0]->commands.push(command));
    }
  }

  std::filesystem::path log_;
  std::shared_ptr<ExternalMaster> line_ = std::make_shared<ExternalMaster>(tracker);
  std::vector<MachineMaster> masters_;
  std::vector<ExecutorOptions> axes_{1};
  std::unique_ptr<RecordBuffer> buffer_ = std::make_unique<RecordBuffer>();
  test::Random random_{57};
  std::int32_t epoch_ = 1;
  double silent_until_ = 0;
  double reading_ = 0;
  int lost_ = 0, dropped_ = 0, recorded_dropped_ = 0;
};

TEST(RemadeMasters, AreTheSameToTheLastBit) {
  RecordedRun run;
  const Replay replay = run.play();
  EXPECT_TRUE(replay.same()) << (replay.difference ? replay.difference->what.field
                                                   : replay.shorter);
  EXPECT_EQ(replay.compared, 3000);
  EXPECT_GT(run.lost(), 100) << "also where they are lost, and where they are found again";
  EXPECT_EQ(replay.masters[0].made, RecordedMaster::Made::samples);
  EXPECT_EQ(replay.masters[1].made, RecordedMaster::Made::readings);
  EXPECT_EQ(replay.masters[2].made, RecordedMaster::Made::elsewhere);
}

TEST(RemadeMasters, OfAnotherFilterDiffer) {
  RecordedRun line;
  const Replay other =
      line.play([](auto& masters) { masters[0].tracker.time_constant *= 1 + 1e-9; });
  ASSERT_TRUE(other.difference);
  EXPECT_TRUE(other.difference->of_master);
  EXPECT_EQ(other.difference->axis, 0U);
  EXPECT_EQ(other.difference->what.field.substr(0, 7), "master_");
  RecordedRun web;
  const Replay encoder = web.play([](auto& masters) { masters[1].tracker.latency = 1e-9; });
  ASSERT_TRUE(encoder.difference);
  EXPECT_TRUE(encoder.difference->of_master);
  EXPECT_EQ(encoder.difference->axis, 1U);
}

TEST(RemadeMasters, ThatCannotBeAreRejected) {
  RecordedRun run;
  EXPECT_THROW(run.play([](auto& masters) { masters[0].tracker.order = 7; }), InputError);
}

TEST(RecordedTicks, ReportMotionsThatDidNotBegin) {
  RecordedRun run;
  const Replay replay = run.play();
  EXPECT_TRUE(replay.same());
  EXPECT_GT(run.dropped(), 10);
  EXPECT_EQ(run.recorded_dropped(), run.dropped());
}

TEST(RecordedTicks, DifferWhereSomethingElseWasDropped) {
  Tick was, now;
  was.dropped = now.dropped = Refusal{Cause::replaced, 1, 2, 3};
  EXPECT_FALSE(first_difference(was, now));
  now.dropped->value = 1.5;
  EXPECT_EQ(first_difference(was, now)->field, "dropped_value");
  now.dropped.reset();
  EXPECT_EQ(first_difference(was, now)->field, "dropped");
}

}  // namespace
}  // namespace jounce::master_replay_test
