// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace jounce::optimize_verb_test {
namespace {

using cli_test::cam;
using cli_test::examples;
using cli_test::Result;
using cli_test::slurp;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using OptimizeVerb = cli_test::Program;

/// A cam with one free shape between two dwells.
constexpr const char* free_cam = R"(jounce = 1
kind = "cam"
name = "lift"   # a comment
periodic = true
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }
[[segment]]
name = "up"
law = "4567"   # the law it was
free = { shape = 20 }
end = { master = 120, slave = 50 }
[[segment]]
law = "dwell"
end = { master = 200, slave = 50 }
[[segment]]
law = "4567"
end = { master = 320, slave = 0 }
[[segment]]
law = "dwell"
end = { master = 360, slave = 0 }
[master]
velocity = 360
distance = 360
[load]
position_per_rev = 100
inertia = "2 kg cm^2"
[limits]
geo_velocity = 0.92
[optimize]
minimize = ["peak torque"]
)";

/// The shell waits until the program catches the signal, then sends it.
TEST_F(OptimizeVerb, SigtermKeepsTheBestSoFarAsSigintDoes) {
  std::string spec = slurp(examples + "fastest-for-motor/move.toml");
  const std::string few = "max_evaluations = 600";
  const std::size_t at = spec.find(few);
  ASSERT_NE(at, std::string::npos);
  spec.replace(at, few.size(), "max_evaluations = 1000000\ntolerance = 1e-9");
  const std::string local = "search = \"local\"";
  spec.replace(spec.find(local), local.size(), "search = \"global\"");
  write("move.toml", spec);
  for (const char* signal : {"INT", "TERM"}) {
    // SigCgt, hexadecimal: bits 1 and 14 are SIGINT and SIGTERM
    const std::string script = JOUNCE_EXE
                               " optimize move.toml -o best.toml > out.txt 2>&1 & pid=$!; "
                               "for i in $(seq 3000); do kill -0 $pid || break; grep -Eq "
                               "'SigCgt:.*[4-7c-f]..[2367abef]$' /proc/$pid/status && break; "
                               "sleep 0.01; done; sleep 1; kill -" +
                               std::string(signal) + " $pid; wait $pid; echo status $?";
    std::filesystem::remove(folder / "best.toml");
    write("stop.sh", script);
    const std::string command = "cd " + folder.string() + " && bash stop.sh";
    std::FILE* pipe = popen(command.c_str(), "r");
    std::string out;
    std::array<char, 256> buffer{};
    while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe))
      out.append(buffer.data(), n);
    pclose(pipe);
    EXPECT_EQ(out, "status 0\n") << signal << ": " << slurp(folder / "out.txt");
    EXPECT_THAT(slurp(folder / "out.txt"), StartsWith("cancelled")) << signal;
    EXPECT_THAT(slurp(folder / "best.toml"), HasSubstr("kind = \"move\""));
  }
}

TEST_F(OptimizeVerb, RejectsOptionsBeforeTheSearch) {
  const std::string shapes = "optimize " + examples + "residual-17hz/cam.toml";
  EXPECT_EQ(run(shapes + " --plot x.pdf").err,
            "jounce: --plot = x.pdf: must end in .svg or .png\n");
  EXPECT_THAT(run(shapes + " --seconds nan").err, HasSubstr("--seconds = nan"));
  EXPECT_THAT(run("optimize " + cam + " --seconds 0").err, HasSubstr("must be greater than 0"));
  EXPECT_THAT(files(), ::testing::IsEmpty());
}

TEST_F(OptimizeVerb, DrawsParametersBeforeAndAfter) {
  const Result done = run("optimize " + examples + "shear-line-speed/shear.toml --plot both.svg");
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_THAT(slurp(folder / "both.svg"), HasSubstr("optimized"));
}

TEST_F(OptimizeVerb, AgainstADriveReportsIntegratedFigures) {
  const std::string against = examples + "against-drive/";
  const Result done = run("optimize " + against + "cam.toml --against " + against +
                          "drive.toml --json -o better.toml");
  ASSERT_EQ(done.status, 0) << done.err;
  const json drive = json::parse(done.out).at("drive");
  EXPECT_TRUE(drive.at("real"));
  EXPECT_EQ(drive.at("figures").at(0).at("figure"), "drive rms torque");
  EXPECT_LT(drive.at("figures").at(0).at("reached"),
            0.9 * drive.at("figures").at(0).at("given").get<double>());
  EXPECT_THAT(slurp(folder / "better.toml"), HasSubstr("hermite"));
}

TEST_F(OptimizeVerb, AgainstADriveWritesNothingIfACeilingCannotBeKept) {
  const std::string against = examples + "against-drive/";
  write("cam.toml", slurp(against + "cam.toml") +
                        "\n[[optimize.ceiling]]\nfigure = \"drive following error\"\n"
                        "at_most = 0.001\n");
  const Result done = run("optimize cam.toml --against " + against + "drive.toml -o better.toml");
  EXPECT_EQ(done.status, 1) << done.out;
  EXPECT_THAT(done.out, HasSubstr("drive following error"));
  EXPECT_EQ(files(), std::vector<std::string>{"cam.toml"});
}

TEST_F(OptimizeVerb, AgainstADriveRejectsASpecWithoutOne) {
  const std::string spec = examples + "against-drive/cam.toml";
  const Result none = run("optimize " + spec);
  EXPECT_EQ(none.status, 2);
  EXPECT_THAT(none.err, HasSubstr("--against drive.toml"));
  const Result cam_as_drive = run("optimize " + spec + " --against " + spec);
  EXPECT_EQ(cam_as_drive.status, 2);
  EXPECT_THAT(cam_as_drive.err, HasSubstr("drive: is missing"));
}

TEST_F(OptimizeVerb, WritesTheSameTextWithOtherNumbers) {
  const Result result = run("optimize --json " + cam + " -o better.toml --table better.csv");
  ASSERT_EQ(result.status, 0) << result.err;
  const json outcome = json::parse(result.out);
  EXPECT_TRUE(outcome["usable"].get<bool>());
  for (const auto& objective : outcome["objectives"]) {
    EXPECT_GE(objective["reached"].get<double>(), objective["bound"].get<double>() * (1 - 1e-12))
        << objective;
    EXPECT_LE(objective["reached"].get<double>(), objective["given"].get<double>()) << objective;
  }
  EXPECT_EQ(run("check better.toml").status, 0);
  EXPECT_EQ(run("check better.csv --limit geo_velocity=3 --limit geo_acceleration=0.15").status, 0);
  // The stretch in step, 75 to 200, is as it was.
  const std::string better = slurp(folder / "better.toml");
  EXPECT_THAT(
      better,
      HasSubstr("end = { master = 75, slave = 100, geo_velocity = 1, geo_acceleration = 0 }"));
  EXPECT_THAT(
      better,
      HasSubstr("end = { master = 200, slave = 225, geo_velocity = 1, geo_acceleration = 0 }"));
  EXPECT_THAT(better, HasSubstr("# pulse/s"));
}

TEST_F(OptimizeVerb, RejectsItsInputAsAnOutputBeforeTheSearch) {
  write("own.toml", slurp(cam));
  for (const char* option : {"-o", "--table", "--plot"}) {
    const Result result = run(std::string("optimize own.toml ") + option + " own.toml");
    EXPECT_EQ(result.status, 2) << option;
    EXPECT_EQ(result.out, "") << option;
  }
  EXPECT_THAT(run("optimize own.toml -o own.toml").err,
              HasSubstr("--output = own.toml: is also the input"));
  EXPECT_EQ(slurp(folder / "own.toml"), slurp(cam));
}

TEST_F(OptimizeVerb, ComparesThePeaksBeforeAndAfter) {
  const Result told = run("optimize " + cam + " -o better.toml");
  EXPECT_THAT(told.out, HasSubstr("peaks                           given    optimized"));
  EXPECT_THAT(told.out, HasSubstr("not limited   pulse/pulse^3"));
  const json outcome = json::parse(run("optimize --json " + cam).out);
  ASSERT_EQ(outcome["peaks"].size(), 3U);
  const json& jerk = outcome["peaks"][2];
  EXPECT_EQ(jerk["quantity"], "geo_jerk");
  EXPECT_TRUE(jerk["limit"].is_null());
  // The same numbers as `check` has of the given and of the optimized cam.
  const auto peak = [&](const std::string& file) {
    const json report = json::parse(run("check --json " + file).out);
    for (const json& f : report["findings"])
      if (f["rule"] == "unlimited/geo_jerk") return std::abs(f["value"].get<double>());
    return 0.0;
  };
  EXPECT_EQ(jerk["given"].get<double>(), peak(cam));
  EXPECT_EQ(jerk["optimized"].get<double>(), peak("better.toml"));
}

TEST_F(OptimizeVerb, ReportsAnInfeasibleLimitAndWritesNothing) {
  std::string text = slurp(cam);
  text.replace(text.find("geo_velocity = 3\n"), 17, "geo_velocity = 1\n");
  write("tight.toml", text);
  const Result result = run("optimize tight.toml -o out.toml --table out.csv");
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.out, StartsWith("infeasible"));
  EXPECT_THAT(result.out, HasSubstr("limit/geo_velocity"));
  EXPECT_EQ(files(), std::vector<std::string>{"tight.toml"});
}

TEST_F(OptimizeVerb, FindsAShapeThatDesignRepeats) {
  write("cam.toml", free_cam);
  const Result result =
      run("optimize --json cam.toml -o better.toml --table better.csv --plot better.svg");
  ASSERT_EQ(result.status, 0) << result.err << result.out;
  const json outcome = json::parse(result.out);
  EXPECT_TRUE(outcome["usable"].get<bool>());
  const json& figure = outcome["runs"][0]["figures"][0];
  EXPECT_EQ(figure["figure"], "peak torque");
  EXPECT_EQ(figure["unit"], "N m");
  EXPECT_LT(figure["reached"].get<double>(), 0.65 * figure["given"].get<double>());
  EXPECT_EQ(files(),
            (std::vector<std::string>{"better.csv", "better.svg", "better.toml", "cam.toml"}));
  const std::string better = slurp(folder / "better.toml");
  EXPECT_THAT(better, HasSubstr("name = \"lift\"   # a comment\n"));
  EXPECT_THAT(better, HasSubstr("law = \"hermite\"   # the law it was\n"));
  // The design from it has the promised peak: J a with a of the exact curve.
  const json check = json::parse(run("check --json better.toml").out);
  EXPECT_EQ(run("check better.toml").status, 0);
  const Result again = run("optimize --json better.toml");
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_NEAR(json::parse(again.out)["runs"][0]["figures"][0]["given"].get<double>(),
              figure["reached"].get<double>(), 1e-9 * figure["reached"].get<double>());
  EXPECT_THAT(slurp(folder / "better.svg"), HasSubstr("torque [N m]"));
}

TEST_F(OptimizeVerb, ReportsWhatLimitsAShape) {
  write("cam.toml", free_cam);
  const Result result = run("optimize cam.toml");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("peak torque"));
  EXPECT_THAT(result.out, HasSubstr("segments 1 up"));
  EXPECT_THAT(result.out, HasSubstr("peak torque is attained at "));
  EXPECT_EQ(files(), std::vector<std::string>{"cam.toml"});
}

TEST_F(OptimizeVerb, WritesNothingForAnImpossibleShape) {
  std::string text = free_cam;
  text.replace(text.find("0.92"), 4, "0.4 ");
  write("cam.toml", text);
  const Result result = run("optimize cam.toml -o better.toml --plot better.svg");
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.out, StartsWith("infeasible"));
  EXPECT_THAT(result.out, HasSubstr("geo_velocity"));
  EXPECT_EQ(files(), std::vector<std::string>{"cam.toml"});
}

TEST_F(OptimizeVerb, FindsNumbersOfAnySpec) {
  const std::string shear = examples + "shear-line-speed/shear.toml";
  const Result result = run("optimize --json " + shear + " -o faster.toml --table faster.csv");
  ASSERT_EQ(result.status, 0) << result.err;
  const json outcome = json::parse(result.out);
  EXPECT_EQ(outcome["status"], "converged");
  EXPECT_EQ(outcome["maximize"], "master velocity");
  EXPECT_NEAR(outcome["figures"][0]["reached"].get<double>(), 1019.76, 0.01);
  EXPECT_EQ(outcome["parameters"][0]["unit"], "m/min");
  EXPECT_EQ(run("check faster.toml").status, 0);
  EXPECT_EQ(run("check faster.csv").status, 0);
  const Result piped = run("optimize " + shear + " -o -");
  EXPECT_THAT(piped.out, HasSubstr("line_speed = \"61.18"));
  EXPECT_THAT(piped.err, StartsWith("converged"));
}

TEST_F(OptimizeVerb, WritesNothingIfNoNumbersKeepTheLimits) {
  std::string text = slurp(examples + "shear-line-speed/shear.toml");
  write("tight.toml", text + "\n[[optimize.require]]\nfigure = \"stroke\"\nat_most = 1\n");
  const Result result = run("optimize tight.toml -o out.toml --table out.csv");
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.out, StartsWith("infeasible"));
  EXPECT_EQ(files(), std::vector<std::string>{"tight.toml"});
  EXPECT_THAT(run("optimize tight.toml --seconds 0").err,
              HasSubstr("--seconds = 0: must be greater than 0"));
  EXPECT_EQ(run("optimize tight.toml --seconds nan").status, 2);
}

}  // namespace
}  // namespace jounce::optimize_verb_test
