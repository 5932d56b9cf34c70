// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "jounce/design/make.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/spec/detail/drive_figures.hpp"
#include "jounce/spec/detail/edit.hpp"
#include "jounce/spec/shape_spec.hpp"

#include "support/errors.hpp"

namespace jounce::shape_test {
namespace {

constexpr const char* cam = R"(jounce = 1
kind = "cam"
periodic = true
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }
[[segment]]
name = "push"
law = "modified_sine"
inflection = 0.4
free = { shape = 40 }
end = { master = 120, slave = 50 }
[[segment]]
law = "345"   # keep me
free = { shape = 30, monotone = true }
end = { master = 240, slave = 20 }
[[segment]]
law = "dwell"
end = { master = 360, slave = 20 }
[limits]
geo_velocity = 1.5
[master]
velocity = 360
distance = 720
[load]
position_per_rev = 100
inertia = "2 kg cm^2"
mass = 5
gravity = 9.81
stiffness = "0.4 N/mm"
preload = 30
damping = 0.001
torque = 0.2
force = 10
winding_loss = 0.8
[optimize]
minimize = ["rms torque"]
)";

/// The dwell stands at 20, and the cam begins at 0: made one by replacing.
std::string spec_text(const std::string& from = "", const std::string& to = "") {
  std::string text = cam;
  const auto replace = [&](const std::string& a, const std::string& b) {
    const auto at = text.find(a);
    ASSERT_NE(at, std::string::npos) << a;
    text.replace(at, a.size(), b);
  };
  replace("end = { master = 240, slave = 20 }", "end = { master = 240, slave = 0 }");
  replace("end = { master = 360, slave = 20 }", "end = { master = 360, slave = 0 }");
  if (!from.empty()) replace(from, to);
  return text;
}

Spec spec_of(const std::string& from = "", const std::string& to = "") {
  return parse_spec(spec_text(from, to), "a.toml");
}

/// Objection of the reader or the problem.
std::string complaint(const std::string& from, const std::string& to) {
  return test::error_of([&] { (void)make_shape_problem(spec_of(from, to)); });
}

TEST(FreeShapes, AreReadFromTheirSegments) {
  const Spec spec = spec_of("shape = 40", "shape = 40, continuity = 5");
  const auto& shapes = spec.optimize.shape.shapes;
  ASSERT_EQ(shapes.size(), 2U);
  EXPECT_EQ(shapes[0].segment, 0U);
  EXPECT_EQ(shapes[0].pieces, 40U);
  EXPECT_EQ(shapes[0].continuity, 5);
  EXPECT_FALSE(shapes[0].monotone);
  EXPECT_EQ(shapes[1].continuity, 4);
  EXPECT_TRUE(shapes[1].monotone);
}

TEST(FreeShapes, TakeWhatTheKnotBetweenThemLeavesOut) {
  const CamShapeProblem left_out = make_shape_problem(spec_of());
  ASSERT_EQ(left_out.knots.size(), 1U);
  EXPECT_EQ(left_out.knots[0].knot, 1U);
  EXPECT_FALSE(left_out.knots[0].slave);
  EXPECT_TRUE(std::isinf(left_out.knots[0].geo_velocity->upper));
  EXPECT_TRUE(std::isinf(left_out.knots[0].geo_acceleration->lower));

  const CamShapeProblem given =
      make_shape_problem(spec_of("slave = 50 }", "slave = 50, geo_velocity = 0 }"));
  EXPECT_FALSE(given.knots[0].geo_velocity);
  EXPECT_TRUE(given.knots[0].geo_acceleration);

  const CamShapeProblem bounded =
      make_shape_problem(spec_of("shape = 40 }", "shape = 40, slave = [\"4 cm\", 55] }"));
  EXPECT_EQ(bounded.knots[0].slave->lower, 40);
  EXPECT_EQ(bounded.knots[0].slave->upper, 55);
}

TEST(FreeShapes, LimitsOfTheSlaveBecomeCorridorsAtTheMastersSpeed) {
  const CamShapeProblem problem =
      make_shape_problem(spec_of("[master]",
                                 "[limits.slave]\nvelocity = 600\njerk = \"4e5 mm/s^3\"\n"
                                 "[master]"));
  EXPECT_EQ(problem.limits.velocity, 1.5);
  ASSERT_EQ(problem.corridors.size(), 2U);
  EXPECT_EQ(problem.corridors[0].quantity.name, "velocity");
  EXPECT_EQ(problem.corridors[0].quantity.by[1], 360);
  EXPECT_EQ(problem.corridors[0].upper->at_to, 600);
  EXPECT_EQ(problem.corridors[1].quantity.by[3], 360. * 360 * 360);
  EXPECT_EQ(problem.corridors[1].lower->at_from, -4e5);
  EXPECT_EQ(problem.corridors[1].to, 360);
}

TEST(Load, IsTheTorqueAtTheMotor) {
  const Spec spec = spec_of();
  const LinearQuantity torque = torque_of(*spec.optimize.shape.load, 360, "mm");
  // 100 mm a turn: r = 0.1 / 2 pi m. Master 360 deg/s.
  const double turn = 2 * std::numbers::pi / 100;  // rad of the motor per mm
  const double r = 0.1 / (2 * std::numbers::pi);   // m per rad
  EXPECT_NEAR(torque.by[0], r * 400 * 1e-3, 1e-15);
  EXPECT_NEAR(torque.by[1], 0.001 * turn * 360, 1e-15);
  EXPECT_NEAR(torque.by[2], (2e-4 + 5 * r * r) * turn * 360 * 360, 1e-12);
  EXPECT_NEAR(torque.constant, 0.2 + r * (30 + 10 + 5 * 9.81), 1e-14);
  // Accelerated by 1 m/s^2 from rest at 0, the motor gives what lifts, presses and accelerates.
  const double f2 = 1000. / (360 * 360);  // mm/deg^2
  EXPECT_NEAR(torque.by[2] * f2 + torque.constant,
              0.2 + r * (30 + 10 + 5 * 9.81 + 5 * 1) + 2e-4 * 1 / r, 1e-12);
}

TEST(Load, OfARotarySlaveCountsInTurns) {
  LoadSpec load;
  load.position_per_rev = 36;  // deg: a gear of 10
  load.inertia = 1e-3;
  load.stiffness = 2;  // N m/rad, at the slave
  const LinearQuantity torque = torque_of(load, 100, "deg");
  EXPECT_NEAR(torque.by[0], 0.1 * 2 * std::numbers::pi / 180, 1e-15);
  EXPECT_NEAR(torque.by[2], 1e-3 * (10 * std::numbers::pi / 180) * 1e4, 1e-12);
}

TEST(Load, DryFrictionAndALeverCountAtTheMotorWhicheverWayItTurns) {
  LoadSpec load;
  load.inertia = 1e-3;
  load.torque = 0.2;
  load.coulomb = 0.05;
  load.lever = 3;  // N m, at the slave
  load.lever_angle = 0.4;
  ASSERT_FALSE(is_linear(load));
  for (const double per_rev : {36., -36.}) {  // deg: a gear of 10
    SCOPED_TRACE(per_rev);
    load.position_per_rev = per_rev;
    const LoadTorque torque = load_torque_of(load, 100, "deg");
    const double sign = per_rev > 0 ? 1 : -1;
    const double turn = 10 * std::numbers::pi / 180;  // rad of the motor per deg
    EXPECT_NEAR(torque.linear.by[2], 1e-3 * turn * 1e4, 1e-12);
    EXPECT_NEAR(torque.linear.constant, sign * 0.2, 1e-15);
    EXPECT_EQ(torque.coulomb, 0.05) << "always against the motion";
    EXPECT_NEAR(torque.gravity, 3 / 10., 1e-15) << "the arm does not depend on the motor";
    EXPECT_NEAR(torque.turn, std::numbers::pi / 180, 1e-15);
    EXPECT_EQ(torque.angle, 0.4);
    const EnergyOf energy = energy_of(load, 100, "deg");
    EXPECT_NEAR(energy.load.coulomb, 0.05 * turn, 1e-15);
    EXPECT_NEAR(energy.load.linear.by[2], 1e-3 * turn * turn * 1e4, 1e-12);
  }
}

TEST(Load, DryFrictionTakesItsTorqueTimesTheAngle) {
  LoadSpec load;
  load.position_per_rev = 100;
  load.coulomb = 0.3;
  ShapeProblem p;
  p.from = {.value = 0, .velocity = 0};
  p.to = {.value = 250, .velocity = 0};
  p.pieces = 10;
  p.minimize = {{RmsOf{derivative_of_shape(2)}}};
  p.ceilings = {{energy_of(load, 360, "mm"), 1e9}};
  p.options.budget.evaluations = 1;
  EXPECT_NEAR(optimize_shape(p).figures[1].given, 0.3 * 2.5 * 2 * std::numbers::pi, 1e-5);
}

TEST(Load, WithFrictionHasFiguresThatAreSearched) {
  const Spec spec = spec_of("torque = 0.2", "torque = 0.2\ncoulomb = \"5 N cm\"\nrecovered = 0.6");
  EXPECT_EQ(spec.optimize.shape.load->coulomb, 0.05);
  EXPECT_TRUE(std::holds_alternative<RmsTorqueOf>(spec.optimize.shape.figures[0].figure));
  const Spec others = spec_of(
      "torque = 0.2\nforce = 10\nwinding_loss = 0.8\n[optimize]\nminimize = [\"rms torque\"]",
      "coulomb = 0.05\nrecovered = 0.6\nwinding_loss = 0.8\n[optimize]\n"
      "minimize = [\"peak torque\", \"motor heating\", \"driving energy\"]");
  const auto& figures = others.optimize.shape.figures;
  EXPECT_TRUE(std::holds_alternative<TorqueOf>(figures[0].figure));
  EXPECT_TRUE(std::holds_alternative<RmsTorqueOf>(figures[1].figure));
  EXPECT_TRUE(figures[1].squared);
  EXPECT_EQ(std::get<EnergyOf>(figures[2].figure).recovered, 0.6);
  EXPECT_EQ(figures[2].unit, "J");
}

TEST(Load, RejectsWhatItCannotMean) {
  const auto with = [](const std::string& key) {
    return complaint("torque = 0.2", "torque = 0.2\n" + key);
  };
  EXPECT_THAT(with("coulomb = -1"), testing::HasSubstr("coulomb = -1 N m: must not be negative"));
  EXPECT_THAT(with("recovered = 1.2"), testing::HasSubstr("must be 0 to 1"));
  EXPECT_THAT(with("lever = 2"),
              testing::HasSubstr("does not fit a slave in mm: an arm needs a unit of angle"));
  EXPECT_THAT(complaint("torque = 0.2\nforce = 10\nwinding_loss = 0.8\n[optimize]\nminimize = "
                        "[\"rms torque\"]",
                        "coulomb = 1\n[optimize]\nminimize = [\"peak power\"]"),
              testing::HasSubstr("is not possible with coulomb or lever in [load]"));
}

TEST(ShapeFigures, OfADriveAreKnownByNameAndAskForOne) {
  const std::string rms = "minimize = [\"rms torque\"]";
  const Spec spec = spec_of(rms, "minimize = [\"drive residual\", \"drive rms torque\"]");
  const auto& figures = spec.optimize.shape.figures;
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].unit, "mm");
  EXPECT_EQ(figures[1].unit, "N m");
  EXPECT_EQ(drive_figure(figures[0].figure), DriveFigure::residual);
  EXPECT_EQ(drive_figure(figures[1].figure), DriveFigure::rms_torque);
  EXPECT_NO_THROW(make_shape_problem(spec, true));
  EXPECT_THAT(complaint(rms, "minimize = [\"drive residual\"]"), testing::HasSubstr("--against"));
  EXPECT_THAT(complaint(rms, "minimize = [\"drive resdual\"]"),
              testing::HasSubstr("did you mean \"drive residual\"?"));
}

TEST(ShapeFigures, HaveTheirUnitsAndNumbers) {
  const Spec spec = spec_of("minimize = [\"rms torque\"]",
                            "minimize = [\"motor heating\", \"energy\", \"peak power\", \"peak "
                            "acceleration\", \"rms geo_jounce\"]");
  const auto& figures = spec.optimize.shape.figures;
  ASSERT_EQ(figures.size(), 5U);
  EXPECT_EQ(figures[0].unit, "W");
  EXPECT_DOUBLE_EQ(shown(figures[0], 0.5, 240), 0.8 * 0.25);
  EXPECT_DOUBLE_EQ(computed(figures[0], 0.2), 0.5);
  EXPECT_EQ(figures[1].unit, "J");
  EXPECT_DOUBLE_EQ(shown(figures[1], 0.5, 240), 0.8 * 0.25 * 240 / 360);
  EXPECT_EQ(figures[2].unit, "W");
  const auto& power = std::get<PowerOf>(figures[2].figure);
  EXPECT_NEAR(power.velocity.by[1], 2 * std::numbers::pi / 100 * 360, 1e-12);
  EXPECT_EQ(figures[3].unit, "mm/s^2");
  EXPECT_EQ(std::get<PeakOf>(figures[3].figure).quantity.by[2], 360. * 360);
  EXPECT_EQ(figures[4].unit, "mm/deg^4");
  EXPECT_EQ(std::get<RmsOf>(figures[4].figure).quantity.by[4], 1);
  EXPECT_EQ(spec.optimize.shape.minimize.size(), 5U) << "in order of priority";
}

TEST(ShapeFigures, AreWeightedInTables) {
  const Spec spec = spec_of("minimize = [\"rms torque\"]", R"(
[[optimize.minimize]]
figure = "residual"
at = ["15 Hz", 19]
damping = 0.02
weight = 3
[[optimize.minimize]]
figure = "peak geo_jerk"
[[optimize.ceiling]]
figure = "motor heating"
at_most = "0.2 W"
)");
  const ShapeSpec& shape = spec.optimize.shape;
  ASSERT_EQ(shape.minimize.size(), 1U);
  ASSERT_EQ(shape.minimize[0].size(), 2U);
  EXPECT_EQ(shape.minimize[0][0].weight, 3);
  const auto& residual = std::get<ResidualOf>(shape.minimize[0][0].figure);
  EXPECT_DOUBLE_EQ(residual.low, 15. / 360);  // cycles per deg
  EXPECT_DOUBLE_EQ(residual.high, 19. / 360);
  EXPECT_EQ(residual.damping_low, 0.02);
  EXPECT_EQ(residual.damping_high, 0.02);
  EXPECT_DOUBLE_EQ(shape.ceilings[0].at_most, 0.5);
  EXPECT_EQ(shape.figures.size(), 3U);
  EXPECT_EQ(shape.figures[0].name, "residual 15 to 19 Hz");
}

TEST(Corridors, AreReadAsBoundsOrAsAValue) {
  const Spec spec = spec_of("minimize = [\"rms torque\"]", R"(minimize = ["peak torque"]
[[optimize.corridor]]
from = 30
to = 60
lower = [1, 5]
[[optimize.corridor]]
at = "0.25 rev"
value = 45
tolerance = "100 um"
[[optimize.corridor]]
quantity = "torque"
from = 0
to = 240
upper = 3
)");
  const auto& corridors = spec.optimize.shape.corridors;
  ASSERT_EQ(corridors.size(), 3U);
  EXPECT_EQ(corridors[0].lower->at_to, 5);
  EXPECT_FALSE(corridors[0].upper);
  EXPECT_NEAR(corridors[1].from, 90, 1e-12);
  EXPECT_EQ(corridors[1].from, corridors[1].to);
  EXPECT_NEAR(corridors[1].lower->at_from, 44.9, 1e-12);
  EXPECT_NEAR(corridors[1].upper->at_to, 45.1, 1e-12);
  EXPECT_EQ(corridors[2].quantity.name, "torque");
}

struct Bad {
  const char* from;
  const char* to;
  const char* message;
};

TEST(FreeShapes, RejectWhatMakesNoSense) {
  for (const Bad& bad :
       {Bad{"shape = 40", "shape = 0", "must be a whole number of at least 1"},
        Bad{"shape = 40", "shape = 40.5", "must be a whole number of at least 1"},
        Bad{"shape = 40", "shape = 5000", "segment[1].free.shape = 5000: must be 1 to 2000 pieces"},
        Bad{"shape = 40", "shape = 40, continuity = 1",
            "segment[1].free.continuity = 1: must be 2 to 6"},
        Bad{"shape = 30", "shape = 30, continuity = 3",
            "segment[2].free.continuity = 3: must be the same in all free segments"},
        Bad{"{ shape = 40 }", "{ monotone = true }",
            "segment[1].free.monotone = true: needs a free shape: add shape = 100"},
        Bad{"shape = 40", "shap = 40", "did you mean shape?"},
        Bad{"shape = 40 }", "shape = 40, master = [100, 130] }",
            "segment[1].free.master: cannot be free next to free shapes"},
        Bad{"shape = 30, ", "shape = 30, slave = [10, 30], ",
            "segment[2].free: every segment next to a free knot must have a free shape"},
        Bad{"shape = 40 }", "shape = 40, slave = [60, 40] }",
            "must be [least, greatest], in this order"},
        Bad{"[optimize]\nminimize = [\"rms torque\"]\n", "", "optimize: is missing: a free shape"},
        Bad{"[\"rms torque\"]", "[]", "optimize.minimize: is missing"},
        Bad{"[\"rms torque\"]", "[\"rms torqe\"]", "did you mean \"rms torque\"?"},
        Bad{"[\"rms torque\"]", "[\"least torque\"]", "must be one of peak geo_velocity"},
        Bad{"[\"rms torque\"]", "[\"residual\"]", "needs a frequency"},
        Bad{"[\"rms torque\"]", "[{ figure = \"residual\" }]",
            "optimize.minimize[1].at: is missing"},
        Bad{"[\"rms torque\"]", "[{ figure = \"residual\", at = \"17 kg\" }]",
            "is not a unit of this quantity: give the value in Hz"},
        Bad{"[\"rms torque\"]", "[{ figure = \"residual\", at = [20, 10] }]",
            "a band must be [lowest, highest]"},
        Bad{"[\"rms torque\"]", "[{ figure = \"residual\", at = 17, damping = 1 }]",
            "damping = 1: must be at least 0 and less than 1"},
        Bad{"[\"rms torque\"]", "[{ figure = \"rms torque\", weight = 0 }]",
            "optimize.minimize[1].weight = 0: must be greater than 0"},
        Bad{"[\"rms torque\"]", "[{ figure = \"rms torque\", weight = nan }]",
            "must be a finite number"},
        Bad{"[\"rms torque\"]",
            "[\"rms torque\"]\nceiling = [{ figure = \"energy\", at_most = 1 }]",
            "cannot have a limit"},
        Bad{"[\"rms torque\"]", "[\"rms torque\"]\ncorridor = [{ from = 3, to = 2, lower = 1 }]",
            "optimize.corridor[1].from = 3 deg: must be at most to = 2 deg"},
        Bad{"[\"rms torque\"]", "[\"rms torque\"]\ncorridor = [{ from = 1, to = 2 }]",
            "a corridor needs a lower bound, an upper bound or a value"},
        Bad{"[\"rms torque\"]",
            "[\"rms torque\"]\ncorridor = [{ from = 1, to = 2, lower = 3, upper = 2 }]",
            "must not be above upper = 2"},
        Bad{"[\"rms torque\"]", "[\"rms torque\"]\ncorridor = [{ at = 300, lower = 3 }]",
            "optimize.corridor[1].at = 300 deg: must lie in a segment with a free shape: 0 to 240"},
        Bad{"[\"rms torque\"]", "[\"rms torque\"]\nbudget = \"-1 s\"",
            "optimize.budget = -1 s: must be greater than 0"},
        Bad{"winding_loss = 0.8\n[optimize]\nminimize = [\"rms torque\"]",
            "[optimize]\nminimize = [\"energy\"]", "needs load.winding_loss"},
        Bad{"position_per_rev = 100", "position_per_rev = 0", "must not be 0"},
        Bad{"mass = 5", "mass = -5", "load.mass = -5 kg: must not be negative"},
        Bad{"stiffness = \"0.4 N/mm\"", "stiffness = \"0.4 N m/rad\"",
            "is not a unit of this quantity"}})
    EXPECT_NE(complaint(bad.from, bad.to).find(bad.message), std::string::npos)
        << bad.to << "\n"
        << complaint(bad.from, bad.to);
}

TEST(FreeShapes, NeedAMasterAndALoadForWhatIsOfThem) {
  EXPECT_NE(complaint("[master]\nvelocity = 360\ndistance = 720\n", "").find("add [master]"),
            std::string::npos);
  std::string text = spec_text();
  text.erase(text.find("[load]"), text.find("[optimize]") - text.find("[load]"));
  try {
    (void)parse_spec(text, "a.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(
        std::string(error.what())
            .find("a.toml:25:12: optimize.minimize = \"rms torque\": needs the load: add [load]"),
        std::string::npos)
        << error.what();
  }
}

CamSpec with_points(const Spec& spec) {
  CamSpec better = std::get<CamSpec>(spec.subject);
  for (const FreeShape& shape : spec.optimize.shape.shapes) {
    CamSegment& segment = better.segments[shape.segment];
    segment.law = Law::hermite;
    segment.form = {};
    segment.points = {{.master = 120. * static_cast<double>(shape.segment) + 60,
                       .slave = 1. / 3,
                       .geo_velocity = 0.1,
                       .geo_acceleration = -1e-3}};
  }
  return better;
}

TEST(WithShapes, ReplacesLawsByPointsAndNothingElse) {
  const Spec spec = spec_of();
  const std::string text = with_shapes(spec, with_points(spec));
  std::string wanted = spec_text();
  const auto replace = [&](const std::string& a, const std::string& b) {
    wanted.replace(wanted.find(a), a.size(), b);
  };
  replace(
      "law = \"modified_sine\"\ninflection = 0.4\n",
      "law = \"hermite\"\npoints = [  # 1 points, by `jounce optimize`\n  { master = 60, slave = "
      "0.3333333333333333, geo_velocity = 0.1, geo_acceleration = -0.001 },\n]\n");
  replace(
      "law = \"345\"   # keep me\n",
      "law = \"hermite\"   # keep me\npoints = [  # 1 points, by `jounce optimize`\n  { master = "
      "180, slave = 0.3333333333333333, geo_velocity = 0.1, geo_acceleration = -0.001 },\n]\n");
  EXPECT_EQ(text, wanted);
  const auto again = std::get<CamSpec>(parse_spec(text, "b.toml").subject);
  EXPECT_EQ(again.segments[0].points[0].slave, 1. / 3);
}

TEST(WithShapes, ReplacesTheListOfARunBefore) {
  const Spec first = spec_of();
  const std::string once = with_shapes(first, with_points(first));
  const Spec second = parse_spec(once, "b.toml");
  EXPECT_EQ(with_shapes(second, with_points(second)), once);
}

TEST(WithShapes, TakesPointsInTablesOfTheirOwnAway) {
  const Spec spec = spec_of(
      "law = \"modified_sine\"\ninflection = 0.4\nfree = { shape = 40 }\nend = { "
      "master = 120, slave = 50 }\n",
      "law = \"quintic_spline\"\nfree = { shape = 40 }\nend = { master = 120, "
      "slave = 50 }\n[[segment.points]]\nmaster = 50\nslave = 20\n\n"
      "[[segment.points]]\nmaster = 80\nslave = 40\n");
  const std::string text = with_shapes(spec, with_points(spec));
  EXPECT_EQ(text.find("[[segment.points]]"), std::string::npos) << text;
  const auto again = std::get<CamSpec>(parse_spec(text, "b.toml").subject);
  ASSERT_EQ(again.segments.size(), 3U);
  EXPECT_EQ(again.segments[0].points.size(), 1U);
  EXPECT_EQ(again.segments[0].law, Law::hermite);
}

TEST(WithShapes, WorksInInlineTables) {
  const std::string text = R"(jounce = 1
kind = "cam"
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }
segment = [{ law = "modified_sine", inflection = 0.4, free = { shape = 9 }, end = { master = 90, slave = 5 } }]
optimize = { minimize = ["peak geo_jerk"] }
)";
  const Spec spec = parse_spec(text, "a.toml");
  CamSpec better = std::get<CamSpec>(spec.subject);
  better.segments[0].law = Law::hermite;
  better.segments[0].form = {};
  better.segments[0].points = {
      {.master = 45, .slave = 2.5, .geo_velocity = 0.1, .geo_acceleration = 0}};
  const auto again = std::get<CamSpec>(parse_spec(with_shapes(spec, better), "b.toml").subject);
  EXPECT_EQ(again.segments[0].law, Law::hermite);
  EXPECT_EQ(again.segments[0].points[0].geo_velocity, 0.1);
  EXPECT_FALSE(again.segments[0].form.inflection);
}

}  // namespace
}  // namespace jounce::shape_test
