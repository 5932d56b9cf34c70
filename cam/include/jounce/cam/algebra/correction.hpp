// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// Correction that is added to a cam so that a slave engages without a jump. The correction begins
/// at the difference between slave and cam, and ends at zero. A correction over time is a Profile
/// within limits, and stays at zero after its end. A correction over the master is a polynomial of
/// the master's position, so it stands still while the master stands still. It is zero while the
/// master is beyond the distance of the correction. Copies are independent. No member allocates,
/// except curve(). u is the slave's unit, m the master's.
class Correction {
 public:
  Correction() = default;  ///< no correction: zero everywhere

  /// Returns a correction that follows a profile from time `start`, s. The profile ends at rest at
  /// zero.
  static Correction over_time(const Profile& profile, double start);

  /// Returns a correction that ends after `distance` > 0 (m) of master travel from the position
  /// `origin` (m), in either direction. `difference` is the difference at the origin with its
  /// derivatives with respect to the master: u, u/m, u/m^2.
  static Correction over_master(const Jet& difference, double origin, double distance);

  /// Returns the value and derivatives with respect to time at t (s). `master`: position of the
  /// master at t and its derivatives with respect to time.
  [[nodiscard]] Jet jet(double t, const Jet& master) const;

  /// True if the correction is complete at t (s), or if there is no correction. A correction over
  /// the master is complete while the master, at position `master`, is at least `distance` away
  /// from `origin` (see over_master()).
  [[nodiscard]] bool done(double t, double master) const;

  /// Duration, s; 0 unless the correction is over time.
  [[nodiscard]] double duration() const { return kind_ == Kind::time ? profile_.duration() : 0; }
  /// True for a correction over the master.
  [[nodiscard]] bool follows_master() const { return kind_ == Kind::master; }
  /// The profile of a correction over time; otherwise empty.
  [[nodiscard]] const Profile& profile() const { return profile_; }
  /// False if a number of a correction over the master is not finite, as for a difference beyond
  /// 1e300. Otherwise true.
  [[nodiscard]] bool finite() const;
  /// A correction over the master as a curve over the master's position; zero outside the distance.
  /// Requires follows_master().
  [[nodiscard]] Cam curve() const;

 private:
  enum class Kind : std::uint8_t { none, time, master };

  [[nodiscard]] Jet by_master(double u) const;

  Kind kind_ = Kind::none;
  Profile profile_;
  double start_ = 0;        // s, or m for a correction over master
  double distance_ = 0;     // m
  Segment ahead_, behind_;  // over the distance of the master from the start: forwards, backwards
};

}  // namespace jounce
