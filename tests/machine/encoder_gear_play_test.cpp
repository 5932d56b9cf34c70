// SPDX-License-Identifier: Apache-2.0
// examples/external-master/crank.toml: a gear behind a single-turn encoder, whose samples come over the bus. The judge
// compares the tick log with the motion of the crank.
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/machine/machine_parts.hpp"
#include "jounce/stream/sender/client.hpp"

#include "executor/site.hpp"
#include "machine/log_columns.hpp"

namespace jounce::encoder_gear_play_test {
namespace {

using namespace std::chrono_literals;

constexpr double start = 350;    // deg
constexpr double travel = 5400;  // deg, 15 turns

/// The crank: at rest for 1 s, 15 turns forwards in 9 s, and 5 turns back in 5 s, by inclined sines.
double crank(double t) {
  const auto step = [](double s) {
    s = std::min(std::max(s, 0.0), 1.0);
    return s - std::sin(2 * std::numbers::pi * s) / (2 * std::numbers::pi);
  };
  return start + travel * step((t - 1) / 9) - 1800 * step((t - 11) / 5);
}

TEST(EncoderGearPlay, CountsTheTurnsOfASingleTurnEncoder) {
  const std::string log = testing::TempDir() + "/crank_" + std::to_string(getpid()) + ".csv";
  MachineParts parts =
      machine_parts({.files = {JOUNCE_SOURCE_DIR "/examples/external-master/crank.toml"},
                     .log = log,
                     .enable = true});
  test::Site site(std::move(parts.axes), {.masters = parts.masters, .recorded = true, .said = {}});
  MemoryTransport encoder(site.network);
  std::int64_t samples = 0;
  const Nanos zero = site.clock();
  const auto since = [&] { return std::chrono::duration<double>(site.clock() - zero).count(); };
  site.before = [&] {
    const double now = crank(since());
    send_message(encoder, {"crank", 0,
                           wire::Master{.seq = ++samples,
                                        .stamp_ns = site.clock().count(),
                                        .clock = 1,
                                        .valid = true,
                                        .position = now - 360 * std::floor(now / 360),
                                        .unit = "deg"}});
  };
  site.advance(500ms);
  {
    Client client(site.link, "roller", {}, site.clock);
    const CallOutcome outcome = client.command(command::GearIn{.numerator = 1, .denominator = 2});
    ASSERT_TRUE(outcome.ok()) << outcome.reason;
    static_cast<void>(client.release());
  }
  site.advance(17s);
  const double began = since() - site.last().time;
  EXPECT_FALSE(site.replayed().difference);
  const test::LogColumns columns(log);
  const auto master = columns.numbers("master");
  const auto position = columns.numbers("position");
  const auto time = columns.numbers("time");
  std::size_t judged = 0;
  double first = 0;
  for (std::size_t k = 0; k < time.size(); ++k) {
    ASSERT_EQ(columns.text.at("fault")[k], "none") << k;
    if (columns.text.at("state")[k] != "synchronized_motion") continue;
    if (judged++ == 0) first = position[k] - master[k] / 2;
    ASSERT_NEAR(position[k], first + master[k] / 2, 1e-9) << k << ": 1 mm for each 2 deg";
    ASSERT_NEAR(master[k], crank(began + time[k]), 5)
        << k << ": samples and filter are some ms late, at up to 1200 deg/s";
  }
  EXPECT_GT(judged, 15000U);
  EXPECT_NEAR(master.back(), start + travel - 1800, 1e-6) << "all turns";
  std::filesystem::remove(log);
}

}  // namespace
}  // namespace jounce::encoder_gear_play_test
