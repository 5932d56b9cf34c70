// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace jounce::convert_verb_test {
namespace {

using cli_test::cam;
using cli_test::examples;
using cli_test::Result;
using cli_test::slurp;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

using ConvertVerb = cli_test::Program;

TEST_F(ConvertVerb, RejectsAToleranceBelowTheRounding) {
  const std::string convert = "convert " + cam + " out.csv ";
  EXPECT_EQ(run(convert + "--tolerance 1e-30").err,
            "jounce: --tolerance = 1e-30 pulse: must be at least 5.55948e-12 pulse: rounding hides "
            "smaller errors\n");
  EXPECT_THAT(run(convert + "--velocity-tolerance 1e-30").err,
              HasSubstr("--velocity-tolerance = 1e-30 pulse/pulse: must be at least "));
  EXPECT_EQ(run(convert + "--tolerance -1").err,
            "jounce: --tolerance = -1: must be greater than 0\n");
  EXPECT_TRUE(files().empty());
  EXPECT_EQ(run(convert + "--tolerance 5.559478149432e-12").status, 0);
}

TEST_F(ConvertVerb, NamesTheOptionOfAWrongUnit) {
  ASSERT_EQ(run("design " + cam + " -o given.csv").status, 1);
  EXPECT_EQ(run("convert given.csv out.csv --master-unit J").err,
            "jounce: --master-unit = J: cannot be converted from the unit of the table, pulse\n");
  EXPECT_EQ(run("convert given.csv out.csv --position-unit wibble").err,
            "jounce: --position-unit = wibble: is not a known unit: give a length (mm m um nm cm "
            "in ft yd), an "
            "angle (rad deg rev), a time (s ms us ns min h), or pulse, count or inc\n");
  EXPECT_EQ(run("convert given.csv given.csv").err,
            "jounce: OUT = given.csv: is also the input: choose another name\n");
}

TEST_F(ConvertVerb, ConvertsThereAndBackWithoutLoss) {
  EXPECT_EQ(run("design " + cam + " -o a.csv").status, 1);
  EXPECT_EQ(run("convert a.csv a.xyva").status, 0);
  EXPECT_EQ(run("convert a.xyva a.st").status, 0);
  EXPECT_EQ(run("convert a.st b.csv").status, 0);
  const auto hash = [&](const char* file) {
    const std::string text = slurp(folder / file);
    return text.substr(text.find("# sha256: "), 74);
  };
  EXPECT_EQ(hash("a.csv"), hash("b.csv"));
  EXPECT_EQ(run("diff a.csv a.st").status, 0);
  EXPECT_EQ(run("plot a.xyva -o a.svg").status, 0);
}

TEST_F(ConvertVerb, StatesItsLoss) {
  EXPECT_EQ(run("new cam -o a.toml").status, 0);
  const Result pairs = run("convert a.toml a.txt --intervals 360 --json");
  EXPECT_EQ(pairs.status, 0) << pairs.err;
  const json summary = json::parse(pairs.out);
  EXPECT_FALSE(summary["lossless"].get<bool>());
  EXPECT_NEAR(summary["error"].get<double>(), 0.0024, 1e-4);  // h^2 max|f''| / 8 = 0.0191943 / 8
  const Result coarse = run("convert a.toml c.txt --intervals 6");
  EXPECT_EQ(coarse.status, 1);
  EXPECT_THAT(coarse.out, HasSubstr("nothing was written: give more --intervals"));
  EXPECT_FALSE(std::filesystem::exists(folder / "c.txt"));
  EXPECT_EQ(run("convert a.toml c.txt --intervals 6 --allow-loss").status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "c.txt"));
  EXPECT_EQ(run("convert a.toml d.txt").status, 0) << "the knots follow from the tolerance";
  EXPECT_EQ(
      run("convert a.toml c.bas").err,
      "jounce: --position-resolution: is missing: the format trio has the position in counts. "
      "Give the size of one count, such as 0.001mm\n");
  const std::string both = run("convert a.toml c.dmc").err;
  EXPECT_THAT(both, HasSubstr("jounce: --resolution: is missing"));
  EXPECT_THAT(both, HasSubstr("\njounce: --position-resolution: is missing"));
  EXPECT_EQ(run("convert a.toml c.bas --position-resolution 1um").status, 0);
  EXPECT_THAT(run("convert a.toml c.csv --tolerance 1 um").err,
              HasSubstr("`1 um` is one value: write it without a space"));
  EXPECT_THAT(run("convert a.toml e.csv --most 5 --tolerance 1um").err,
              HasSubstr("--most = 5: must be at least "));
  EXPECT_EQ(run("convert a.toml b.xyva --tolerance 0.1um").status, 0);
  const Result close = run("diff a.toml b.xyva --tolerance position=0.1um");
  EXPECT_EQ(close.status, 0) << close.out;
}

TEST_F(ConvertVerb, NamesTheKeysThatAreLost) {
  write("c.toml", slurp(cam) +
                      "\n[coupling]\nstart = \"absolute\"\n[[switch]]\ntrack = 1\n"
                      "first_on_position = 25\nlast_on_position = 40\n");
  EXPECT_THAT(run("convert c.toml c.st").out,
              HasSubstr("laws, limits, the coupling and 1 cam switch stay in the spec"));
  EXPECT_THAT(run("convert " + cam + " c.st").out, HasSubstr("laws and limits stay in the spec"));
  write("t.st",
        "E_A : ARRAY[0..1] OF SMC_CAMXYVA := [(dX := 0), (dX := 360, dY := 40)];\n"
        "E : MC_CAM_REF := (nTappets := 3, pce := ADR(E_A));\n");
  EXPECT_THAT(run("convert t.st t.xyva").out, HasSubstr("3 tappets of E are not read"));
}

// KAS joins points of the type SPLINE by curves: the error is theirs, and CYCLIC is in the file.
TEST_F(ConvertVerb, JudgesSplinesAsSplines) {
  EXPECT_EQ(run("new cam -o a.toml").status, 0);
  const json lines = json::parse(run("convert a.toml a.txt --intervals 360 --json").out);
  const Result made = run("convert a.toml a.csv --to kollmorgen --intervals 360 --json");
  const json splines = json::parse(made.out);
  EXPECT_LT(splines["error"].get<double>(), lines["error"].get<double>() / 100);
  EXPECT_THAT(slurp(folder / "a.csv"), StartsWith("CYCLIC;YES;"));
  EXPECT_THAT(splines["losses"].dump(), HasSubstr("cubic spline"));
  EXPECT_THAT(splines["losses"].dump(), Not(HasSubstr("that the cam repeats")));
  EXPECT_THAT(lines["losses"].dump(), HasSubstr("that the cam repeats"));
  const json knots =
      json::parse(run("convert a.toml b.csv --to kollmorgen --intervals 6 --json").out);
  EXPECT_GT(knots["error"].get<double>(), 1e3 * splines["error"].get<double>());
}

TEST_F(ConvertVerb, ReadsOneCamOfSeveral) {
  for (const char* name : {"A", "B"}) {
    EXPECT_EQ(run("design " + cam + " -o " + name + ".csv").status, 1);
    EXPECT_EQ(run(std::string("convert ") + name + ".csv " + name + ".st").status, 0);
  }
  std::string both = slurp(folder / "A.st") + slurp(folder / "B.st");
  both.replace(both.rfind("  Cam : "), 7, "  Other :");
  write("both.st", both);
  const Result asked = run("convert both.st c.xyva");
  EXPECT_EQ(asked.status, 2);
  EXPECT_EQ(asked.err,
            "jounce: --axis: is missing: both.st has several axes. Choose one of Cam, Other\n");
  write("same.st", slurp(folder / "A.st") + slurp(folder / "B.st"));
  EXPECT_EQ(run("convert same.st c.xyva --axis Cam").err,
            "jounce: --axis = Cam: is the name of 2 cams in same.st: rename one of them\n");
  EXPECT_EQ(run("convert both.st c.xyva --axis Other").status, 0);
  EXPECT_EQ(run("diff c.xyva A.csv").status, 0);
  EXPECT_EQ(run("check both.st").status, 0);
  EXPECT_EQ(run("plot both.st -o both.svg").status, 0);
}

// Input for a controller: whole ms, no step of the velocity, and the same motion when it is read
// again.
TEST_F(ConvertVerb, WritesTheSegmentsOfAController) {
  write("m.toml",
        "jounce = 1\nkind = \"move\"\nunits = { position = \"pulse\", time = \"ms\" }\n[move]\n"
        "profile = \"s_curve\"\nto = 20000\nvelocity = 50\nacceleration = 0.25\njerk = 0.002\n");
  const Result even =
      run("convert m.toml even.csv --rule linear --most 33 --resolution 1ms --json");
  const Result made = run("convert m.toml p.csv --to points --controller googol_pt --json");
  ASSERT_EQ(made.status, 0) << made.err;
  const double error = json::parse(made.out)["error"].get<double>();
  EXPECT_LT(10 * error, json::parse(even.out)["error"].get<double>());
  const std::string points = slurp(folder / "p.csv");
  EXPECT_THAT(points, StartsWith("time [ms],position [pulse],type\n"));
  EXPECT_LE(std::count(points.begin(), points.end(), '\n'), 33);
  EXPECT_THAT(points, HasSubstr(",20000,normal\n"));
  write("p.toml",
        "jounce = 1\nkind = \"pt\"\nunits = { position = \"pulse\", time = \"ms\" }\n"
        "points = \"p.csv\"\n[pt]\ncontroller = \"googol\"\n");
  const Result played = run("check p.toml --continuity 1");
  EXPECT_EQ(played.status, 0) << played.out << played.err;
  EXPECT_THAT(played.out, Not(HasSubstr("pt/velocity_step")));
  EXPECT_EQ(run("diff p.toml m.toml --tolerance position=" + std::to_string(1.01 * error) + "pulse")
                .status,
            0);
  EXPECT_EQ(run("convert p.csv x.csv --controller googol_pt").status, 2);
  const Result refused =
      run("convert m.toml q.csv --controller googol_pt --position-resolution 1pulse");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err,
              HasSubstr("--position-resolution = 1 pulse: cannot be used with quadratic pieces"));
  EXPECT_THAT(run("convert m.toml q.csv --to points --rule cubic_hermite").err,
              HasSubstr("needs a constant acceleration between the knots; before knot 2"));
}

// A law that begins at rest has 1.9e-16 there: its first segment was "continue", which takes over a ratio.
TEST_F(ConvertVerb, TakesRoundingForRest) {
  write("f.toml",
        "jounce = 1\nkind = \"cam\"\nunits = { master = \"pulse\", position = \"pulse\" }\n"
        "start = { master = 0, slave = 0 }\n"
        "segment = [{ law = \"simple_sine\", end = { master = 10000, slave = 20000 } }]\n");
  ASSERT_EQ(run("convert f.toml f.csv --to points --controller googol_follow").status, 0);
  const std::string points = slurp(folder / "f.csv");
  EXPECT_THAT(points, StartsWith("master [pulse],slave [pulse],type\n"));
  EXPECT_THAT(points, Not(HasSubstr("continue")));
  EXPECT_EQ(std::count(points.begin(), points.end(), '\n'), 17);
}

TEST_F(ConvertVerb, AsksForTheSizeOfAPulse) {
  EXPECT_EQ(run("new cam -o a.toml").status, 0);  // deg and mm
  const Result position = run("convert a.toml a.csv --most 32 --position-resolution 1pulse");
  EXPECT_EQ(position.status, 2);
  EXPECT_THAT(position.err, HasSubstr("give the size of a pulse, such as --position-resolution "
                                      "\"0.001 mm\""));
  const Result controller = run("convert a.toml a.csv --controller googol_follow");
  EXPECT_EQ(controller.status, 2);
  EXPECT_THAT(controller.err, HasSubstr("give the size of one count with --resolution"));
  EXPECT_EQ(run("convert a.toml a.csv --controller googol_follow --resolution 0.01deg").status, 0);
}

// A cam goes to a controller that counts and comes back: both files have the same motion. The master of Trio is in
// its user units.
TEST_F(ConvertVerb, ReadsCountsWithTheirSize) {
  EXPECT_EQ(run("new cam -o a.toml").status, 0);  // deg and mm
  const std::string master = " --resolution 0.01deg", position = " --position-resolution 1um";
  for (const std::string file : {"a.dmc", "a.bas", "a.c --to googol-follow"}) {
    SCOPED_TRACE(file);
    const std::string name = file.substr(0, file.find(' '));
    const bool trio = name == "a.bas";
    ASSERT_EQ(run("convert a.toml " + file + (trio ? "" : master) + position + " --tolerance 20um")
                  .status,
              0);
    const std::string sizes =
        (trio ? "" : master) + position + " --master-unit deg --position-unit mm --periodic";
    const Result read = run("convert " + name + " b.csv" + sizes);
    ASSERT_EQ(read.status, 0) << read.err;
    EXPECT_THAT(read.out, HasSubstr("0.001 mm (position)"));
    const Result same = run("diff a.toml b.csv --tolerance position=20.5um");
    EXPECT_EQ(same.status, 0) << same.out << same.err;
    const Result codesys = run("convert " + name + " c.st" + sizes);
    EXPECT_EQ(codesys.status, 0) << codesys.out << codesys.err;
    EXPECT_THAT(slurp(folder / "c.st"), HasSubstr("dX := 360"));
  }
  EXPECT_THAT(run("convert a.dmc b.csv --master-unit deg").err,
              HasSubstr("from the unit of the table, count; for a table from a file, give the size "
                        "of one count, such as --resolution 0.01deg"));
}

// 57 counts of 0.01 deg are 0.57 deg, without a rounding error of the product.
TEST_F(ConvertVerb, GivesCountsTheUnitOfTheirSize) {
  write("a.dmc", "EAA\nEM 36000,0\nEP 18000,0\nET[0]=,0\nET[1]=,57\nET[2]=,0\n");
  const Result made = run("convert a.dmc a.csv --resolution 0.01deg --position-resolution 1um");
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.out,
              HasSubstr("in the input, 1 count is 0.01 deg (master) and 1 um (position)"));
  EXPECT_THAT(slurp(folder / "a.csv"), HasSubstr("\n180,57\n"));
  ASSERT_EQ(run("convert a.dmc m.csv --position-resolution 1um --position-unit mm").status, 0);
  EXPECT_THAT(slurp(folder / "m.csv"), HasSubstr("\n18000,0.057\n"));
  ASSERT_EQ(run("convert a.dmc a.bas --resolution 0.01deg --position-resolution 1um").status, 0);
  EXPECT_THAT(slurp(folder / "a.bas"), HasSubstr("TABLE(1000,0,57,0)"));
  EXPECT_THAT(run("convert a.dmc b.csv --position-resolution -1um").err,
              HasSubstr("--position-resolution = -1um: must be greater than 0"));
  EXPECT_THAT(run("convert a.dmc b.csv --resolution 1um --master-unit deg").err,
              HasSubstr("--resolution = 1um: "));
}

TEST_F(ConvertVerb, AsksForMissingUnits) {
  write("a.xyva", "0 0 0 0\n180 90 0 0\n360 0 0 0\n");
  const Result refused = run("convert a.xyva a.csv");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("--master-unit"));
  EXPECT_EQ(run("design a.xyva -o a.csv").status, 2) << "what it wrote could not be read";
  EXPECT_EQ(run("convert a.xyva a.csv --master-unit deg --position-unit mm --periodic").status, 0);
  EXPECT_THAT(slurp(folder / "a.csv"), HasSubstr("# outside: wrap"));
  const std::string rotary = examples + "codesys-default/cam.xyva";
  EXPECT_EQ(
      run("convert " + rotary + " r.csv --master-unit deg --position-unit deg --periodic").status,
      0);
  EXPECT_THAT(slurp(folder / "r.csv"), HasSubstr("# outside: advance"));
  EXPECT_EQ(run("convert a.csv b.csv --position-unit m").status, 0);
  EXPECT_THAT(slurp(folder / "b.csv"), HasSubstr("180,0.09,0,0"));
  write("comma.txt", "0;0\n1;0,5\n");
  EXPECT_EQ(run("check comma.txt").status, 2);
  EXPECT_EQ(
      run("convert comma.txt c.csv --decimal-comma --master-unit deg --position-unit mm").status,
      0);
}

}  // namespace
}  // namespace jounce::convert_verb_test
