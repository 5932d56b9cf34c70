// SPDX-License-Identifier: Apache-2.0
// A drive without nonlinear parts: bodies 0 (the motor) to n in a chain, joined by shafts. A mass
// that is joined rigidly to the one before it is one body with it. A pendulum is one more body, on
// the last mass. With angles x_i = th_i - th_r relative to the reference,
//
//     (1)  e     = -K_p x_0 + (k_v - 1) w_r - x_0'                   both loops' error
//     (2)  T_c   = K_v e + z + k_a J a_r + k_f b w_r                  J, b: of all bodies together
//     (3)  z'    = K_v e / T_i
//     (4)  T'    = (T_d - T) / tau                                    tau = 0: T = T_d
//     (5)  S_i   = c_i (x_(i-1) - x_i) + d_i (x_(i-1)' - x_i')        shaft before body i
//     (6)  J_i x_i'' = [T if i = 0] + S_i - S_(i+1) - b_i (x_i' + w_r) - L_i - J_i a_r
//     (8)  T_d   = T_c after a delay D by Pade's approximant of order (2, 2), as drive_model.cpp:
//          q_1' = q_2 / D,  q_2' = (T_c - 6 q_2 - 12 q_1) / D,  T_d = T_c - 12 q_2
//     (7)  pendulum of share s on the last mass, inertia J:
//          its body has s J, the mass (1 - s) J;  c = s J (2 pi f)^2,  d = 2 D s J 2 pi f
//     (9)  within its limits, driving or braking: |T_d| <= T_max, and |T_d + k w_0| <= k w_max with
//          k = T_max / (w_max - w_rated), the line on which the limit falls to nothing at w_max

#include "validate/src/drive/drive_system.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "validate/src/drive/dense.hpp"

namespace jounce::validate_detail {
namespace {

struct LinkedBody {
  double inertia = 0;
  double friction = 0;
  double load = 0;
  double stiffness = 0;  // stiffness of the shaft to the body before
  double damping = 0;
};

struct DriveChain {
  std::vector<LinkedBody> bodies;
  std::size_t load = 0;  // the body of the last mass
};

DriveChain chain_of(const Drive& drive) {
  DriveChain chain;
  chain.bodies.push_back({drive.motor.inertia, drive.motor.friction.viscous, 0, 0, 0});
  double last = drive.motor.inertia;
  for (const Mass& m : drive.train) {
    if (m.stiffness > 0) chain.bodies.push_back({0, 0, 0, m.stiffness, m.damping});
    LinkedBody& body = chain.bodies.back();
    body.inertia += m.inertia;
    body.friction += m.friction.viscous;
    body.load += m.load_torque;
    last = m.inertia;
  }
  chain.load = chain.bodies.size() - 1;
  if (drive.pendulum) {  // (7)
    const Pendulum& p = *drive.pendulum;
    const double w = 2 * std::numbers::pi * p.frequency;
    const double hung = p.share * last;
    chain.bodies.back().inertia -= hung;
    chain.bodies.push_back({hung, 0, 0, hung * w * w, 2 * p.damping * hung * w});
  }
  return chain;
}

using Eigen::Index;
using Row = Eigen::RowVectorXd;

/// A linear form in the states and the inputs.
struct Form {
  Row x;
  Row w;
};

/// The bodies alone, driven by `torque`: (5), (6). The states are angles, then speeds, then others
/// up to `states`.
void add_bodies(LinearSystem& s, const DriveChain& chain, const Form& torque, double radians) {
  const auto n = static_cast<Index>(chain.bodies.size());
  for (Index i = 0; i < n; ++i) {
    const LinkedBody& body = chain.bodies[static_cast<std::size_t>(i)];
    s.a(i, n + i) = 1;
    s.a(n + i, n + i) -= body.friction / body.inertia;
    s.b(n + i, LinearSystem::one) = -body.load / body.inertia;
    s.b(n + i, LinearSystem::velocity) = -radians * body.friction / body.inertia;
    s.b(n + i, LinearSystem::acceleration) = -radians;
    s.follows_position(i) = radians;
    s.follows_velocity(n + i) = radians;
    if (i == 0) continue;
    const Index sides[2] = {i - 1, i};
    for (const Index side : sides) {  // the shaft pulls body i towards i-1 and back
      const double by = (side == i ? 1 : -1) / chain.bodies[static_cast<std::size_t>(side)].inertia;
      s.a(n + side, i - 1) += by * body.stiffness;
      s.a(n + side, i) -= by * body.stiffness;
      s.a(n + side, n + i - 1) += by * body.damping;
      s.a(n + side, n + i) -= by * body.damping;
    }
  }
  s.a.row(n) += torque.x / chain.bodies[0].inertia;
  s.b.row(n) += torque.w / chain.bodies[0].inertia;
}

LinearSystem empty(Index states) {
  LinearSystem s;
  s.a.setZero(states, states);
  s.b.setZero(states, LinearSystem::inputs);
  s.c.setZero(drive_rows, states);
  s.d.setZero(drive_rows, LinearSystem::inputs);
  s.follows_position.setZero(states);
  s.follows_velocity.setZero(states);
  s.scale.setOnes(states);
  return s;
}

void add_outputs(LinearSystem& s, const DriveChain& chain, const Form& torque, double radians) {
  s.c.row(torque_row) = torque.x;
  s.d.row(torque_row) = torque.w;
  s.c(motor_row, 0) = 1;
  s.c(load_row, static_cast<Index>(chain.load)) = 1;
  s.c(velocity_row, static_cast<Index>(chain.bodies.size())) = 1;
  s.d(velocity_row, LinearSystem::velocity) = radians;
}

Form state(Index states, Index which) {
  Form f{Row::Zero(states), Row::Zero(LinearSystem::inputs)};
  f.x(which) = 1;
  return f;
}

/// x_which' = f / time.
void set_rate(LinearSystem& s, Index which, const Form& f, double time) {
  s.a.row(which) = f.x / time;
  s.b.row(which) = f.w / time;
}

/// (8), its states q_1 and q_2 from `first` on.
Form add_delay(LinearSystem& s, Index first, Form torque, double delay) {
  Form rate = torque;
  rate.x(first) -= 12;
  rate.x(first + 1) -= 6;
  set_rate(s, first, state(s.states(), first + 1), delay);
  set_rate(s, first + 1, rate, delay);
  torque.x(first + 1) -= 12;
  return torque;
}

}  // namespace

double total_inertia(const Drive& drive) {
  double sum = drive.motor.inertia;
  for (const Mass& m : drive.train) sum += m.inertia;
  return sum;
}

double total_friction(const Drive& drive) {
  double sum = drive.motor.friction.viscous;
  for (const Mass& m : drive.train) sum += m.friction.viscous;
  return sum;
}

LinearSystem drive_system(const Drive& drive) {
  const Controller& k = drive.controller;
  const DriveChain chain = chain_of(drive);
  const auto n = static_cast<Index>(chain.bodies.size());
  const bool integral = k.integral_time > 0;
  const bool delayed = k.delay > 0;
  const bool lag = drive.motor.current_lag > 0;
  const Index delay_state = 2 * n + (integral ? 1 : 0);
  const Index states = delay_state + (delayed ? 2 : 0) + (lag ? 1 : 0);
  const double radians = 2 * std::numbers::pi / drive.position_per_rev;
  LinearSystem s = empty(states);

  Form error{Row::Zero(states), Row::Zero(LinearSystem::inputs)};  // K_v e of (1)
  error.x(0) = -k.velocity_gain * k.position_gain;
  error.x(n) = -k.velocity_gain;
  error.w(LinearSystem::velocity) = k.velocity_gain * (k.velocity_feed_forward - 1) * radians;

  Form torque = error;  // (2)
  if (integral) torque.x(2 * n) = 1;
  torque.w(LinearSystem::acceleration) = k.torque_feed_forward * total_inertia(drive) * radians;
  torque.w(LinearSystem::velocity) += k.friction_feed_forward * total_friction(drive) * radians;

  if (integral) set_rate(s, 2 * n, error, k.integral_time);  // (3)
  if (delayed) torque = add_delay(s, delay_state, torque, k.delay);
  if (lag) {  // (4)
    Form missing = torque;
    missing.x(states - 1) -= 1;
    set_rate(s, states - 1, missing, drive.motor.current_lag);
    torque = state(states, states - 1);
  }
  add_bodies(s, chain, torque, radians);
  add_outputs(s, chain, torque, radians);
  return s;
}

double torque_slope(const Motor& m) {
  return m.max_velocity > 0 ? m.torque_limit / (m.max_velocity - m.rated_velocity) : 0;
}

LinearSystem watched_drive(const Drive& drive) {
  LinearSystem s = drive_system(drive);
  const DriveChain chain = chain_of(drive);
  const auto load = static_cast<Index>(chain.load);
  const Index last = s.states() - 1;
  s.c.conservativeResize(watched_rows, Eigen::NoChange);
  s.d.conservativeResize(watched_rows, Eigen::NoChange);
  s.c.bottomRows(watched_rows - drive_rows).setZero();
  s.d.bottomRows(watched_rows - drive_rows).setZero();
  s.c(load_velocity_row, static_cast<Index>(chain.bodies.size()) + load) = 1;
  if (drive.pendulum) {
    s.c(swing_row, load + 1) = 1;
    s.c(swing_row, load) = -1;
  }
  s.c.row(demand_row) = s.c.row(torque_row);
  s.d.row(demand_row) = s.d.row(torque_row);
  if (const double lag = drive.motor.current_lag; lag > 0) {  // (4), solved for T_d
    s.c.row(demand_row) += lag * s.a.row(last);
    s.d.row(demand_row) += lag * s.b.row(last);
  }
  const double k = torque_slope(drive.motor);
  s.c.row(envelope_row) = s.c.row(demand_row) + k * s.c.row(velocity_row);  // (9)
  s.d.row(envelope_row) = s.d.row(demand_row) + k * s.d.row(velocity_row);
  return s;
}

Eigen::VectorXd equilibrium(const LinearSystem& system) {
  const Eigen::VectorXd pull = system.b.col(LinearSystem::one);
  if (pull.isZero(0)) return pull;
  return solve_full(system.a, -pull);
}

OpenRest open_rest(const Drive& drive) {
  const DriveChain chain = chain_of(drive);
  OpenRest rest;
  for (const LinkedBody& body : chain.bodies) rest.torque += body.load;
  double torque = rest.torque;
  const Controller& k = drive.controller;
  double angle = k.integral_time > 0 ? 0 : -torque / (k.velocity_gain * k.position_gain);
  rest.angles.push_back(angle);
  for (std::size_t i = 1; i < chain.bodies.size(); ++i) {
    torque -= chain.bodies[i - 1].load;
    angle -= torque / chain.bodies[i].stiffness;
    rest.angles.push_back(angle);
  }
  return rest;
}

LinearSystem open_drive(const Drive& drive) {
  const DriveChain chain = chain_of(drive);
  const auto n = static_cast<Index>(chain.bodies.size());
  const bool lag = drive.motor.current_lag > 0;
  const Index states = 2 * n + (lag ? 2 : 1);
  LinearSystem s = empty(states);
  Form torque = state(states, states - 1);
  if (lag) {  // (4)
    const Form given = state(states, 2 * n);
    s.a.row(2 * n) = (torque.x - given.x) / drive.motor.current_lag;
    torque = given;
  }
  add_bodies(s, chain, torque, 0);
  add_outputs(s, chain, torque, 0);
  return s;
}

}  // namespace jounce::validate_detail
