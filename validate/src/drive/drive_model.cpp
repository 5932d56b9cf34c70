// SPDX-License-Identifier: Apache-2.0
// A servo axis: the motor (body 0) and the bodies behind it on elastic joints, along the reference
// (index r). Angles in rad at the motor's shaft, torques in N m. B, C and J are the sums of viscous
// friction, Coulomb friction and inertia.
//
//     (1)  e    = K_p (th_r - th_0) + k_v w_r - w_0            position loop, velocity feed-forward
//     (2)  T_c  = K_v e + z + k_a J a_r + k_f (B w_r + C sgn w_r)   velocity loop, feed-forwards
//     (3)  T_d  = T_c after the delay tau, by Pade's approximant of order (2, 2),
//                 (s^2 - 6 s + 12) / (s^2 + 6 s + 12) with s in 1/tau:
//                 q_1' = q_2 / tau,  q_2' = (T_c - 6 q_2 - 12 q_1) / tau,  T_d = T_c - 12 q_2
//     (4)  T_l  = T_d, held within the torque limit; driving (T w_0 > 0) the limit falls along a line
//                 from T_max at the rated velocity to 0 at the greatest
//     (5)  z'   = (K_v e + T_l - T_d) / T_i                    integral part, with back-calculation
//     (6)  T'   = (T_l - T) / tau_i                            current loop; T = T_l without a lag
//     (7)  S_i  = c (phi - f g / 2) + d phi',  phi = th_(i-1) - th_i   joint; f = 1, -1: the flank
//                 that touches, S_i = 0 in the gap (f = 0)
//     (8)  the flank f touches while both f phi > g / 2 and f S_i > 0: it presses, and does not pull
//     (9)  J_i w_i' = N_i - s_i (F(w_i) + L(s_i)),  N_i = S_i - S_(i+1) - b_i w_i - M_i - G_i
//                 M load, G gravity; S_0 = T; s_i the sign of w_i
//     (10) F(w) = sum of T_c + (T_s - T_c) exp(-(w / w_s)^2);  L(s) = (1 - eta) |S_i| where the
//                 joint drives (s S_i > 0), (1 / eta - 1) |S_i| where it is driven
//     (11) a body at rest stays so (w_i = 0) while -(F(0) + L(-1)) <= N_i <= F(0) + L(1)
//
// Within the limit, (5) is the usual z' = K_v e / T_i. At the limit, the term T_l - T_d reduces z
// with the time constant T_i, which prevents windup. T_l is continuous at the limit.
//
// With dry friction as a plain sign(w), a solver would step back and forth over w = 0 without end.
// With tanh(w / eps), an axis at rest would creep. Sticking is therefore a separate mode (11), in
// which a body is exactly at rest.
//
// The integrated variables are the deviations from the reference
//
//     (12)  x_i = th_i - th_r,  x_i'' = w_i' - a_r
//
// Errors are then relative to the following error and not to the distance that the axis has
// traveled. In addition, these integrals are computed:
//
//     (13) W' = T^2,  E' = T w_0                               rms torque, work

#include "validate/src/drive/drive_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jounce::validate_detail {
namespace {

/// Loss of the gear before the body for a joint torque and a sign of motion: L of (10).
double loss(double efficiency, int sign, double joint) {
  return std::abs(joint) * (sign * joint > 0 ? 1 - efficiency : 1 / efficiency - 1);
}

/// F of (10) at a speed w >= 0.
double dry(const Friction& f, double w) {
  const double u = w / f.stribeck_velocity;
  return f.coulomb + (f.stribeck_velocity > 0 ? (f.breakaway - f.coulomb) * std::exp(-u * u) : 0);
}

}  // namespace

DriveModel::DriveModel(const Drive& drive)
    : drive_(drive),
      train_(bodies(drive)),
      radians_(2 * std::numbers::pi / drive.position_per_rev),
      inertia_(validate_detail::inertia(train_)),
      viscous_(viscous(train_)),
      coulomb_(coulomb(train_)),
      delayed_(drive.controller.delay > 0 && drive.controller.cycle == 0),
      lagging_(drive.motor.current_lag > 0),
      load_(2 * (train_.size() - (drive.pendulum ? 2 : 1))),
      delay_(integral() + 1),
      lag_(delay_ + (delayed_ ? 2 : 0)),
      size_(lag_ + (lagging_ ? 1 : 0) + 2) {
  mode_.slip.resize(train_.size());
  mode_.contact.resize(train_.size());
}

// ---- controller ---------------------------------------------------------------------------------

double DriveModel::velocity_error(const Jet& r, double angle, double speed) const {
  const Controller& c = drive_.controller;
  return -c.position_gain * angle + (c.velocity_feed_forward - 1) * radians_ * r[1] - speed;  // (1)
}

double DriveModel::asked(const Jet& r, double velocity_error, double integral) const {
  const Controller& c = drive_.controller;
  return c.velocity_gain * velocity_error + integral +
         c.torque_feed_forward * inertia_ * radians_ * r[2] +
         c.friction_feed_forward * (viscous_ * radians_ * r[1] + coulomb_ * mode_.feed);  // (2)
}

double DriveModel::asked(const Jet& r, const double* y) const {
  return asked(r, velocity_error(r, y[0], y[1]), y[integral()]);
}

double DriveModel::commanded(const Jet& r, const double* y) const {
  if (sampled()) return held_;
  return asked(r, y) - (delayed_ ? 12 * y[delay_ + 1] : 0);  // (3)
}

double DriveModel::motor_speed(const Jet& r, const double* y) const {
  return y[1] + radians_ * r[1];
}

double DriveModel::limit(int sign, double motor_speed) const {
  const Motor& m = drive_.motor;
  const double driving = sign * motor_speed;
  if (m.max_velocity == 0 || driving <= m.rated_velocity) return sign * m.torque_limit;
  const double left = (m.max_velocity - driving) / (m.max_velocity - m.rated_velocity);
  return sign * m.torque_limit * std::max(0.0, left);  // (4)
}

bool DriveModel::weakened(int sign, double motor_speed) const {
  const Motor& m = drive_.motor;
  return m.max_velocity > 0 && sign * motor_speed > m.rated_velocity;
}

double DriveModel::limited(const Jet& r, const double* y) const {
  return mode_.torque == 0 || sampled() ? commanded(r, y) : limit(mode_.torque, motor_speed(r, y));
}

double DriveModel::torque(const Jet& r, const double* y) const {
  return lagging_ ? y[lag_] : limited(r, y);
}

void DriveModel::controller_rhs(const Jet& r, const double* y, double* dy) const {
  const Controller& c = drive_.controller;
  const double given = limited(r, y);
  if (lagging_) dy[lag_] = (given - y[lag_]) / drive_.motor.current_lag;  // (6)
  dy[integral()] = 0;
  if (sampled()) return;
  const double e = velocity_error(r, y[0], y[1]);
  if (c.integral_time > 0)
    dy[integral()] = (c.velocity_gain * e + given - commanded(r, y)) / c.integral_time;  // (5)
  if (!delayed_) return;
  dy[delay_] = y[delay_ + 1] / c.delay;  // (3)
  dy[delay_ + 1] = (asked(r, y) - 6 * y[delay_ + 1] - 12 * y[delay_]) / c.delay;
}

// ---- train --------------------------------------------------------------------------------------

double DriveModel::joint(std::size_t i, const double* y) const {
  const Body& b = train_[i];
  const double twist = y[2 * i - 2] - y[2 * i];
  const double rate = y[2 * i - 1] - y[2 * i + 1];
  if (b.half_gap == 0) return b.stiffness * twist + b.damping * rate;
  const int flank = mode_.contact[i];
  return flank == 0 ? 0 : b.stiffness * (twist - flank * b.half_gap) + b.damping * rate;  // (7)
}

double DriveModel::pressed(std::size_t i, int flank, const double* y) const {
  const Body& b = train_[i];
  const double spring = b.stiffness * (flank * (y[2 * i - 2] - y[2 * i]) - b.half_gap);
  return spring + std::min(0.0, flank * b.damping * (y[2 * i - 1] - y[2 * i + 1]));  // (8)
}

double DriveModel::loads(std::size_t i, double angle) const {
  double torque = train_[i].load;
  for (const Gravity& g : train_[i].gravity)
    torque += g.torque * std::sin(g.angle + g.ratio * angle);
  return torque;
}

double DriveModel::net(std::size_t i, const Jet& r, const double* y) const {
  const double before = i == 0 ? torque(r, y) : joint(i, y);
  const double behind = i + 1 < train_.size() ? joint(i + 1, y) : 0;
  return before - behind - train_[i].viscous * (y[2 * i + 1] + radians_ * r[1]) -
         loads(i, y[2 * i] + radians_ * r[0]);  // (9)
}

double DriveModel::holding(std::size_t i, int sign, const double* y) const {
  const Body& b = train_[i];
  double torque = b.efficiency < 1 ? loss(b.efficiency, sign, joint(i, y)) : 0;
  for (const Friction& f : b.dry) torque += f.breakaway;
  return torque;  // (11)
}

double DriveModel::rubbing(std::size_t i, double speed, const double* y) const {
  const Body& b = train_[i];
  const int sign = mode_.slip[i];
  double torque = b.efficiency < 1 ? loss(b.efficiency, sign, joint(i, y)) : 0;
  for (const Friction& f : b.dry) torque += dry(f, std::max(0.0, sign * speed));
  return sign * torque;  // (9), (10)
}

void DriveModel::rhs(const Jet& r, const double* y, double* dy) const {
  const double th_r = radians_ * r[0];
  const double w_r = radians_ * r[1];
  const double a_r = radians_ * r[2];
  controller_rhs(r, y, dy);
  double before = torque(r, y);
  dy[torque_squared()] = before * before;  // (13)
  dy[work()] = before * (y[1] + w_r);
  for (std::size_t i = 0; i < train_.size(); ++i) {
    const Body& b = train_[i];
    const double behind = i + 1 < train_.size() ? joint(i + 1, y) : 0;
    const double speed = y[2 * i + 1] + w_r;
    double sum = before - behind - b.viscous * speed - b.load;
    if (!b.gravity.empty()) sum -= loads(i, y[2 * i] + th_r) - b.load;
    dy[2 * i] = y[2 * i + 1];
    if (!b.rubs())
      dy[2 * i + 1] = sum / b.inertia - a_r;  // (9), (12)
    else
      dy[2 * i + 1] = mode_.slip[i] == 0 ? -a_r : (sum - rubbing(i, speed, y)) / b.inertia - a_r;
    before = behind;
  }
}

// ---- rest ---------------------------------------------------------------------------------------

void DriveModel::rest_train(double reference, double* y) const {
  double twist = 0;
  double torque = 0;
  for (std::size_t k = 0; k < train_.size(); ++k) torque += loads(k, y[2 * k] + reference);
  const Controller& c = drive_.controller;
  y[integral()] = c.integral_time > 0 ? torque : 0;
  y[0] = c.integral_time > 0 ? 0 : -torque / (c.velocity_gain * c.position_gain);
  if (delayed_) y[delay_] = torque / 12;
  if (lagging_) y[lag_] = torque;
  for (std::size_t i = 1; i < train_.size(); ++i) {
    torque -= loads(i - 1, y[2 * i - 2] + reference);
    twist = torque / train_[i].stiffness +
            (torque == 0 ? 0 : std::copysign(train_[i].half_gap, torque));
    y[2 * i] = y[2 * i - 2] - twist;
  }
}

void DriveModel::shift(const Jet& before, const Jet& after, double* y) const {
  for (std::size_t i = 0; i < integral(); i += 2) {
    y[i] -= radians_ * (after[0] - before[0]);
    y[i + 1] -= radians_ * (after[1] - before[1]);
  }
}

void DriveModel::rest(const Jet& r, double* y) {
  std::fill_n(y, size_, 0.0);
  // Gravity depends on the twist that it causes: a few rounds, each better by the ratio of
  // gravity's stiffness to the shaft's.
  for (int round = 0; round < 20; ++round) rest_train(radians_ * r[0], y);
  held_ = asked(r, y);
  mode_.torque = 0;
  for (std::size_t i = 1; i < train_.size(); ++i) {
    const double twist = y[2 * i - 2] - y[2 * i];
    mode_.contact[i] = train_[i].half_gap == 0 || twist == 0 ? 0 : (twist > 0 ? 1 : -1);
  }
  std::fill(mode_.slip.begin(), mode_.slip.end(), 0);
}

}  // namespace jounce::validate_detail
