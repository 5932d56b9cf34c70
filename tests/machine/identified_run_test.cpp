// SPDX-License-Identifier: Apache-2.0
// The chain of commissioning in one process: a run of an axis with a simulated drive, its record, the
// list of its ticks, and the fit, which is judged by the numbers of the simulated drive.
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/io/recording.hpp"
#include "jounce/machine/detail/replay_text.hpp"
#include "jounce/machine/machine_parts.hpp"
#include "jounce/spec/spec.hpp"
#include "jounce/stream/sender/client.hpp"

#include "executor/site.hpp"
#include "support/random.hpp"
#include "support/temporary_folder.hpp"

namespace jounce::identified_run_test {
namespace {

using namespace std::chrono_literals;
using Status = Identification::Status;

struct Truth {
  double motor = 4e-5;          ///< kg m^2
  double load = 2e-4;           ///< kg m^2
  double stiffness = 50;        ///< N m/rad
  std::string controller = "";  ///< more keys
};

class IdentifiedRun : public test::WithFolder {
 protected:
  void write_drive(const std::string& name, const Truth& is) const {
    std::ofstream(folder_ / name)
        << "jounce = 1\nkind = \"drive\"\n[units]\nposition = \"mm\"\n[drive]\nposition_per_rev = "
           "10\n"
        << "[drive.motor]\ninertia = " << is.motor
        << "\nfriction.viscous = 1e-4\ntorque_limit = 3.8\n[[drive.mass]]\nstiffness = "
        << is.stiffness << "\ndamping = 5e-3\ninertia = " << is.load
        << "\nfriction.viscous = 1e-4\n[drive.controller]\nposition_gain = 40\n"
           "velocity_gain = 0.05\nintegral_time = \"20 ms\"\n"
        << is.controller;
  }
  void write_axis(const std::string& limits) const {
    std::ofstream(folder_ / "axis.toml")
        << "jounce = 1\nkind = \"axis\"\nname = \"feeder\"\nunits = { position = \"mm\" }\n[axis]\n"
           "cycle = \"1 ms\"\n[drive]\nspec = \"drive.toml\"\n[limits]\nvelocity = 300\n"
           "acceleration = 5000\n"
        << limits;
  }

  /// Two moves with late cycles, and a new coordinate between them.
  std::string csv_of_run(std::uint64_t seed) const {
    MachineParts parts =
        machine_parts({.files = {(folder_ / "axis.toml").string()}, .enable = true});
    test::Site site(std::move(parts.axes), {.recorded = true, .said = {}});
    test::Random random(seed);
    site.before = [&] {
      if (random.below(50) == 0) site.pacer.delay = random.below(6) * 1'000'000;
    };
    site.advance(50ms);
    {
      Client client(site.link, "feeder", {}, site.clock);
      EXPECT_TRUE(client.command(command::MoveAbsolute{.position = random.uniform(20, 40)}).ok());
      site.advance(500ms);
      EXPECT_TRUE(client.command(command::SetPosition{.position = -100}).ok());
      EXPECT_TRUE(
          client.command(command::MoveAbsolute{.position = random.uniform(-120, -140)}).ok());
      site.advance(500ms);
      static_cast<void>(client.release());
    }
    site.before = {};
    const std::string record = (folder_ / "run.lcmlog").string();
    std::ofstream(record, std::ios::binary) << site.record();
    const std::string csv = (folder_ / "run.csv").string();
    EXPECT_TRUE(replay_file(record, {.csv = csv}).replay.same());
    return csv;
  }

  Identification identified(const std::string& csv, const Truth& start) const {
    write_drive("start.toml", start);
    const Spec spec = read_spec((folder_ / "start.toml").string());
    return identify(read_recording(csv, spec.drive->drive, "mm"),
                    {spec.drive->drive, {"motor.inertia", "mass[1].inertia", "mass[1].stiffness"}});
  }

  static std::vector<double> numbers_of(const Truth& is) {
    return {is.motor, is.load, is.stiffness};
  }

  /// The start of the fit: not one of the fitted numbers is right, and so is its feed-forward.
  static Truth start_of(const Truth& truth) {
    return {1.3 * truth.motor, 1.4 * truth.load, 0.8 * truth.stiffness, truth.controller};
  }

  void expect_exact(const Truth& truth, const std::string& limits) const {
    write_drive("drive.toml", truth);
    write_axis(limits);
    const Identification found = identified(csv_of_run(5), start_of(truth));
    EXPECT_EQ(found.status, Status::converged) << found.reason;
    const auto values = numbers_of(truth);
    ASSERT_EQ(found.numbers.size(), values.size());
    for (std::size_t j = 0; j < values.size(); ++j) {
      const FittedNumber& n = found.numbers[j];
      EXPECT_NEAR(n.value, values[j], 1e-6 * values[j]) << n.key;
      EXPECT_TRUE(n.low <= values[j] && values[j] <= n.high) << n.key;
    }
    ASSERT_TRUE(found.feed_forward);
    EXPECT_NEAR(found.feed_forward->value, truth.motor + truth.load, 1e-9);
    EXPECT_NEAR(found.drive.controller.torque_feed_forward, 1, 1e-6);
  }
};

TEST_F(IdentifiedRun, OfSCurvesGivesTheNumbersOfTheDrive) {
  expect_exact({}, "jerk = 5e5\n");
}

TEST_F(IdentifiedRun, OfTrapezoidsGivesTheNumbersOfTheDrive) {
  expect_exact({}, "");
}

TEST_F(IdentifiedRun, UnderASampledControllerGivesTheNumbersOfTheDrive) {
  expect_exact({.controller = "cycle = \"0.25 ms\"\ndelay = \"0.1 ms\"\n"}, "jerk = 5e5\n");
}

// The counts act on the controller, which passes them on as correlated noise. Binomial(40, 0.95): fewer than
// 33 have a probability of 0.1 %.
TEST_F(IdentifiedRun, UnderAControllerWithCountsHasIntervalsWithTheNumbersOfTheDrive) {
  write_axis("jerk = 5e5\n");
  constexpr int cases = 40;
  std::vector<int> held(3);
  int converged = 0;
  for (int k = 1; k <= cases; ++k) {
    test::Random random(static_cast<std::uint64_t>(k));
    const Truth truth{random.uniform(3e-5, 6e-5), random.uniform(1.5e-4, 3e-4),
                      random.uniform(40, 70),
                      "cycle = \"0.25 ms\"\ndelay = \"0.1 ms\"\nencoder_counts = 10000\n"};
    write_drive("drive.toml", truth);
    const Identification found =
        identified(csv_of_run(static_cast<std::uint64_t>(k)), start_of(truth));
    EXPECT_TRUE(found.usable()) << found.reason;
    converged += found.status == Status::converged ? 1 : 0;
    const auto values = numbers_of(truth);
    for (std::size_t j = 0; j < values.size(); ++j)
      held[j] += found.numbers[j].low <= values[j] && values[j] <= found.numbers[j].high;
  }
  for (const int of_number : held) EXPECT_GE(of_number, 33);
  EXPECT_GE(converged, 38);
}

}  // namespace
}  // namespace jounce::identified_run_test
