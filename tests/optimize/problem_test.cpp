// SPDX-License-Identifier: Apache-2.0
#include "jounce/optimize/problem.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "jounce/optimize/optimize.hpp"
#include "jounce/profiles/error.hpp"

#include "optimize/rest_to_rest.hpp"

namespace jounce::problem_test {
namespace {

using test_optimize::fig614;

/// The key of the InputError that the problem causes; empty if it is accepted.
std::string refused(const CamProblem& problem) {
  try {
    require_valid(problem);
  } catch (const InputError& error) {
    return error.key();
  }
  return "";
}

CamProblem with_free(std::vector<FreeKnot> free) {
  CamProblem problem = fig614();
  problem.free = std::move(free);
  return problem;
}

TEST(Objective, NamesAreTheWordsOfTheSpec) {
  EXPECT_STREQ(name(Objective::peak_jerk), "peak geo_jerk");
  EXPECT_EQ(objective_named("peak geo_acceleration"), Objective::peak_acceleration);
  EXPECT_EQ(objective_named("rms geo_acceleration"), Objective::rms_acceleration);
  EXPECT_EQ(objective_named("peak geo_velocity"), std::nullopt);
}

TEST(Objective, ValuesAreThoseOfThe345Law) {
  const Cam cam = design({{0, 0, {}, {}}, {{Law::poly345, {2, 3, {}, {}}, ""}}}).cam;
  EXPECT_NEAR(value_of(Objective::peak_acceleration, cam), 10 / std::sqrt(3) * 3 / 4, 1e-14);
  EXPECT_NEAR(value_of(Objective::peak_jerk, cam), 60 * 3 / 8.0, 1e-13);
  EXPECT_NEAR(value_of(Objective::rms_acceleration, cam), std::sqrt(120.0 / 7) * 3 / 4, 1e-14);
}

TEST(Objective, RmsOfASineLawIsExactToRounding) {
  // Inclined sine: f'' = 2 pi sin(2 pi z), rms sqrt(2) pi.
  const Cam cam = design({{0, 0, {}, {}}, {{Law::inclined_sine, {1, 1, {}, {}}, ""}}}).cam;
  EXPECT_NEAR(value_of(Objective::rms_acceleration, cam), std::sqrt(2) * std::acos(-1), 1e-13);
}

TEST(CamProblem, IsAcceptedAsTheDemoHasIt) {
  EXPECT_EQ(refused(with_free({{3, Bound{205, 355}, Bound{-20, 240}, Bound{-3, 3}, {}},
                               {0, {}, {}, {}, Bound{-0.1, 0.1}}})),
            "");
}

TEST(CamProblem, RejectsWhatWouldChangeANeighboursAcceleration) {
  // The sine-straight hands its acceleration to the quintic before it.
  CamProblem problem;
  problem.cam = {
      {0, 0},
      {{Law::quintic, {100, 10}}, {Law::sine_straight, {200, 30}}, {Law::dwell, {260, 30}}}};
  problem.minimize = {Objective::peak_acceleration};
  problem.free = {{1, {}, {}, Bound{-1, 1}, {}}};
  EXPECT_EQ(refused(problem), "segment[1].free.geo_velocity");
  problem.cam.segments[1].law = Law::modified_sine;  // has none to hand on
  EXPECT_EQ(refused(problem), "");
}

TEST(CamProblem, TakesASineBesideADwell) {
  CamProblem problem;
  problem.cam = {{0, 0},
                 {{Law::simple_sine, {60, 20}},
                  {Law::dwell, {120, 20}},
                  {Law::quintic, {200, 10, 0.0, 0.0}},
                  {Law::quintic, {360, 0}}}};
  problem.minimize = {Objective::peak_acceleration};
  problem.free = {{3, {}, {}, Bound{-1, 1}, {}}};
  const Outcome<CamSpec> outcome = optimize(problem);
  EXPECT_TRUE(outcome.usable()) << outcome.reason;
}

TEST(CamProblem, RejectsBadBounds) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused(with_free({{3, Bound{355, 205}, {}, {}, {}}})), "segment[3].free.master");
  EXPECT_EQ(refused(with_free({{3, Bound{205, 270}, {}, {}, {}}})), "segment[3].free.master");
  EXPECT_EQ(refused(with_free({{3, {}, Bound{nan, 1}, {}, {}}})), "segment[3].free.slave.lower");
  EXPECT_EQ(refused(with_free({{3, {}, {}, Bound{0, INFINITY}, {}}})),
            "segment[3].free.geo_velocity.upper");
  EXPECT_EQ(refused(with_free({{0, {}, {}, {}, Bound{1, 2}}})), "start.free.geo_acceleration");
}

TEST(CamProblem, RejectsWhatIsNoKnotOrNamedTwice) {
  EXPECT_EQ(refused(with_free({{5, {}, Bound{0, 1}, {}, {}}})), "segment[5].free");
  const FreeKnot three{3, {}, Bound{-20, 240}, {}, {}};
  EXPECT_EQ(refused(with_free({three, three})), "segment[3].free");
  const FreeKnot start{0, {}, {}, Bound{-1, 1}, {}};
  const FreeKnot last{4, {}, {}, Bound{-1, 1}, {}};
  EXPECT_EQ(refused(with_free({start, last})), "segment[4].free");
}

TEST(CamProblem, RejectsMovingTheEndsOfTheMaster) {
  EXPECT_EQ(refused(with_free({{4, Bound{300, 400}, {}, {}, {}}})), "segment[4].free.master");
  EXPECT_EQ(refused(with_free({{0, Bound{-1, 1}, {}, {}, {}}})), "start.free.master");
}

TEST(CamProblem, RejectsNothingToDo) {
  EXPECT_EQ(refused(with_free({})), "free");
  EXPECT_EQ(refused(with_free({{3, Bound{280, 280}, {}, {}, {}}})), "free");
  CamProblem problem = with_free({{3, {}, Bound{-20, 240}, {}, {}}});
  problem.minimize = {};
  EXPECT_EQ(refused(problem), "minimize");
  problem.minimize = {Objective::peak_jerk, Objective::peak_jerk};
  EXPECT_EQ(refused(problem), "minimize[2]");
}

TEST(CamProblem, RejectsBadSettingsAndBadCams) {
  const CamProblem good = with_free({{3, {}, Bound{-20, 240}, {}, {}}});
  const auto but = [&](auto change) {
    CamProblem problem = good;
    change(problem);
    return refused(problem);
  };
  EXPECT_EQ(but([](CamProblem& p) { p.options.starts = 0; }), "starts");
  EXPECT_EQ(but([](CamProblem& p) { p.options.budget.evaluations = 0; }), "max_evaluations");
  EXPECT_EQ(but([](CamProblem& p) { p.options.tolerance = 0; }), "tolerance");
  EXPECT_EQ(but([](CamProblem& p) { p.options.tolerance = NAN; }), "tolerance");
  EXPECT_EQ(but([](CamProblem& p) { p.limits.jerk = -1; }), "jerk");
  EXPECT_EQ(but([](CamProblem& p) { p.cam.segments[1].end.master = 10; }), "segment[2].end.master");
}

TEST(CamProblem, RejectsWhatALawBesideTheKnotFixes) {
  CamProblem problem;
  problem.cam.start = {0, 0, {}, {}};
  problem.cam.segments = {{Law::modified_sine, {40, 30, {}, {}}, ""},
                          {Law::dwell, {70, 30, {}, {}}, ""},
                          {Law::quintic, {95, 45, 0.5, 0}, ""},
                          {Law::line, {105, 50, {}, {}}, ""},
                          {Law::quintic, {150, 10, {}, {}}, ""}};
  problem.minimize = {Objective::peak_acceleration};
  const auto free = [&](FreeKnot knot) {
    problem.free = {knot};
    return refused(problem);
  };
  EXPECT_EQ(free({1, Bound{30, 50}, {}, {}, {}}), "");  // both laws take a new master
  EXPECT_EQ(free({1, {}, Bound{20, 40}, {}, {}}), "segment[1].free.slave");
  EXPECT_EQ(free({1, {}, {}, Bound{-1, 1}, {}}), "segment[1].free.geo_velocity");
  EXPECT_EQ(free({2, {}, {}, {}, Bound{-1, 1}}), "segment[2].free.geo_acceleration");
  EXPECT_EQ(free({3, Bound{80, 100}, {}, {}, {}}), "segment[3].free.master");
  EXPECT_EQ(free({4, {}, Bound{40, 60}, {}, {}}), "segment[4].free.slave");
  EXPECT_EQ(free({5, {}, Bound{0, 20}, Bound{-1, 1}, Bound{-1, 1}}), "");
}

}  // namespace
}  // namespace jounce::problem_test
