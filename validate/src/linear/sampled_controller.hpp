// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "validate/src/drive/drive_model.hpp"

namespace jounce::validate_detail {

/// The controller at its sample instants, as struct Controller describes: it reads, computes, and sets its
/// torque later.
class SampledController {
 public:
  explicit SampledController(DriveModel& model);

  /// The next instant at which it reads or its torque changes, in s from the start of the run.
  [[nodiscard]] double next() const;
  /// Performs the actions that are due at `t`: reads, and sets the integral part of the state and
  /// the torque that the model holds. Instants that differ by at most `slack` (s) count as the same
  /// instant.
  void act(double t, double slack, const Jet& r, std::span<double> y);

 private:
  struct Output {
    double time;
    double torque;
    int limited;  ///< side on which the limit was met, or 0
  };

  void read(const Jet& r, std::span<double> y);

  DriveModel& model_;
  double cycle_, delay_;
  double count_;             ///< rad; 0: exact
  double samples_ = 0;       ///< read so far
  double angle_ = 0;         ///< absolute, as read last
  std::vector<Output> due_;  ///< in order
};

}  // namespace jounce::validate_detail
