// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "tests/path/paths.hpp"

namespace jounce::plan_test {
namespace {

using path_tests::usual;

Program square(Corner corner, double value) {
  Program p(2);
  p.set({.velocity = 100, .corner = corner, .value = value});
  p.line({100, 0}, 1);
  p.line({100, 100}, 2);
  p.line({0, 100}, 3);
  p.line({0, 0}, 4);
  return p;
}

// spec/path.md, 3: rows 1 to 4 and 6 to 9.

TEST(Plan, ALineWholeOrInPieces) {
  Program whole(1);
  whole.set({.velocity = 100});
  whole.line({200});
  EXPECT_NEAR(plan(whole, usual(1)).duration(), 2.2, 1e-12);
  Program pieces(2);
  pieces.set({.velocity = 100});
  for (int i = 1; i <= 2000; ++i) pieces.line({0.1 * i, 0});
  const Plan cut = plan(pieces, usual(2));
  EXPECT_NEAR(cut.duration(), 2.2, 1e-9);
  EXPECT_TRUE(cut.corners().empty());
  const PlanAxes axes = to_axes(cut);
  path_tests::expect_whole(cut, axes, pieces);
  EXPECT_LE(path_tests::worst_ratio(axes, usual(2)), 1 + 1e-12);
}

TEST(Plan, RampsThatMeetLeaveNoCruiseBetweenThem) {
  // A cruise within rounding made a table break the jerk limit by 4e-10 of it.
  Program p(2, {-42.376, 31.435});
  p.set({.velocity = 100});
  p.line({-49.91965, 38.881992});
  const Plan made = plan(
      p, {.axes = {{.acceleration = 476, .jerk = 72879}, {.acceleration = 2307, .jerk = 89848}}});
  ASSERT_EQ(made.law().stretches().size(), 1u);
  std::array<LawPhase, 7> phase;
  EXPECT_EQ(phases(made.law().stretches()[0], phase), 6u);
}

TEST(Plan, ASquareWithStops) {
  EXPECT_NEAR(plan(square(Corner::stop, 0), usual(2)).duration(), 4.8, 1e-12);
  EXPECT_NEAR(plan(square(Corner::stop, 0), usual(2, 1e5)).duration(), 4.44, 1e-12);
}

TEST(Plan, ASquareWithTurns) {
  // The third row in closed form: the share b of the fastest turn solves (4 - k) b^2 - 6 b + 3 = 0, k = 24 J^2 c / A^3,
  // c = e / |D|. The table has 15.795152, of a share rounded to 0.3877; the root is 4.5e-5 faster.
  const double offset = 0.05 / std::sqrt(2.0);
  const double k = 24 * 1e10 * offset / 1e9;
  const double share = (6 - std::sqrt(36 - 12 * (4 - k))) / (2 * (4 - k));
  const double length = offset * 24 * (1 - share) / (3 - 6 * share + 4 * share * share);
  const double v = std::sqrt(1000 * (1 - share) * length);
  // Legs by ramps from 100 mm/s to v and to rest, T(dv) = dv / A + A / J.
  const auto lost = [](double from) {
    return ((100 - from) / 1000 + 0.01) * (1 - (100 + from) / 200);
  };
  const double duration = (400 - 3 * length) / 100 + 2 * lost(0) + 6 * lost(v) + 3 * length / v;
  const struct {
    double deviation, jerk, velocity, duration;
  } rows[] = {{1, 1e4, 56.462162, 4.568655},
              {4, 1e4, 100, 4.2},
              {0.05, 1e5, v, duration},
              {4, 1e5, 100, 4.11}};
  for (const auto& row : rows) {
    const Program p = square(Corner::deviation, row.deviation);
    const Plan turned = plan(p, usual(2, row.jerk));
    EXPECT_NEAR(turned.duration(), row.duration, 5e-7) << row.deviation << " " << row.jerk;
    ASSERT_EQ(turned.corners().size(), 3u);
    for (const CornerRecord& c : turned.corners()) {
      EXPECT_NEAR(c.velocity, row.velocity, 5e-7);
      EXPECT_NEAR(c.angle, std::numbers::pi / 2, 1e-12);
      EXPECT_LE(c.deviation, row.deviation * (1 + 1e-12));
      EXPECT_FALSE(c.stop);
      EXPECT_EQ(c.note, JunctionNote::none);
    }
    const PlanAxes axes = to_axes(turned);
    path_tests::expect_whole(turned, axes, p);
    EXPECT_LE(path_tests::worst_ratio(axes, usual(2, row.jerk)), 1 + 1e-12);
    EXPECT_EQ(axes.error[0][0], 0);
  }
}

TEST(Plan, ATurnThatIsSlowerThanAStopIsAStop) {
  for (const double deviation : {0.05, 0.1}) {
    const Plan stopped = plan(square(Corner::deviation, deviation), usual(2));
    EXPECT_LE(stopped.duration(), 4.8 + 1e-12);
    EXPECT_NEAR(stopped.stop_duration(), 4.8, 1e-12);
    for (const CornerRecord& c : stopped.corners()) {
      EXPECT_TRUE(c.stop);
      EXPECT_EQ(c.note, JunctionNote::slower);
    }
  }
}

TEST(Plan, AStopAtACornerOfAFastFollowerHasItsCause) {
  // The corner of a follower that turns 12 deg/mm: the rounding is passed at about 10 mm/s (0.1) or 15 mm/s (0.2).
  GroupLimits limits{
      .axes = std::vector<Limits>(2, {.velocity = 200, .acceleration = 1500, .jerk = 30000})};
  limits.axes.push_back({.velocity = 400, .acceleration = 4000, .jerk = 80000});
  const auto made = [&](double deviation, Corner first, Corner second) {
    Program p(3, {}, 2);
    p.set({.velocity = 150, .corner = Corner::deviation, .value = deviation});
    p.line({0, -40, 0}, 1);
    p.set({.velocity = 150, .corner = first, .value = deviation});
    p.line({30, -40, 360}, 2);
    p.set({.velocity = 150, .corner = second, .value = deviation});
    p.line({30, 0, 360}, 3);
    return plan(p, limits);
  };
  for (const double deviation : {0.05, 0.1, 0.2}) {
    const Plan stopped = made(deviation, Corner::deviation, Corner::deviation);
    ASSERT_EQ(stopped.corners().size(), 2u);
    for (const CornerRecord& c : stopped.corners()) {
      EXPECT_TRUE(c.stop);
      EXPECT_EQ(c.note, JunctionNote::slower) << deviation;
    }
    // No choice of the two stops is faster.
    for (const auto& [first, second] :
         {std::pair{Corner::stop, Corner::deviation}, std::pair{Corner::deviation, Corner::stop},
          std::pair{Corner::stop, Corner::stop}})
      EXPECT_LE(stopped.duration(), made(deviation, first, second).duration() * (1 + 1e-12));
  }
  for (const CornerRecord& c : made(1, Corner::deviation, Corner::deviation).corners())
    EXPECT_FALSE(c.stop);
}

Program circle(double feed) {
  Program p(2);
  p.set({.velocity = feed});
  p.arc(arc_about({}, {50, 0}, {}, Plane{0, 1}, ArcRotation::counterclockwise), 1);
  return p;
}

TEST(Plan, ACircleKeepsItsLimitsAndItsBound) {
  const GroupLimits limits = usual(2);
  const Plan round = plan(circle(100), limits);
  const PlanAxes axes = to_axes(round, 1e-9);
  path_tests::expect_whole(round, axes, circle(100));
  EXPECT_LE(path_tests::worst_ratio(axes, limits),
            1 + 1e-9);  // a fit: its jerk within its certificate
  EXPECT_LE(lower_bound(round), round.duration());
  EXPECT_GT(round.duration(), 3.241727);
  EXPECT_LT(round.duration(), 3.40);
}

TEST(Plan, TheBoundOfACircle) {
  // Rows 6 and 7: the total acceleration is bounded, the jerk is not.
  GroupLimits limits{.axes = std::vector<Limits>(2), .path = {.total_acceleration = 1000}};
  const double R = 50;
  const double whole = std::sqrt(R / 1000) * (2.6220575543 + 3 * std::numbers::pi / 2);
  EXPECT_NEAR(lower_bound(plan(circle(PathSettings::none), limits), 20000), 1.640032, 2e-6);
  EXPECT_NEAR(whole, 1.640032, 5e-7);
  EXPECT_NEAR(lower_bound(plan(circle(100), limits), 20000), 3.241727, 2e-6);
}

TEST(Plan, AHelixIsAsLongAsItsSpatialCurve) {
  Program p(3);
  p.set({.velocity = 100});
  p.arc(arc_about({}, {50, 0}, {0, 0, 100}, Plane{0, 1}, ArcRotation::counterclockwise, 4), 1);
  const Plan screw = plan(p, usual(3));
  EXPECT_NEAR(screw.path().length(), 1573.976207, 5e-7);
  std::vector<Jet> jets(3);
  screw.path().jets(0, 700, jets);
  double curvature = 0;
  double speed = 0;
  for (const Jet& j : jets) {
    curvature += j[2] * j[2];
    speed += j[1] * j[1];
  }
  EXPECT_NEAR(std::sqrt(curvature), 0.019919270, 5e-10);
  EXPECT_NEAR(speed, 1, 1e-12);
  const PlanAxes axes = to_axes(screw, 1e-8);
  path_tests::expect_whole(screw, axes, p);
}

TEST(Plan, DwellsAreExact) {
  Program p(1);
  p.set({.velocity = 100});
  p.dwell(0.1234567);
  p.line({100});
  p.dwell(0.3);
  p.dwell(0.0333);
  p.line({200});
  p.dwell(0.5);
  const Plan waits = plan(p, usual(1));
  EXPECT_NEAR(waits.duration(), 0.1234567 + 1.2 + 0.3333 + 1.2 + 0.5, 1e-12);
  const PlanAxes axes = to_axes(waits);
  path_tests::expect_whole(waits, axes, p);
  EXPECT_EQ(axes.curves[0].at(0.1).position, 0);
  EXPECT_EQ(axes.curves[0].at(1.4).position, 100);
}

TEST(Plan, TrapezoidsOfTheSeeds) {
  // PMC600 8.1 to 8.6 as spec/seed-pmc600-group.md computes them: no jerk limit, tangential acceleration.
  const auto seed = [](std::size_t n, std::size_t m, double v, double a) {
    Program p(n, {}, m);
    p.set({.velocity = v, .acceleration = a});
    return p;
  };
  const GroupLimits four{.axes = std::vector<Limits>(4)};
  Program line = seed(4, 3, 1000, 1000);
  line.line({500, 1000, 1000, 2000});
  EXPECT_NEAR(plan(line, four).duration(), 2.5, 1e-12);
  Program next = seed(4, 3, 1000, 1000);
  next.line({1500, 500, 1000, 1000});
  EXPECT_NEAR(plan(next, four).duration(), 2.870829, 5e-7);
  const GroupLimits two{.axes = std::vector<Limits>(2)};
  Program arcs = seed(2, 2, 10000, 20000);
  arcs.arc(arc_of_radius({}, 5000, {10000, 0}, Plane{0, 1}, ArcRotation::clockwise));
  EXPECT_NEAR(plan(arcs, two).duration(), 2.070796, 5e-7);
  Program second = seed(2, 2, 10000, 20000);
  second.line({0, 0});
  Program other(2, {10000, 0});
  other.set({.velocity = 10000, .acceleration = 20000});
  other.arc(
      arc_of_radius({10000, 0}, 10000, {30000, 0}, Plane{0, 1}, ArcRotation::counterclockwise));
  EXPECT_NEAR(plan(other, two).duration(), 3.641593, 5e-7);
  Program lines = seed(2, 2, 1000, 2000);
  lines.line({1000, 1000});
  lines.line({3000, 2000});
  lines.line({4000, 0});
  EXPECT_NEAR(plan(lines, two).duration(), 7.386350, 5e-6);
  Program turns = seed(3, 3, 1e4, 2e4);
  turns.arc(arc_of_radius({}, 5000, {10000, 0}, Plane{0, 1}, ArcRotation::clockwise, 3));
  const GroupLimits three{.axes = std::vector<Limits>(3)};
  EXPECT_NEAR(plan(turns, three).path().length(), 109955.743, 5e-4);
}

TEST(Plan, BadInputNamesItsLine) {
  const auto error = [](auto make) {
    try {
      make();
    } catch (const InputError& e) {
      return std::to_string(e.line()) + ": " + e.key();
    }
    return std::string("none");
  };
  EXPECT_EQ(error([] {
              Program p(2);
              p.line({1, std::nan("")}, 7);
            }),
            "7: to[2]");
  EXPECT_EQ(error([] {
              Program p(2);
              p.line({1, 1, 1}, 8);
            }),
            "8: to[3]");
  EXPECT_EQ(error([] {
              Program p(1);
              p.line({5}, 3);
              plan(p, {.axes = {{.velocity = 1}}});
            }),
            "3: acceleration");
  EXPECT_EQ(error([] {
              Program p(1);
              p.line({5}, 4);
              plan(p, {.axes = {{.position_max = 4, .acceleration = 1}}});
            }),
            "4: to[1]");
  EXPECT_EQ(error([] {
              Program p(1);
              p.line({0}, 4);
              plan(p, usual(1));
            }),
            "4: program");
  EXPECT_EQ(error([] { plan(Program(1), usual(1)); }), "0: program");
  EXPECT_EQ(error([] { plan(Program(2), usual(1)); }), "0: axes");
}

TEST(TimingLaw, FindsTheIntervalOfAnyInstant) {
  // Legs from 1e-6 to 1e3: the intervals are very unequal. The expected result is that of a search over all of them.
  path_tests::Random random(7);
  Program program(2);
  program.set({.velocity = 100, .corner = Corner::deviation, .value = 0.01});
  Point at{};
  for (int i = 1; i <= 300; ++i) {
    for (std::size_t k = 0; k < 2; ++k) at[k] += random.log_between(1e-6, 1e3);
    program.line(at, i);
  }
  const Plan motion = plan(program, path_tests::usual(2));
  const std::vector<LawInterval> all = motion.law().stretches().unpacked();
  const auto expected = [&](double t) {
    const auto behind = std::upper_bound(all.begin() + 1, all.end(), t,
                                         [](double x, const LawInterval& s) { return x < s.time; });
    return static_cast<std::size_t>(behind - all.begin()) - 1;
  };
  const auto check = [&](double t) { ASSERT_EQ(motion.law().find(t).index(), expected(t)) << t; };
  for (const LawInterval& s : all)
    for (const double t : {std::nextafter(s.time, -1.0), s.time, std::nextafter(s.time, 1e9)})
      check(t);
  for (int i = 0; i < 10000; ++i) check(random.between(-1, motion.duration() + 1));
}

// ---- limits of axes in commands ---------------------------------------------------------------

/// On one axis, the limits of the axis are those along the path.
TEST(Plan, AShortArcBesideAVerySlowCornerIsPlanned) {
  // The ramp from a thousandth of the greatest velocity to that of the corner was longer than the arc.
  Program p(3, {-125.17003830427943, 0, 92.246339404483294});
  p.set({.corner = Corner::curvature, .value = 1.1613432246680893});
  p.line({-115.6246176471863, 6.6536793767969096, 86.755908662962355}, 1);
  p.arc(arc_through(p.position(), {-115.29779496738867, 5.7900311018657744, 86.427754140501193},
                    {-114.9583342361762, 4.9426055656462005, 86.071351040120419}, 3),
        2);
  p.set(
      {.velocity = 0.018184728631076633, .corner = Corner::curvature, .value = 1.1613432246680893});
  p.arc(arc_through(p.position(), {-114.93300563981795, 4.8327073408505203, 86.031129229910036},
                    {-114.94296671109255, 4.7165363732495207, 86.003888911097121}, 3),
        3);
  const GroupLimits limits{.axes = {{.velocity = 147, .acceleration = 288, .jerk = 1.2e7},
                                    {.velocity = 656, .acceleration = 133, .jerk = 8.4e6},
                                    {.velocity = 4579, .acceleration = 620, .jerk = 378}}};
  const Plan made = plan(p, limits);
  const PlanAxes axes = to_axes(made);
  path_tests::expect_whole(made, axes, p);
  EXPECT_LE(path_tests::worst_ratio(axes, limits), 1 + 1e-12);
}

TEST(Plan, TheJerkOfRampsOf10MicrosecondsOnAnArcKeepsItsLimit) {
  // The table of such a ramp exceeded the limit of the jerk by 1.6e-5 of it.
  Program p(2, {-31.456381813969376, -48.999632396641367});
  p.set({.velocity = 2.8864641698850559});
  p.arc(arc_through(p.position(), {-31.344471705986287, -49.7641512601515},
                    {-31.01078602438746, -50.461049266195097}, 2));
  const GroupLimits limits{
      .axes = {{.acceleration = 1017.4555673048253, .jerk = 711550.56622446992},
               {.acceleration = 6.3578496791281545, .jerk = 638170.0954683451}}};
  const PlanAxes axes = to_axes(plan(p, limits));
  EXPECT_LE(path_tests::worst_ratio(axes, limits), 1 + 1e-12);
}

TEST(Plan, LimitsOfAnAxisInACommandAreThoseAlongALineOfThisAxis) {
  const auto made = [](bool of_axis) {
    Program p(1);
    p.set({.velocity = 150});
    p.line({60}, 1);
    if (of_axis)
      p.set({.velocity = 150, .axes = {{.velocity = 20, .acceleration = 300, .jerk = 5000}}});
    else
      p.set({.velocity = 20, .acceleration = 300, .deceleration = 300, .jerk = 5000});
    p.line({80}, 2);
    p.set({.velocity = 150});
    p.line({140}, 3);
    return plan(p, usual(1));
  };
  const Plan axis = made(true);
  const Plan path = made(false);
  EXPECT_NEAR(axis.duration(), path.duration(), 1e-12);
  for (const double t : {0.3, 0.6, 1.0, 1.5, 2.0})
    EXPECT_NEAR(axis.law().at(t).velocity, path.law().at(t).velocity, 1e-9) << t;
}

/// The path keeps its corners; lower limits begin where the path reaches their command.
TEST(Plan, LimitsOfAxesInCommandsKeepThePath) {
  const auto made = [](std::vector<AxisRates> axes) {
    Program p(2);
    p.set({.velocity = 100, .corner = Corner::deviation, .value = 0.5});
    p.line({100, 0}, 1);
    p.set({.velocity = 100, .corner = Corner::deviation, .value = 0.5, .axes = std::move(axes)});
    p.line({100, 100}, 2);
    p.set({.velocity = 100, .corner = Corner::deviation, .value = 0.5});
    p.line({0, 100}, 3);
    return plan(p, usual(2));
  };
  const Plan free = made({});
  const Plan limited = made({{}, {.velocity = 25}});  // y
  ASSERT_EQ(limited.path().pieces().size(), free.path().pieces().size());
  EXPECT_EQ(limited.path().length(), free.path().length());
  double fastest = 0;
  for (const LawInterval& s : limited.law().stretches())
    if (limited.path().pieces()[s.piece].line == 2) fastest = std::max(fastest, s.peak);
  EXPECT_NEAR(fastest, 25, 1e-9);
  EXPECT_GT(limited.duration(), free.duration() + 2);
  EXPECT_NEAR(limited.law().stretches().front().peak, free.law().stretches().front().peak, 1e-9);
  EXPECT_LE(limited.duration(), limited.stop_duration());
  EXPECT_GE(limited.duration(), lower_bound(limited));
}

TEST(Plan, LimitsOfAxesInCommandsAreChecked) {
  Program p(2);
  EXPECT_THROW(p.set({.axes = {{.velocity = 0}}}), InputError);
  EXPECT_THROW(p.set({.axes = {{.jerk = -1}}}), InputError);
  p.set({.velocity = 10, .axes = std::vector<AxisRates>(3, {.velocity = 5})});
  p.line({10, 0}, 7);
  EXPECT_THROW(plan(p, usual(2)), InputError) << "three axes";
}

TEST(Plan, WritesTheMotionOfEachAxis) {
  const Plan made = plan(square(Corner::stop, 0), usual(2));
  std::vector<Motion> out(3);
  PlanCursor cursor(made);
  for (const std::size_t n : {1U, 3U}) {
    EXPECT_THROW(made.at(0.1, std::span(out).first(n)), InputError);
    EXPECT_THROW(cursor.at(0.1, std::span(out).first(n)), InputError);
  }
  std::vector<Jet> jets(1);
  EXPECT_THROW(made.path().jets(0, 0, jets), InputError);
}

Program zigzag(int lines) {
  Program p(3);
  p.set({.velocity = 100, .corner = Corner::deviation, .value = 0.5});
  for (int i = 1; i <= lines; ++i) p.line({5.0 * i, i % 2 == 0 ? 0.0 : 5.0, 0.1 * (i % 7)}, i);
  return p;
}

TEST(Plan, ALineWithARoundedCornerNeedsAtMost250Bytes) {
  constexpr int lines = 1000;
  const Plan made = plan(zigzag(lines), usual(3));
  const std::size_t bytes =
      made.path().bytes() + made.law().bytes() + made.junctions().size_bytes();
  EXPECT_EQ(made.path().pieces().size(), 2 * lines - 1);
  EXPECT_LE(bytes, 250 * lines);
}

/// All numbers of a plan of lines and turns.
std::vector<double> numbers_of(const Plan& motion) {
  std::vector<double> all{motion.stop_duration()};
  for (const LawInterval& s : motion.law().stretches())
    all.insert(all.end(), {s.time, s.start, s.length, s.v0, s.peak, s.v1, s.acceleration,
                           s.deceleration, s.jerk, s.duration});
  std::array<Jet, 3> jets;
  for (std::size_t k = 0; k < motion.path().pieces().size(); ++k) {
    motion.path().jets(k, motion.path().pieces()[k].length / 3, jets);
    for (const Jet& jet : jets) all.insert(all.end(), jet.begin(), jet.end());
  }
  return all;
}

// A thread keeps the memory of its last plan. The sides of `chain` are so short that ramps are joined.
TEST(Plan, TheLastPlanOfTheThreadChangesNothing) {
  Program chain(3);
  chain.set({.velocity = 100, .corner = Corner::deviation, .value = 0.05});
  for (int i = 1; i <= 200; ++i)
    chain.line({std::sin(0.02 * i) * 40 + 0.5 * std::sin(1.7 * i), std::sin(0.04 * i) * 40, 0}, i);
  const Plan joined = plan(chain, usual(3));
  EXPECT_TRUE(std::ranges::any_of(joined.law().stretches(),
                                  [](const LawInterval& s) { return s.pieces > 1; }));
  const std::array programs{zigzag(30), chain, zigzag(900), zigzag(31)};
  const auto all = [&] {
    std::vector<std::vector<double>> plans;
    for (const bool stop : {true, false})
      for (const Program& program : programs)
        plans.push_back(numbers_of(plan(program, usual(3), {.stop_at_corners = stop})));
    return plans;
  };
  const auto after_others = all();
  EXPECT_EQ(all(), after_others);
  for (std::size_t k = 0; k < after_others.size(); ++k) {
    std::vector<double> alone;
    std::thread([&] {
      alone = numbers_of(
          plan(programs[k % programs.size()], usual(3), {.stop_at_corners = k < programs.size()}));
    }).join();
    EXPECT_EQ(alone, after_others[k]) << k;
  }
}

TEST(Plan, TheLowerBoundOfALongProgramIsTheSumOfThoseOfItsParts) {
  constexpr std::size_t lines = 3000;
  constexpr std::size_t rest = 700;
  const Program whole = zigzag(lines);
  Program with_rest(3);
  for (std::size_t k = 0; k < lines; ++k) {
    if (k == rest) with_rest.dwell(0.5);
    with_rest.set(whole.settings()[whole.commands()[k].settings]);
    with_rest.line(whole.place_before(k + 1));
  }
  const auto bound = [](const Program& p) { return lower_bound(plan(p, usual(3)), 4); };
  const double parts = bound(whole.part(0, rest)) + 0.5 + bound(whole.part(rest, lines));
  EXPECT_NEAR(bound(with_rest), parts, 1e-12 * parts);
}

}  // namespace
}  // namespace jounce::plan_test
