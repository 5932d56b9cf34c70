// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "jounce/profiles/curve/jet.hpp"
#include "jounce/validate/drive.hpp"

#include "validate/src/drive/bodies.hpp"
#include "validate/src/witness/piece.hpp"

namespace jounce::validate_detail {

/// The modes of the switching elements. They change only between steps, so the integrated equations
/// are smooth.
struct DriveMode {
  int torque = 0;              ///< 1: at the upper torque limit, -1: at the lower one; 0: within
  int feed = 0;                ///< sign of the reference's velocity, for the friction feed-forward
  std::vector<int> slip = {};  ///< for each body that rubs: the sign of its motion; 0: it sticks
  std::vector<int> contact =
      {};  ///< contact of a joint with a gap: the flank that touches; 0: neither

  bool operator==(const DriveMode&) const = default;
};

/// The equations of the axis at the head of drive_model.cpp, in deviations from the reference. No
/// function allocates.
///
/// States: angle and speed of body i in rad and rad/s relative to the reference (2 i and 2 i + 1),
/// and the integral part in N m. If they are modelled: the delayed command (two states) and the
/// torque behind the lag of the current loop. Last, the integrals of T^2 and of the motor's power.
class DriveModel {
 public:
  explicit DriveModel(const Drive& drive);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t load() const { return load_; }  ///< index of the load's angle
  /// Indices of the integral part, of the integral of T^2, and of the work.
  [[nodiscard]] std::size_t integral() const { return 2 * train_.size(); }
  [[nodiscard]] std::size_t torque_squared() const { return size_ - 2; }
  [[nodiscard]] std::size_t work() const { return size_ - 1; }
  /// True if the controller is sampled.
  [[nodiscard]] bool sampled() const { return drive_.controller.cycle > 0; }
  [[nodiscard]] const Drive& drive() const { return drive_; }
  [[nodiscard]] const std::vector<Body>& train() const { return train_; }
  /// Motor angle for one unit of the position, rad.
  [[nodiscard]] double radians_per_unit() const { return radians_; }
  /// Sums over all bodies: inertia, viscous friction, Coulomb friction.
  [[nodiscard]] double inertia() const { return inertia_; }
  [[nodiscard]] double friction() const { return viscous_; }
  [[nodiscard]] double dry_friction() const { return coulomb_; }

  [[nodiscard]] const DriveMode& mode() const { return mode_; }
  [[nodiscard]] DriveMode& mode() { return mode_; }

  /// For the next functions: r is the reference in u; y and dy have size() entries.
  [[nodiscard]] double commanded(const Jet& r, const double* y) const;  ///< T_d of (3), N m
  /// T of (6), the torque of the motor, N m.
  [[nodiscard]] double torque(const Jet& r, const double* y) const;
  [[nodiscard]] double motor_speed(const Jet& r, const double* y) const;
  /// Returns the limit on the side `sign` as a signed torque, N m, at this speed of the motor: (4).
  [[nodiscard]] double limit(int sign, double motor_speed) const;
  /// True if this limit is below the peak torque.
  [[nodiscard]] bool weakened(int sign, double motor_speed) const;
  /// Writes the derivatives of the states to dy.
  void rhs(const Jet& r, const double* y, double* dy) const;
  /// Writes the derivatives of rhs() to dfdy[column * size + row], which must be zeros before.
  void jacobian(const Jet& r, const double* y, double* dfdy) const;

  /// Sets y to rest in equilibrium at the position of the reference, and the modes accordingly.
  void rest(const Jet& r, double* y);
  /// Applies a step of the reference: the axis itself does not step, so its deviations do.
  void shift(const Jet& before, const Jet& after, double* y) const;

  /// Returns the torque of the joint before body i >= 1: (7).
  [[nodiscard]] double joint(std::size_t i, const double* y) const;
  /// Returns the torque that presses the flank of this sign, N m; > 0: the flank touches, see (8).
  [[nodiscard]] double pressed(std::size_t i, int flank, const double* y) const;
  /// Returns the torque on body i without dry friction and the loss of its gear, N m.
  [[nodiscard]] double net(std::size_t i, const Jet& r, const double* y) const;
  /// Returns the greatest torque with which dry friction and the loss of the gear hold the body at
  /// rest against motion of this sign, N m, >= 0: (11).
  [[nodiscard]] double holding(std::size_t i, int sign, const double* y) const;

  /// Sets the torque of a sampled controller, until the next call.
  void hold(double torque) { held_ = torque; }
  /// Return e and T_c of (1) and (2), for a motor that was read at `angle` (relative to the
  /// reference) and `speed`.
  [[nodiscard]] double velocity_error(const Jet& r, double angle, double speed) const;
  [[nodiscard]] double asked(const Jet& r, double velocity_error, double integral) const;

 private:
  [[nodiscard]] double asked(const Jet& r, const double* y) const;
  [[nodiscard]] double limited(const Jet& r, const double* y) const;
  [[nodiscard]] double loads(std::size_t i, double angle) const;
  [[nodiscard]] double rubbing(std::size_t i, double speed, const double* y) const;
  void rest_train(double reference, double* y) const;
  void controller_rhs(const Jet& r, const double* y, double* dy) const;
  [[nodiscard]] double passed(std::size_t i, const double* y) const;

  void controller_jacobian(const Jet& r, const double* y, double* dfdy) const;
  void body_jacobian(std::size_t i, const Jet& r, const double* y, double* dfdy) const;
  void torque_row(std::size_t row, double share, const Jet& r, const double* y, double* dfdy) const;
  void limited_row(std::size_t row, double share, const Jet& r, const double* y,
                   double* dfdy) const;
  void commanded_row(std::size_t row, double share, double* dfdy) const;
  void asked_row(std::size_t row, double share, double* dfdy) const;

  Drive drive_;
  std::vector<Body> train_;
  double radians_;
  double inertia_, viscous_, coulomb_;
  bool delayed_, lagging_;
  std::size_t load_;
  std::size_t delay_, lag_, size_;  // indices of states
  DriveMode mode_;
  double held_ = 0;
};

/// Scales of a run in rad, rad/s and N m, all > 0. Tolerances are shares of them.
struct DriveScales {
  double angle, speed, torque;

  DriveScales(const DriveModel& model, const Scales& reference);
};

}  // namespace jounce::validate_detail
