// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/algebra/algebra.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/limits/limits.hpp"

#include "cam/design/random_cams.hpp"
#include "support/errors.hpp"
#include "support/fig_6_14.hpp"

namespace jounce::algebra_test {
namespace {

constexpr double pi = std::numbers::pi;

Cam rise_and_return(Law law, double period, double stroke,
                    Extrapolation outside = Extrapolation::wrap) {
  CamSpec spec;
  spec.segments = {{law, {period / 3, stroke, {}, {}}, ""},
                   {Law::dwell, {period / 2, stroke, {}, {}}, ""},
                   {law, {period, 0, {}, {}}, ""}};
  return with(design(spec).cam, outside);
}

template <class Make>
std::string complaint(Make make) {
  return test::error_of([&] { (void)make(); });
}

/// g(x) is f(at(x)) within rounding of the places, away from the breaks of g.
template <class At>
void expect_values(const Cam& g, const Cam& f, At at, double factor = 1, double offset = 0) {
  const Range range = extrema(f, 0);
  const double rounding =
      1e-13 * std::abs(range.peak().value) +
      1e-15 * std::abs(extrema(f, 1).peak().value) *
          (std::abs(f.start()) + std::abs(f.end()) + std::abs(g.start()) + std::abs(g.end()));
  for (std::size_t i = 0; i < g.segments().size(); ++i)
    for (int n = 1; n < 8; ++n) {
      const double x = g.breaks()[i] + g.segments()[i].length * n / 8;
      EXPECT_NEAR(g.at(x).position, factor * f.at(at(x)).position + offset, rounding) << x;
    }
}

/// f + g, wherever both are defined, within rounding of places.
void expect_sum(const Cam& h, const Cam& f, const Cam& g, double tolerance) {
  for (std::size_t i = 0; i < h.segments().size(); ++i)
    for (int n = 1; n < 8; ++n) {
      const double x = h.breaks()[i] + h.segments()[i].length * n / 8;
      EXPECT_NEAR(h.at(x).position, f.at(x).position + g.at(x).position, tolerance) << x;
    }
}

// ---- part, phase, splice ----------------------------------------------------------------------

TEST(Part, IsTheCamBetweenTwoMasterPositions) {
  const Cam cam = design(test::fig_6_14()).cam;
  const Cam window = part(cam, 30, 300);
  EXPECT_EQ(window.start(), 30);
  EXPECT_EQ(window.end(), 300);
  EXPECT_EQ(window.segments().size(), 4U);
  EXPECT_EQ(window.outside(), Extrapolation::refuse);
  expect_values(window, cam, [](double x) { return x; });
  EXPECT_EQ(part(cam, 75, 200).segments().size(), 1U) << "whole segments are not cut";
  EXPECT_EQ(part(cam, 75, 200).segments()[0].c, cam.segments()[1].c);
}

TEST(Part, ContinuesAsTheCamOutsideItsInterval) {
  const Cam cam = rise_and_return(Law::modified_sine, 360, 50);
  const Cam turns = part(cam, 300, 1100);
  EXPECT_NEAR(turns.length(), 800, 1e-12);
  expect_values(turns, cam, [](double x) { return x; });
  const Cam before = part(cam, -1000, -700);
  expect_values(before, cam, [](double x) { return x; });

  const Cam holding = with(cam, Extrapolation::hold);
  const Cam around = part(holding, -10, 400);
  EXPECT_EQ(around.segments().size(), cam.segments().size() + 2);
  EXPECT_NEAR(around.at(-5).position, 0, 1e-12);
  EXPECT_NEAR(around.at(380).position, 0, 1e-12);
  EXPECT_EQ(part(holding, 500, 600).segments().size(), 1U);

  EXPECT_EQ(complaint([&] { return part(with(cam, Extrapolation::refuse), 0, 361); }),
            "to = 361: must lie within the cam, 0 to 360");
  EXPECT_EQ(complaint([&] { return part(cam, 5, 5); }), "to = 5: must be greater than from = 5");
  EXPECT_EQ(complaint([&] { return part(cam, 0, 1e9); }),
            "to = 1000000000: is more than 1e6 segments away from 0");
  EXPECT_EQ(complaint([&] { return part(cam, 360, 360 + 1e-12); }),
            "to = 360.000000000001: is so near to 360 that no cam remains between them");
}

TEST(Part, AndTheRestAreTheWhole) {
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const Cam cam = test::random_cam(random, false);
    const double at = random.uniform(cam.start(), cam.end());
    const Cam whole = concatenated(part(cam, cam.start(), at), part(cam, at, cam.end()));
    EXPECT_NEAR(whole.end(), cam.end(), 4e-16 * std::max(std::abs(cam.end()), cam.length()));
    expect_values(whole, cam, [](double x) { return x; });
    if (HasFailure()) break;
  }
}

TEST(Phased, IsLaterByThePhase) {
  const Cam cam = rise_and_return(Law::modified_trapezoid, 360, 50);
  for (const double phase : {90.0, -90.0, 180.0, 360.0 * 7 + 33.3, 0.0, -720.0, 1e-14}) {
    const Cam later = phased(cam, phase);
    EXPECT_EQ(later.start(), 0);
    EXPECT_EQ(later.end(), 360) << phase;
    expect_values(later, cam, [&](double x) { return x - phase; });
    EXPECT_TRUE(check_continuity(later, 2).ok()) << phase;
  }
  EXPECT_EQ(phased(cam, -720).segments().size(), cam.segments().size());
  EXPECT_EQ(phased(cam, 120).segments().size(), cam.segments().size() + 1) << "one cut";
  EXPECT_EQ(phased(cam, 180).segments().size(), cam.segments().size())
      << "the wrap of the new one is a break of the old";
  EXPECT_EQ(complaint([&] { return phased(with(cam, Extrapolation::hold), 10); }),
            "phase = 10: needs a periodic cam: use `shifted` for others");
}

TEST(Phased, KeepsThePeriodToTheLastDigit) {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const Cam cam = test::random_cam(random, false, Extrapolation::wrap);
    const double phase = random.uniform(-3, 3) * cam.length();
    const Cam later = phased(cam, phase);
    EXPECT_EQ(later.start(), cam.start());
    EXPECT_EQ(later.end(), cam.end());
    if (HasFailure()) break;
  }
}

TEST(Advancing, ASlaveAdvancesTurnByTurn) {
  Segment f = line(360, 0, 120);
  f.sines = 1;
  f.sine[0] = {-20, 2 * pi, 0};
  const Cam cam({f}, 0, Extrapolation::advance);
  const Cam window = part(cam, -500, 1000);
  EXPECT_TRUE(check_continuity(window, 3).ok());
  expect_values(window, cam, [](double x) { return x; });
  for (const double phase : {90.0, -90.0, 1000.0, -1000.0}) {
    const Cam later = phased(cam, phase);
    EXPECT_TRUE(check_continuity(later, 3).ok()) << phase;
    EXPECT_NEAR(later.advance(), 120, 1e-12);
    expect_values(later, cam, [&](double x) { return x - phase; });
  }
  const Cam both = superimposed(cam, rise_and_return(Law::poly345, 240, 3));
  EXPECT_EQ(both.outside(), Extrapolation::advance);
  EXPECT_NEAR(both.advance(), 240, 1e-12);
  expect_sum(both, cam, rise_and_return(Law::poly345, 240, 3), 1e-12);
}

TEST(Spliced, ReplacesAStretch) {
  const Cam cam = design(test::fig_6_14()).cam;
  const Cam slower = replaced(cam, Cam({line(50, 125, 175)}, 100));
  EXPECT_EQ(slower.breaks().size(), 7U);
  EXPECT_EQ(slower.end(), 360);
  EXPECT_EQ(slower.outside(), Extrapolation::wrap);
  EXPECT_TRUE(check_continuity(slower, 2).ok()) << "the line is in step, as the cam is there";
  expect_values(slower, cam, [](double x) { return x; });
  EXPECT_EQ(replaced(cam, Cam({line(75, 0, 100)}, 0)).segments().size(), 4U);
  EXPECT_EQ(complaint([&] { return replaced(cam, Cam({line(50, 0, 0)}, 320)); }),
            "interval = 320 to 370: must lie within the cam, 0 to 360");
}

TEST(Spliced, InsertsAStretch) {
  const Cam cam = rise_and_return(Law::poly345, 360, 50);
  const Cam longer = inserted(cam, 150, Cam({line(40, 50, 50)}, 7));
  EXPECT_NEAR(longer.end(), 400, 1e-13);
  EXPECT_TRUE(check_continuity(longer, 2).ok());
  EXPECT_NEAR(longer.at(310).position, cam.at(270).position, 1e-13);
  EXPECT_EQ(inserted(cam, 0, Cam({line(1, 0, 0)})).at(0.5).position, 0);
  EXPECT_EQ(inserted(cam, 360, Cam({line(1, 3, 3)})).at(360.5).position, 3);
  EXPECT_FALSE(check_continuity(inserted(cam, 60, Cam({line(1, 0, 0)})), 0).ok())
      << "values are not moved";
  EXPECT_THROW(inserted(cam, 361, cam), InputError);
}

TEST(Mirrored, AboutTheMasterRunsTheOtherWay) {
  const Cam cam = rise_and_return(Law::inclined_sine, 360, 50);
  const Cam back = mirrored_about_master(cam, 100);
  EXPECT_EQ(back.start(), -160);
  EXPECT_EQ(back.end(), 200);
  expect_values(back, cam, [](double x) { return 200 - x; });
  expect_values(mirrored_about_master(back, 100), cam, [](double x) { return x; });
}

TEST(Mirrored, AboutTheSlaveMovesTheOtherWay) {
  const Cam cam = rise_and_return(Law::inclined_sine, 360, 50);
  const Cam down = mirrored_about_slave(cam, 10);
  expect_values(
      down, cam, [](double x) { return x; }, -1, 20);
}

// ---- superposed -------------------------------------------------------------------------------

TEST(Superimposed, PeriodicCamsRepeatToTheirCommonPeriod) {
  const Cam f = rise_and_return(Law::modified_sine, 360, 50);
  const Cam g = rise_and_return(Law::poly345, 240, 3);
  const Cam both = superimposed(f, g);
  EXPECT_EQ(both.start(), 0);
  EXPECT_EQ(both.end(), 720);
  EXPECT_EQ(both.outside(), Extrapolation::wrap);
  EXPECT_TRUE(check_continuity(both, 2).ok());
  expect_sum(both, f, g, 1e-12);
}

TEST(Superimposed, PeriodicCamsMayStartAnywhere) {
  const Cam f = rise_and_return(Law::modified_sine, 360, 50);
  const Cam g = shifted(rise_and_return(Law::poly345, 120, 3), 1017, 0);
  const Cam both = superimposed(f, g);
  EXPECT_EQ(both.end(), 360);
  EXPECT_TRUE(check_continuity(both, 2).ok());
  expect_sum(both, f, g, 1e-12);
}

TEST(Superimposed, CamsThatHoldReachFromTheFirstStartToTheLastEnd) {
  const Cam f = rise_and_return(Law::modified_sine, 360, 50, Extrapolation::hold);
  const Cam g = shifted(rise_and_return(Law::poly345, 100, 3, Extrapolation::hold), 300, 1);
  const Cam both = superimposed(f, g);
  EXPECT_EQ(both.start(), 0);
  EXPECT_EQ(both.end(), 400);
  EXPECT_EQ(both.outside(), Extrapolation::hold);
  expect_sum(both, f, g, 1e-12);
}

TEST(Superimposed, ACamThatRejectsGivesTheInterval) {
  const Cam f = part(rise_and_return(Law::modified_sine, 360, 50), 30, 500);
  const Cam g = rise_and_return(Law::poly345, 77, 3);  // no common period is needed
  for (const Cam& both : {superimposed(f, g), superimposed(g, f)}) {
    EXPECT_EQ(both.start(), 30);
    EXPECT_NEAR(both.end(), 500, 1e-12);
    EXPECT_EQ(both.outside(), Extrapolation::refuse);
    expect_sum(both, f, g, 1e-12);
  }
  EXPECT_THROW(superimposed(f, part(f, 40, 50)), InputError);
}

TEST(Superimposed, NamesWhatHasNoPeriod) {
  const Cam f = rise_and_return(Law::poly345, 360, 50);
  EXPECT_EQ(complaint([&] { return superimposed(f, rise_and_return(Law::poly345, 360.5, 1)); }), "")
      << "721 turns of one are 720 of the other";
  EXPECT_EQ(complaint([&] { return superimposed(f, rise_and_return(Law::poly345, 100 * pi, 1)); }),
            "period = 360 and 314.1592653589793: have no common period within 1000 turns: choose a "
            "ratio of whole numbers, or cut out a part with `part`");
  EXPECT_EQ(
      complaint([&] { return superimposed(f, with(f, Extrapolation::hold)); }),
      "period = 360: belongs to one of the two cams only; the other holds, so the sum does not "
      "repeat: cut one period out of the repeating cam with operator = \"part\"");
}

/// A Fourier cam of three harmonics.
Cam three_sines(double period, double angle) {
  Segment f = line(period, 0, 0);
  f.sines = 3;
  for (std::size_t i = 0; i < 3; ++i) f.sine[i] = {1, angle * static_cast<double>(i + 1), 0.3};
  return Cam({f}, 0, Extrapolation::wrap);
}

TEST(Superimposed, FitsWithinAToleranceWhatIsNoSegment) {
  const Cam f = three_sines(360, 2 * pi);
  const Cam g = scaled(three_sines(360, 8 * pi), 0.1);
  EXPECT_EQ(complaint([&] { return superimposed(f, g); }),
            "sum = 0: needs more than three sines in one segment");
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const auto fitted = superimposed(f, g, tolerance);
    EXPECT_LE(fitted.error[0], tolerance);
    EXPECT_GT(fitted.error[0], 0);
    expect_sum(fitted.curve, f, g, fitted.error[0] + 1e-14);
    EXPECT_TRUE(check_continuity(fitted.curve, 3, 1e-7).ok());
  }
  const auto exact = superimposed(f, f, 1e-6);
  EXPECT_EQ(exact.error, Jet{}) << "sines of one frequency are merged";
  EXPECT_EQ(exact.curve.segments().size(), 1U);
  EXPECT_THROW(superimposed(f, g, 0), InputError);
  EXPECT_THROW(superimposed(f, g, 1e-18), InputError);
}

TEST(Superimposed, AddsRandomCamsOfEveryLawAndScale) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const Cam f = test::random_cam(random, false, Extrapolation::wrap);
    const Cam any = test::random_cam(random, false, Extrapolation::wrap);
    const double ratio = (1 + random.below(4)) / (1.0 + random.below(4));
    const Cam g = shifted(scaled(shifted(any, -any.start()), 1, ratio * f.length() / any.length()),
                          f.start() + random.uniform(-2, 2) * f.length());
    const double tolerance = 1e-10 * (extrema(f, 0).max.value - extrema(f, 0).min.value +
                                      std::abs(extrema(g, 0).peak().value));
    const auto [both, error] = superimposed(f, g, tolerance);  // some laws have three sines
    EXPECT_LE(error[0], tolerance);
    EXPECT_EQ(both.start(), f.start());
    const auto reach = [](const Cam& c) {
      return 1e-12 * (std::abs(extrema(c, 0).peak().value) +
                      std::abs(extrema(c, 1).peak().value) * (std::abs(c.start()) + c.length()));
    };
    expect_sum(both, f, g, 1e-2 * reach(f) + reach(g) + reach(f) + error[0]);
    if (HasFailure()) break;
  }
}

// ---- composed ---------------------------------------------------------------------------------

TEST(Composed, ACamBehindACam) {
  // The camshaft turns 1:2 and holds; the cam on it is a quintic: exact.
  const Cam cam = design(test::fig_6_14()).cam;
  const Cam shaft({line(720, 0, 360)}, 0, Extrapolation::refuse);
  const Cam slave = composed(cam, shaft);
  EXPECT_EQ(slave.end(), 720);
  expect_values(slave, cam, [](double x) { return x / 2; });
  test::Random random(1);
  for (int i = 0; i < 50; ++i) {
    const double x = random.uniform(0, 720);
    EXPECT_NEAR(slave.at(x).geo_jerk, cam.at(x / 2).geo_jerk / 8, 1e-12);
  }
}

TEST(Composed, WithinAToleranceACamBehindAnyCam) {
  const Cam outer = rise_and_return(Law::modified_sine, 10, 50);
  const Cam inner = rise_and_return(Law::inclined_sine, 360, 13);  // passes the outer's wrap
  EXPECT_THROW(composed(outer, inner), InputError);
  for (const double tolerance : {1e-4, 1e-8, 1e-11}) {
    const auto slave = composed_within(outer, inner, tolerance);
    EXPECT_LE(slave.error[0], tolerance);
    for (std::size_t i = 0; i < slave.curve.segments().size(); ++i)
      for (int n = 1; n < 16; ++n) {
        const double x = slave.curve.breaks()[i] + slave.curve.segments()[i].length * n / 16;
        const Jet y = inner.jet(x);
        const Jet f = outer.jet(y[0]);
        const Jet chain{f[0], f[1] * y[1], f[2] * y[1] * y[1] + f[1] * y[2],
                        f[3] * y[1] * y[1] * y[1] + 3 * f[2] * y[1] * y[2] + f[1] * y[3]};
        const Jet got = slave.curve.jet(x);
        const double rounding = 1e-12 * 50;
        for (std::size_t k = 0; k < 4; ++k)
          EXPECT_NEAR(got[k], chain[k], slave.error[k] + rounding) << k << " at " << x;
      }
    EXPECT_TRUE(check_continuity(slave.curve, 2, 1e-9).ok());
  }
}

}  // namespace
}  // namespace jounce::algebra_test
