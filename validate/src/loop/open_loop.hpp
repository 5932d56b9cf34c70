// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <vector>

#include <Eigen/Core>

#include "jounce/validate/drive.hpp"

namespace jounce::validate_detail {

/// The drive without its nonlinear parts: no dry friction, closed joints, gears without loss, no arm.
Drive linear_part(Drive drive);

/// The loop of a linear drive, opened where the torque enters the motor. The equations are at the head of
/// open_loop.cpp.
class OpenLoop {
 public:
  explicit OpenLoop(const Drive& drive);

  /// L at a frequency in Hz, > 0 and, for a sampled controller, at most half its rate. The closed loop has its
  /// poles where L = -1.
  [[nodiscard]] std::complex<double> at(double frequency) const;

  /// The poles of the closed loop in 1/s, those of a sampled controller by (3), with the velocity gain
  /// times `gain`.
  [[nodiscard]] std::vector<std::complex<double>> closed_poles(double gain = 1) const;

  /// The poles of motor and masses alone, in 1/s.
  [[nodiscard]] std::vector<std::complex<double>> plant_poles() const;

  /// The greatest frequency of the loop, in Hz; infinite for a continuous controller.
  [[nodiscard]] double highest() const;

 private:
  [[nodiscard]] bool sampled() const { return drive_.controller.cycle > 0; }
  [[nodiscard]] std::complex<double> continuous_at(double frequency) const;
  [[nodiscard]] std::complex<double> sampled_at(double frequency) const;
  [[nodiscard]] Eigen::MatrixXd sampled_matrix(double gain) const;
  void sample_plant();

  Drive drive_;
  Eigen::MatrixXd plant_;       ///< A of x' = A x + b T
  Eigen::VectorXd input_;       ///< b
  double angle_ = 1;            ///< the motor's angle is this times x_0
  int late_ = 0;                ///< n of (4)
  Eigen::MatrixXd over_cycle_;  ///< Phi of (4)
  Eigen::VectorXd now_;         ///< G_0 of (4)
  Eigen::VectorXd before_;      ///< G_1 of (4), empty where the delay is whole cycles
};

}  // namespace jounce::validate_detail
