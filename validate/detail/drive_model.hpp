#pragma once

#include <array>

#include "jounce/profiles/jet.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce::detail {

/// The equations of the axis at the head of drive_model.cpp, in deviations from the reference.
class DriveModel {
 public:
  /// Angles in rad, relative to the reference; integral part in N m; integral of torque^2.
  enum State { motor, motor_speed, load, load_speed, integral, torque_squared, size };
  using Values = std::array<double, size>;

  explicit DriveModel(const Drive& drive);

  [[nodiscard]] double radians_per_unit() const { return radians_; }
  [[nodiscard]] double torque_limit() const { return drive_.motor.torque_limit; }
  [[nodiscard]] double inertia() const { return drive_.motor.inertia + drive_.train[0].inertia; }
  [[nodiscard]] double friction() const {
    return drive_.motor.friction.viscous + drive_.train[0].friction.viscous;
  }

  /// 1 or -1 while the torque stands at that limit, 0 while it does not. A mode, not a condition:
  /// it changes between steps only, so that what the solver integrates is smooth.
  [[nodiscard]] int mode() const { return mode_; }
  void set_mode(int mode) { mode_ = mode; }

  /// r is the reference in user units; y has `size` entries.
  [[nodiscard]] double commanded(const Jet& r, const double* y) const;  // (2)
  [[nodiscard]] double torque(const Jet& r, const double* y) const;     // (3)
  void rhs(const Jet& r, const double* y, double* dy) const;
  /// dfdy[column * size + row], zeros filled in before.
  void jacobian(const Jet& r, const double* y, double* dfdy) const;

 private:
  [[nodiscard]] double velocity_error(const Jet& r, const double* y) const;  // (1)

  Drive drive_;
  double radians_;
  int mode_ = 0;
};

}  // namespace jounce::detail
