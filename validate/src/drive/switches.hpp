// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "validate/src/drive/drive_model.hpp"

namespace jounce::detail {

/// Brings a model's modes about: the event functions that root finding watches, and what becomes of
/// a mode where one of them goes through zero. A band of one tolerance about every threshold keeps
/// rounding from switching to and fro; what an event cannot see (two crossings in one step, a start
/// on a threshold) is found by the state itself, outside of two tolerances.
class Switches {
 public:
  /// Torques and speeds of the run, in N m and rad/s: what the tolerance is a share of.
  Switches(DriveModel& model, double tolerance, double torque, double speed);

  [[nodiscard]] int events() const { return events_; }
  void evaluate(const Jet& r, const double* y, double* g) const;

  /// The modes that the state is in, `crossed` being the direction of every event (empty: none).
  /// What comes to rest gets the speed of rest. True if a mode changed.
  bool update(const Jet& r, double* y, std::span<const int> crossed = {});
  /// Which way the friction feed-forward pushes at the beginning of an interval.
  void begin(const Jet& r, double fastest);

  /// How often a flank of a joint has been met.
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

}  // namespace jounce::detail
