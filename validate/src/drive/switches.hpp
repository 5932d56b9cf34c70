// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "validate/src/drive/drive_model.hpp"

namespace jounce::validate_detail {

/// Changes the modes of a model. It contains the event functions for root finding, and sets the new
/// mode when one of them crosses zero. A band of one tolerance around every threshold prevents
/// rounding from switching back and forth. Cases that an event cannot detect (two crossings in one
/// step, a start on a threshold) are determined from the state itself, outside of two tolerances.
class Switches {
 public:
  /// `torque`, `speed`: usual torque and speed of the run, N m and rad/s. `tolerance`: relative to
  /// them.
  Switches(DriveModel& model, double tolerance, double torque, double speed);

  /// Number of event functions.
  [[nodiscard]] int events() const { return events_; }
  /// Writes their values to g.
  void evaluate(const Jet& r, const double* y, double* g) const;

  /// Sets the modes of the state. `crossed`: direction of each event; empty: no event. A body that
  /// comes to rest gets the speed 0. Returns true if a mode has changed.
  bool update(const Jet& r, double* y, std::span<const int> crossed = {});
  /// Sets the sign of the friction feed-forward at the beginning of an interval. `fastest`: peak
  /// velocity of the reference.
  void begin(const Jet& r, double fastest);

  /// Number of times that a flank of a joint has touched.
  [[nodiscard]] long impacts() const { return impacts_; }

 private:
  [[nodiscard]] double threshold(int sign, const Jet& r, const double* y, double widths) const;
  [[nodiscard]] double margin(std::size_t body, const Jet& r, const double* y, double widths) const;
  bool update_torque(const Jet& r, const double* y, std::span<const int> crossed);
  bool update_slip(std::size_t body, const Jet& r, double* y, int crossed);
  bool update_contact(std::size_t body, const double* y, std::span<const int> crossed);

  DriveModel& model_;
  double tolerance_, torque_, speed_;
  std::vector<std::size_t> rubbing_;  ///< bodies
  std::vector<std::size_t> gaps_;     ///< joints
  bool feed_;
  std::size_t slip_, contact_, feed_event_;  ///< first event of each kind
  int events_;
  long impacts_ = 0;
};

}  // namespace jounce::validate_detail
