// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "validate/src/drive/drive_model.hpp"

// The derivative of the right-hand side in drive_model.cpp, whose numbers are cited, within a mode.

namespace jounce::validate_detail {
namespace {

/// Rows and columns of a matrix that is stored column by column.
struct Dense {
  double* entries;
  std::size_t size;
  double& operator()(std::size_t row, std::size_t column) const {
    return entries[column * size + row];
  }
};

/// dF/dw at a speed w >= 0: (10).
double slope(const Friction& f, double w) {
  if (f.stribeck_velocity == 0) return 0;
  const double u = w / f.stribeck_velocity;
  return (f.breakaway - f.coulomb) * std::exp(-u * u) * -2 * u / f.stribeck_velocity;
}

}  // namespace

/// dS/dS less loss: the effect of a change of the joint's torque on the sliding body, (9), (10).
double DriveModel::passed(std::size_t i, const double* y) const {
  const double eta = train_[i].efficiency;
  return mode_.slip[i] * joint(i, y) > 0 ? eta : 1 / eta;
}

void DriveModel::jacobian(const Jet& r, const double* y, double* dfdy) const {
  const Dense at{dfdy, size_};
  controller_jacobian(r, y, dfdy);
  const double given = torque(r, y);  // (13)
  const double speed = motor_speed(r, y);
  torque_row(torque_squared(), 2 * given, r, y, dfdy);
  torque_row(work(), speed, r, y, dfdy);
  at(work(), 1) += given;
  for (std::size_t i = 0; i < train_.size(); ++i) {
    at(2 * i, 2 * i + 1) = 1;
    if (!train_[i].rubs() || mode_.slip[i] != 0) body_jacobian(i, r, y, dfdy);
  }
}

/// The row of body i's speed: (9).
void DriveModel::body_jacobian(std::size_t i, const Jet& r, const double* y, double* dfdy) const {
  const Dense at{dfdy, size_};
  const Body& b = train_[i];
  const std::size_t row = 2 * i + 1;
  const double w = y[row] + radians_ * r[1];
  const auto joint_row = [&](std::size_t j, double share) {  // (7)
    const Body& of = train_[j];
    if (of.half_gap > 0 && mode_.contact[j] == 0) return;
    at(row, 2 * j - 2) += share * of.stiffness;
    at(row, 2 * j) -= share * of.stiffness;
    at(row, 2 * j - 1) += share * of.damping;
    at(row, 2 * j + 1) -= share * of.damping;
  };
  if (i == 0)
    torque_row(row, 1 / b.inertia, r, y, dfdy);
  else
    joint_row(i, (b.efficiency < 1 ? passed(i, y) : 1) / b.inertia);
  if (i + 1 < train_.size()) joint_row(i + 1, -1 / b.inertia);
  double damping = b.viscous;
  for (const Friction& f : b.dry) damping += slope(f, std::max(0.0, mode_.slip[i] * w));
  at(row, row) -= damping / b.inertia;
  for (const Gravity& g : b.gravity)
    at(row, 2 * i) -=
        g.torque * g.ratio * std::cos(g.angle + g.ratio * (y[2 * i] + radians_ * r[0])) / b.inertia;
}

/// Adds share times the derivative of the motor's torque to a row.
void DriveModel::torque_row(std::size_t row, double share, const Jet& r, const double* y,
                            double* dfdy) const {
  if (lagging_)
    Dense{dfdy, size_}(row, lag_) += share;
  else
    limited_row(row, share, r, y, dfdy);
}

/// The same of T_l: (4).
void DriveModel::limited_row(std::size_t row, double share, const Jet& r, const double* y,
                             double* dfdy) const {
  if (sampled()) return;
  if (mode_.torque == 0) return commanded_row(row, share, dfdy);
  const Motor& m = drive_.motor;
  const double speed = motor_speed(r, y);
  if (weakened(mode_.torque, speed) && mode_.torque * speed < m.max_velocity)
    Dense{dfdy, size_}(row, 1) -= share * m.torque_limit / (m.max_velocity - m.rated_velocity);
}

/// The same of T_d: (1) to (3).
void DriveModel::commanded_row(std::size_t row, double share, double* dfdy) const {
  asked_row(row, share, dfdy);
  if (delayed_) Dense{dfdy, size_}(row, delay_ + 1) -= 12 * share;
}

/// The same of T_c.
void DriveModel::asked_row(std::size_t row, double share, double* dfdy) const {
  const Dense at{dfdy, size_};
  const Controller& c = drive_.controller;
  at(row, 0) -= share * c.velocity_gain * c.position_gain;
  at(row, 1) -= share * c.velocity_gain;
  at(row, integral()) += share;
}

void DriveModel::controller_jacobian(const Jet& r, const double* y, double* dfdy) const {
  const Dense at{dfdy, size_};
  const Controller& c = drive_.controller;
  if (lagging_) {  // (6)
    limited_row(lag_, 1 / drive_.motor.current_lag, r, y, dfdy);
    at(lag_, lag_) -= 1 / drive_.motor.current_lag;
  }
  if (sampled()) return;
  if (c.integral_time > 0) {  // (5)
    const double share = 1 / c.integral_time;
    at(integral(), 0) -= share * c.velocity_gain * c.position_gain;
    at(integral(), 1) -= share * c.velocity_gain;
    limited_row(integral(), share, r, y, dfdy);
    commanded_row(integral(), -share, dfdy);
  }
  if (delayed_) {  // (3)
    at(delay_, delay_ + 1) = 1 / c.delay;
    asked_row(delay_ + 1, 1 / c.delay, dfdy);
    at(delay_ + 1, delay_ + 1) -= 6 / c.delay;
    at(delay_ + 1, delay_) -= 12 / c.delay;
  }
}

}  // namespace jounce::validate_detail
