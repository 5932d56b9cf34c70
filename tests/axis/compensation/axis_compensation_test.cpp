// SPDX-License-Identifier: Apache-2.0
// The compensation of axes (EnableComp and DisableComp of HIMC): tables of the HMPL manual 14.1.1, and an
// interpolation written here.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/axis/machine.hpp"
#include "jounce/drive/drive.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/bench.hpp"

namespace jounce::axis_compensation_test {
namespace {

using test::limits;
using test::refusal;
using ::testing::HasSubstr;

const CompensationSpec screw{
    .axes = {{-100, 200, 5}}, .values = {-0.2, 0.1, -0.3, 0.4, -0.1}, .most = 1};

/// The straight lines of the screw.
double of_screw(double x) {
  const std::array v{-0.2, 0.1, -0.3, 0.4, -0.1};
  const double s = std::clamp((x + 100) / 200, 0.0, 4.0);
  const auto i = std::min<std::size_t>(static_cast<std::size_t>(s), 3);
  return v.at(i) + (v.at(i + 1) - v.at(i)) * (s - static_cast<double>(i));
}

AxisConfig corrected(const CompensationSpec& table, std::optional<std::size_t> own) {
  AxisConfig config{.limits = limits(500, 5000)};
  config.compensation = AxisCompensation{.table = table, .own = own};
  return config;
}

/// Axes with ideal drives, each corrected by the references that it names.
struct Table {
  explicit Table(std::vector<MachineAxis> axes)
      : machine(std::move(axes)), images(machine.size()), drives(machine.size()) {}

  Tick step(std::size_t axis, const Command& command = {}) {
    for (AxisImage& image : images) image.command = {};
    images[axis].command = command;
    for (std::size_t i = 0; i < images.size(); ++i)
      images[i].inputs.feedback.position = drives[i].position;
    machine.step(++tick, images);
    for (std::size_t i = 0; i < images.size(); ++i)
      drives[i] = drive_setpoint(images[i].tick, images[i].command);
    return images[axis].tick;
  }
  void home(std::size_t axis) {
    step(axis, {command::Enable{}});
    step(axis, {command::Home{}});
    step(axis);
    step(axis, {command::Disable{}});
  }
  void on(std::size_t axis) {
    home(axis);
    ASSERT_EQ(refusal(step(axis, {command::EnableCompensation{}})), Cause::none);
    step(axis, {command::Enable{}});
  }
  /// Moves, and calls `each` in every tick until the axis rests.
  template <class Each>
  void move(std::size_t axis, double to, Each each) {
    step(axis, {command::MoveAbsolute{.position = to}});
    each();
    for (int i = 0; i < 100'000 && images[axis].tick.state != State::standstill; ++i) {
      step(axis);
      each();
    }
    ASSERT_EQ(images[axis].tick.position, to);
  }

  Machine machine;
  std::vector<AxisImage> images;
  std::vector<DriveSetpoint> drives;
  std::int64_t tick = -1;
};

Table one_screw() {
  return Table({{.name = "x", .config = corrected(screw, 0), .references = {0}}});
}

TEST(AxisCompensation, TheDriveReceivesTheSetpointPlusTheCorrection) {
  Table axis = one_screw();
  axis.on(0);
  double drive = axis.drives[0].position;
  int judged = 0;
  for (const double to : {700.0, -250.0, 450.0, 900.0})
    axis.move(0, to, [&] {
      const Tick& now = axis.images[0].tick;
      EXPECT_NEAR(axis.drives[0].position + now.offset, now.position + of_screw(now.position),
                  1e-12);
      EXPECT_NEAR(now.following_error, 0, 1e-12)
          << "an ideal drive is where the corrected setpoint is";
      EXPECT_LE(std::abs(axis.drives[0].position - drive), (500 + 500 * 0.0035) * 1e-3 + 1e-9);
      drive = axis.drives[0].position;
      ++judged;
    });
  EXPECT_GT(judged, 5000);
  EXPECT_NEAR(axis.images[0].tick.correction[0], -0.1, 1e-12) << "900: outside of the grid";
}

TEST(AxisCompensation, TheVelocityOfTheDriveIsTheDerivativeOfItsPosition) {
  CompensationSpec smooth = screw;
  smooth.rule = GridRule::cubic;
  Table axis({{.name = "x", .config = corrected(smooth, 0), .references = {0}}});
  axis.on(0);
  Jet before = axis.images[0].tick.correction;
  double most = 0;
  axis.move(0, 600, [&] {
    const Jet& now = axis.images[0].tick.correction;
    EXPECT_NEAR(now[0] - before[0], (before[1] + now[1]) / 2 * 1e-3, 5e-6);
    EXPECT_EQ(axis.drives[0].velocity, axis.images[0].tick.velocity + now[1]);
    most = std::max(most, std::abs(now[1]));
    before = now;
  });
  EXPECT_GT(most, 1) << "2.5e-3 in a tick";
}

TEST(AxisCompensation, SwitchingOnAndOffMovesNothing) {
  Table axis = one_screw();
  axis.home(0);
  axis.step(0, {command::Enable{}});
  axis.move(0, 450, [] {});
  axis.step(0, {command::Disable{}});
  const double drive = axis.drives[0].position;
  const Tick on = axis.step(0, {command::EnableCompensation{}});
  EXPECT_EQ(refusal(on), Cause::none);
  EXPECT_TRUE(on.compensated);
  EXPECT_NEAR(axis.drives[0].position, drive, 1e-12);
  EXPECT_NEAR(on.position + of_screw(on.position), 450, 1e-12)
      << "only the name of the place changes";
  axis.step(0, {command::Enable{}});
  for (int i = 0; i < 10; ++i) {
    axis.step(0);
    EXPECT_NEAR(axis.drives[0].position, drive, 1e-12);
  }
  axis.step(0, {command::Disable{}});
  const Tick off = axis.step(0, {command::DisableCompensation{}});
  EXPECT_EQ(refusal(off), Cause::none);
  EXPECT_FALSE(off.compensated);
  EXPECT_NEAR(off.position, 450, 1e-12);
  EXPECT_EQ(off.correction[0], 0);
  EXPECT_NEAR(axis.drives[0].position, drive, 1e-12);
}

TEST(AxisCompensation, ADisabledAxisFollowsItsDriveByHand) {
  Table axis = one_screw();
  axis.home(0);
  axis.step(0, {command::EnableCompensation{}});
  for (double drive = 0; drive < 800; drive += 7.3) {
    axis.drives[0].position = drive;
    const Tick now = axis.step(0);
    EXPECT_NEAR(now.position + of_screw(now.position), drive + now.offset, 1e-11);
    EXPECT_NEAR(axis.drives[0].position, drive, 1e-11);
  }
}

TEST(AxisCompensation, MistakesAreRejectedWithTheirReason) {
  Table plain({{.name = "x", .config = {.limits = limits(500, 5000)}}});
  EXPECT_EQ(refusal(plain.step(0, {command::EnableCompensation{}})), Cause::no_compensation);
  EXPECT_EQ(refusal(plain.step(0, {command::DisableCompensation{}})), Cause::no_compensation);
  plain.step(0, {command::Enable{}});
  EXPECT_EQ(refusal(plain.step(0, {command::EnableCompensation{}})), Cause::no_compensation)
      << "not `enabled`: disabling the axis would not help";

  Table axis = one_screw();
  const auto on = [&] { return refusal(axis.step(0, {command::EnableCompensation{}})); };
  const auto off = [&] { return refusal(axis.step(0, {command::DisableCompensation{}})); };
  EXPECT_EQ(on(), Cause::not_homed);
  EXPECT_EQ(off(), Cause::compensation_inactive);
  axis.home(0);
  axis.step(0, {command::Enable{}});
  EXPECT_EQ(on(), Cause::enabled);
  axis.step(0, {command::MoveAbsolute{.position = 100}});
  EXPECT_EQ(on(), Cause::in_motion);
  axis.step(0, {command::Abort{}});
  EXPECT_EQ(on(), Cause::enabled) << "in the fault";
  axis.step(0, {command::Disable{}});
  EXPECT_EQ(on(), Cause::none);
  EXPECT_EQ(on(), Cause::compensation_active) << "twice";
  EXPECT_EQ(refusal(axis.step(0, {command::SetPosition{.position = 1}})),
            Cause::compensation_active);
  axis.step(0, {command::Reset{}});
  axis.step(0, {command::Enable{}});
  axis.step(0);
  EXPECT_EQ(refusal(axis.step(0, {command::Home{}})), Cause::compensation_active);
  axis.step(0, {command::MoveAbsolute{.position = 50}});
  EXPECT_EQ(off(), Cause::in_motion);
}

TEST(AxisCompensation, TwoAxesCorrectEachOtherInTheSameTick) {
  // Example 2 of the manual for both axes, x with the references x, y and y with y, x.
  const CompensationSpec plate{.axes = {{-100, 200, 3}, {-100, 100, 3}},
                               .values = {0.3, 0.1, -0.4, -0.4, 0, 0.2, 0.2, -0.1, 0.5}};
  const auto of_plate = [&](double x, double y) {
    const double s = std::clamp((x + 100) / 200, 0.0, 2.0),
                 t = std::clamp((y + 100) / 100, 0.0, 2.0);
    const auto i = std::min<std::size_t>(static_cast<std::size_t>(s), 1);
    const auto j = std::min<std::size_t>(static_cast<std::size_t>(t), 1);
    const auto value = [&](std::size_t a, std::size_t b) { return plate.values[a + 3 * b]; };
    const double u = s - static_cast<double>(i), w = t - static_cast<double>(j);
    return (1 - w) * ((1 - u) * value(i, j) + u * value(i + 1, j)) +
           w * ((1 - u) * value(i, j + 1) + u * value(i + 1, j + 1));
  };
  Table table({{.name = "x", .config = corrected(plate, 0), .references = {0, 1}},
               {.name = "y", .config = corrected(plate, 0), .references = {1, 0}}});
  table.on(0);
  EXPECT_EQ(refusal(table.step(1, {command::SetPosition{.position = 3}})),
            Cause::compensation_active)
      << "x refers to y";
  table.step(1, {command::Enable{}});
  table.step(1, {command::MoveAbsolute{.position = 90, .dynamics = {.velocity = 100}}});
  table.move(0, 300, [&] {
    const Tick& x = table.images[0].tick;
    const Tick& y = table.images[1].tick;
    EXPECT_NEAR(x.correction[0], of_plate(x.position, y.position), 1e-12);
    EXPECT_FALSE(y.compensated);
    EXPECT_EQ(y.correction[0], 0);
  });
}

TEST(AxisCompensation, ThreeReferences) {
  const CompensationSpec cube{.axes = {{-10, 20, 3}, {5, 10, 3}, {0, 30, 3}},
                              .values = {.3, .1, .2, -.2, 0,  .1, -.1, .3,  .4, .2, -.1, .4, .2, 0,
                                         .2, .3, .1, .1,  .4, .3, -.2, -.2, .1, .2, -.2, .1, -.4}};
  LiveCompensation live({.table = cube, .own = 0}, 0);
  live.set(true);
  const auto at = [&](double x, double y, double z) {
    live.see({Jet{x, 0, 0, 0}, Jet{y, 0, 0, 0}, Jet{z, 0, 0, 0}});
    return live.correction()[0];
  };
  EXPECT_NEAR(at(-10, 5, 0), 0.3, 1e-12);
  EXPECT_NEAR(at(10, 15, 30), 0, 1e-12);
  EXPECT_NEAR(at(30, 25, 60), -0.4, 1e-12);
  EXPECT_NEAR(at(99, 99, 99), -0.4, 1e-12) << "outside of the grid";
}

std::string error_of(const AxisCompensation& spec, double modulo) {
  try {
    (void)LiveCompensation(spec, modulo);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(AxisCompensation, ATableThatCannotBeInvertedOrDoesNotCloseIsRejected) {
  const CompensationSpec steep{.axes = {{0, 1, 3}}, .values = {0, 0.6, 0}};
  EXPECT_THAT(error_of({.table = steep, .own = 0}, 0), HasSubstr("at most 0.5 times is permitted"));
  EXPECT_EQ(error_of({.table = steep}, 0), "") << "another axis may change it quickly";
  const CompensationSpec turn{.axes = {{0, 90, 5}}, .values = {0.1, 0.2, 0, -0.1, 0.1}};
  EXPECT_EQ(error_of({.table = turn, .own = 0}, 360), "");
  CompensationSpec open = turn;
  open.values.back() = 0.2;
  EXPECT_THAT(error_of({.table = open, .own = 0}, 360), HasSubstr("values[5] = 0.2: must be 0.1"));
  EXPECT_THAT(error_of({.table = turn, .own = 0}, 270), HasSubstr("within one turn"));
}

TEST(AxisCompensation, AModuloAxisTakesTheCorrectionOfItsTurn) {
  const CompensationSpec turn{.axes = {{0, 90, 5}}, .values = {0.1, 0.2, 0, -0.1, 0.1}};
  AxisConfig config = corrected(turn, 0);
  config.modulo = 360;
  Table axis({{.name = "c", .config = config, .references = {0}}});
  axis.on(0);
  double drive = axis.drives[0].position;
  axis.step(0, {command::MoveRelative{.distance = 1000}});
  for (int i = 0; i < 3000; ++i) {
    const Tick now = axis.step(0);
    const double s = std::fmod(now.position + 3600, 360) / 90;
    const auto k = static_cast<std::size_t>(s);
    const double w = s - static_cast<double>(k);
    EXPECT_NEAR(now.correction[0], (1 - w) * turn.values[k] + w * turn.values[k + 1], 1e-9);
    EXPECT_LE(std::abs(axis.drives[0].position - drive), 500e-3 * 1.003);
    drive = axis.drives[0].position;
  }
  EXPECT_EQ(axis.images[0].tick.state, State::standstill);
}

TEST(AxisCompensation, TheReferencesMustFitTheTable) {
  const auto error = [](std::vector<MachineAxis> axes) -> std::string {
    try {
      (void)Machine(std::move(axes));
      return "";
    } catch (const InputError& e) {
      return e.what();
    }
  };
  EXPECT_THAT(error({{.name = "x", .config = corrected(screw, 0)}}), HasSubstr("must be 1 axes"));
  EXPECT_THAT(error({{.name = "x", .config = corrected(screw, 0), .references = {4}}}),
              HasSubstr("no such axis"));
  EXPECT_THAT(error({{.name = "x", .config = corrected(screw, std::nullopt), .references = {0}}}),
              HasSubstr("at the index own of the table"));
}

}  // namespace
}  // namespace jounce::axis_compensation_test
