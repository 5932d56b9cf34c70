// SPDX-License-Identifier: Apache-2.0 Periodic motion along an endless reference of period T. Over
// a period, the state of x' = A x + B w becomes
//
//     (1)  x(T) = P x(0) + c,   P = exp(A T)
//
// where c is the end of a run from x(0) = 0. At the wrap, the reference may step in velocity by
// v = r'(0) - r'(T), and the deviation with it. (A step of position is the advance of a rotary
// slave, which changes only the name of the position.) Therefore
//
//     (2)  x(0) = (I - P)^-1 (c - v follows_velocity)
//
// which is the unique solution if every mode of A decays: no eigenvalue of P is then 1. Its error
// is the rounding of P. It is removed by solving (2) again with the remaining difference after a
// period instead of c.

#include "validate/src/linear/periodic.hpp"

#include <cmath>
#include <utility>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/validate/linear_drive.hpp"
#include "jounce/validate/loop.hpp"

#include "validate/src/drive/dense.hpp"
#include "validate/src/drive/drive_system.hpp"
#include "validate/src/linear/exponential.hpp"

namespace jounce::validate_detail {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

double first_velocity(const Trajectory& period) {
  return evaluate(period.segments().front(), 0)[1];
}

void require_calm(const Drive& drive) {
  const std::vector<LoopPole> poles = loop_poles(drive);
  if (poles.front().growth >= 0)
    throw InputError("controller.velocity_gain", drive.controller.velocity_gain,
                     "makes the loop unstable at " + six_digits(poles.front().frequency) +
                         " Hz: there is no periodic steady state");
}

/// The state after a period, the wrap included.
VectorXd after_a_period(const LinearSystem& system, const Trajectory& period, const VectorXd& x) {
  ExactPath path(system, period, period.length(), {x, first_velocity(period)});
  path.whole();
  const double step = first_velocity(period) - evaluate(period.segments().back(), 1)[1];
  return path.reached() - step * system.follows_velocity;
}

}  // namespace

void require_steady(const Drive& drive) {
  if (const auto key = nonlinearity(drive))
    throw InputError(*key, "not 0",
                     "makes the drive nonlinear: its periodic steady state has no closed form");
  if (drive.controller.cycle > 0)
    throw InputError("controller.cycle", drive.controller.cycle,
                     "must be 0: the periodic steady state needs a continuous controller");
}

std::optional<DriveResult> without_steady_state(const Drive& drive, double start) {
  const auto unstable = unstable_loop(drive);
  if (!unstable) return std::nullopt;
  DriveResult result;
  result.integration = {Ended::failed, start, 0, 0,
                        "the loop is unstable at " + number(unstable->where) +
                            " Hz: it has no periodic steady state"};
  result.report.findings.push_back(*unstable);
  return result;
}

VectorXd periodic_start(const LinearSystem& system, const Trajectory& period, const Drive& drive) {
  require_calm(drive);
  const Index n = system.states();
  const Eigen::MatrixXd left =
      Eigen::MatrixXd::Identity(n, n) - exponential(system.a * period.length());
  VectorXd x = VectorXd::Zero(n);
  for (int round = 0; round < 2; ++round)
    x += solve(left, after_a_period(system, period, x) - x);  // (2)
  return x;
}

PathStart path_start(const LinearSystem& system, const Trajectory& reference, const Drive& drive,
                     bool periodic) {
  if (!periodic) return {equilibrium(system), 0};
  return {periodic_start(system, reference, drive), first_velocity(reference)};
}

std::vector<double> periodic_model_start(const Trajectory& period, const Drive& drive) {
  const LinearSystem system = balanced(drive_system(drive));
  const VectorXd x = periodic_start(system, period, drive).cwiseProduct(system.scale);
  const bool integral = drive.controller.integral_time > 0;
  const Index others = (drive.controller.delay > 0 ? 2 : 0) + (drive.motor.current_lag > 0 ? 1 : 0);
  const Index bodies = (x.size() - others - (integral ? 1 : 0)) / 2;
  std::vector<double> y;
  for (Index i = 0; i < bodies; ++i) {
    y.push_back(x(i));
    y.push_back(x(bodies + i));
  }
  y.push_back(integral ? x(2 * bodies) : 0);
  for (Index i = x.size() - others; i < x.size(); ++i) y.push_back(x(i));
  y.insert(y.end(), 2, 0.0);  // the integrals
  return y;
}

}  // namespace jounce::validate_detail
