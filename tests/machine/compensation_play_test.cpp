// SPDX-License-Identifier: Apache-2.0
// examples/compensated-table, commanded through the protocol on a virtual clock: answers, log, status, record.
// tests/cli/judge_compensation.py judges the numbers.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/machine/detail/status_text.hpp"
#include "jounce/machine/machine_parts.hpp"
#include "jounce/stream/sender/client.hpp"

#include "executor/site.hpp"
#include "machine/log_columns.hpp"

namespace jounce::compensation_play_test {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

struct Plate {
  explicit Plate(const std::string& machine)
      : log(testing::TempDir() + "/plate_" + std::to_string(getpid()) + ".csv"),
        site(machine_parts(
                 {.files = {JOUNCE_SOURCE_DIR "/examples/" + machine}, .log = log, .enable = false})
                 .axes,
             {.masters = {}, .recorded = true, .said = {}}),
        listener(site.network) {
    for (const ExecutorOptions& axis : site.axes)
      listener.subscribe(wire::channel(axis.receiver.executor, wire::Lane::status), 1000);
    site.advance(20ms);
  }
  ~Plate() {
    for (const char* const axis : {"x", "y", "z", "line", "corrector", "label"})
      std::filesystem::remove(log_of(log, axis, 2));
  }
  Plate(const Plate&) = delete;
  Plate& operator=(const Plate&) = delete;

  CallOutcome order(const std::string& axis, const ClientCommand& command) {
    Client client(site.link, axis, {}, site.clock);
    const CallOutcome outcome = client.command(command);
    static_cast<void>(client.release());
    site.advance(50ms);
    return outcome;
  }
  void on(const std::string& axis) {
    EXPECT_TRUE(order(axis, command::Enable{}).ok());
    EXPECT_TRUE(order(axis, command::Home{}).ok());
    EXPECT_TRUE(order(axis, command::Disable{}).ok());
    EXPECT_TRUE(order(axis, command::EnableCompensation{}).ok());
    EXPECT_TRUE(order(axis, command::Enable{}).ok());
  }
  /// The newest status of an axis.
  std::optional<wire::Status> status(const std::string& axis) {
    std::optional<wire::Status> newest;
    Rejects rejects;
    while (const auto message = next_message(listener, 0ns, rejects))
      if (const auto* one = std::get_if<wire::Status>(&message->body);
          one != nullptr && message->executor == axis)
        newest = *one;
    return newest;
  }

  std::string log;
  test::Site site;
  MemoryTransport listener;
};

TEST(CompensationPlay, IsInTheLogTheStatusAndTheReplay) {
  Plate plate("compensated-table/machine.toml");
  plate.on("x");
  plate.on("y");
  ASSERT_TRUE(plate.order("x", command::MoveAbsolute{.position = 450}).ok());
  ASSERT_TRUE(plate.order("y", command::MoveAbsolute{.position = 50}).ok());
  plate.site.advance(3s);
  const auto status = plate.status("x");
  ASSERT_TRUE(status);
  EXPECT_NEAR(status->correction, 0.2548828125, 1e-12) << "the natural spline at s = 2.75";
  EXPECT_THAT(status_text("x", *status), HasSubstr("compensated 0.254883 mm"));
  // (1 - w) row 1 + w row 2 at the last point of x, half way between 0 and 100.
  EXPECT_NEAR(plate.site.last(1).correction[0], (0.2 + 0.5) / 2, 1e-12);
  EXPECT_FALSE(plate.site.replayed().difference);
  const test::LogColumns log(log_of(plate.log, "x", 2));
  EXPECT_EQ(log.text.at("compensated").back(), "1");
  EXPECT_NEAR(log.numbers("compensation").back(), 0.2548828125, 1e-12);
}

/// The table of examples/compensated-table/z.toml, interpolated between its points with code of its own.
double in_space(double x, double y, double z) {
  constexpr double values[3][3][3] = {
      {{0.3, 0.1, 0.2}, {-0.2, 0, 0.1}, {-0.1, 0.3, 0.4}},
      {{0.2, -0.1, 0.4}, {0.2, 0, 0.2}, {0.3, 0.1, 0.1}},
      {{0.4, 0.3, -0.2}, {-0.2, 0.1, 0.2}, {-0.2, 0.1, -0.4}}};  // [z][y][x]
  const auto cell = [](double at, double base, double interval) {
    const double s = std::clamp((at - base) / interval, 0.0, 2.0);
    const int k = std::min(static_cast<int>(s), 1);
    return std::pair(k, s - k);
  };
  const auto [i, u] = cell(x, -10, 20);
  const auto [j, v] = cell(y, 5, 10);
  const auto [k, w] = cell(z, 0, 30);
  double sum = 0;
  for (const int a : {0, 1})
    for (const int b : {0, 1})
      for (const int c : {0, 1})
        sum += (a == 1 ? u : 1 - u) * (b == 1 ? v : 1 - v) * (c == 1 ? w : 1 - w) *
               values[k + c][j + b][i + a];
  return sum;
}

// HIMC manual 14.1.1, example 3: in each tick of the log, while all axes move, and at the points of the manual.
TEST(CompensationPlay, ThreeReferencesCorrectAQuill) {
  Plate plate("compensated-table/space.toml");
  for (const char* const axis : {"x", "y"}) {
    ASSERT_TRUE(plate.order(axis, command::Enable{}).ok());
    ASSERT_TRUE(plate.order(axis, command::Home{}).ok());
  }
  plate.on("z");
  for (const auto& [x, y, z, correction] :
       {std::array{-10.0, 5.0, 0.0, 0.3}, {10.0, 15.0, 30.0, 0.0}, {30.0, 25.0, 60.0, -0.4}}) {
    ASSERT_TRUE(plate.order("x", command::MoveAbsolute{.position = x}).ok());
    ASSERT_TRUE(plate.order("y", command::MoveAbsolute{.position = y}).ok());
    ASSERT_TRUE(plate.order("z", command::MoveAbsolute{.position = z}).ok());
    plate.site.advance(2s);
    EXPECT_NEAR(plate.site.last(2).correction[0], correction, 1e-12) << x;
  }
  EXPECT_FALSE(plate.site.replayed().difference);
  const auto positions = [&](const char* axis) {
    return test::LogColumns(log_of(plate.log, axis, 3)).numbers("position");
  };
  const test::LogColumns log(log_of(plate.log, "z", 3));
  const auto x = positions("x");
  const auto y = positions("y");
  const auto z = positions("z");
  const auto drive = log.numbers("drive_position");
  std::size_t judged = 0;
  for (std::size_t t = 0; t < z.size(); ++t) {
    if (log.text.at("compensated")[t] != "1" || log.text.at("state")[t] == "disabled") continue;
    ASSERT_NEAR(drive[t], z[t] + in_space(x[t], y[t], z[t]), 1e-12) << t;
    ++judged;
  }
  EXPECT_GT(judged, 5000U);
}

TEST(CompensationPlay, ADamagedReplayDiffers) {
  Plate plate("compensated-table/machine.toml");
  plate.on("x");
  ASSERT_TRUE(plate.order("x", command::MoveAbsolute{.position = 300}).ok());
  plate.site.advance(1s);
  std::istringstream record(plate.site.record());
  std::int64_t corrected = 0;
  const Replay done = replay(record, "record", [&](const RecordedCycle& cycle) {
    corrected += cycle.axis == 0 && cycle.tick.compensated && cycle.tick.correction[0] != 0 ? 1 : 0;
  });
  EXPECT_FALSE(done.difference);
  EXPECT_GT(corrected, 500);
}

TEST(CompensationPlay, MistakesAreAnsweredWithTheirReason) {
  Plate plate("compensated-table/machine.toml");
  EXPECT_THAT(plate.order("x", command::EnableCompensation{}).reason, HasSubstr("not_homed"));
  plate.on("x");
  EXPECT_THAT(plate.order("x", command::EnableCompensation{}).reason, HasSubstr("enabled"));
  EXPECT_THAT(plate.order("x", command::SetPosition{.position = 0}).reason,
              HasSubstr("compensation_active"));
  EXPECT_TRUE(plate.order("y", command::SetPosition{.position = 0}).ok())
      << "x does not refer to y";
}

TEST(GearState, IsInTheStatusOfTheSlaveAndOfItsMaster) {
  Plate line("printing-line/machine.toml");
  for (const char* const axis : {"line", "label"})
    ASSERT_TRUE(line.order(axis, command::Enable{}).ok());
  EXPECT_EQ(line.status("label")->gear, wire::GearState::disengaged);
  ASSERT_TRUE(line.order("line", command::MoveVelocity{.velocity = 100}).ok());
  ASSERT_TRUE(
      line.order("label", command::GearIn{.numerator = -1, .denominator = 2, .clutch = 40}).ok());
  line.site.advance(60ms);
  auto label = line.status("label");
  EXPECT_EQ(label->gear, wire::GearState::engaging);
  line.site.advance(1s);
  label = line.status("label");
  EXPECT_EQ(label->gear, wire::GearState::in_gear);
  EXPECT_EQ(label->ratio, -0.5);
  EXPECT_FALSE(label->gear_master);
  EXPECT_THAT(status_text("label", *label), HasSubstr("in gear, ratio -0.5"));
  line.site.advance(50ms);
  const auto master = line.status("line");
  EXPECT_TRUE(master->gear_master);
  EXPECT_EQ(master->gear, wire::GearState::none);
  ASSERT_TRUE(line.order("label", command::GearOut{}).ok());
  label = line.status("label");
  ASSERT_TRUE(label);
  EXPECT_EQ(label->gear, wire::GearState::disengaged);
  EXPECT_EQ(label->ratio, 0);
}

}  // namespace
}  // namespace jounce::compensation_play_test
