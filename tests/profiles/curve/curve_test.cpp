// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/invariants.hpp"
#include "support/random.hpp"

namespace jounce::curve_test {
namespace {

/// Two lines, 0 -> 1 over [10, 12] and 5 -> 4 over [12, 13]: it jumps at 12.
Trajectory two_lines(Extrapolation outside = Extrapolation::hold) {
  return Trajectory({line(2, 0, 1), line(1, 5, 4)}, 10, outside);
}

TEST(Curve, IsRightContinuousWithALeftLimitOnDemand) {
  const Trajectory f = two_lines();
  EXPECT_DOUBLE_EQ(f.at(12).position, 5);
  EXPECT_DOUBLE_EQ(f.at(12, Side::left).position, 1);
  EXPECT_DOUBLE_EQ(f.at(13).position, 4) << "the last segment is closed";
  EXPECT_DOUBLE_EQ(f.at(12).velocity, -1);
  EXPECT_DOUBLE_EQ(f.at(12, Side::left).velocity, 0.5);
}

TEST(Curve, HoldsOrWrapsOutside) {
  EXPECT_DOUBLE_EQ(two_lines().at(9).position, 0);
  EXPECT_DOUBLE_EQ(two_lines().at(20).position, 4);
  EXPECT_DOUBLE_EQ(two_lines().at(20).velocity, 0);
  const Trajectory f = two_lines(Extrapolation::wrap);
  EXPECT_DOUBLE_EQ(f.at(13).position, 0) << "the end is the next start";
  EXPECT_DOUBLE_EQ(f.at(13, Side::left).position, 4);
  EXPECT_DOUBLE_EQ(f.at(14).position, 0.5);
  EXPECT_DOUBLE_EQ(f.at(9.5).position, 4.5);
  EXPECT_DOUBLE_EQ(f.at(10 + 3e6 + 1).position, 0.5);
}

TEST(Curve, IsNanAtAPlaceThatIsNone) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const auto is_nan = [](const Jet& f) {
    return std::all_of(f.begin(), f.end(), [](double each) { return std::isnan(each); });
  };
  for (const Extrapolation outside :
       {Extrapolation::refuse, Extrapolation::hold, Extrapolation::wrap, Extrapolation::advance}) {
    const Trajectory f = two_lines(outside);
    EXPECT_TRUE(is_nan(f.jet(std::nan(""))));
    EXPECT_TRUE(is_nan(f.jet(std::nan(""), Side::left)));
    const std::vector<double> x{10.5, std::nan(""), 11};
    std::vector<Motion> block(x.size());
    f.sample(x, block);
    EXPECT_TRUE(std::isnan(block[1].velocity));
    EXPECT_EQ(block[2].velocity, 0.5);
    EXPECT_EQ(is_nan(f.jet(-inf)), repeats(outside));
  }
  EXPECT_EQ(two_lines().at(inf).position, 4) << "the nearer end";
  const Profile move = s_curve({.to = 3, .velocity = 1, .acceleration = 7, .jerk = 90});
  const Motion at = move.at(std::nan(""));
  EXPECT_TRUE(is_nan({at.position, at.velocity, at.acceleration, at.jerk}));
}

TEST(Curve, SamplesABlockLikeSinglePoints) {
  for (const Extrapolation outside : {Extrapolation::hold, Extrapolation::wrap}) {
    const Trajectory f = two_lines(outside);
    const std::vector<double> x{8, 10, 11, 12, 12.5, 11.5, 13, 14.25, 10.5};
    std::vector<Motion> block(x.size());
    f.sample(x, block);
    for (std::size_t i = 0; i < x.size(); ++i) {
      EXPECT_EQ(block[i].position, f.at(x[i]).position) << x[i];
      EXPECT_EQ(block[i].velocity, f.at(x[i]).velocity) << x[i];
    }
  }
}

TEST(Curve, BreaksOfAMillionSegmentsEndWhereTheyShould) {
  const Trajectory f(std::vector<Segment>(1'000'000, line(0.1, 0, 1)));
  EXPECT_NEAR(f.end(), 100'000, 1e-10);
}

TEST(Curve, AlgebraKeepsItsPromises) {
  const Trajectory f = s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve();
  const double end = f.end();

  EXPECT_DOUBLE_EQ(shifted(f, 3, 7).at(3).position, 7);
  EXPECT_DOUBLE_EQ(shifted(f, 3, 7).end(), end + 3);
  EXPECT_DOUBLE_EQ(scaled(f, -2, 3).at(3 * end).position, -100);
  EXPECT_NEAR(scaled(f, -2, 3).at(3).velocity, f.at(1).velocity * -2 / 3, 1e-14);

  const Trajectory there_and_back = concatenated(f, reversed(f));
  EXPECT_NEAR(there_and_back.at(end).position, 50, 1e-13);
  EXPECT_NEAR(there_and_back.at(2 * end).position, 0, 1e-13);
  test::expect_invariants(there_and_back, 2);

  const Trajectory thrice = repeated(there_and_back, 3);
  EXPECT_NEAR(thrice.end(), 6 * end, 1e-13);
  EXPECT_NEAR(thrice.at(4 * end + 0.3).position, f.at(0.3).position, 1e-12);
}

TEST(Curve, SumHasTheBreaksOfBoth) {
  const Trajectory f({line(1, 0, 1), line(2, 1, 0)});
  const Trajectory g({line(2, 5, 5), line(1, 5, 8)});
  const Trajectory h = sum(f, g);
  EXPECT_EQ(h.segments().size(), 3U);
  for (const double x : {0.0, 0.5, 1.0, 1.5, 2.0, 2.9, 3.0})
    EXPECT_NEAR(h.at(x).position, f.at(x).position + g.at(x).position, 1e-14) << x;
  EXPECT_THROW(sum(f, Trajectory({line(4, 0, 1)})), InputError);
}

TEST(Curve, SumKeepsShortSegmentsFarFromTheOrigin) {
  // Jerk phases of 4 ms, 10 000 s from the origin, where a double resolves 2e-12 s.
  const Trajectory f =
      shifted(s_curve({.to = 170, .velocity = 1.3, .acceleration = 0.14, .jerk = 35}).curve(), 1e4);
  const Trajectory rest({line(f.length(), 5, 5)}, f.start());
  EXPECT_NEAR(extrema(sum(f, rest), 3).max.value, 35, 35e-14);
  EXPECT_NEAR(extrema(sum(rest, f), 2).max.value, 0.14, 0.14e-14);
}

TEST(Curve, RejectsAnInvalidCurve) {
  EXPECT_THROW(Trajectory(std::vector<Segment>{}), InputError);
  EXPECT_THROW(Trajectory({line(0, 0, 1)}), InputError);
  EXPECT_THROW(Trajectory({line(-1, 0, 1)}), InputError);
  const auto steep = [](double length, double c4) {
    return Segment{.length = length, .degree = 4, .c = {0, 0, 0, 0, c4}};
  };
  EXPECT_THROW(Trajectory({steep(1e-100, 1)}), InputError) << "its fourth derivative is 2.4e401";
  EXPECT_THROW(Trajectory({steep(1e-30, 1e190)}), InputError);
  EXPECT_TRUE(std::isfinite(Trajectory({steep(1e-30, 1e150)}).jet(1e-30)[3]));
  EXPECT_THROW(Trajectory({line(1, 0, std::nan(""))}), InputError);
  EXPECT_THROW(Trajectory({line(1, 0, 1)}, std::numeric_limits<double>::infinity()), InputError);
  EXPECT_THROW(Trajectory({line(1e308, 0, 1), line(1e308, 0, 1)}), InputError)
      << "the end overflows";
  for (const int wrong : {-1, 12, 200}) {
    EXPECT_THROW(Trajectory({Segment{.length = 1, .degree = wrong}}), InputError);
    EXPECT_THROW(Trajectory({Segment{.length = 1, .sines = wrong}}), InputError);
  }
}

TEST(InputErrorText, NamesPlaceKeyValueAndRule) {
  const InputError error =
      InputError("move.velocity", -3, "must be greater than 0").at("a.toml", 4, 12);
  EXPECT_STREQ(error.what(), "a.toml:4:12: move.velocity = -3: must be greater than 0");
}

TEST(Curve, WrapsIntoItsTurnToTheLastDigit) {
  EXPECT_EQ(wrapped(-1e-20, 0, 360), 0) << "360 itself is not in [0, 360)";
  EXPECT_EQ(wrapped(-1e-20, -5, 5), -5);
  EXPECT_EQ(wrapped(-90, 0, 360), 270);
}

TEST(Curve, WrapsAsTheLibraryDividesToTheBit) {
  test::Random random(53);
  for (int i = 0; i < 200'000; ++i) {
    const double length = random.log_uniform(1e-12, 1e12);
    const double u = random.below(2) == 0 ? length * random.below(1'000'000)
                                          : length * random.log_uniform(1e-3, 1e20);
    for (const double x : {u, std::nextafter(u, 0), std::nextafter(u, 2 * u)})
      ASSERT_EQ(remainder_of(x, length), std::fmod(x, length)) << x << " by " << length;
  }
  constexpr double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(remainder_of(7 * least, 3 * least), least);
  EXPECT_EQ(remainder_of(1e308, 3 * least), std::fmod(1e308, 3 * least));
}

TEST(Curve, RejectsAnOriginThatSwallowsItsLength) {
  EXPECT_THROW(shifted(Trajectory({line(5.7, 0, 1)}), 1e17), InputError);
}

TEST(Curve, SamplesIntoASpanOfTheSameSize) {
  const Trajectory f({line(5.7, 0, 1)});
  const std::vector<double> x{0, 1, 2};
  std::vector<Motion> out(4, Motion{-777, 0, 0, 0});
  EXPECT_THROW(f.sample(x, std::span(out).first(2)), InputError);
  EXPECT_THROW(f.sample(x, out), InputError);
  EXPECT_EQ(out[0].position, -777);
  f.sample(x, std::span(out).first(3));
  EXPECT_EQ(out[3].position, -777);
}

}  // namespace
}  // namespace jounce::curve_test
