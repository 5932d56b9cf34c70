// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <vector>

#include <Eigen/Core>

#include "jounce/validate/drive.hpp"

namespace jounce::validate_detail {

/// Returns the drive without its nonlinear parts: no dry friction, backlash, gear losses or arm.
Drive linear_part(Drive drive);

/// The loop of a linear drive, opened where the torque enters the motor. The equations are at the
/// head of open_loop.cpp.
class OpenLoop {
 public:
  explicit OpenLoop(const Drive& drive);

  /// Returns L at a frequency > 0, Hz; for a sampled controller, at most half of its rate. The
  /// poles of the closed loop are where L = -1.
  [[nodiscard]] std::complex<double> at(double frequency) const;

  /// Returns the poles of the closed loop, 1/s, with the velocity gain multiplied by `gain`. For a
  /// sampled controller they are computed by (3).
  [[nodiscard]] std::vector<std::complex<double>> closed_poles(double gain = 1) const;

  /// Returns the poles of motor and masses alone, 1/s.
  [[nodiscard]] std::vector<std::complex<double>> plant_poles() const;

  /// Returns the greatest frequency of the loop, Hz; infinite for a continuous controller.
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
  double angle_ = 1;            ///< angle of the motor divided by x_0
  int late_ = 0;                ///< n of (4)
  Eigen::MatrixXd over_cycle_;  ///< Phi of (4)
  Eigen::VectorXd now_;         ///< G_0 of (4)
  Eigen::VectorXd before_;      ///< G_1 of (4); empty if the delay is a whole number of cycles
};

}  // namespace jounce::validate_detail
