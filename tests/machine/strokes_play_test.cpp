// SPDX-License-Identifier: Apache-2.0
// examples/strokes, commanded through the protocol on a virtual clock. The judge computes the positions from the
// numbers of the manuals, and compares them with the tick log alone.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/machine/machine_parts.hpp"
#include "jounce/stream/sender/client.hpp"

#include "executor/site.hpp"
#include "machine/log_columns.hpp"

namespace jounce::strokes_play_test {
namespace {

using namespace std::chrono_literals;

struct Slide {
  Slide()
      : log(testing::TempDir() + "/strokes_" + std::to_string(getpid()) + ".csv"),
        site(machine_parts({.files = {JOUNCE_SOURCE_DIR "/examples/strokes/axis.toml"},
                            .log = log,
                            .enable = true})
                 .axes,
             {.masters = {}, .recorded = true, .said = {}}) {
    site.advance(20ms);
  }
  ~Slide() { std::filesystem::remove(log); }
  Slide(const Slide&) = delete;
  Slide& operator=(const Slide&) = delete;

  void order(const ClientCommand& command) {
    Client client(site.link, "slide", {}, site.clock);
    const CallOutcome outcome = client.command(command);
    EXPECT_TRUE(outcome.ok()) << outcome.reason;
    static_cast<void>(client.release());
  }
  /// The positions of the log from the last tick at rest, before it first leaves 0.
  std::vector<double> positions() {
    EXPECT_FALSE(site.replayed().difference);
    const test::LogColumns columns(log);
    for (const std::string& fault : columns.text.at("fault")) EXPECT_EQ(fault, "none");
    const std::vector<double> all = columns.numbers("position");
    const auto first = std::find_if(all.begin(), all.end(), [](double p) { return p != 0; });
    return {first - 1, all.end()};
  }

  std::string log;
  test::Site site;
};

// Agito PCSuite manual 4.10: amplitude 200 and 5 Hz, so strokes of 400 pulses in 0.1 s, each of two parabolas.
TEST(StrokesPlay, TheQuasiSineOfAgitoIsInTheLog) {
  Slide slide;
  slide.order(command::MoveRepetitive{
      .position = 400,
      .dynamics = {.velocity = 8000, .acceleration = 160000, .deceleration = 160000},
      .strokes = 20});
  slide.site.advance(3s);
  const std::vector<double> log = slide.positions();
  ASSERT_GT(log.size(), 2500U);
  for (std::size_t k = 0; k < log.size(); ++k) {
    const double t = static_cast<double>(std::min<std::size_t>(k, 2000)) * 1e-3;
    const double s = t - 0.2 * std::floor(t / 0.2 + 1e-9);  // in one period of 0.2 s
    const double u = s <= 0.1 ? s : 0.2 - s;  // the stroke back is the same, backwards
    const double way = u <= 0.05 ? 80000 * u * u : 400 - 80000 * (0.1 - u) * (0.1 - u);
    ASSERT_NEAR(log[k], way, 1e-6) << k;
  }
}

// Googol iDEABOX manual, example 7-2: a jog at 100 pulse/ms; 50 pulse/ms once the position exceeds 100000.
TEST(StrokesPlay, ANewVelocityAtAPositionIsInTheLog) {
  Slide slide;
  slide.order(command::MoveVelocity{.velocity = 1e5,
                                    .dynamics = {.acceleration = 62500, .deceleration = 62500}});
  slide.order(command::ChangeVelocity{.velocity = 5e4, .position = 100000});
  slide.site.advance(3s);
  const std::vector<double> log = slide.positions();
  ASSERT_GT(log.size(), 2700U);
  for (std::size_t k = 0; k < log.size(); ++k) {
    const double t = static_cast<double>(k) * 1e-3;
    double p = 31250 * t * t;
    if (t > 1.6) p = 80000 + 1e5 * (t - 1.6);
    if (t > 1.8) p = 100000 + 1e5 * (t - 1.8) - 31250 * (t - 1.8) * (t - 1.8);
    if (t > 2.6) p = 160000 + 5e4 * (t - 2.6);
    ASSERT_NEAR(log[k], p, 1e-5) << k;
  }
}

// Agito PCSuite manual 4.11: to 3800 at 20000 pulse/s; from 3400 on, SpeedChgPos, at 500 pulse/s.
TEST(StrokesPlay, TheSlowApproachOfAgitoIsInTheLog) {
  Slide slide;
  slide.order(command::MoveAbsolute{.position = 3800, .dynamics = {.velocity = 20000}});
  slide.order(command::ChangeVelocity{.velocity = 500, .position = 3400});
  slide.site.advance(1s);
  const std::vector<double> log = slide.positions();
  constexpr double a = 2e6;
  constexpr double ramp = 19500 / a;                        // s
  constexpr double slow = 3400 + ramp * (20000 + 500) / 2;  // place from which it is slow
  constexpr double braking = 500.0 * 500 / (2 * a);         // before 3800
  constexpr double arrived = 0.175 + ramp + (3800 - braking - slow) / 500;
  static_assert(arrived + 500 / a > 0.784 && arrived + 500 / a < 0.786, "0.785 s");
  ASSERT_GT(log.size(), 800U);
  for (std::size_t k = 0; k < log.size(); ++k) {
    const double t = static_cast<double>(k) * 1e-3;
    double p = a / 2 * t * t;
    if (t > 0.01) p = 100 + 20000 * (t - 0.01);
    if (t > 0.175) p = 3400 + 20000 * (t - 0.175) - a / 2 * (t - 0.175) * (t - 0.175);
    if (t > 0.175 + ramp) p = slow + 500 * (t - 0.175 - ramp);
    if (t > arrived) p = 3800 - a / 2 * std::pow(std::max(arrived + 500 / a - t, 0.0), 2);
    ASSERT_NEAR(log[k], p, 1e-6) << k;
  }
}

}  // namespace
}  // namespace jounce::strokes_play_test
