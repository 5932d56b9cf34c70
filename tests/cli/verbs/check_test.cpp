// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "program.hpp"

namespace jounce::check_verb_test {
namespace {

using cli_test::cam;
using cli_test::examples;
using cli_test::Result;
using cli_test::slurp;
using cli_test::via;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

using CheckVerb = cli_test::Program;

json finding_of(const json& report, const std::string& rule, const std::string& quantity) {
  for (const json& f : report["findings"])
    if (f["rule"] == rule && f["quantity"] == quantity) return f;
  return {};
}

/// A recorded motion of so many rows, and a spec that plays it.
void write_recording(const std::filesystem::path& folder, const std::string& name, int rows) {
  std::ofstream points(folder / (name + ".csv"));
  points << "time [s],position [mm],velocity [mm/s]\n";
  for (int i = 0; i < rows; ++i) {
    const double t = 1e-3 * i;
    std::array<char, 80> row{};
    std::snprintf(row.data(), row.size(), "%.3f,%.9f,%.9f\n", t, 10 * std::sin(t),
                  10 * std::cos(t));
    points << row.data();
  }
  std::ofstream(folder / (name + ".toml"))
      << "jounce = 1\nkind = \"pvt\"\noutside = \"refuse\"\n"
         "units = { position = \"mm\", time = \"s\" }\npoints = \"" +
             name + ".csv\"\n[limits]\nvelocity = 11\n";
}

// By closed forms: at X = 0.5 * 0 + 30 = 0.4 of the first segment the quintic is at 23.68, with slope 1.792.
// So the slave rests 2 * 23.68 - 7 = 40.36 from its place, which moves on at 2 * 0.5 * 1.792 * 200 = 358.4,
// and the correction turns round by 5000.
TEST_F(CheckVerb, StatesTheRampOfAScaledCoupling) {
  write("cam.toml", slurp(cam) +
                        "\n[coupling]\nstart = \"ramp_in\"\nvelocity_diff = 150\n"
                        "acceleration = 5000\nmaster_scaling = 0.5\nmaster_offset = 30\n"
                        "slave_scaling = 2\nslave_offset = -7\n");
  const json report =
      json::parse(run("check cam.toml --json --slave 0 --master 0 --master-velocity 200").out);
  const auto peak = [&](const char* quantity) {
    return std::abs(finding_of(report, "coupling/ramp", quantity)["value"].get<double>());
  };
  EXPECT_NEAR(peak("position"), 40.36 + 358.4 * 358.4 / 2 / 5000, 1e-9);
  EXPECT_NEAR(peak("velocity"), 358.4, 1e-9);
  EXPECT_NEAR(peak("acceleration"), 5000, 1e-6);
}

TEST_F(CheckVerb, ReportsAnEndWithAVelocity) {
  const Result gear = run("check " + examples + "pmc600-gear-in-pos/gear.toml");
  EXPECT_THAT(gear.out, HasSubstr("coupling/end"));
  EXPECT_THAT(
      gear.out,
      HasSubstr("at the master velocity 10000 pulse/s, the slave moves at 5000 pulse/s "
                "there; with a live master, the slave stays in gear after the end of its table"));
  const std::string once =
      "jounce = 1\nkind = \"cam\"\nunits = { master = \"deg\", position = \"mm\" }\n"
      "start = { master = 0, slave = 0 }\n[[segment]]\nlaw = \"quintic\"\n"
      "end = { master = 90, slave = 40, geo_velocity = 0.5, geo_acceleration = 0 }\n"
      "[master]\nvelocity = 180\ndistance = 90\n";
  write("once.toml", once);
  const Result cam_once = run("check once.toml");
  EXPECT_EQ(cam_once.status, 0) << "the axis brakes there";
  EXPECT_THAT(cam_once.out, Not(HasSubstr("BROKEN"))) << "one finding";
  EXPECT_THAT(cam_once.out,
              HasSubstr("at the master velocity 180 deg/s, the slave moves at 90 mm/s there; "
                        "with a live master, the slave brakes there"));
  EXPECT_THAT(cam_once.out, HasSubstr("warn   coupling/end"));
  write("scaled.toml", once + "[coupling]\nstart = \"absolute\"\nslave_scaling = 2\n");
  EXPECT_THAT(run("check scaled.toml").out, HasSubstr("the slave moves at 180 mm/s there"));
  EXPECT_THAT(run("check scaled.toml --master-velocity 90").out,
              HasSubstr("at the master velocity 90 deg/s, the slave moves at 90 mm/s there"));
  write("open.toml",
        "jounce = 1\nkind = \"follow\"\nunits = { master = \"pulse\", position = "
        "\"pulse\" }\nsegment = [{ master = 20000, slave = 10000 }]\n"
        "[master]\nvelocity = 50000\ndistance = 20000\n");
  const Result open = run("check open.toml");
  EXPECT_EQ(open.status, 1);
  EXPECT_THAT(open.out, HasSubstr("the slave moves at 50000 pulse/s there; the controller stops"));
  EXPECT_THAT(run("check " + cam).out, Not(HasSubstr("coupling/end"))) << "it repeats";
}

TEST_F(CheckVerb, JudgesACouplingFromTheGivenState) {
  const std::string line = slurp(cam) + "\n[coupling]\nstart = \"absolute\"\n";
  std::ofstream(folder / "cam.toml") << line;
  const Result rest = run("check cam.toml --json");
  const json before = json::parse(rest.out);
  const auto broken_start = [](const json& report) {
    for (const json& f : report["findings"])
      if (f["rule"] == "coupling/start" && f["quantity"] == "position") return f;
    return json();
  };
  EXPECT_FALSE(broken_start(before)["broken"].get<bool>());
  const json moved = json::parse(run("check cam.toml --json --slave 12.5 --master 0").out);
  EXPECT_TRUE(broken_start(moved)["broken"].get<bool>());
  EXPECT_NEAR(std::abs(broken_start(moved)["value"].get<double>()), 12.5, 1e-9);
  EXPECT_TRUE(broken_start(moved)["limit"].is_null());
  const Result refused = run("check " + cam + " --slave 12.5");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("--slave = 12.5: applies to a spec with [coupling]"));
}

TEST_F(CheckVerb, ReportsAnExcessiveAccelerationOfTheMaster) {
  const std::string gear = R"(jounce = 1
kind = "gear"
units = { position = "mm", master = "mm" }
gear = { numerator = 5, master_period = 100 }
limits = { slave = { acceleration = 5000 } }
)";
  write("fast.toml", gear + "master = { velocity = 500, distance = 100, acceleration = 2000 }\n");
  const Result fast = run("check fast.toml");
  EXPECT_EQ(fast.status, 1);
  EXPECT_THAT(fast.out, HasSubstr("master_acceleration 2000 mm/s^2"));
  EXPECT_THAT(fast.out, HasSubstr("lower acceleration in [master] to at most 1000"));
  EXPECT_THAT(fast.out, HasSubstr("fastest acceleration of the master 1000 mm/s^2"));
  EXPECT_THAT(fast.out, Not(HasSubstr("slow the master down")));
  const auto passing = [](const std::string& velocity, const std::string& acceleration) {
    return R"(jounce = 1
kind = "follow"
units = { position = "mm", master = "mm" }
follow = {}
zone = [{ from = 100, to = 200, ratio = 5, slave = 250 }]
point = [{ master = 300, slave = 1000 }]
limits = { slave = { acceleration = 5000 } }
master = { distance = 300, velocity = )" +
           velocity + ", acceleration = " + acceleration + " }\n";
  };
  write("both.toml", passing("500", "2000"));
  EXPECT_THAT(run("check both.toml").out,
              HasSubstr("at most 500 mm/s^2, and velocity to at most 216.345 mm/s"));
  write("advised.toml", passing("216.345", "500"));
  EXPECT_THAT(run("check advised.toml").out, Not(HasSubstr("BROKEN limit/")));
  write("good.toml", gear + "master = { velocity = 500, distance = 100, acceleration = 1000 }\n");
  EXPECT_EQ(run("check good.toml").status, 0);
}

TEST_F(CheckVerb, FindsWhereThePmc600CamBreaksItsLimits) {
  const Result check = run("check --json " + cam);
  EXPECT_EQ(check.status, 1);
  const json report = json::parse(check.out);
  EXPECT_FALSE(report["ok"].get<bool>());
  const auto& worst = report["findings"][0];
  EXPECT_EQ(worst["rule"], "limit/geo_velocity");
  EXPECT_EQ(worst["segment"], 3);
  EXPECT_NEAR(worst["value"].get<double>(), -3.392270802, 1e-9);
  EXPECT_NEAR(worst["where"].get<double>(), 241.8976648927, 1e-9);
  EXPECT_NEAR(report["segments"][0]["geo_velocity"]["max"]["value"].get<double>(), 2.107392, 1e-12);
}

TEST_F(CheckVerb, FindsTheOvershootOfTheHmplExample) {
  const Result check = run("check --json " + examples + "hmpl-pvt/pvt.toml");
  EXPECT_EQ(check.status, 1);
  const json report = json::parse(check.out);
  int outside = 0;
  for (const auto& finding : report["findings"]) outside += finding["broken"].get<bool>() ? 1 : 0;
  EXPECT_EQ(outside, 6);
  EXPECT_NEAR(report["findings"][0]["value"].get<double>(), 596.1, 0.05);
  EXPECT_THAT(run("check " + examples + "hmpl-pvt/pvt.toml").out,
              HasSubstr("position -188.701 mm at 1.2126 s (segment 1)"));
}

TEST_F(CheckVerb, LimitsFromTheCommandLineTakeUnits) {
  EXPECT_EQ(run("check " + cam + " --limit geo_velocity=4 --limit geo_acceleration=0.2").status, 0);
  const Result wrong = run("check " + cam + " --limit geo_velocity='4 mm'");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.err,
              HasSubstr("mm is not a unit of this quantity: give the value in pulse/pulse"));
  EXPECT_EQ(run("check " + cam + " --limit velocity=4 --master-velocity 1000").status, 1);
  EXPECT_EQ(run("check " + cam + " --limit velocty=4").status, 2);
  EXPECT_EQ(run("check " + cam + " --limit geo_velocity=nan").status, 2);
}

TEST_F(CheckVerb, ComparesATableWithItsSpec) {
  EXPECT_EQ(run("new cam -o feeder.toml").status, 0);
  EXPECT_EQ(run("design feeder.toml -o feeder.csv").status, 0);
  EXPECT_EQ(run("convert feeder.toml feeder.st").status, 0);
  EXPECT_EQ(run("check feeder.csv feeder.st --against feeder.toml --strict").status, 0);
  const std::string spec = slurp(folder / "feeder.toml");
  write("feeder.toml", spec + "# another text\n");
  for (const char* verb : {"check", "validate"}) {
    const Result older = run(std::string(verb) + " . --strict");
    EXPECT_EQ(older.status, 1) << verb;
    EXPECT_THAT(older.out, HasSubstr("feeder.toml has changed since the table was made"));
    EXPECT_THAT(older.out, HasSubstr("`jounce design feeder.toml -o feeder.csv`"));
  }
  EXPECT_EQ(run("check feeder.csv --against feeder.toml --strict").status, 0);
  EXPECT_EQ(run("check feeder.csv --tolerance 1e-3").err,
            "jounce: --tolerance = 1e-3: needs --baseline or --against: add one, or leave out "
            "--tolerance\n");
  EXPECT_EQ(run("check feeder.csv --against feeder.csv").status, 2);
}

TEST_F(CheckVerb, NamesTheQuantitiesWithoutALimit) {
  const Result better = run("optimize " + cam + " -o better.toml");
  ASSERT_EQ(better.status, 0) << better.err;
  const Result checked = run("check better.toml");
  EXPECT_THAT(checked.out, HasSubstr("all limits hold; the closest: "));
  EXPECT_THAT(checked.out, HasSubstr("; not limited: geo_jerk (up to "));
  EXPECT_THAT(run("design better.toml -o better.csv").out,
              HasSubstr("\nnot limited: geo_jerk (up to "));
  const json design = json::parse(run("design --json better.toml -o better.csv").out);
  EXPECT_EQ(design["not_limited"][0]["quantity"], "geo_jerk");
  const json report = json::parse(run("check --json better.toml").out);
  std::size_t notes = 0;
  for (const json& f : report["findings"]) notes += f["rule"] == "unlimited/geo_jerk" ? 1 : 0;
  EXPECT_EQ(notes, 1U);
  EXPECT_THAT(run("check better.toml --limit geo_jerk=1").out, Not(HasSubstr("not limited")));
  ASSERT_EQ(run("report better.toml -o better.html").status, 0);
  EXPECT_THAT(slurp(folder / "better.html"), HasSubstr("not limited"));
}

TEST_F(CheckVerb, JudgesTheTorqueOfALoad) {
  std::string text = slurp(examples + "pusher-torque/cam.toml");
  const auto load = text.find("[limits]");
  ASSERT_NE(load, std::string::npos);
  text.insert(load, "[load.limits]\ntorque = 0.5\n\n");
  write("pusher.toml", text);
  const Result result = run("check pusher.toml");
  EXPECT_EQ(result.status, 1) << result.out;
  EXPECT_THAT(result.out, HasSubstr("BROKEN limit/load_torque"));
  EXPECT_THAT(result.out, HasSubstr(" N m at "));
}

TEST_F(CheckVerb, NamesTheErrorWithWhichHimcRejectsATable) {
  write("pvt.toml",
        "jounce = 1\nkind = \"pvt\"\ncontroller = \"himc\"\nunits = { position = \"mm\", time = "
        "\"s\" }\n"
        "knot = [{time = 0, position = 0, velocity = 0}, {time = 1, position = 10, velocity = 0}]\n"
        "[limits]\nvelocity = 12\nacceleration = 50\n");
  const Result result = run("check pvt.toml");
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.out, HasSubstr("MovePVT refuses the table: HIMC error 0x83aa08a2"));
  EXPECT_THAT(result.out, HasSubstr("MovePVT refuses the table: HIMC error 0x83aa08ac"));
}

TEST_F(CheckVerb, RejectsAnEnergyAsAUnitOfPosition) {
  ASSERT_EQ(run("new move -o move.toml").status, 0);
  std::string text = slurp(folder / "move.toml");
  const auto at = text.find("position = \"");
  text.replace(at, text.find('"', at + 12) + 1 - at, "position = \"J\"");
  write("move.toml", text);
  EXPECT_THAT(run("check move.toml").err,
              HasSubstr("units.position = \"J\": is not a unit of position"));
}

TEST_F(CheckVerb, CheckAndValidateIncludeEveryAxis) {
  const Result text = run("check " + via);
  EXPECT_EQ(text.status, 0);
  EXPECT_THAT(text.out, StartsWith("via points x: all limits hold"));
  EXPECT_THAT(text.out, HasSubstr("\nvia points y: all limits hold"));
  const json all = json::parse(run("check --json " + via).out);
  EXPECT_TRUE(all["ok"].get<bool>());
  EXPECT_EQ(all["axes"]["x"]["segments"].size(), 19U);
  EXPECT_TRUE(all["axes"]["y"]["ok"].get<bool>());
  const json x = json::parse(run("check --axis x --json " + via).out);
  EXPECT_EQ(x, all["axes"]["x"]);
  EXPECT_TRUE(json::parse(run("validate --json " + via).out)["axes"]["y"]["ok"].get<bool>());

  std::string spec = slurp(via);
  spec.replace(spec.rfind("limits = { velocity = 1000"), 26, "limits = { velocity = 900");
  write("tight.toml", spec);
  EXPECT_EQ(run("check tight.toml").status, 1) << "y alone is over its limit";
  EXPECT_EQ(run("check tight.toml --axis x").status, 0);
  EXPECT_FALSE(json::parse(run("check tight.toml --json").out)["ok"].get<bool>());
}

TEST_F(CheckVerb, IgnoresTheRoundingOfKnots) {
  // The shortest phases of this motion last 3.5 us, at 2000 mm: there the jerk of a table of doubles
  // is off by more than the limit itself, the curve's is not.
  EXPECT_EQ(run("check " + via).status, 0);
  // A limit that the table breaks by more is still found.
  write("coarse.toml",
        "jounce = 1\nkind = \"move\"\nunits = { position = \"mm\" }\n[move]\n"
        "profile = \"s_curve\"\nto = 300\nvelocity = 400\nacceleration = 2000\njerk = 20000\n"
        "[limits]\njerk = 20000\n[table]\nrule = \"cubic_hermite\"\nintervals = 10\n");
  const Result coarse = run("check coarse.toml");
  EXPECT_EQ(coarse.status, 1);
  EXPECT_THAT(coarse.out, HasSubstr("table"));
}

TEST_F(CheckVerb, RejectsPointsWithoutASpec) {
  write("p.csv", "time [s];position [mm]\n0;0\n1;2,5\n");
  for (const char* command : {"convert p.csv x.csv", "check p.csv"}) {
    const Result refused = run(command);
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("has points only, without the header of a Jounce table"));
    EXPECT_THAT(refused.err, HasSubstr("points = \"p.csv\""));
  }
}

TEST_F(CheckVerb, StatesCharacteristicValuesAndTheFastestMaster) {
  const std::string text = R"(jounce = 1
kind = "cam"
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }
segment = [{ law = "345", end = { master = 120, slave = 50 } }]
limits = { slave = { velocity = 400, acceleration = 6000 } }
)";
  write("cam.toml", text);
  const Result good = run("check cam.toml");
  EXPECT_EQ(good.status, 0) << good.out << good.err;
  EXPECT_THAT(good.out, HasSubstr("rise 0 .. 120 deg    velocity Cv 1.875, acceleration Ca 5.7735, "
                                  "jerk Cj 60, torque Cm 6.6943; with this Cj, Ca can be as low as "
                                  "4.753"));
  EXPECT_THAT(good.out,
              HasSubstr("fastest master 512 deg/s, limited by the slave's velocity at 60 deg"));
  EXPECT_THAT(good.out, Not(HasSubstr("bound/"))) << "certificates are for --json";

  write("fast.toml", text + "master = { velocity = 600, distance = 120 }\n");
  const Result fast = run("check fast.toml --json");
  EXPECT_EQ(fast.status, 1);
  const json document = json::parse(fast.out);
  EXPECT_NEAR(document["cam"]["fastest_master"]["value"].get<double>(), 512, 1e-9);
  EXPECT_NEAR(document["cam"]["rises"][0]["cv"]["value"].get<double>(), 1.875, 1e-12);
  EXPECT_EQ(document["findings"][0]["rule"], "limit/acceleration") << "the worst first";
  EXPECT_TRUE(std::any_of(document["findings"].begin(), document["findings"].end(),
                          [](const json& f) { return f["rule"] == "limit/master_velocity"; }));
  bool certified = false;
  for (const json& f : document["findings"])
    certified = certified || f["rule"] == "bound/acceleration_for_jerk";
  EXPECT_TRUE(certified);
}

TEST_F(CheckVerb, WarnsAboutTheDefaultCamOfCodesys) {
  write("cam.toml", R"(jounce = 1
kind = "cam"
units = { master = "deg", position = "deg" }
start = { master = 0, slave = 0 }
[[segment]]
law = "quintic"
end = { master = 120, slave = 120, geo_velocity = 1 }
[[segment]]
law = "quintic"
end = { master = 240, slave = 240, geo_velocity = 1 }
[[segment]]
law = "quintic"
end = { master = 360, slave = 360 }
[limits]
geo_velocity = 2
)");
  const Result result = run("check cam.toml");
  EXPECT_EQ(result.status, 0) << "a warning fails nothing";
  EXPECT_THAT(result.out, HasSubstr("(2 warnings)"));
  EXPECT_THAT(result.out,
              HasSubstr("warn   warning/velocity_overshoot geo_velocity 1.512 deg/deg"));
  EXPECT_THAT(result.out, HasSubstr("use a length from 200 deg to 300 deg"));
}

#ifndef __SANITIZE_ADDRESS__  // its allocator needs more memory
TEST_F(CheckVerb, NeedsLittleMemoryForARecording) {
  const auto peak = [&](const std::string& file) {  // KiB, the most of all children so far
    EXPECT_EQ(run("check " + file + " > out.txt").status, 0) << slurp(folder / "out.txt");
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return static_cast<double>(usage.ru_maxrss);
  };
  constexpr int few = 100000, many = 500000;
  write_recording(folder, "few", few);
  write_recording(folder, "many", many);
  const double of_few = peak("few.toml");
  EXPECT_LT(1024 * (peak("many.toml") - of_few) / (many - few), 120) << "bytes a row";
}
#endif

}  // namespace
}  // namespace jounce::check_verb_test
