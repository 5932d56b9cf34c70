// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/design/characteristics.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "cam/laws/laws.hpp"
#include "support/fig_6_14.hpp"
#include "support/oracle.hpp"
#include "support/random.hpp"

namespace jounce::characteristics_test {
namespace {

using test::laws;
using test::oracle;

TEST(Characteristics, MeetTheOracleOfEveryLaw) {
  for (const auto& [name, law] : laws()) {
    SCOPED_TRACE(name);
    const auto& expected = oracle("laws")["laws"][name];
    const Characteristics c = characteristics(law);
    const auto near = [](double value, const auto& wanted) {
      if (wanted.is_null()) return std::isinf(value);
      return std::abs(value - wanted.template get<double>()) <=
             1e-11 * wanted.template get<double>();
    };
    EXPECT_TRUE(near(c.cv.value, expected["cv"])) << c.cv.value;
    EXPECT_TRUE(near(c.ca.value, expected["ca"])) << c.ca.value;
    EXPECT_TRUE(near(c.ca_star.value, expected["ca"])) << c.ca_star.value;
    EXPECT_TRUE(near(c.cj.value, expected["cj"])) << c.cj.value;
    EXPECT_TRUE(near(c.cj_inside, expected["cj_inside"])) << c.cj_inside;
    EXPECT_TRUE(near(c.cm.value, expected["cm"])) << c.cm.value;
    EXPECT_TRUE(near(c.rms, expected["rms_f2"])) << c.rms;
  }
}

TEST(Characteristics, HaveTheClosedFormsOfTheAsymmetricLaws) {
  constexpr double pi = std::numbers::pi;
  const Characteristics c = characteristics(Cam(normalized(Law::double_harmonic)));
  EXPECT_NEAR(c.cv.value, 3 * std::sqrt(3) * pi / 8, 1e-12);
  EXPECT_NEAR(c.cv.where, 2.0 / 3, 1e-9);
  EXPECT_NEAR(c.ca.value, 9 * pi * pi / 16, 1e-12);
  EXPECT_NEAR(c.ca_star.value, pi * pi, 1e-12);
  EXPECT_EQ(c.ca_star.where, 1);
  EXPECT_NEAR(c.cj.value, 42.4137, 1e-4) << "to the printed digits";
  EXPECT_NEAR(c.rms, pi * pi / 2, 1e-12);

  // R-U of the 8th degree, to the coefficients' printed digits.
  const Characteristics eight = characteristics(
      Cam({test::polynomial({0, 0, 0, 6.09755, 0, -20.78040, 26.73155, -13.60965, 2.56095})}));
  EXPECT_NEAR(eight.cv.value, 1.776661, 2e-5);
  EXPECT_NEAR(eight.ca.value, 5.26830, 2e-4);
  EXPECT_NEAR(eight.ca_star.value, 5.26830, 2e-4);
}

TEST(Characteristics, DoNotDependOnStrokeLengthPlaceOrSign) {
  test::Random random(11);
  for (const auto& [name, law] : laws()) {
    SCOPED_TRACE(name);
    const double stroke = random.log_uniform(1e-6, 1e6) * (random.below(2) == 0 ? 1 : -1);
    const double length = random.log_uniform(1e-6, 1e6);
    SCOPED_TRACE(::testing::Message() << stroke << " over " << length);
    const Characteristics one = characteristics(law);
    const Characteristics c =
        characteristics(shifted(scaled(law, stroke, length), length / 3, stroke / 7));
    EXPECT_DOUBLE_EQ(c.length, length);
    EXPECT_NEAR(c.stroke / stroke, 1, 1e-12);
    EXPECT_NEAR(c.cv.value / one.cv.value, 1, 1e-12);
    EXPECT_NEAR(c.ca.value / one.ca.value, 1, 1e-12);
    EXPECT_NEAR(c.cj_inside, one.cj_inside, 1e-12 * one.cj_inside);
    EXPECT_NEAR(c.cm.value / one.cm.value, 1, 1e-12);
    EXPECT_NEAR(c.rms / one.rms, 1, 1e-12);
    EXPECT_EQ(std::isinf(c.cj.value), std::isinf(one.cj.value));
  }
}

TEST(Characteristics, NoSampleOfThePowerIsAboveCm) {
  test::Random random(12);
  for (int n = 0; n < 2000; ++n) {
    const std::array<double, 6> q{random.uniform(-1, 1),   random.uniform(-5, 5),
                                  random.uniform(-40, 40), random.uniform(-1, 1) + 3,
                                  random.uniform(-5, 5),   random.uniform(-40, 40)};
    Segment f = quintic(1, q[0], q[1], q[2], q[3], q[4], q[5]);
    if (n % 2 == 1) {  // also add sines
      f.sines = 2;
      f.sine[0] = {random.uniform(-1, 1), random.uniform(-30, 30), random.uniform(-3, 3)};
      f.sine[1] = {random.uniform(-1, 1), random.uniform(-9, 9), random.uniform(-3, 3)};
    }
    const Cam cam({f});
    const Characteristics c = characteristics(cam);
    double most = 0;
    for (int i = 0; i <= 1000; ++i) {
      const Jet jet = evaluate(f, i / 1000.0);
      most = std::max(most, std::abs(jet[1] * jet[2]) / (c.stroke * c.stroke));
    }
    EXPECT_LE(most, c.cm.value * (1 + 1e-10)) << n;
    EXPECT_GE(most, c.cm.value * (1 - 1e-3)) << n << ": a grid this fine comes close";
    const Jet jet = cam.jet(c.cm.where);
    EXPECT_NEAR(std::abs(jet[1] * jet[2]) / (c.stroke * c.stroke) / c.cm.value, 1, 1e-9) << n;
  }
}

TEST(Characteristics, AreInfiniteWhereAStepWouldNeedIt) {
  const Cam straight({line(1, 0, 1)}, 0, Extrapolation::hold);
  const Characteristics c = characteristics(straight);
  EXPECT_EQ(c.cv.value, 1);
  EXPECT_TRUE(std::isinf(c.ca.value) && std::isinf(c.cm.value) && std::isinf(c.rms));
  EXPECT_EQ(characteristics(with(straight, Extrapolation::refuse)).ca.value, 0)
      << "nothing beside it";
}

TEST(Characteristics, RejectALawWithoutStroke) {
  EXPECT_THROW((void)characteristics(Cam({line(1, 2, 2)})), InputError);
}

TEST(Rises, AreTheStretchesBetweenRestsAlsoThroughTheWrap) {
  // Rise 10..60, dwell, fall through the wrap at 100 to 110 = 10.
  const auto law = normalized(Law::modified_sine);
  Cam rise = shifted(scaled(Cam(law), 5, 50), 10);
  const Cam fall = shifted(scaled(Cam(law), -5, 40), 70, 5);
  const Cam whole = concatenated(concatenated(rise, Cam({line(10, 5, 5)}, 60)), fall);
  // Cut at 100, the last quarter of the fall put first.
  std::vector<Segment> front;
  std::vector<Segment> back;
  for (std::size_t i = 0; i < whole.segments().size(); ++i) {
    const double from = whole.breaks()[i];
    const double to = whole.breaks()[i + 1];
    if (to <= 100) {
      back.push_back(whole.segments()[i]);
    } else if (from >= 100) {
      front.push_back(whole.segments()[i]);
    } else {
      const double cut = (100 - from) / (to - from);
      back.push_back(part(whole.segments()[i], 0, cut));
      front.push_back(part(whole.segments()[i], cut, 1));
    }
  }
  front.insert(front.end(), back.begin(), back.end());
  const Cam cam(front, 0, Extrapolation::wrap);
  const auto found = rises(cam);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].cam.start(), 10, 1e-12);
  EXPECT_NEAR(found[0].cam.end(), 60, 1e-12);
  EXPECT_NEAR(found[1].cam.start(), 70, 1e-12);
  EXPECT_NEAR(found[1].cam.end(), 110, 1e-12) << "beyond the cam's end";
  for (const Rise& one : found) {
    EXPECT_EQ(one.smooth, 2);
    EXPECT_EQ(one.continuous, 2);
    EXPECT_NEAR(characteristics(one).cv.value, 1.7596033859537701, 1e-12);
  }
}

TEST(Rises, AreNoneWhereTheSlaveTurnsBackByMuchOfTheStroke) {
  // 0 to 82 and back to 45 between two rests is no rise to 45; back by a twentieth of the stroke is one.
  const auto there_and_back = [](double top, double end) {
    return Cam({line(10, 0, 0), quintic(40, 0, 0, 0, top, 0, -0.01),
                quintic(30, top, 0, -0.01, end, 0, 0), line(10, end, end)});
  };
  EXPECT_EQ(rises(there_and_back(82, 45)).size(), 2U) << "the slave rests at 82";
  const auto in_one = [](double top, double end) {
    const double k = -0.05;
    return Cam({line(10, 0, 0), quintic(40, 0, 0, 0, top, k, 0), quintic(30, top, k, 0, end, 0, 0),
                line(10, end, end)});
  };
  EXPECT_TRUE(rises(in_one(82, 45)).empty());
  EXPECT_EQ(rises(in_one(82, 81)).size(), 1U);
}

TEST(Rises, AreNoneInACamThatComesBackBetweenItsRests) {
  EXPECT_TRUE(rises(design(test::fig_6_14()).cam).empty()) << "it rests at 0 only";
}

}  // namespace
}  // namespace jounce::characteristics_test
