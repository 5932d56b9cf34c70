// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "validate/src/drive/drive_model.hpp"

namespace jounce::validate_detail {

/// The controller at its sample instants, as described for struct Controller: it reads, computes,
/// and sets its torque later.
class SampledController {
 public:
  explicit SampledController(DriveModel& model);

  /// Returns the next instant at which it reads or its torque changes, s from the start of the run.
  [[nodiscard]] double next() const;
  /// Performs the actions that are due at `t`: reads, and sets the integral part of the state and
  /// the torque that the model holds. Instants that differ by at most `slack` (s) count as the same
  /// instant.
  void act(double t, double slack, const Jet& r, std::span<double> y);

 private:
  struct Output {
    double time;    ///< s
    double torque;  ///< N m
    int limited;    ///< side on which the limit was reached; 0: none
  };

  void read(const Jet& r, std::span<double> y);

  DriveModel& model_;
  double cycle_, delay_;
  double count_;             ///< angle of one encoder count, rad; 0: exact
  double samples_ = 0;       ///< number of readings so far
  double angle_ = 0;         ///< last reading, absolute
  std::vector<Output> due_;  ///< outputs that are due, in order
};

}  // namespace jounce::validate_detail
