// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/live_registration.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"

namespace jounce::live_registration_test {
namespace {

using ::testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double dt = 1e-3;

/// Products of 400: a mark at 255, and a correction from 265 on over 130.
LiveRegistrationSpec film(CorrectionOf add_to = CorrectionOf::slave) {
  LiveRegistrationSpec spec{.period = 400, .mark = 255, .window = 5, .search = 60};
  spec.correction = {.window_from = 265, .window_length = 130, .most = 2};
  spec.add_to = add_to;
  return spec;
}

/// A film that runs at a constant speed past a sensor which reports without delay.
struct Film {
  explicit Film(const LiveRegistrationSpec& spec, double velocity = 1000)
      : marks(spec), v(velocity) {
    marks.begin(0);
  }

  /// Runs up to this position. `places`: positions of all marks, ascending.
  void run(double to, const std::vector<double>& places) {
    while (x < to) {
      const double before = x;
      x += v * dt;
      std::vector<double> seen;
      for (const double place : places)
        if (place > before && place <= x) seen.push_back(place);
      marks.step({x, v, 0, 0}, x, seen);
      last = marks.correction();
      fastest = std::max(fastest, std::abs(last[1]));
    }
  }

  LiveRegistration marks;
  double v;
  double x = 0;
  Jet last{};
  double fastest = 0;
};

// The remaining error after each product, by the rule of the page and nothing else.
TEST(LiveRegistration, CorrectsAtMostOneStepAProductUntilTheMarkIsInRegister) {
  Film run(film());
  run.run(400, {255 + 5.0});
  EXPECT_EQ(run.marks.reading().deviation, 5);
  EXPECT_EQ(run.last[0], -2);
  run.run(800, {655 + 5.0});
  EXPECT_EQ(run.last[0], -4);
  run.run(1200, {1055 + 5.0});
  EXPECT_EQ(run.last[0], -5);
  run.run(1600, {1455 + 5.0});
  EXPECT_EQ(run.last[0], -5);
  EXPECT_EQ(run.marks.reading().marks, 4);
  EXPECT_EQ(run.marks.reading().missed, 0);
  // 3-4-5: the peak velocity is 15/8 of the step over the time of the window.
  EXPECT_NEAR(run.fastest, 1.875 * 2 * 1000 / 130, 1e-3);
}

TEST(LiveRegistration, FollowsItsLawOverTheExactWindow) {
  Film run(film(), 777);
  run.run(320, {256.5});
  const double xi = (run.x - 265) / 130;
  const double f = xi * xi * xi * (10 - 15 * xi + 6 * xi * xi);
  const double slope = 30 * xi * xi * (1 - xi) * (1 - xi);
  EXPECT_NEAR(run.last[0], -1.5 * f, 1e-12);
  EXPECT_NEAR(run.last[1], -1.5 * slope / 130 * 777, 1e-9);
}

// The phase x + c passes the window at its own place: from 265 to 395.
TEST(LiveRegistration, OfTheMasterKeepsItsWindowInThePhase) {
  Film run(film(CorrectionOf::master), 100);
  const std::vector<double> places{257.0, 657.0, 1059.0};
  run.run(400, places);
  EXPECT_EQ(run.last[0], -2);
  run.run(666, places);
  EXPECT_EQ(run.last[0], -2);  // the window begins at the phase 665, which is the position 667
  run.run(1060, places);
  EXPECT_EQ(run.marks.reading().deviation, 4);
  run.run(1060 + 7, places);
  EXPECT_EQ(run.last[0], -2);
  run.run(1067 + 131.9, places);
  EXPECT_GT(run.last[0], -4);
  run.run(1067 + 132.2, places);  // 130 of the phase, with 2 that the correction takes back
  EXPECT_EQ(run.last[0], -4);
}

TEST(LiveRegistration, IgnoresStraysAndASecondMarkOfAProduct) {
  Film run(film());
  run.run(800, {256.0, 300.0, 656.0, 658.0});
  EXPECT_EQ(run.marks.reading().marks, 2);
  EXPECT_EQ(run.marks.reading().strays, 2);
  EXPECT_EQ(run.marks.reading().deviation, 1);
  EXPECT_EQ(run.last[0], -1);
}

TEST(LiveRegistration, ExpectsTheNextMarkWhereTheLastOneWas) {
  Film run(film());  // drifts by 4 a product: always within the window of 5
  run.run(2000, {255, 659, 1063, 1467, 1871});
  EXPECT_EQ(run.marks.reading().marks, 5);
  EXPECT_EQ(run.marks.reading().deviation, 16);
}

TEST(LiveRegistration, CountsMissingMarksAndIsLostAfterSome) {
  Film run(film());
  run.run(400, {257.0});
  run.run(1070, {});
  EXPECT_EQ(run.marks.reading().missed, 2);
  EXPECT_FALSE(run.marks.reading().lost);
  run.run(1470, {});
  EXPECT_EQ(run.marks.reading().missed, 3);
  EXPECT_TRUE(run.marks.reading().lost);
  EXPECT_EQ(run.last[0], -2) << "the correction stays";
  run.run(2000, {1855.0 + 40});  // found again by the search
  EXPECT_FALSE(run.marks.reading().lost);
  EXPECT_EQ(run.marks.reading().deviation, 40);
  EXPECT_EQ(run.marks.reading().missed, 3);
}

TEST(LiveRegistration, AMarkBetweenMissingOnesStartsTheCountAgain) {
  Film run(film());
  run.run(4000, {255, 1055, 1855, 2655, 3455});
  EXPECT_EQ(run.marks.reading().missed, 5);
  EXPECT_FALSE(run.marks.reading().lost);
}

TEST(LiveRegistration, InsideAWindowTheCorrectionFollowsTheMasterBackAndForth) {
  Film run(film());
  run.run(300, {256.0});
  const double there = run.last[0];
  run.marks.step({330, 0, 0, 0}, 330, {});
  EXPECT_LT(run.marks.correction()[0], there);
  run.marks.step({run.x, 0, 0, 0}, 330, {});
  EXPECT_EQ(run.marks.correction()[0], there);
  run.marks.step({260, 0, 0, 0}, 330, {});
  EXPECT_EQ(run.marks.correction()[0], 0);
}

TEST(LiveRegistration, ANewCoordinateOfTheMasterChangesNothing) {
  Film plain(film()), moved(film());
  plain.run(300, {256.0});
  moved.run(300, {256.0});
  moved.marks.shift(5000);
  plain.marks.step({310, 1000, 0, 0}, 310, {});
  moved.marks.step({5310, 1000, 0, 0}, 5310, {});
  EXPECT_EQ(plain.marks.correction(), moved.marks.correction());
}

TEST(LiveRegistration, ALostOrJumpingMasterEndsInBoundedTime) {
  Film run(film());
  run.marks.step({nan, 0, 0, 0}, nan, {});
  EXPECT_EQ(run.marks.correction()[0], 0);
  run.marks.step({1e15, 0, 0, 0}, 1e15, {});
  EXPECT_TRUE(run.marks.reading().lost);
}

TEST(LiveRegistration, CorrectsAShareOfTheErrorWithAGain) {
  LiveRegistrationSpec spec = film();
  spec.gain = 0.5;
  Film run(spec);
  run.run(400, {256.0});
  EXPECT_EQ(run.last[0], -0.5);
  run.run(800, {656.0});
  EXPECT_EQ(run.last[0], -0.75);
}

TEST(LiveRegistration, AMissingMarkLeavesTheCorrectionAsItIs) {
  LiveRegistrationSpec half = film();
  half.gain = 0.5;
  for (const auto& [spec, error, corrected] :
       {std::tuple{half, 2.0, 1.0}, {film(), 5.0, 2.0}, {film(CorrectionOf::master), 5.0, 2.0}}) {
    Film run(spec);
    run.run(600, {255 + error});
    EXPECT_EQ(run.last[0], -corrected);
    run.run(1400, {});
    EXPECT_EQ(run.last[0], -corrected) << "two products without a mark";
    EXPECT_EQ(run.marks.reading().missed, 2);
  }
}

// The mark passes at 256, and its report arrives inside the window of the correction.
TEST(LiveRegistration, ALateMarkIsCorrectedOnceInTheNextProduct) {
  Film run(film());
  run.run(300, {});
  run.marks.step({301, 1000, 0, 0}, 301, std::vector<double>{256});
  run.run(600, {});
  EXPECT_EQ(run.last[0], 0);
  run.run(800, {});
  EXPECT_EQ(run.last[0], -1);
  run.run(1200, {});
  EXPECT_EQ(run.last[0], -1);
}

TEST(LiveRegistration, RejectsInvalidSpecsByTheirKeys) {
  const auto rejected = [](auto change) {
    LiveRegistrationSpec spec = film();
    change(spec);
    return test::error_of([&] { LiveRegistration marks(spec); });
  };
  EXPECT_THAT(rejected([](auto& s) { s.period = 0; }), HasSubstr("period"));
  EXPECT_THAT(rejected([](auto& s) { s.window = 0; }), HasSubstr("window"));
  EXPECT_THAT(rejected([](auto& s) { s.window = 70; }), HasSubstr("must be at most 60"));
  EXPECT_THAT(rejected([](auto& s) { s.search = 201; }), HasSubstr("must be at most 200"));
  EXPECT_THAT(rejected([](auto& s) { s.correction.window_length = 401; }),
              HasSubstr("correct_length"));
  EXPECT_THAT(rejected([](auto& s) { s.correction.most = 0; }), HasSubstr("most"));
  EXPECT_THAT(rejected([](auto& s) { s.ratio = 0; }), HasSubstr("ratio"));
  EXPECT_THAT(rejected([](auto& s) { s.gain = 1.1; }), HasSubstr("gain"));
  EXPECT_THAT(rejected([](auto& s) { s.misses = 0; }), HasSubstr("misses"));
  EXPECT_THAT(rejected([](auto& s) { s.correction.law = Law::line; }), HasSubstr("law"));
  EXPECT_THAT(rejected([](auto& s) {
                s.add_to = CorrectionOf::master;
                s.correction.most = 66;
              }),
              HasSubstr("must be at most 65"));
}

}  // namespace
}  // namespace jounce::live_registration_test
