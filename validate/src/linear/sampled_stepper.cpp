// SPDX-License-Identifier: Apache-2.0
// The equations at the head of sampled_drive.cpp, with the encoder, the limit and the
// back-calculation of sampled_controller.cpp:
//
//     (1)  th_k = round(th / count) count,  w_k = (th_k - th_(k-1)) / cycle     0 at the first
//     (2)  e_k  = K_p (th_r - th_k) + k_v w_r - w_k
//     (3)  T_k  = K_v e_k + z_k + k_a J a_r + k_f b w_r,  T_l = T_k within the limits at w
//     (4)  z_(k+1) = z_k + (K_v e_k + T_l - T_k) cycle / T_i
//     (5)  T_l takes effect `delay` later: whole cycles and a part of one

#include "validate/src/linear/sampled_stepper.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "jounce/profiles/error.hpp"

#include "validate/src/drive/drive_system.hpp"
#include "validate/src/linear/exponential.hpp"
#include "validate/src/linear/small_product.hpp"

namespace jounce::validate_detail {
namespace {

constexpr double same = 1e-9;        // share of a cycle
constexpr double most_cycles = 1e3;  // greatest number in a delay and in a period

int cycles_of(const Drive& drive, double period) {
  const double cycle = drive.controller.cycle;
  const double cycles = std::nearbyint(period / cycle);
  if (!(cycles >= 1 && cycles <= most_cycles && std::abs(cycles * cycle - period) <= same * cycle))
    throw InputError("controller.cycle", cycle,
                     "must divide the cycle of the axis, " + number(period) +
                         " s, into at most 1000 whole cycles");
  return static_cast<int>(cycles);
}

}  // namespace

SampledStepper::SampledStepper(const Drive& drive, double period)
    : drive_(drive),
      limits_(drive),
      inertia_(total_inertia(drive)),
      viscous_(total_friction(drive)),
      radians_(2 * std::numbers::pi / drive.position_per_rev),
      count_(drive.controller.encoder_counts > 0
                 ? 2 * std::numbers::pi / drive.controller.encoder_counts
                 : 0),
      cycles_(cycles_of(drive, period)) {
  const double cycle = drive.controller.cycle;
  const double whole = std::floor(drive.controller.delay / cycle + same);  // (5)
  const double left = std::max(0.0, drive.controller.delay - whole * cycle);
  if (!(whole <= most_cycles))
    throw InputError("controller.delay", drive.controller.delay, "must be at most 1000 cycles");
  split_ = left > same * cycle;
  const LinearSystem s = balanced(open_drive(drive));
  states_ = static_cast<std::size_t>(s.states());
  // The loads pull all the time: x(t + h) = P x + q, q by one more state that is 1.
  const auto with_loads = [&](double h) {
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(s.states() + 1, s.states() + 1);
    m.topLeftCorner(s.states(), s.states()) = s.a;
    m.topRightCorner(s.states(), 1) = s.b.col(LinearSystem::one);
    return flat(exponential(h * m).topRows(s.states()));
  };
  before_ = with_loads(split_ ? left : cycle);
  if (split_) after_ = with_loads(cycle - left);
  outputs_ = flat(s.c);
  const OpenRest rest = open_rest(drive);
  const std::size_t angles = rest.angles.size();
  for (std::size_t i = 0; i < states_; ++i) {
    const double value = i < angles ? rest.angles[i] : i < 2 * angles ? 0 : rest.torque;
    rest_.push_back(value / s.scale(static_cast<Eigen::Index>(i)));
  }
  rest_torque_ = rest.torque;
  torque_scale_ = s.scale(s.states() - 1);
  next_.resize(states_);
  due_.resize(static_cast<std::size_t>(whole) + 1);
  this->rest(0);
}

void SampledStepper::rest(double position) {
  x_ = rest_;
  std::fill(due_.begin(), due_.end(), rest_torque_);
  read_ = 0;
  zero_ = radians_ * position;
  moved_ = angle_ = 0;
  integral_ = drive_.controller.integral_time > 0 ? rest_torque_ : 0;
}

void SampledStepper::step(const SteppedReference& reference, int periods) {
  const double cycle = drive_.controller.cycle;
  for (int k = 0; k < periods * cycles_; ++k) {
    read(reference.at(k * cycle));
    if (!split_) give();
    advance(before_);
    if (!split_) continue;
    give();
    advance(after_);
  }
  moved_ += reference.at(periods * cycles_ * cycle)[0];
}

void SampledStepper::advance(const Matrix& m) {
  for (std::size_t i = 0; i < states_; ++i) next_[i] = m[states_ * states_ + i];
  for (std::size_t k = 0; k < states_; ++k)
    for (std::size_t i = 0; i < states_; ++i) next_[i] += m[k * states_ + i] * x_[k];
  x_.swap(next_);
}

void SampledStepper::read(const Jet& r) {
  const Controller& k = drive_.controller;
  const double exact = zero_ + output(motor_row);
  const double angle = count_ > 0 ? std::round(exact / count_) * count_ : exact;  // (1)
  const double speed = read_ == 0 ? 0 : (angle - angle_) / k.cycle;
  const double w_r = radians_ * r[1];
  const double error = k.position_gain * (zero_ + radians_ * (moved_ + r[0]) - angle) +
                       k.velocity_feed_forward * w_r - speed;  // (2)
  const double asked = k.velocity_gain * error + integral_ +
                       k.torque_feed_forward * inertia_ * radians_ * r[2] +
                       k.friction_feed_forward * viscous_ * w_r;  // (3)
  const double w = output(velocity_row);
  const double given = std::clamp(asked, limits_.limit(-1, w), limits_.limit(1, w));
  if (k.integral_time > 0)
    integral_ += k.cycle * (k.velocity_gain * error + given - asked) / k.integral_time;  // (4)
  angle_ = angle;
  due_[read_ % due_.size()] = given;
  ++read_;
}

void SampledStepper::give() {
  x_[states_ - 1] = due_[read_ % due_.size()] / torque_scale_;  // the oldest one: read `whole` ago
}

double SampledStepper::output(std::size_t row) const {
  double sum = 0;
  for (std::size_t k = 0; k < states_; ++k) sum += outputs_[k * drive_rows + row] * x_[k];
  return sum;
}

DriveSample SampledStepper::sample(double unit) const {
  DriveSample s;
  s.motor = unit * output(motor_row);
  s.load = unit * output(load_row);
  s.velocity = output(velocity_row);
  s.torque = output(torque_row);
  return s;
}

}  // namespace jounce::validate_detail
