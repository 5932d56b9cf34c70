// SPDX-License-Identifier: Apache-2.0
// A drive at its torque limits, in deviations from its reference. T_d is the torque that its
// controller demands and T_l the torque of the motor (equations (1) to (8) of drive_system.cpp, (4)
// and (5) of drive_model.cpp):
//
//     (1)  x' = A x + B w + g (T_l - T_d),   w = (1, r', r''),   T_d = c x + d w
//     (2)  T_l = T_d within the limits, else the limit that it is beyond: L, or where the speed w_0 leaves
//          less of it, L_0 - k w_0 with k = T_max / (w_max - w_rated), L_0 = k w_max
//
// g is 1 / J_0 in the row of the motor, or 1 / tau in that of the lag of the current loop, and
// 1 / T_i in that of the integral part (the back-calculation). There are therefore three linear
// systems: (1) with T_l = T_d, and at the two limits
//
//     (3)  x' = (A - g c) x + (B - g d) w + g L
//     (4)  x' = (A - g (c + k c_w)) x + (B - g (d + k d_w)) w + g L_0,   w_0 = c_w x + d_w w
//
// T_l is continuous at the changes between them: the state alone determines which of them applies.
// With the quintic between two setpoints, whose derivatives w_5 = (1, r', ..., r^(5)) obey
// w_5' = N w_5, each system has an exponential over a time h,
//
//     (5)  x(t + h) = P_h x(t) + Q_h (w_5(t), L)
//
// which is exact except for rounding, as long as one system applies. A period consists of `first`
// steps. A step with different systems at its ends is halved, at most `levels` times. The remaining
// error is in the instant of the change: period / (first 2^levels), during which the two systems
// differ by the change of T_d.

#include "validate/src/linear/continuous_stepper.hpp"

#include <cmath>
#include <numbers>

#include "validate/src/drive/drive_system.hpp"
#include "validate/src/linear/exponential.hpp"
#include "validate/src/linear/small_product.hpp"

namespace jounce::validate_detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr int first = 4;
constexpr std::size_t levels = 6;
constexpr Index missing = LinearSystem::inputs;  // column of g

/// The system with T_l - T_d as one more input.
LinearSystem with_limit(const Drive& drive) {
  LinearSystem s = watched_drive(drive);
  const double lag = drive.motor.current_lag;
  const LinearSystem open = open_drive(drive);
  const Index n = (open.states() - (lag > 0 ? 2 : 1)) / 2;  // bodies
  s.b.conservativeResize(Eigen::NoChange, missing + 1);
  s.b.col(missing).setZero();
  if (lag > 0)  // T' = (T_d - T) / tau is a row of the system
    s.b(s.states() - 1, missing) = 1 / lag;
  else
    s.b(n, missing) = open.a(n, open.states() - 1);
  if (drive.controller.integral_time > 0) s.b(2 * n, missing) = 1 / drive.controller.integral_time;
  return balanced(s);
}

/// (5) for a length of time: [P, Q].
std::vector<double> over(const MatrixXd& a, const MatrixXd& b, const Eigen::VectorXd& held,
                         double h) {
  constexpr auto chain = static_cast<Index>(SteppedReference::derivatives + 1);
  const Index n = a.rows();
  MatrixXd m = MatrixXd::Zero(n + chain + 1, n + chain + 1);
  m.topLeftCorner(n, n) = a;
  m.block(0, n, n, LinearSystem::inputs) = b.leftCols(LinearSystem::inputs);
  m.topRightCorner(n, 1) = held;
  for (Index k = 1; k + 1 < chain; ++k) m(n + k, n + k + 1) = 1;
  const MatrixXd e = exponential(h * m).topRows(n);
  return {e.data(), e.data() + e.size()};
}

}  // namespace

ContinuousStepper::ContinuousStepper(const Drive& drive, double period)
    : period_(period), lag_(drive.motor.current_lag > 0), limits_(drive) {
  const LinearSystem s = with_limit(drive);
  states_ = static_cast<std::size_t>(s.states());
  MatrixXd outputs(watched_rows, s.states() + LinearSystem::inputs);
  outputs << s.c, s.d;
  outputs_ = flat(outputs);
  const double slope = torque_slope(drive.motor);
  const Eigen::VectorXd g = s.b.col(missing);
  for (std::size_t which = free; which < systems; ++which) {
    if (which == weakened && slope == 0) continue;
    const double share = which == free ? 0 : 1;
    const double k = which == weakened ? slope : 0;
    const MatrixXd a = s.a - g * (share * s.c.row(demand_row) + k * s.c.row(velocity_row));
    const MatrixXd b =
        s.b.leftCols(missing) - g * (share * s.d.row(demand_row) + k * s.d.row(velocity_row));
    for (std::size_t level = 0; level <= levels; ++level)
      steps_[which].push_back(
          over(a, b, share * g, std::ldexp(period / first, -static_cast<int>(level))));
  }
  next_.assign(levels + 1, Matrix(states_));
  rest_ = flat(equilibrium(s));
  follows_velocity_ = flat(s.follows_velocity);
  x_ = rest_;
}

void ContinuousStepper::rest() {
  x_ = rest_;  // always this size, so that nothing is allocated
  reference_ = {};
  velocity_ = end_ = 0;
}

void ContinuousStepper::step(const SteppedReference& reference, int periods) {
  reference_ = reference;
  const double jump = reference.at(0)[1] - velocity_;  // the axis goes on, the deviation steps
  for (std::size_t i = 0; i < states_; ++i) x_[i] -= follows_velocity_[i] * jump;
  for (int k = 0; k < periods * first; ++k) go(k * (period_ / first), 0);
  end_ = periods * period_;
  velocity_ = reference.at(end_)[1];
}

ContinuousStepper::Inputs ContinuousStepper::inputs(double t) const {
  const auto rates = reference_.rates(t);
  Inputs w{1};
  for (std::size_t k = 0; k < rate_count; ++k) w[k + 1] = rates[k];
  return w;
}

double ContinuousStepper::row(const Matrix& rows, std::size_t which, const std::vector<double>& x,
                              const Inputs& w) const {
  constexpr std::size_t height = watched_rows;
  double sum = 0;
  for (std::size_t k = 0; k < states_; ++k) sum += rows[k * height + which] * x[k];
  for (std::size_t k = 0; k < LinearSystem::inputs; ++k)
    sum += rows[(states_ + k) * height + which] * w[k];
  return sum;
}

double ContinuousStepper::demand(const std::vector<double>& x, const Inputs& w) const {
  return row(outputs_, demand_row, x, w);
}

ContinuousStepper::Hold ContinuousStepper::hold(const std::vector<double>& x,
                                                const Inputs& w) const {
  const double asked = demand(x, w);
  const double speed = row(outputs_, velocity_row, x, w);
  const int sign = asked > 0 ? 1 : -1;
  const double limit = limits_.limit(sign, speed);
  if (sign * asked <= sign * limit) return {};  // (2)
  if (limit == 0 || !limits_.weakened(sign, speed)) return {limited, limit};
  const Motor& m = limits_.drive().motor;
  return {weakened, sign * torque_slope(m) * m.max_velocity};
}

/// The limit that the torque exceeds.
double ContinuousStepper::held(const std::vector<double>& x, const Inputs& w) const {
  return limits_.limit(demand(x, w) > 0 ? 1 : -1, row(outputs_, velocity_row, x, w));
}

/// One step of a level from t, or the two below where the systems differ at its ends.
void ContinuousStepper::go(double t, std::size_t level) {
  const double h = std::ldexp(period_ / first, -static_cast<int>(level));
  Inputs w = inputs(t);
  const Hold before = hold(x_, w);
  w[rate_count + 1] = before.torque;
  const Matrix& m = steps_[before.system][level];
  std::vector<double>& next = next_[level];
  for (std::size_t i = 0; i < states_; ++i) next[i] = 0;
  for (std::size_t k = 0; k < states_ + w.size(); ++k) {  // (5)
    const double factor = k < states_ ? x_[k] : w[k - states_];
    for (std::size_t i = 0; i < states_; ++i) next[i] += m[k * states_ + i] * factor;
  }
  if (level < levels && hold(next, inputs(t + h)) != before) {
    go(t, level + 1);
    go(t + h / 2, level + 1);
  } else {
    x_.swap(next);
  }
}

DriveSample ContinuousStepper::sample(double unit) const {
  const Inputs w = inputs(end_);
  DriveSample s;
  s.motor = unit * row(outputs_, motor_row, x_, w);
  s.load = unit * row(outputs_, load_row, x_, w);
  s.velocity = row(outputs_, velocity_row, x_, w);
  s.torque = lag_ || hold(x_, w).system == free ? row(outputs_, torque_row, x_, w) : held(x_, w);
  return s;
}

}  // namespace jounce::validate_detail
