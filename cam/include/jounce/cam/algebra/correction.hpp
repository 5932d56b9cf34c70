// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// Correction of a cam so that a slave engages without a jump: it goes from the difference at the
/// start to zero and stays there. Over time it is a Profile within limits. Over master it is a
/// polynomial that is at rest when the master is. A value type; nothing allocates.
class Correction {
 public:
  Correction() = default;  ///< none: zero everywhere

  /// Follows a profile that ends at rest at zero, starting at time `start`, s.
  static Correction over_time(const Profile& profile, double start);

  /// Ends after `distance` > 0 of master travel from `origin`, in either direction. The difference
  /// at the origin is given by its derivatives over the master: u, u/m, u/m^2.
  static Correction over_master(const Jet& difference, double origin, double distance);

  /// Value and derivatives by time for the master's jet at t.
  [[nodiscard]] Jet jet(double t, const Jet& master) const;

  /// True if the correction is complete; over master: while the master stays outside the distance.
  [[nodiscard]] bool done(double t, double master) const;

  /// Its duration, s; 0 unless it runs over time.
  [[nodiscard]] double duration() const { return kind_ == Kind::time ? profile_.duration() : 0; }
  [[nodiscard]] bool follows_master() const { return kind_ == Kind::master; }
  [[nodiscard]] const Profile& profile() const { return profile_; }
  /// True if all its numbers over master are finite: a difference beyond 1e300 is not.
  [[nodiscard]] bool finite() const;
  /// For one over master: the correction as a curve over the master's position, zero outside.
  [[nodiscard]] Cam curve() const;

 private:
  enum class Kind : std::uint8_t { none, time, master };

  [[nodiscard]] Jet by_master(double u) const;

  Kind kind_ = Kind::none;
  Profile profile_;
  double start_ = 0;        // s, or m for a correction over master
  double distance_ = 0;     // m
  Segment ahead_, behind_;  // over the distance from the start, forwards and backwards
};

}  // namespace jounce
