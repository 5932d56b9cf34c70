// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "jounce/profiles/moves/move.hpp"

#include "profiles/src/solver/extremal.hpp"

namespace jounce::profiles_detail {

/// One third-order move between two states inside the bounds. It is found between two families of
/// extremals: one goes as far as possible in the positive direction in every duration, the other,
/// as the mirror image, in the negative direction. Derivation: docs/generators/move.md.
class PointToPoint {
 public:
  PointToPoint(const MotionState& from, const MotionState& to, const Bounds& bounds) noexcept;

  /// The shortest motion, as a profile between the two given states.
  [[nodiscard]] Profile shortest(const MotionState& from, const MotionState& to) const noexcept;
  /// The same, appended to a beginning that has brought the motion inside the bounds.
  void append_shortest(Profile& out) const noexcept { append(fastest(), out); }
  /// Appends the phases of a motion of exactly this duration, which must be >= minimum(); returns
  /// false if it is blocked.
  bool lasting(double t, Profile& out) const noexcept;
  /// The same, if this motion has a cruise longer than rounding. Then t is longer than minimum(),
  /// and the shortest motion is not needed. Otherwise returns false.
  bool cruises(double t, Profile& out) const noexcept;
  [[nodiscard]] double minimum() const noexcept;
  [[nodiscard]] Durations durations() const noexcept;

  // The early branch alone, for a start that leaves the bounds and may reach its target before. The
  // acceleration must return from this state at once, and must not pass zero.
  [[nodiscard]] bool has_early() const noexcept;
  /// The last blocked interval has no end.
  [[nodiscard]] Durations early_durations() const noexcept;

 private:
  using Branch = Extremals::Branch;

  PointToPoint(const MotionState& from, const MotionState& to, const Bounds& b,
               const Extremals::Jerks& jerks) noexcept;

  /// The phases of one member, and the family to which it belongs.
  struct Course {
    bool upwards = true;
    std::array<double, 7> phases{};
  };
  /// Both families of one task.
  struct Families {
    Extremals up, down;
    bool early;

    [[nodiscard]] const Extremals& of(bool upwards) const noexcept { return upwards ? up : down; }
  };

  [[nodiscard]] Extremals family(bool upwards) const noexcept;
  [[nodiscard]] Families families() const noexcept;
  [[nodiscard]] bool is_early(const Extremals& up) const noexcept;
  /// The distance in the direction of the family.
  [[nodiscard]] double towards(bool upwards) const noexcept { return upwards ? d_ : -d_; }
  [[nodiscard]] bool fastest_early(const Extremals& up, Course& out) const noexcept;
  [[nodiscard]] Course fastest() const noexcept;
  [[nodiscard]] bool reachable(const Families& both, double t) const noexcept;
  /// Durations between which the target is either always reachable or never.
  struct Events {
    std::array<double, 17> at{};
    std::size_t count = 0;

    void add(double t) noexcept { at[count++] = t; }
  };
  void add_events(Branch b, const Families& both, Events& events) const noexcept;
  template <class Possible>
  static void find_blocked(Events events, Durations& out, Possible possible) noexcept;
  [[nodiscard]] double rounding(double t) const noexcept;
  [[nodiscard]] std::array<double, 2> jerks(bool upwards) const noexcept;
  [[nodiscard]] Profile profile(const Course& c, const MotionState& from,
                                const MotionState& to) const noexcept;
  void append(const Course& c, Profile& out) const noexcept;
  [[nodiscard]] Bounds ramps() const noexcept;
  bool append_long(double t, Profile& out) const noexcept;
  bool append_mean(const std::array<Course, 2>& ends, const std::array<double, 2>& reach,
                   Profile& out) const noexcept;
  bool append_stair(double t, Profile& out) const noexcept;
  void append_blend(const std::array<Course, 2>& c, double share, Profile& out) const noexcept;

  double rise_, fall_;  ///< signed jerks
  double d_;
  double dv_;  ///< velocity of to_ minus velocity of from_
  Extremals::End from_, to_;
  Extremals::Jerks jerks_;
  std::array<double, 2> natural_;  ///< natural velocities of start and target
  bool start_is_higher_;           ///< true if the start has the higher natural velocity
  Extremals::Limits up_limits_, down_limits_;
  MotionState scale_;  ///< magnitudes of the states
};

/// Appends a blocked interval. It extends the last one if both touch, or if there is no space for
/// another one, so no blocked duration is reported as possible.
void block(const Durations::Interval& interval, Durations& out) noexcept;

}  // namespace jounce::profiles_detail
