// SPDX-License-Identifier: Apache-2.0
// Cam switches and position compare as messages, and in a record that is replayed.
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/stream/sender/client.hpp"

#include "axis/tables.hpp"
#include "executor/site.hpp"

namespace jounce::outputs_test {
namespace {

using namespace test;
using namespace std::chrono_literals;

const Units over_time{.x = "s", .position = "mm"};

PositionCompare camera() {
  return {.mode = CompareMode::linear, .points = evenly(1, 0.5, 90), .pulse = 3e-4};
}

AxisSwitches glue() {
  return {.table = {.switches = {{.track = 1, .first_on_position = 10, .last_on_position = 20},
                                 {.track = 2,
                                  .first_on_position = 15,
                                  .mode = CamSwitchMode::time,
                                  .duration = 0.01}},
                    .tracks = {{.track = 1, .on_compensation = -2e-3}}}};
}

ExecutorOptions feeder() {
  ExecutorOptions options = axis_named("feeder", limits(1000, 1e5), {"", "mm"});
  options.switches = glue();
  options.compare = {SwitchesOf::position, camera()};
  return options;
}

/// A feeder that is recorded.
struct Recorded : Site {
  /// `said`: configuration of the outputs in the record.
  explicit Recorded(const ExecutorOptions& said = feeder())
      : Site({feeder()}, {.recorded = true, .said = {said}}) {}
};

// The instants in messages are those of the curve, for every cycle time.
TEST(Outputs, OfAComparePassOverTheWireWithTheirInstants) {
  Recorded site;
  MemoryTransport listener(site.network);
  listener.subscribe(wire::channel("feeder", wire::Lane::event), 4096);
  const TablePtr move = trapezoid_table(50, 100, 1000, 1000);
  constexpr std::int64_t start = 300;
  ASSERT_TRUE(
      site.stream({.executor = {}, .tables = {{*move, over_time}}, .start_tick = start}).ok());
  site.advance(1200ms);
  std::map<std::int64_t, wire::Event> events;
  Rejects rejects;
  while (const auto message = next_message(listener, 0ns, rejects))
    if (const auto* event = std::get_if<wire::Event>(&message->body)) events[event->count] = *event;
  std::vector<wire::Event> compares;
  double before = 0;
  for (const auto& [count, event] : events) {
    const double instant = static_cast<double>(event.tick) * 1e-3 - event.offset_s;
    EXPECT_GE(instant, before) << "ascending, both kinds together";
    before = instant;
    if (event.kind == wire::EventKind::compare) compares.push_back(event);
  }
  EXPECT_EQ(events.size(), compares.size() + 4) << "two tracks, on and off";
  const auto exact = compared(camera(), move->curve<OverTime>()).edges;
  ASSERT_EQ(compares.size(), exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const wire::Event& event = compares[i];
    const double instant = static_cast<double>(event.tick - start) * 1e-3 - event.offset_s;
    EXPECT_NEAR(instant, exact[i].time, 1e-9) << i;
    EXPECT_EQ(event.on, exact[i].on);
    EXPECT_EQ(event.number, 1U);
    EXPECT_NEAR(event.position, move->jet(exact[i].time)[0], 1e-9);
  }
}

void run(Site& site) {
  Client client(site.link, "feeder", {}, site.clock);
  ASSERT_TRUE(
      client.command(command::MoveAbsolute{.position = 30, .dynamics = {.velocity = 77}}).ok());
  site.advance(700ms);
  ASSERT_TRUE(client.command(command::SetPosition{.position = 3}).ok());
  ASSERT_TRUE(
      client.command(command::MoveAbsolute{.position = 25, .dynamics = {.velocity = 33}}).ok());
  site.pacer.delay = 4'000'000;  // a late cycle
  site.advance(900ms);
  ASSERT_TRUE(client.release().ok());
}

TEST(Outputs, AreReplayedWithTheirEdges) {
  Recorded site;
  run(site);
  const Replay replay = site.replayed();
  EXPECT_TRUE(replay.same()) << replay.shorter;
  EXPECT_GT(replay.compared, 1500);
  ASSERT_EQ(replay.axes.size(), 1U);
  EXPECT_EQ(replay.axes[0].outputs.table.switches.size(), 2U);
  EXPECT_EQ(replay.axes[0].compare.list->points.size(), 90U) << "in two parts";
}

// It would be noticed if they were not the same.
TEST(Outputs, OfAnotherListOrAnotherSwitchDiffer) {
  for (const bool list : {true, false}) {
    ExecutorOptions other = feeder();
    if (list)
      other.compare.list->points[40].position += 1e-6;
    else
      other.switches.table.tracks[0].on_compensation *= 1 + 1e-6;
    Recorded site(other);
    run(site);
    const Replay replay = site.replayed();
    ASSERT_TRUE(replay.difference);
    EXPECT_EQ(replay.difference->what.field, list ? "compare_edge" : "switch_edge");
  }
}

// ---- orders that wait ----------------------------------------------------------------------------

TEST(Orders, BufferedAndAtATickPassOverTheWireAndAreReplayed) {
  Recorded site;
  Client client(site.link, "feeder", {}, site.clock);
  ASSERT_TRUE(client.command(command::MoveAbsolute{20, {100, 2000, 2000}}).ok());
  ASSERT_TRUE(
      client.command(command::MoveRelative{10, {50, 2000, 2000}, BufferMode::blending_low}).ok());
  site.advance(1s);
  EXPECT_EQ(site.last().position, 30);
  EXPECT_EQ(site.last().finished, 2U);
  const std::int64_t at = site.last().tick + 400;
  ASSERT_TRUE(client.command(command::MoveAbsolute{40}, at).ok());
  while (site.last().tick < at - 1) {
    site.advance(1ms);
    ASSERT_EQ(site.last().position, 30);
  }
  site.advance(300ms);
  EXPECT_EQ(site.last().position, 40);
  EXPECT_EQ(client.command(command::Halt{}, 3).cause, static_cast<int>(Cause::too_late));
  EXPECT_TRUE(site.replayed().same());
}

// Orders like those of `jounce order`: each in a session of its own, which ends.
TEST(Orders, ThatWaitOutlastTheSessionThatGaveThem) {
  Recorded site;
  const auto order = [&](const ClientCommand& command, std::int64_t at = -1) {
    Client client(site.link, "feeder", {}, site.clock);
    EXPECT_TRUE(client.command(command, at).ok());
    EXPECT_TRUE(client.release().ok());
    site.advance(5ms);
  };
  order(command::MoveAbsolute{20, {100, 2000, 2000}});
  order(command::MoveRelative{10, {50, 2000, 2000}, BufferMode::buffered});
  site.advance(1s);
  EXPECT_EQ(site.last().position, 30);
  EXPECT_EQ(site.last().finished, 2U);
  order(command::MoveAbsolute{40}, site.last().tick + 200);
  site.advance(500ms);
  EXPECT_EQ(site.last().position, 40);
}

}  // namespace
}  // namespace jounce::outputs_test
