// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <unsupported/Eigen/MatrixFunctions>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce::test {

/// The drive without a torque limit, solved exactly by matrix exponentials: x' = A x with x =
/// (th_m, w_m, th_l, w_l, z, r, r', ..., r^(7)), the reference's derivatives being part of the
/// state. Written from the equations in docs/validate/signals.md in absolute angles; it shares
/// nothing with the module under test but the struct Drive. For references whose segments are
/// polynomials of degree <= 7.
class ExactDrive {
 public:
  static constexpr int derivatives = 8;
  static constexpr int size = 5 + derivatives;
  using Matrix = Eigen::Matrix<double, size, size>;
  using Vector = Eigen::Matrix<double, size, 1>;

  explicit ExactDrive(const Drive& d) : radians_(2 * std::numbers::pi / d.position_per_rev) {
    const double inertia = d.motor.inertia + d.train[0].inertia;
    torque_.setZero();
    torque_(0) = -d.controller.velocity_gain * d.controller.position_gain;
    torque_(1) = -d.controller.velocity_gain;
    torque_(4) = 1;
    torque_(5) = d.controller.velocity_gain * d.controller.position_gain;
    torque_(6) = d.controller.velocity_gain * d.controller.velocity_feed_forward;
    torque_(7) = d.controller.torque_feed_forward * inertia;

    Eigen::Matrix<double, 1, size> shaft = Eigen::Matrix<double, 1, size>::Zero();
    shaft(0) = d.train[0].stiffness;
    shaft(2) = -d.train[0].stiffness;
    shaft(1) = d.train[0].damping;
    shaft(3) = -d.train[0].damping;

    a_.setZero();
    a_(0, 1) = 1;
    a_(2, 3) = 1;
    a_.row(1) = (torque_ - shaft) / d.motor.inertia;
    a_(1, 1) -= d.motor.friction.viscous / d.motor.inertia;
    a_.row(3) = shaft / d.train[0].inertia;
    a_(3, 3) -= d.train[0].friction.viscous / d.train[0].inertia;
    if (d.controller.integral_time > 0) {
      a_.row(4) = torque_ / d.controller.integral_time;
      a_(4, 4) = 0;
      a_(4, 7) = 0;
    }
    for (int k = 5; k + 1 < size; ++k) a_(k, k + 1) = 1;
  }

  /// At rest at a position in user units.
  [[nodiscard]] Vector rest(double position) const {
    Vector x = Vector::Zero();
    x(0) = x(2) = radians_ * position;
    return x;
  }

  /// Puts the reference's segment into the state, at the segment's start.
  void enter(Vector& x, const Segment& f) const {
    double factor = radians_;
    for (int k = 0; k < derivatives; ++k) {
      x(5 + k) = k <= f.degree ? factor * f.c[static_cast<std::size_t>(k)] : 0;
      factor *= (k + 1) / f.length;
    }
  }

  void hold(Vector& x, double position) const {
    x.tail(derivatives).setZero();
    x(5) = radians_ * position;
  }

  [[nodiscard]] Matrix transition(double time) const { return (a_ * time).exp(); }
  [[nodiscard]] Vector after(const Vector& x, double time) const { return transition(time) * x; }

  /// The state at t, from rest at the start of the reference, which is held after its end.
  [[nodiscard]] Vector at(const Trajectory& reference, double t) const {
    Vector x = rest(reference.jet(reference.start())[0]);
    const auto breaks = reference.breaks();
    for (std::size_t i = 0; i < reference.segments().size(); ++i) {
      enter(x, reference.segments()[i]);
      if (t <= breaks[i + 1]) return after(x, t - breaks[i]);
      x = after(x, breaks[i + 1] - breaks[i]);
    }
    hold(x, reference.jet(reference.end(), Side::left)[0]);
    return after(x, t - reference.end());
  }

  [[nodiscard]] double torque(const Vector& x) const { return torque_ * x; }
  [[nodiscard]] double reference(const Vector& x) const { return x(5) / radians_; }
  [[nodiscard]] double motor(const Vector& x) const { return x(0) / radians_; }
  [[nodiscard]] double load(const Vector& x) const { return x(2) / radians_; }

  /// The closed loop alone: its eigenvalues are the axis' own motions.
  [[nodiscard]] Eigen::Matrix<double, 5, 5> loop() const { return a_.topLeftCorner<5, 5>(); }

 private:
  double radians_;
  Matrix a_;
  Eigen::Matrix<double, 1, size> torque_;
};

}  // namespace jounce::test
