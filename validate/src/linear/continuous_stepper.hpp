// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "jounce/validate/drive.hpp"

#include "validate/src/drive/drive_model.hpp"
#include "validate/src/linear/linear_system.hpp"
#include "validate/src/linear/stepped_reference.hpp"

namespace jounce::validate_detail {

/// A linear drive under a continuous controller, with the torque limit of the motor, over periods
/// of equal length. The equations are at the head of continuous_stepper.cpp. Only the constructor
/// allocates.
class ContinuousStepper {
 public:
  /// `period`: length of a period, s.
  ContinuousStepper(const Drive& drive, double period);

  /// Sets the drive to rest.
  void rest();
  /// Steps the drive along the reference, over this number of periods.
  void step(const SteppedReference& reference, int periods);
  /// Returns the state at the end of the last step, with motor and load relative to the reference.
  /// `unit`: u for one radian of the motor.
  [[nodiscard]] DriveSample sample(double unit) const;

 private:
  static constexpr std::size_t rate_count = SteppedReference::derivatives;
  /// 1, r', ..., r^(5), and the torque at the limit.
  using Inputs = std::array<double, rate_count + 2>;
  enum System : std::size_t { free, limited, weakened, systems };
  /// The present system, and its L or L_0.
  struct Hold {
    System system = free;
    double torque = 0;
    bool operator==(const Hold&) const = default;
  };
  using Matrix = std::vector<double>;  // by columns: states rows; states, then Inputs, columns

  [[nodiscard]] Inputs inputs(double t) const;
  [[nodiscard]] double row(const Matrix& rows, std::size_t which, const std::vector<double>& x,
                           const Inputs& w) const;
  [[nodiscard]] double demand(const std::vector<double>& x, const Inputs& w) const;
  [[nodiscard]] double held(const std::vector<double>& x, const Inputs& w) const;
  [[nodiscard]] Hold hold(const std::vector<double>& x, const Inputs& w) const;
  void go(double t, std::size_t level);

  std::size_t states_;
  double period_;
  bool lag_;
  DriveModel limits_;
  Matrix outputs_;  // drive_rows + 1 rows: the last one is the torque asked for
  std::array<std::vector<Matrix>, systems> steps_;  // by level: of period / (first * 2^level)
  std::vector<double> rest_;
  std::vector<double> follows_velocity_;
  std::vector<double> x_;
  std::vector<std::vector<double>> next_;  // by level
  SteppedReference reference_;
  double velocity_ = 0;  // velocity of the reference at the end, u/s
  double end_ = 0;       // end of the reference, s
};

}  // namespace jounce::validate_detail
