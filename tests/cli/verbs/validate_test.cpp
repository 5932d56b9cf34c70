// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace jounce::validate_verb_test {
namespace {

using cli_test::cam;
using cli_test::Result;
using cli_test::slurp;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

using ValidateVerb = cli_test::Program;

/// A move through two masses whose loop has a delay, ms.
std::string delayed_drive(double delay) {
  return R"(jounce = 1
kind = "move"
units = { position = "mm" }
[move]
profile = "s_curve"
to = 100
velocity = 500
acceleration = 5000
jerk = 2e5
[drive]
position_per_rev = 20
settle = 0.3
motor = { inertia = 4e-5, friction.viscous = 1e-4, torque_limit = 20, torque_constant = 0.5 }
mass = [{ stiffness = 50, damping = 5e-3, inertia = 2e-4 }]
[drive.controller]
position_gain = 40
velocity_gain = 0.05
integral_time = 0.02
delay = ")" +
         std::to_string(delay) + " ms\"\n";
}

TEST_F(ValidateVerb, ProvesAGCodeProgram) {
  const std::string part = cli_test::examples + "gcode-part/";
  const std::string program = part + "plate.ngc --machine " + part + "machine.toml";
  EXPECT_EQ(run("validate --axis x " + program).status, 0);
  EXPECT_EQ(run("validate --quiet " + program).status, 0);
  EXPECT_EQ(run("validate " + part + "plate.ngc").status, 2);
}

TEST_F(ValidateVerb, ALoadThatDoesNotSettleIsReportedAsSuch) {
  const std::string limits = "[drive.limits]\nsettling_band = 1e-9\nsettling_time = ";
  write("soon.toml", delayed_drive(0) + limits + "0.1\n");
  const Result soon = run("validate soon.toml");
  EXPECT_EQ(soon.status, 1);
  EXPECT_THAT(soon.out, HasSubstr("settling time 0.3 s"));
  EXPECT_THAT(soon.out, HasSubstr("exceeds the limit 0.1 s"));
  write("late.toml", delayed_drive(0) + limits + "5\n");
  const Result late = run("validate late.toml");
  EXPECT_EQ(late.status, 1);
  EXPECT_THAT(
      late.out,
      HasSubstr("the load does not settle in the 0.3 s that are simulated after the motion"));
  EXPECT_THAT(late.out, HasSubstr("-> simulate a standstill as long as the limit: set settle = 5"));
}

/// A loop that is hardly unstable, and one that is much so: findings of the loop, not of the solver.
TEST_F(ValidateVerb, AnUnstableLoopIsAFinding) {
  for (const double delay : {0.86, 1.1}) {
    write("unstable.toml", delayed_drive(delay));
    for (const char* verb : {"validate", "check"}) {
      const Result found = run(std::string(verb) + " unstable.toml");
      EXPECT_EQ(found.status, 1) << verb << found.err;
      EXPECT_THAT(
          found.out,
          HasSubstr(delay < 1 ? "the loop is unstable: an oscillation at 307.217 Hz grows"
                              : "the loop is unstable: an oscillation at 278.632 Hz grows"));
      EXPECT_THAT(found.out, HasSubstr("-> lower controller.velocity_gain from 0.05 to less than"));
      EXPECT_THAT(found.out, Not(HasSubstr("please report")));
      EXPECT_THAT(found.out, Not(HasSubstr("without this limit, the torque reaches")));
    }
    const json validated = json::parse(run("validate --json unstable.toml").out);
    EXPECT_EQ(validated["findings"][0]["rule"], "drive/stability");
    EXPECT_EQ(validated["findings"][0]["where_unit"], "Hz");
    EXPECT_EQ(validated["drive"]["loop"]["stable"], false);
    EXPECT_EQ(run("report unstable.toml -o page.html").status, 1);
    const std::string page = slurp(folder / "page.html");
    EXPECT_EQ(page.find("drive/stability"), page.rfind("drive/stability"));  // reported once
    EXPECT_THAT(page, HasSubstr("gain margin"));
    for (const char* picture : {"spectrum", "bode", "nyquist", "response"}) {
      const Result drawn = run(std::string("plot unstable.toml --drive ") + picture);
      EXPECT_EQ(drawn.status, 0) << picture << drawn.err;
      EXPECT_THAT(drawn.out, StartsWith("<svg"));
    }
  }
  std::string periodic = delayed_drive(1.1);
  periodic.replace(periodic.find("settle = 0.3"), 12, "periodic = true");
  write("periodic.toml", periodic);  // a finding too, though it has no steady state to integrate
  for (const char* verb : {"validate", "check"}) {
    const Result found = run(std::string(verb) + " periodic.toml");
    EXPECT_EQ(found.status, 1) << verb << found.err;
    EXPECT_THAT(found.out, HasSubstr("the loop is unstable: an oscillation at 278.632 Hz grows"));
    EXPECT_THAT(found.out, HasSubstr("-> lower controller.velocity_gain from 0.05 to less than"));
  }
  EXPECT_THAT(run("validate periodic.toml").out,
              HasSubstr("loop unstable at 278.6 Hz, gain margin"));
  EXPECT_EQ(run("report periodic.toml -o page.html").status, 1);
  write("stable.toml", delayed_drive(0.1));
  const Result calm = run("validate stable.toml");
  EXPECT_EQ(calm.status, 0) << calm.out;
  EXPECT_THAT(calm.out, HasSubstr("loop stable, gain margin"));
}

/// The signals of the model are a recording that `identify` reads.
TEST_F(ValidateVerb, WritesTheSignalsOfADrive) {
  write("move.toml", delayed_drive(0.1));
  ASSERT_EQ(run("validate move.toml --signals run.csv --samples 801").status, 0);
  const std::string text = slurp(folder / "run.csv");
  EXPECT_THAT(text, HasSubstr("\ntime [s],command [mm],feedback [mm],load [mm],velocity [mm/s],"
                              "following_error [mm],torque [N m],current [A]\n0,0,0,0,0,0,0,0\n"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3 + 1 + 801);
  const Result found = run("identify move.toml --log run.csv --fit mass[1].inertia --json");
  EXPECT_EQ(found.status, 0) << found.out << found.err;
  EXPECT_NEAR(json::parse(found.out)["numbers"][0]["value"].get<double>(), 2e-4, 1e-7);
  ASSERT_EQ(run("validate move.toml --signals run.npy --samples 801").status, 0);
  EXPECT_THAT(slurp(folder / "run.npy"), HasSubstr("('feedback', '<f8'), ('load', '<f8')"));
  EXPECT_THAT(run("validate move.toml --signals run.txt").err,
              HasSubstr("must end in .csv or .npy"));
  EXPECT_THAT(run("validate move.toml --signals move.toml").err, HasSubstr("--signals"));
  ASSERT_EQ(run("new gear -o gear.toml").status, 0);
  EXPECT_THAT(run("validate gear.toml --signals run.csv").err, HasSubstr("[drive]"));
  const Result piped = run("validate move.toml --signals -");
  EXPECT_THAT(piped.out, StartsWith("# jounce drive signals 1\n"));
  EXPECT_THAT(piped.err, HasSubstr("proven"));
}

TEST_F(ValidateVerb, ProvesACamAndReportsAFollowingError) {
  const Result good = run("validate --json " + cam);
  EXPECT_EQ(good.status, 0);
  const json proof = json::parse(good.out);
  EXPECT_LE(proof["witness"]["curve"]["position"].get<double>(), 1e-10);
  EXPECT_GT(
      proof["drive"]["peak_torque"].get<double>() * proof["drive"]["peak_torque"].get<double>(), 0);

  std::string text = slurp(cam);
  text.replace(text.find("following_error = 1"), 19, "following_error = 0.001");
  write("tight.toml", text);
  EXPECT_EQ(run("validate tight.toml").status, 1);
}

TEST_F(ValidateVerb, SimulatesTheDriveOfEachAxis) {
  const std::string spec =
      "jounce = 1\nkind = \"axes\"\nunits = { position = \"mm\" }\n"
      "[[axis]]\nname = \"x\"\nto = 30\nvelocity = 100\nacceleration = 1000\njerk = 20000\n"
      "[axis.drive]\nmodel = \"servo_400w\"\nposition_per_rev = 10\n"
      "[[axis]]\nname = \"y\"\nto = 30\nvelocity = 100\nacceleration = 1000\n";
  write("gantry.toml", spec);
  const json proof = json::parse(run("validate --json gantry.toml").out)["axes"];
  EXPECT_GT(proof["x"]["drive"]["peak_torque"].get<double>(), 0);
  EXPECT_FALSE(proof["y"].contains("drive"));
  write("wrong.toml", std::string(spec).replace(spec.find("rev = 10"), 8, "rev = -1"));
  EXPECT_EQ(run("validate wrong.toml").err,
            "jounce: wrong.toml:12:20: axis[1].drive.position_per_rev = -1 mm/rev: must be greater "
            "than 0\n");
}

}  // namespace
}  // namespace jounce::validate_verb_test
