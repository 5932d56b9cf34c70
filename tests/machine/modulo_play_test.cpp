// SPDX-License-Identifier: Apache-2.0
// examples/rotary-table/axis.toml on a virtual clock: moves around the turn, then two tables, which begin in the
// turn of the axis and swap without a stop. The judge reads the tick log alone.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/machine/machine_parts.hpp"
#include "jounce/stream/sender/client.hpp"

#include "executor/site.hpp"
#include "machine/log_columns.hpp"

namespace jounce::modulo_play_test {
namespace {

using namespace std::chrono_literals;

/// From p to q in 1 s, by the 3-4-5 polynomial.
Table stroke(double p, double q) {
  return {Domain::time, Interpolation::quintic_hermite, Extrapolation::hold,
          Columns{.x = {0, 1}, .p = {p, q}, .v = {0, 0}, .a = {0, 0}}};
}

double poly_345(double t) {
  const double z = std::clamp(t, 0.0, 1.0);
  return z * z * z * (10 + z * (6 * z - 15));
}

TEST(ModuloPlay, MovesAndSwappedTablesStayInTheTurnOfTheAxis) {
  const std::string path = testing::TempDir() + "/modulo_" + std::to_string(getpid()) + ".csv";
  test::Site site(machine_parts({.files = {JOUNCE_SOURCE_DIR "/examples/rotary-table/axis.toml"},
                                 .log = path,
                                 .enable = true})
                      .axes,
                  {.masters = {}, .recorded = true, .said = {}});
  site.advance(20ms);
  const auto move = [&](double to, Direction direction) {
    Client client(site.link, "table", {}, site.clock);
    EXPECT_TRUE(client.command(command::MoveAbsolute{.position = to, .direction = direction}).ok());
    static_cast<void>(client.release());
    site.advance(3s);
    return site.last().position;
  };
  EXPECT_NEAR(move(350, Direction::positive), 350, 1e-9);
  EXPECT_NEAR(move(10, Direction::shortest), 370, 1e-9) << "20 deg forwards";
  EXPECT_NEAR(move(20, Direction::negative), 20, 1e-9) << "350 deg back";
  EXPECT_NEAR(move(10, Direction::positive), 370, 1e-9) << "350 deg forwards";
  const Units units{"s", "deg"};
  StreamPlan plan{.executor = "table",
                  .tables = {{stroke(10, 70), units}, {stroke(790, 850), units}}};
  plan.swaps = {{.slave = 1}};
  const StreamOutcome outcome = site.stream(std::move(plan));
  EXPECT_TRUE(outcome.ok()) << outcome.reason;
  site.advance(3s);
  EXPECT_FALSE(site.replayed().difference);

  const test::LogColumns log(path);
  const std::vector<double> position = log.numbers("position");
  const std::vector<double> job = log.numbers("job");
  const auto first = std::find_if(job.begin(), job.end(), [](double id) { return id != 0; });
  ASSERT_NE(first, job.end());
  std::size_t judged = 0;
  for (auto k = static_cast<std::size_t>(first - job.begin()); k < position.size(); ++k, ++judged) {
    const double t = static_cast<double>(judged) * 1e-3;
    ASSERT_NEAR(position[k], 370 + 60 * (poly_345(t) + poly_345(t - 1)), 1e-9) << judged;
    ASSERT_EQ(log.text.at("fault")[k], "none");
  }
  EXPECT_GT(judged, 3000U);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace jounce::modulo_play_test
