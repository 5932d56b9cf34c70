// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/googol/googol_pt.hpp"

#include <cmath>
#include <deque>
#include <string>

#include <gtest/gtest.h>

#include "support/googol_7_4.hpp"
#include "support/random.hpp"

namespace jounce::googol {
namespace {

using State = SegmentFifos::State;

TEST(GoogolPt, Example74IsTheNotesTable) {
  const auto points = test::example_7_4(1);
  ASSERT_EQ(points.size(), 126U);
  EXPECT_NEAR(points[0].position, 40.1447, 5e-5);
  EXPECT_NEAR(points[14].position, 7451.79, 5e-3);
  EXPECT_NEAR(points[30].position, 15899.5772, 5e-5);
  EXPECT_NEAR(points[61].position, 10.0426, 5e-5);
  const auto rates = pt_rates<OverTime>(points);
  EXPECT_NEAR(rates[0].end, 5.0181, 5e-5);
  EXPECT_NEAR(rates[14].end, 49.9013, 5e-5);
  EXPECT_NEAR(rates[61].end, -2.5122, 5e-5);
  EXPECT_NEAR(rates[62].start, -2.5106, 5e-5);
}

/// The reference flow of 7-4: push while there is space, start when there is none, go on pushing.
TEST(GoogolPt, Example74StreamsThroughTwoFifosToTheLastBit) {
  const auto points = test::example_7_4(1);
  const Trajectory whole = pt<OverTime>(points);
  PtFifos axis;
  ASSERT_EQ(axis.prf_pt(PtMode::dynamic), Refusal::none);
  std::size_t pushed = 0;
  const auto push = [&] {
    while (pushed < points.size() && axis.pt_space(0) > 0)
      ASSERT_EQ(axis.pt_data(points[pushed++], 0), Refusal::none);
  };
  push();
  EXPECT_EQ(pushed, 64U) << "both FIFOs of 32 are full";
  EXPECT_EQ(axis.pt_data(points[64], 0), Refusal::full);
  ASSERT_EQ(axis.pt_start(0, 0), Refusal::none);
  std::vector<std::size_t> refills;
  for (int k = 0; k < 4000; ++k) {
    const double t = 0.5 * k;
    const Jet now = axis.at(t);
    ASSERT_EQ(now, whole.jet(t)) << "at " << t;
    const std::size_t before = pushed;
    push();
    if (pushed > before) refills.push_back(pushed - before);
  }
  EXPECT_EQ(refills, (std::vector<std::size_t>{32, 30})) << "space returns in blocks of a FIFO";
  EXPECT_EQ(axis.state(), State::moving);
  EXPECT_EQ(axis.at(2000)[0], 0);
  EXPECT_EQ(axis.state(), State::ended);
}

TEST(GoogolPt, AnUnderrunIsACutOff) {
  const auto points = test::example_7_4(1);
  PtFifos axis;
  axis.prf_pt(PtMode::dynamic);
  for (std::size_t i = 0; i < 20; ++i) axis.pt_data(points[i], 0);
  ASSERT_EQ(axis.pt_start(0, 0), Refusal::none);
  EXPECT_EQ(axis.at(1000)[0], points[19].position) << "it stands where it ran dry";
  EXPECT_EQ(axis.state(), State::cut_off);
  EXPECT_EQ(axis.pt_space(0), 64U);
  EXPECT_EQ(axis.pt_start(0, 1000), Refusal::empty);
}

TEST(GoogolPt, StaticFifosAreKeptPlayedAgainAndLoop) {
  PtFifos axis;
  axis.prf_pt(PtMode::fixed);
  for (const PtPoint& p : {PtPoint{1024, 1024}, {2048, 3072}, {3072, 4096}})
    ASSERT_EQ(axis.pt_data(p, 1), Refusal::none);
  EXPECT_EQ(axis.pt_space(1), 29U);
  EXPECT_EQ(axis.pt_start(0, 0), Refusal::empty);
  ASSERT_EQ(axis.pt_start(1, 0), Refusal::none);
  EXPECT_EQ(axis.pt_start(1, 0), Refusal::moving);
  EXPECT_EQ(axis.prf_pt(PtMode::dynamic), Refusal::moving);
  EXPECT_EQ(axis.set_pt_memory(1), Refusal::moving);
  EXPECT_EQ(axis.at(1536)[1], 2);
  EXPECT_EQ(axis.pt_clear(1), Refusal::in_use);
  EXPECT_EQ(axis.pt_clear(0), Refusal::none) << "the idle one, while moving";
  EXPECT_EQ(axis.at(5000)[0], 4096);
  EXPECT_EQ(axis.state(), State::ended);
  EXPECT_EQ(axis.pt_loop(), 1);
  axis.set_pt_loop(0);
  ASSERT_EQ(axis.pt_start(1, 6000, 100), Refusal::none) << "played again from where it stands";
  EXPECT_EQ(axis.at(6000 + 1000 * 3072.0 + 512)[0], 100 + 1000 * 4096.0 + 256);
  EXPECT_EQ(axis.pt_loop(), 1000);
  EXPECT_EQ(axis.state(), State::moving);
}

TEST(GoogolPt, ANormalFirstSegmentOfAStaticPassBeginsAtRest) {
  PtFifos axis;
  axis.prf_pt(PtMode::fixed);
  axis.set_pt_loop(2);
  axis.pt_data({100, 50}, 0);  // ends at 1
  axis.pt_start(0, 0);
  EXPECT_EQ(axis.at(99)[1], 0.99);
  EXPECT_EQ(axis.at(101)[1], 0.01);
  axis.at(201);
  EXPECT_EQ(axis.state(), State::cut_off);
}

TEST(GoogolPt, RejectsWithTheDocumentedReasons) {
  PtFifos axis;
  EXPECT_EQ(axis.pt_data({1, 1}, 0), Refusal::wrong_mode);
  EXPECT_EQ(axis.pt_clear(0), Refusal::wrong_mode);
  EXPECT_EQ(axis.pt_start(0, 0), Refusal::wrong_mode);
  EXPECT_EQ(axis.set_pt_loop(1), Refusal::wrong_mode);
  EXPECT_EQ(axis.set_pt_memory(0), Refusal::wrong_mode);
  EXPECT_EQ(axis.pt_space(0), 0U);
  axis.prf_pt(PtMode::fixed);
  EXPECT_EQ(axis.set_pt_loop(-1), Refusal::bad_argument);
  EXPECT_EQ(axis.set_pt_memory(2), Refusal::bad_argument);
  EXPECT_EQ(axis.pt_data({1, 1}, 2), Refusal::bad_argument);
  EXPECT_EQ(axis.pt_data({1, 1, PtType::continued}, 0), Refusal::bad_argument);
  EXPECT_EQ(axis.pt_data({0, 1}, 0), Refusal::bad_argument) << "no time";
  EXPECT_EQ(axis.pt_data({1, NAN}, 0), Refusal::bad_argument);
  EXPECT_EQ(axis.pt_data({5, 1}, 0), Refusal::none);
  EXPECT_EQ(axis.pt_data({5, 2}, 0), Refusal::bad_argument);
  EXPECT_EQ(axis.set_pt_memory(1), Refusal::none);
  EXPECT_EQ(axis.pt_space(0), 1024U);
  for (int i = 1; i <= 1024; ++i) ASSERT_EQ(axis.pt_data({1.0 * i, 0}, 0), Refusal::none);
  EXPECT_EQ(axis.pt_data({2000, 0}, 0), Refusal::full);
  axis.prf_pt(PtMode::dynamic);
  axis.pt_data({5, 1}, 1);
  axis.pt_start(1, 0);
  EXPECT_EQ(axis.pt_clear(0), Refusal::in_use) << "the stream is, and has no halves";
}

TEST(GoogolRefusal, HasACodeAndASentence) {
  EXPECT_EQ(return_code(Refusal::none), 0);
  EXPECT_EQ(return_code(Refusal::bad_argument), 7);
  for (const Refusal r : {Refusal::wrong_mode, Refusal::moving, Refusal::not_moving,
                          Refusal::in_use, Refusal::full, Refusal::empty, Refusal::no_master}) {
    EXPECT_EQ(return_code(r), 1);
    EXPECT_FALSE(std::string(explain(r)).empty());
  }
}

/// The stream written without FIFOs: a list of all points, and the unused ones.
struct NaiveStream {
  std::size_t each;
  std::vector<PtPoint> points;       // points of the running or waiting stream
  std::deque<std::size_t> blocks{};  // points a FIFO, the one that plays first
  std::size_t gone = 0;              // points of FIFOs emptied

  std::size_t space() const {
    if (blocks.empty()) return 2 * each;
    return each - blocks.back() + (blocks.size() == 1 ? each : 0);
  }
  void push(const PtPoint& p) {
    if (blocks.empty() || blocks.back() == each) blocks.push_back(0);
    ++blocks.back();
    points.push_back(p);
  }
  /// Returns true if the stream has run dry.
  bool play(double t) {
    while (!blocks.empty() && t >= points[gone + blocks.front() - 1].x) {
      gone += blocks.front();
      blocks.pop_front();
    }
    return blocks.empty();
  }
};

TEST(GoogolPt, RandomStreamsMatchANaiveModel) {
  for (std::uint64_t seed = 1; seed <= 200 && !::testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::Random random(seed);
    PtFifos axis;
    axis.prf_pt(PtMode::dynamic);
    NaiveStream model{32, {}};
    bool moving = false;
    double t = 0;
    double start = 0;
    double x = 0;
    for (int step = 0; step < 400 && !::testing::Test::HasFailure(); ++step) {
      switch (random.below(5)) {
        case 0:
        case 1:
          for (int i = random.below(40); i > 0; --i) {
            const PtPoint p{x + 1 + random.below(20), 1.0 * random.below(1000),
                            static_cast<PtType>(random.below(3))};
            const bool room = model.space() > 0;
            ASSERT_EQ(axis.pt_data(p, random.below(2)), room ? Refusal::none : Refusal::full);
            if (!room) break;
            model.push(p);
            x = p.x;
          }
          break;
        case 2:
          if (moving || random.below(4) > 0) break;
          ASSERT_EQ(axis.pt_start(0, t), model.points.empty() ? Refusal::empty : Refusal::none);
          moving = !model.points.empty();
          start = t;
          break;
        case 3:
          if (random.below(20) > 0) break;
          ASSERT_EQ(axis.pt_clear(random.below(2)), moving ? Refusal::in_use : Refusal::none);
          if (!moving) model = {32, {}}, x = 0;
          break;
        default:
          t += random.below(200);
          const Jet now = axis.at(t);
          if (!moving) break;
          if (model.play(t - start)) {
            EXPECT_EQ(now[0], model.points.back().position);
            EXPECT_NE(axis.state(), State::moving);
            moving = false;
            model = {32, {}};
            x = 0;
          } else {
            ASSERT_EQ(now, pt<OverTime>(model.points).jet(t - start)) << "step " << step;
          }
      }
      ASSERT_EQ(axis.pt_space(0), model.space()) << "step " << step;
      ASSERT_EQ(axis.state() == State::moving, moving) << "step " << step;
    }
  }
}

}  // namespace
}  // namespace jounce::googol
