// SPDX-License-Identifier: Apache-2.0
// The loop of a drive, cut where the torque T enters the motor. P(s) is the motor's angle for a
// torque. The angle returns through the position and velocity controllers as the torque -C(s) th.
// With a continuous controller
//
//     (1)  L(s) = C(s) D(s) P(s) / (tau s + 1),   C(s) = K_v (s + K_p) (1 + 1 / (T_i s))
//     (2)  D(s) = (12 - 6 s D + (s D)^2) / (12 + 6 s D + (s D)^2)      Pade's approximant, as in drive_system.cpp
//
// In the code, the plant includes the current loop (tau). A controller with the cycle h reads the
// plant once per cycle. Its delay is n cycles and d, 0 <= d < h. With the torque T_(k-n-1) until d
// and T_(k-n) after it, x' = A x + b T over a cycle is
//
//     (3)  z = exp(s h)
//     (4)  x_(k+1) = Phi x_k + G_0 T_(k-n) + G_1 T_(k-n-1)
//          Phi = exp(A h),  G(t) = int_0^t exp(A u) b du,  G_0 = G(h - d),  G_1 = exp(A (h - d)) G(d)
//     (5)  L(z) = C(z) e_0 (z I - Phi)^-1 (G_0 z^-n + G_1 z^-(n+1))
//          C(z) = K_v (K_p + (1 - z^-1) / h) (1 + (h / T_i) / (z - 1))
//
// as sampled_drive.cpp reads, differentiates and integrates. Source: K. J. Astrom, B. Wittenmark,
// Computer-Controlled Systems, 3rd ed. 1997, 2.3 (sampling with a delay).

#include "validate/src/loop/open_loop.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "validate/src/drive/dense.hpp"
#include "validate/src/drive/drive_system.hpp"
#include "validate/src/linear/exponential.hpp"

namespace jounce::validate_detail {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

void drop_dry(Friction& friction) {
  friction.coulomb = friction.breakaway = 0;
}

std::vector<Complex> poles_of(const Eigen::MatrixXd& m) {
  const Eigen::VectorXcd values = eigenvalues(m);
  return {values.begin(), values.end()};
}

/// (2)
Complex delayed(Complex s, double delay) {
  const Complex u = s * delay;
  return (12.0 - 6.0 * u + u * u) / (12.0 + 6.0 * u + u * u);
}

/// e_0 (p I - A)^-1 b.
Complex first_of(const Eigen::MatrixXd& a, Complex p, const Eigen::VectorXcd& b) {
  const Index n = a.rows();
  const Eigen::MatrixXcd left = p * Eigen::MatrixXcd::Identity(n, n) - a.cast<Complex>();
  return solve(left, b)(0);
}

}  // namespace

Drive linear_part(Drive drive) {
  drop_dry(drive.motor.friction);
  for (Mass& mass : drive.train) {
    drop_dry(mass.friction);
    mass.backlash = mass.gravity_torque = 0;
    mass.efficiency = 1;
  }
  return drive;
}

OpenLoop::OpenLoop(const Drive& drive) : drive_(linear_part(drive)) {
  const LinearSystem open = balanced(open_drive(drive_));
  const Index n = open.states() - 1;  // the last one is the torque
  plant_ = open.a.topLeftCorner(n, n);
  input_ = open.a.col(n).head(n) / open.scale(n);
  angle_ = open.scale(0);
  if (sampled()) sample_plant();
}

/// (4)
void OpenLoop::sample_plant() {
  const Controller& c = drive_.controller;
  const Index n = plant_.rows();
  constexpr double same = 1e-9;  // share of a cycle
  late_ = static_cast<int>(std::floor(c.delay / c.cycle + same));
  const double rest = std::max(0.0, c.delay - late_ * c.cycle);
  Eigen::MatrixXd with_torque = Eigen::MatrixXd::Zero(n + 1, n + 1);
  with_torque.topLeftCorner(n, n) = plant_;
  with_torque.col(n).head(n) = input_;
  const auto after = [&](double t) { return exponential(with_torque * t); };
  over_cycle_ = after(c.cycle).topLeftCorner(n, n);
  const Eigen::MatrixXd since = after(c.cycle - rest);
  now_ = since.col(n).head(n);
  if (rest > same * c.cycle) before_ = since.topLeftCorner(n, n) * after(rest).col(n).head(n);
}

Complex OpenLoop::at(double frequency) const {
  return sampled() ? sampled_at(frequency) : continuous_at(frequency);
}

Complex OpenLoop::continuous_at(double frequency) const {
  const Controller& c = drive_.controller;
  const Complex s{0, 2 * std::numbers::pi * frequency};
  Complex control = c.velocity_gain * (s + c.position_gain);
  if (c.integral_time > 0) control *= 1.0 + 1.0 / (c.integral_time * s);
  return control * delayed(s, c.delay) * angle_ * first_of(plant_, s, input_);  // (1)
}

Complex OpenLoop::sampled_at(double frequency) const {
  const Controller& c = drive_.controller;
  const Complex z = std::polar(1.0, 2 * std::numbers::pi * frequency * c.cycle);
  Complex control = c.velocity_gain * (c.position_gain + (1.0 - 1.0 / z) / c.cycle);
  if (c.integral_time > 0) control *= 1.0 + c.cycle / c.integral_time / (z - 1.0);
  Eigen::VectorXcd torque = now_.cast<Complex>();
  if (before_.size() > 0) torque += before_ / z;
  return control * std::pow(z, -static_cast<double>(late_)) * angle_ *
         first_of(over_cycle_, z, torque);  // (5)
}

/// (4) closed: x, the integral part, the angle read before, and the torques on their way, newest first.
Eigen::MatrixXd OpenLoop::sampled_matrix(double gain) const {
  const Controller& c = drive_.controller;
  const Index n = plant_.rows(), integral = n, angle = n + 1, first = n + 2;
  const Index waiting = late_ + (before_.size() > 0 ? 1 : 0);
  const Index size = first + waiting;
  Eigen::RowVectorXd error = Eigen::RowVectorXd::Zero(size);  // K_v e
  error(0) = -gain * c.velocity_gain * (c.position_gain + 1 / c.cycle) * angle_;
  error(angle) = gain * c.velocity_gain / c.cycle * angle_;
  const auto torque = [&](Index cycles_ago) -> Eigen::RowVectorXd {
    if (cycles_ago > 0) return Eigen::RowVectorXd::Unit(size, first + cycles_ago - 1);
    Eigen::RowVectorXd asked = error;
    asked(integral) = 1;
    return asked;
  };
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(size, size);
  m.topLeftCorner(n, n) = over_cycle_;
  m.topRows(n) += now_ * torque(late_);
  if (before_.size() > 0) m.topRows(n) += before_ * torque(late_ + 1);
  if (c.integral_time > 0) {
    m.row(integral) = c.cycle / c.integral_time * error;
    m(integral, integral) += 1;
  }
  m(angle, 0) = 1;
  for (Index i = 0; i < waiting; ++i) m.row(first + i) = torque(i);
  return m;
}

std::vector<Complex> OpenLoop::closed_poles(double gain) const {
  if (!sampled()) {
    Drive drive = drive_;
    drive.controller.velocity_gain *= gain;
    return poles_of(balanced(drive_system(drive)).a);
  }
  std::vector<Complex> poles;
  constexpr double gone =
      1e-9;  // within a cycle: not a real pole, but a step of the chain of delays
  for (const Complex z : poles_of(sampled_matrix(gain)))
    if (std::abs(z) > gone) poles.push_back(std::log(z) / drive_.controller.cycle);  // (3)
  return poles;
}

std::vector<Complex> OpenLoop::plant_poles() const {
  return poles_of(plant_);
}

double OpenLoop::highest() const {
  return sampled() ? 0.5 / drive_.controller.cycle : std::numeric_limits<double>::infinity();
}

}  // namespace jounce::validate_detail
