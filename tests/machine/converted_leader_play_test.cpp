// SPDX-License-Identifier: Apache-2.0
// A follower whose master has another unit of length than its leader. The judge compares the tick
// log of the follower with that of the leader, or with the motion of the master.
#include <cmath>
#include <cstdint>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/machine/machine_parts.hpp"
#include "jounce/stream/sender/client.hpp"

#include "executor/site.hpp"
#include "machine/log_columns.hpp"
#include "support/errors.hpp"
#include "support/temporary_folder.hpp"

namespace jounce::converted_leader_play_test {
namespace {

using namespace std::chrono_literals;

class ConvertedLeader : public test::WithFolder {
 protected:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << "jounce = 1\n" << text;
  }
  /// A web in m, and a carriage in mm; `master`: the unit of the carriage's master.
  void write_axes(const std::string& master = "mm") const {
    write("web.toml",
          "kind = \"axis\"\nname = \"web\"\nunits = { position = \"m\" }\n[axis]\n"
          "cycle = \"1 ms\"\n[limits]\nvelocity = 1\nacceleration = 2\njerk = 20\n");
    write("carriage.toml",
          "kind = \"axis\"\nname = \"carriage\"\nunits = { position = \"mm\", master = \"" +
              master +
              "\" }\n[axis]\ncycle = \"1 ms\"\n[limits]\nvelocity = 4000\nacceleration = 25000\n");
  }
  MachineParts parts_of(const std::string& machine, bool logged = true) const {
    write("machine.toml", "kind = \"machine\"\n" + machine);
    return machine_parts({.files = {(folder_ / "machine.toml").string()},
                          .log = logged ? (folder_ / "run.csv").string() : "",
                          .enable = true});
  }
  /// A gear of 1 : `of`.
  static void gear_in(test::Site& site, const std::string& axis, std::int32_t of) {
    Client client(site.link, axis, {}, site.clock);
    const CallOutcome outcome = client.command(
        command::GearIn{.numerator = 1, .denominator = of, .dynamics = {.acceleration = 20000}});
    ASSERT_TRUE(outcome.ok()) << outcome.reason;
    static_cast<void>(client.release());
  }
};

TEST_F(ConvertedLeader, MovesItsFollowerByTheRatioInTheUnitsOfTheFollower) {
  write_axes();
  MachineParts parts = parts_of(
      "[[axis]]\nspec = \"web.toml\"\n[[axis]]\nspec = \"carriage.toml\"\n"
      "follow = { axis = \"web\" }\n");
  test::Site site(std::move(parts.axes), {.recorded = true, .said = {}});
  site.advance(100ms);
  gear_in(site, "carriage", 2);
  {
    Client web(site.link, "web", {}, site.clock);
    ASSERT_TRUE(web.command(command::MoveAbsolute{.position = 1.5}).ok());
    static_cast<void>(web.release());
  }
  site.advance(4s);
  EXPECT_FALSE(site.replayed().difference);
  const test::LogColumns web((folder_ / "run.web.csv").string());
  const test::LogColumns carriage((folder_ / "run.carriage.csv").string());
  std::size_t judged = 0;
  for (const auto& [column, unit] : {std::pair{"position", 1000.0}, {"velocity", 1000.0}}) {
    const auto leader = web.numbers(column);
    const auto follower = carriage.numbers(column);
    ASSERT_EQ(leader.size(), follower.size());
    for (std::size_t k = 0; k < leader.size(); ++k, ++judged) {
      ASSERT_EQ(carriage.text.at("fault")[k], "none") << k;
      ASSERT_NEAR(follower[k], unit * leader[k] / 2, 1e-9) << column << " " << k;
    }
  }
  EXPECT_GT(judged, 8000U);
  EXPECT_NEAR(carriage.numbers("position").back(), 750, 1e-9) << "mm, behind 1.5 m";
}

TEST_F(ConvertedLeader, MayBeAMasterOfTheMachine) {
  write_axes();
  MachineParts parts = parts_of(
      "[[axis]]\nspec = \"carriage.toml\"\nfollow = { master = \"line\" }\n"
      "[master.line]\nkind = \"external\"\nunit = \"m\"\nvelocity = 1\nacceleration = 20\n");
  test::Site site(std::move(parts.axes), {.masters = parts.masters, .recorded = true, .said = {}});
  MemoryTransport encoder(site.network);
  const Nanos zero = site.clock();
  std::int64_t samples = 0;
  const auto since = [&] { return std::chrono::duration<double>(site.clock() - zero).count(); };
  site.before = [&] {
    const double t = since();
    send_message(encoder, {"line", 0,
                           wire::Master{.seq = ++samples,
                                        .stamp_ns = site.clock().count(),
                                        .clock = 1,
                                        .valid = true,
                                        .position = t < 1 ? 0 : 0.1 * (t - 1) * (t - 1),
                                        .unit = "m"}});
  };
  site.advance(500ms);
  gear_in(site, "carriage", 4);
  site.advance(2500ms);
  EXPECT_FALSE(site.replayed().difference) << "the replay converts the master, too";
  const test::LogColumns carriage((folder_ / "run.csv").string());
  const double t = since() - 1;
  EXPECT_NEAR(carriage.numbers("position").back(), 25 * t * t, 1)
      << "mm: a quarter of the 0.1 t^2 m of the line; samples and filter are some ms late";
  EXPECT_NEAR(carriage.numbers("velocity").back(), 50 * t, 1) << "mm/s";
}

/// A second master in m or deg: the carriage, in mm, adds a hundredth of its motion to that of the web.
TEST_F(ConvertedLeader, MayBeTheSecondMaster) {
  for (const auto& [unit, expected] :
       {std::pair{"m", 750.0 + 0.01 * 500}, {"deg", 750.0 + 0.01 * 0.5}}) {
    write_axes();
    write("corrector.toml",
          "kind = \"axis\"\nname = \"corrector\"\nunits = { position = \"" + std::string(unit) +
              "\" }\n[axis]\ncycle = \"1 ms\"\n[limits]\nvelocity = 1\nacceleration = 2\n");
    MachineParts parts = parts_of(
        "[[axis]]\nspec = \"web.toml\"\n[[axis]]\nspec = \"corrector.toml\"\n[[axis]]\n"
        "spec = \"carriage.toml\"\nfollow = { axis = \"web\", second = { axis = \"corrector\" } "
        "}\n");
    test::Site site(std::move(parts.axes), {.recorded = true, .said = {}});
    site.advance(100ms);
    const auto send = [&](const std::string& axis, const ClientCommand& command) {
      Client client(site.link, axis, {}, site.clock);
      const CallOutcome outcome = client.command(command);
      ASSERT_TRUE(outcome.ok()) << outcome.reason;
      static_cast<void>(client.release());
    };
    send("carriage", command::CombineAxes{.numerator = 1,
                                          .denominator = 2,
                                          .second_numerator = 1,
                                          .second_denominator = 100,
                                          .dynamics = {.acceleration = 20000}});
    send("web", command::MoveAbsolute{.position = 1.5});
    send("corrector", command::MoveAbsolute{.position = 0.5});
    site.advance(4s);
    EXPECT_NEAR(site.last(2).position, expected, 1e-9) << unit;
    EXPECT_FALSE(site.replayed().difference) << unit;
  }
}

TEST_F(ConvertedLeader, HasTheSameQuantity) {
  write_axes("deg");
  EXPECT_THAT(
      test::error_of([&] {
        parts_of(
            "[[axis]]\nspec = \"web.toml\"\n[[axis]]\nspec = \"carriage.toml\"\n"
            "follow = { axis = \"web\" }\n",
            false);
      }),
      testing::HasSubstr("has the unit m, but the axis carriage has units.master = \"deg\""));
}

}  // namespace
}  // namespace jounce::converted_leader_play_test
