// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/optimize/optimize.hpp"

namespace jounce::test_optimize {

/// Rest to rest over [0, length] by `height`, cut at the given shares; the inner knots lie on the
/// 3-4-5 law, so that the given cam is that law, and all their quantities are free.
inline CamProblem rest_to_rest(std::vector<double> cuts, Objective objective, double height = 1,
                               double length = 1) {
  CamProblem problem;
  problem.cam.start = {0, 0, 0, 0};
  problem.cam.segments = {{Law::quintic, {length, height, 0, 0}, ""}};
  const Cam whole = design(problem.cam).cam;
  problem.cam.segments.clear();
  const double h = height;
  const auto around = [](double a, double b) { return a < b ? Bound{a, b} : Bound{b, a}; };
  for (const double cut : cuts) {
    const Jet f = whole.jet(cut * length);
    problem.cam.segments.push_back({Law::quintic, {cut * length, f[0], f[1], f[2]}, ""});
    problem.free.push_back({problem.cam.segments.size(), Bound{0.02 * length, 0.98 * length},
                            around(-h, 2 * h), around(-10 * h / length, 10 * h / length),
                            around(-50 * h / (length * length), 50 * h / (length * length))});
  }
  problem.cam.segments.push_back({Law::quintic, {length, height, 0, 0}, ""});
  problem.minimize = {objective};
  return problem;
}

/// PMC600 manual 6.2, Fig. 6.14: the deceleration after the synchronous part 75..200 breaks the
/// limits 3 and 0.15 (it reaches 3.392270802 and 0.1619234501).
inline CamProblem fig614() {
  CamProblem problem;
  problem.cam.start = {0, 0, 0, 0};
  problem.cam.periodic = true;
  problem.cam.segments = {{Law::quintic, {75, 100, 1, 0}, "run up"},
                          {Law::quintic, {200, 225, 1, 0}, "synchronous"},
                          {Law::quintic, {280, 100, 0.01739120485, 0}, "return"},
                          {Law::quintic, {360, 0, 0, 0}, "settle"}};
  problem.limits = {{}, {}, 3, 0.15, {}};
  problem.minimize = {Objective::peak_acceleration, Objective::peak_jerk,
                      Objective::rms_acceleration};
  return problem;
}

inline const Bound fig614_master{205, 355};
inline const Bound fig614_slave{-20, 240};
inline const Bound fig614_velocity{-3, 3};
inline const Bound fig614_acceleration{-0.15, 0.15};

}  // namespace jounce::test_optimize
