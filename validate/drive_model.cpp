// A servo axis: motor (m) and load (l) on an elastic shaft, reference (r); angles in rad at the
// motor's shaft, torques in N m.
//
//     (1)  e    = K_p (th_r - th_m) + k_v w_r - w_m            position loop, velocity feed-forward
//     (2)  T_c  = K_v e + z + k_a (J_m + J_l) a_r              velocity loop, torque feed-forward
//     (3)  T    = T_c, held within +-T_max                     torque limit
//     (4)  z'   = (K_v e + T - T_c) / T_i                      integral part, with back-calculation
//     (5)  T_s  = c (th_m - th_l) + d (w_m - w_l)              shaft
//     (6)  J_m w_m' = T - T_s - b_m w_m                        motor
//     (7)  J_l w_l' = T_s - b_l w_l                            load
//     (8)  W'   = T^2                                          rms torque = sqrt(W / duration)
//
// Within the limit (4) is the usual z' = K_v e / T_i. At the limit the term T - T_c drains z with
// the time constant T_i, so that it does not wind up; T, and so the whole right-hand side, is
// continuous where the limit is met, hence a mode never chatters.
//
// What is integrated are deviations from the reference,
//
//     (9)  x_m = th_m - th_r,  x_l = th_l - th_r,   x_m'' = w_m' - a_r,  x_l'' = w_l' - a_r
//
// so that errors are relative to the following error and not to how far the axis has travelled.

#include "jounce/validate/detail/drive_model.hpp"

#include <numbers>

namespace jounce::detail {

DriveModel::DriveModel(const Drive& drive)
    : drive_(drive), radians_(2 * std::numbers::pi / drive.position_per_rev) {}

double DriveModel::velocity_error(const Jet& r, const double* y) const {
  return -drive_.controller.position_gain * y[motor] +
         (drive_.controller.velocity_feed_forward - 1) * radians_ * r[1] -
         y[motor_speed];  // (1), (9)
}

double DriveModel::commanded(const Jet& r, const double* y) const {
  return drive_.controller.velocity_gain * velocity_error(r, y) + y[integral] +
         drive_.controller.torque_feed_forward * inertia() * radians_ * r[2];  // (2)
}

double DriveModel::torque(const Jet& r, const double* y) const {
  return mode_ == 0 ? commanded(r, y) : mode_ * drive_.motor.torque_limit;  // (3)
}

void DriveModel::rhs(const Jet& r, const double* y, double* dy) const {
  const Drive& d = drive_;
  const double w_r = radians_ * r[1];
  const double a_r = radians_ * r[2];
  const double asked = commanded(r, y);
  const double given = mode_ == 0 ? asked : mode_ * d.motor.torque_limit;
  const double shaft = d.train[0].stiffness * (y[motor] - y[load]) +
                       d.train[0].damping * (y[motor_speed] - y[load_speed]);  // (5)
  dy[motor] = y[motor_speed];
  dy[load] = y[load_speed];
  dy[motor_speed] =
      (given - shaft - d.motor.friction.viscous * (y[motor_speed] + w_r)) / d.motor.inertia -
      a_r;  // (6)
  dy[load_speed] =
      (shaft - d.train[0].friction.viscous * (y[load_speed] + w_r)) / d.train[0].inertia -
      a_r;  // (7)
  dy[integral] = d.controller.integral_time > 0
                     ? (d.controller.velocity_gain * velocity_error(r, y) + given - asked) /
                           d.controller.integral_time
                     : 0;              // (4)
  dy[torque_squared] = given * given;  // (8)
}

void DriveModel::jacobian(const Jet& r, const double* y, double* dfdy) const {
  const Drive& d = drive_;
  const auto at = [dfdy](State row, State column) -> double& { return dfdy[column * size + row]; };
  const double kp = -d.controller.velocity_gain * d.controller.position_gain;  // dT_c / dx_m
  const double kv = -d.controller.velocity_gain;                               // dT_c / dx_m'
  const double free = mode_ == 0 ? 1 : 0;                                      // dT / dT_c

  at(motor, motor_speed) = 1;
  at(load, load_speed) = 1;

  at(motor_speed, motor) = (free * kp - d.train[0].stiffness) / d.motor.inertia;
  at(motor_speed, motor_speed) =
      (free * kv - d.train[0].damping - d.motor.friction.viscous) / d.motor.inertia;
  at(motor_speed, load) = d.train[0].stiffness / d.motor.inertia;
  at(motor_speed, load_speed) = d.train[0].damping / d.motor.inertia;
  at(motor_speed, integral) = free / d.motor.inertia;

  at(load_speed, motor) = d.train[0].stiffness / d.train[0].inertia;
  at(load_speed, motor_speed) = d.train[0].damping / d.train[0].inertia;
  at(load_speed, load) = -d.train[0].stiffness / d.train[0].inertia;
  at(load_speed, load_speed) =
      -(d.train[0].damping + d.train[0].friction.viscous) / d.train[0].inertia;

  if (d.controller.integral_time > 0) {
    at(integral, motor) = free * kp / d.controller.integral_time;
    at(integral, motor_speed) = free * kv / d.controller.integral_time;
    at(integral, integral) = (free - 1) / d.controller.integral_time;
  }

  const double twice = 2 * free * torque(r, y);
  at(torque_squared, motor) = twice * kp;
  at(torque_squared, motor_speed) = twice * kv;
  at(torque_squared, integral) = twice;
}

}  // namespace jounce::detail
