// SPDX-License-Identifier: Apache-2.0
#include "jounce/study/tune.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "jounce/design/make.hpp"

#include "support/errors.hpp"

namespace jounce::tune_test {
namespace {

using std::numbers::pi;
using test::error_of;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using Status = OptimizeStatus;

std::string parameter(const std::string& key, const std::string& range) {
  return "[[optimize.parameter]]\nkey = \"" + key + "\"\nrange = [" + range + "]\n";
}

TuneOutcome tuned(const std::string& text) {
  return tune(parse_spec(text, "s.toml"));
}

/// The best, read back from the text that is written: it holds what was promised.
Assessment expect_held(const TuneOutcome& outcome) {
  EXPECT_TRUE(outcome.usable()) << outcome.search.reason;
  const Assessment again = assess(parse_spec(outcome.text, "better.toml"));
  EXPECT_TRUE(again.report.ok());
  EXPECT_EQ(again.value(outcome.figures.at(0).name), outcome.figures.at(0).reached);
  return again;
}

const std::string shear =
    "jounce = 1\nkind = \"shear\"\nunits = { position = \"mm\", master = \"mm\" }\n[shear]\n"
    "cut_length = 1000\nline_speed = \"40 m/min\"   # as today\nsync_time = 0.15\n"
    "[limits.slave]\nvelocity = 2000\nacceleration = 10000\n";

/// cams.md 5.2, solved for v with L given: ramps of 3-4-5 at the limit, x_a = (15/8) v^2/a, S = x_a +
/// v t_s, and L = 2 x_a + v t_s + max(Cv S v / v_max, v sqrt(Ca S / a_max)).
double least_length(double v, double time) {
  const double ramp = 15.0 / 8 * v * v / 10000;
  const double sync = v * time;
  const double stroke = ramp + sync;
  return 2 * ramp + sync +
         std::max(15.0 / 8 * stroke * v / 2000,
                  v * std::sqrt(10 / std::sqrt(3.0) * stroke / 10000));
}

double fastest_line(double length, double time) {
  double low = 0, high = 10000;
  for (int i = 0; i < 100; ++i)
    (least_length((low + high) / 2, time) > length ? high : low) = (low + high) / 2;
  return low;
}

TEST(Tune, RunsAShearsLineAsFastAsTheClosedForm) {
  const TuneOutcome outcome = tuned(shear + "[optimize]\nmaximize = \"master velocity\"\n" +
                                    parameter("shear.line_speed", "\"10 m/min\", \"200 m/min\""));
  (void)expect_held(outcome);
  const double fastest = fastest_line(1000, 0.15);  // 1019.76 mm/s
  EXPECT_EQ(outcome.search.status, Status::converged);
  EXPECT_LE(outcome.figures[0].reached, fastest * (1 + 1e-9));
  EXPECT_GE(outcome.figures[0].reached, fastest * (1 - 1e-5));
  EXPECT_NEAR(*outcome.figures[0].given, 40000.0 / 60, 1e-9);
  EXPECT_EQ(outcome.numbers[0].unit, "m/min");
  EXPECT_THAT(outcome.active, Contains(HasSubstr("rejected: shear.cut_length")));
}

TEST(Tune, WritesTheSameTextWithOtherNumbers) {
  const TuneOutcome outcome = tuned(shear + "[optimize]\nmaximize = \"master velocity\"\n" +
                                    parameter("shear.line_speed", "\"10 m/min\", \"200 m/min\""));
  const std::string number_only = shear.substr(shear.find('\n', shear.find("line_speed")));
  EXPECT_THAT(outcome.text, HasSubstr("cut_length = 1000\nline_speed = \"61.18"));
  EXPECT_THAT(outcome.text, HasSubstr(" m/min\"   # as today\nsync_time"));
  EXPECT_THAT(outcome.text, HasSubstr(number_only));
}

TEST(Tune, FindsTheShortestPieceOfAShear) {
  const TuneOutcome outcome = tuned(shear + "[optimize]\nminimize = \"cycle time\"\n" +
                                    parameter("shear.cut_length", "100, 3000"));
  (void)expect_held(outcome);
  const double v = 40000.0 / 60;
  EXPECT_NEAR(outcome.numbers[0].reached, least_length(v, 0.15), 1e-4 * 1000);
  EXPECT_GE(outcome.numbers[0].reached, least_length(v, 0.15) * (1 - 1e-9));
}

const std::string move =
    "jounce = 1\nkind = \"move\"\nunits = { position = \"mm\", time = \"s\" }\n[move]\n"
    "profile = \"trapezoid\"\nfrom = 0\nto = 200\nvelocity = 200\nacceleration = 1000\n"
    "[limits]\nvelocity = 500\nacceleration = 4000\n";

TEST(Tune, BringsAMoveToItsLimits) {
  const TuneOutcome outcome = tuned(move + "[optimize]\nminimize = \"duration\"\n" +
                                    parameter("move.velocity", "100, \"1 m/s\"") +
                                    parameter("move.acceleration", "500, 10000"));
  (void)expect_held(outcome);
  EXPECT_NEAR(outcome.figures[0].reached, 200.0 / 500 + 500.0 / 4000, 1e-5 * 0.525);
  EXPECT_EQ(outcome.numbers[0].reached, 500);
  EXPECT_EQ(outcome.numbers[1].reached, 4000);
  EXPECT_THAT(outcome.active, Contains(HasSubstr("just meets the limit 500")));
  EXPECT_THAT(outcome.active, Contains(HasSubstr("just meets the limit 4000")));
}

TEST(Tune, HoldsWhatIsRequiredInItsUnit) {
  const TuneOutcome outcome =
      tuned(move + "[optimize]\nminimize = \"peak acceleration\"\nsearch = \"local\"\n" +
            parameter("move.velocity", "100, 1000") + parameter("move.acceleration", "500, 10000") +
            "[[optimize.require]]\nfigure = \"duration\"\nat_most = \"625 ms\"\n");
  (void)expect_held(outcome);
  // T = s / v + v / a at v = 500: a = 500 / (0.625 - 0.4).
  EXPECT_NEAR(outcome.figures[0].reached, 500 / 0.225, 1e-4 * 2222);
  EXPECT_LE(outcome.figures[1].reached, 0.625);
  EXPECT_EQ(outcome.figures[1].at_most, 0.625);
  EXPECT_THAT(outcome.active, Contains(HasSubstr("duration is at its maximum, 0.625 s")));
}

TEST(Tune, GearsInOverTheShortestDistance) {
  // The ratio rises straight to 4/3 while the master runs at 720 deg/s: a = 4/3 720^2 / d.
  const TuneOutcome outcome = tuned(
      "jounce = 1\nkind = \"gear\"\nunits = { position = \"mm\", master = \"deg\" }\n[gear]\n"
      "numerator = 4\ndenominator = 3\nengage = \"distance\"\ndistance = 240\nmaster_end = 1440\n"
      "[master]\nvelocity = 720\ndistance = 1440\n[limits.slave]\nacceleration = 8000\n"
      "[optimize]\nmaximize = \"stroke\"\n" +
      parameter("gear.distance", "10, 720"));
  (void)expect_held(outcome);
  EXPECT_NEAR(outcome.numbers[0].reached, 4.0 / 3 * 720 * 720 / 8000, 1e-3);
}

TEST(Tune, GivesAKnifeItsLongestStretchInStep) {
  const TuneOutcome outcome = tuned(
      "jounce = 1\nkind = \"knife\"\nunits = { position = \"deg\", master = \"mm\" }\n[knife]\n"
      "diameter = 200\nblades = 2\ncut_length = 250\nsync_angle = 15\n[master]\nvelocity = 1500\n"
      "distance = 1000\n[limits.slave]\nacceleration = \"300 rad/s^2\"\n"
      "[optimize]\nmaximize = \"in step\"\n" +
      parameter("knife.sync_angle", "5, 60"));
  (void)expect_held(outcome);
  // cams.md 5.1: |1 - rho| Ca h v^2 / b^2, rho = b / (R h), h = phi - theta, b = L - R theta.
  const auto acceleration = [](double theta) {
    const double h = pi - theta, b = 250 - 100 * theta;
    return std::abs(1 - b / (100 * h)) * 10 / std::sqrt(3.0) * h * 1500 * 1500 / (b * b);
  };
  const double reached = outcome.numbers[0].reached * pi / 180;
  EXPECT_LE(acceleration(reached), 300 * (1 + 1e-9));
  EXPECT_GE(acceleration(reached), 300 * (1 - 1e-4));
}

TEST(Tune, IndexesInTheShortestTime) {
  const TuneOutcome outcome = tuned(
      "jounce = 1\nkind = \"indexer\"\nunits = { position = \"deg\", master = \"ms\" }\n"
      "[indexer]\ndistance = 45\ncycle = 2000\nmotion = 400\n[master]\nvelocity = 1000\n"
      "distance = 6000\n[limits.slave]\nvelocity = 300\nacceleration = 2000\n"
      "[optimize]\nmaximize = \"peak velocity\"\n" +
      parameter("indexer.motion", "100, 1900"));
  (void)expect_held(outcome);
  EXPECT_NEAR(outcome.numbers[0].reached, 1000 * std::sqrt(10 / std::sqrt(3.0) * 45 / 2000), 0.01);
}

TEST(Tune, ChoosesTheTimeOfAKnot) {
  // Cubic pieces 0 -> 60 -> 120 with 180 mm/s between: by symmetry 0.6 s, peak 6 h / T^2 - 2 v / T.
  const TuneOutcome outcome = tuned(
      "jounce = 1\nkind = \"pvt\"\nunits = { position = \"mm\", time = \"s\" }\n"
      "[[knot]]\ntime = 0\nposition = 0\nvelocity = 0\n"
      "[[knot]]\ntime = \"500 ms\"\nposition = 60\nvelocity = 180\n"
      "[[knot]]\ntime = 1.2\nposition = 120\nvelocity = 0\n"
      "[optimize]\nminimize = \"peak acceleration\"\n" +
      parameter("knot[2].time", "\"100 ms\", 1.1"));
  (void)expect_held(outcome);
  EXPECT_NEAR(outcome.numbers[0].reached, 600, 1e-3);  // ms, as it is written
  EXPECT_NEAR(outcome.figures[0].reached, 400, 1e-3);
}

const std::string cam =
    "jounce = 1\nkind = \"cam\"\nunits = { position = \"mm\", master = \"deg\" }\n"
    "start = { master = 0, slave = 0 }\n[[segment]]\nlaw = \"345\"\ninflection = 0.3\n"
    "end = { master = 100, slave = 50 }\n[[segment]]\nlaw = \"dwell\"\n"
    "end = { master = 360, slave = 50 }\n";

TEST(Tune, ChoosesTheParameterOfALaw) {
  const TuneOutcome outcome = tuned(cam + "[optimize]\nminimize = \"peak geo_acceleration\"\n" +
                                    parameter("segment[1].inflection", "0.1, 0.9"));
  (void)expect_held(outcome);
  // Ca / 2 lambda before, Ca / 2 (1 - lambda) after.
  EXPECT_NEAR(outcome.numbers[0].reached, 0.5, 1e-5);
  EXPECT_NEAR(outcome.figures[0].reached, 10 / std::sqrt(3.0) * 50 / 1e4, 1e-6);
}

TEST(Tune, RunsACamsMasterAsFastAsItsSlaveCan) {
  const TuneOutcome outcome = tuned(
      cam +
      "[master]\nvelocity = 100\ndistance = 360\n[limits.slave]\nacceleration = 1000\n"
      "[optimize]\nmaximize = \"master velocity\"\n" +
      parameter("master.velocity", "10, 1000") + parameter("segment[1].inflection", "0.1, 0.9"));
  (void)expect_held(outcome);
  const double fastest = std::sqrt(1000 * 1e4 / (50 * 10 / std::sqrt(3.0)));  // at lambda 1/2
  EXPECT_NEAR(outcome.figures[0].reached, fastest, 1e-4 * fastest);
  EXPECT_LE(outcome.figures[0].reached, fastest * (1 + 1e-9));
}

TEST(Tune, ChoosesTheDynamicsOfAQueue) {
  const TuneOutcome outcome = tuned(
      "jounce = 1\nkind = \"queue\"\nunits = { position = \"mm\", time = \"s\" }\n[dynamics]\n"
      "velocity = 100\nacceleration = 4000\n[[command]]\ntype = \"absolute\"\nposition = 150\n"
      "[limits]\nvelocity = 500\n[optimize]\nminimize = \"duration\"\n" +
      parameter("dynamics.velocity", "50, 2000"));
  (void)expect_held(outcome);
  EXPECT_NEAR(outcome.figures[0].reached, 150.0 / 500 + 500.0 / 4000, 1e-6);
}

TEST(Tune, NamesTheBlockingLimits) {
  const TuneOutcome outcome =
      tuned(move +
            "[optimize]\nminimize = \"peak acceleration\"\n"
            "max_evaluations = 300\n" +
            parameter("move.velocity", "100, 1000") + parameter("move.acceleration", "500, 10000") +
            "[[optimize.require]]\nfigure = \"duration\"\nat_most = 0.3\n");
  EXPECT_EQ(outcome.search.status, Status::infeasible);
  EXPECT_FALSE(outcome.usable());
  EXPECT_THAT(outcome.active, ElementsAre(HasSubstr("at most 0.3 is required")));
}

const std::string three_rises =
    "jounce = 1\nkind = \"cam\"\nperiodic = true\nunits = { master = \"deg\", position = \"mm\" }\n"
    "start = { master = 0, slave = 0 }\n"
    "[[segment]]\nlaw = \"345\"\nend = { master = 100, slave = 60 }\n"
    "[[segment]]\nlaw = \"modified_sine\"\nend = { master = 200, slave = 20 }\n"
    "[[segment]]\nlaw = \"inclined_sine\"\nend = { master = 300, slave = 0 }\n"
    "[[segment]]\nlaw = \"dwell\"\nend = { master = 360, slave = 0 }\n"
    "[master]\nvelocity = 360\ndistance = 720\n";
const std::string three_knots =
    parameter("segment[1].end.master", "40, 200") + parameter("segment[2].end.master", "100, 280");

// The peak of a rise h over the length L is c h / L^2. The greatest of all rises is least if all are equal:
// L is proportional to sqrt(c h). The design that was printed exceeded the limit by 198 %, and not by 122 %.
TEST(Tune, TheLeastViolationIsThatOfTheClosedForm) {
  const TuneOutcome outcome =
      tuned(three_rises + "[limits]\ngeo_acceleration = 0.01\n" +
            "[optimize]\nminimize = \"peak acceleration\"\nmax_evaluations = 4000\n" + three_knots);
  EXPECT_EQ(outcome.search.status, Status::infeasible);
  const double pi = std::numbers::pi;
  const double sums = std::sqrt(10 / std::sqrt(3.0) * 60) + std::sqrt(4 * pi * pi / (4 + pi) * 40) +
                      std::sqrt(2 * pi * 20);
  const double least = sums * sums / (300.0 * 300);
  double worst = 0;
  for (const Finding& f : outcome.report.findings)
    if (f.rule == "limit/geo_acceleration") worst = std::max(worst, std::abs(f.value));
  EXPECT_NEAR(worst, least, 1e-4 * least);
}

TEST(Tune, MakesNoMoreDesignsThanPermitted) {
  for (const int most : {1, 3, 20, 100}) {
    const TuneOutcome outcome =
        tuned(three_rises + "[optimize]\nminimize = \"peak acceleration\"\nmax_evaluations = " +
              std::to_string(most) + "\n" + three_knots);
    EXPECT_LE(outcome.search.evaluations, most);
    if (most < 8) {
      EXPECT_EQ(outcome.search.evaluations, most) << "nothing is left for rounding";
    }
    EXPECT_EQ(outcome.search.status, Status::stalled);
    EXPECT_THAT(outcome.search.reason, HasSubstr("the limit of " + std::to_string(most)));
  }
}

TEST(Tune, StopsOnRequest) {
  const Spec spec = parse_spec(move + "[optimize]\nminimize = \"duration\"\n" +
                                   parameter("move.velocity", "100, 1000") +
                                   parameter("move.acceleration", "500, 10000"),
                               "s.toml");
  const TuneOutcome outcome =
      tune(spec, [](const OptimizeProgress& p) { return p.evaluations < 10; });
  EXPECT_EQ(outcome.search.status, Status::cancelled);
  EXPECT_TRUE(outcome.usable());
}

TEST(Tune, RejectsWhatItCannotDo) {
  const std::string one = parameter("move.velocity", "100, 1000");
  const auto said = [&](const std::string& rest) {
    return error_of([&] { (void)tuned(move + rest); });
  };
  EXPECT_THAT(said("[optimize]\nminimize = \"duratoin\"\n" + one),
              HasSubstr("s.toml:14:12: optimize.minimize = \"duratoin\": must be one of "));
  EXPECT_THAT(said("[optimize]\nminimize = \"duration\"\n" + one +
                   "[[optimize.require]]\nfigure = \"peak torque\"\nat_most = 1\n"),
              HasSubstr("optimize.require[1].figure = \"peak torque\""));
  EXPECT_THAT(said("[optimize]\nminimize = \"duration\"\n" + one +
                   "[[optimize.require]]\nfigure = \"peak velocity\"\nat_most = \"1 kg\"\n"),
              HasSubstr("optimize.require[1].at_most = \"1 kg\""));
  EXPECT_THAT(
      said("[optimize]\nminimize = \"duration\"\n" + parameter("move.velocity", "300, 1000")),
      HasSubstr("optimize.parameter[1].range = 300 to 1000 mm/s: must contain 200 mm/s, the "
                "present value in "
                "the spec"));
  EXPECT_THAT(said(""), HasSubstr("optimize.parameter: is missing"));
}

TEST(Tune, RejectsAFigureThatDependsOnNoParameter) {
  // [master] gives the velocity, so that of the line in [shear] does not change it.
  const std::string text =
      shear + "[master]\nvelocity = 600\n[optimize]\nmaximize = \"master velocity\"\n" +
      parameter("shear.line_speed", "\"10 m/min\", \"200 m/min\"");
  const std::string error = error_of([&] { (void)tuned(text); });
  EXPECT_THAT(
      error,
      HasSubstr("optimize.maximize = \"master velocity\": depends on no parameter: it is 600 mm/s "
                "in all "));
  EXPECT_THAT(error, HasSubstr("designs that were tried"));
}

TEST(ParametersSpec, RejectsContradictions) {
  const std::string one = parameter("move.velocity", "100, 1000");
  const auto said = [&](const std::string& rest) {
    return error_of([&] { (void)parse_spec(move + rest, "s.toml"); });
  };
  EXPECT_THAT(said("[optimize]\nminimize = \"duration\"\n"),
              HasSubstr("optimize.parameter: is missing"));
  EXPECT_THAT(said("[optimize]\n" + one), HasSubstr("optimize.minimize: is missing"));
  EXPECT_THAT(said("[optimize]\nminimize = \"duration\"\nmaximize = \"stroke\"\n" + one),
              HasSubstr("cannot be combined with maximize"));
  const std::string least = "[optimize]\nminimize = \"duration\"\n";
  EXPECT_THAT(said(least + parameter("move.velocty", "1, 2")),
              HasSubstr("did you mean \"move.velocity\"?"));
  EXPECT_THAT(said(least + parameter("move.jerk", "1, 2")),
              HasSubstr("names no number in this spec"));
  EXPECT_THAT(said(least + parameter("move.velocity", "\"1 kg\", 2")), HasSubstr("range"));
  EXPECT_THAT(said(least + parameter("move.velocity", "2, 1")), HasSubstr("in this order"));
  EXPECT_THAT(said(least + parameter("move.velocity", "nan, 1")), HasSubstr("finite"));
  EXPECT_THAT(said(least + one + one),
              HasSubstr("parameter[2].key = \"move.velocity\": is given twice"));
  EXPECT_THAT(said(least + one + "[[optimize.require]]\nfigure = \"stroke\"\n"),
              HasSubstr("optimize.require[1].at_most: is missing"));
  EXPECT_THAT(said(least + "seconds = 0\n" + one), HasSubstr("optimize.seconds = 0"));
  EXPECT_THAT(said(least + "tolerance = 0.5\n" + one), HasSubstr("optimize.tolerance = 0.5"));
  EXPECT_THAT(said(least + "max_evaluations = 2000000\n" + one), HasSubstr("at most 1000000"));
  EXPECT_THAT(said(least + "serach = \"local\"\n" + one), HasSubstr("did you mean search?"));
  EXPECT_THAT(error_of([&] {
                (void)parse_spec(
                    cam.substr(0, cam.find("[[segment]]")) +
                        "[[segment]]\nlaw = \"quintic\"\nend = { master = 9, slave = 1 }\n"
                        "free = { geo_velocity = [-1, 1] }\n[optimize]\nminimize = "
                        "\"peak geo_jerk\"\n" +
                        parameter("segment[1].end.slave", "0, 2"),
                    "s.toml");
              }),
              HasSubstr("cannot be combined with `free` knots"));
}

}  // namespace
}  // namespace jounce::tune_test
