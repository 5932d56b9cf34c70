#pragma once

#include <array>

#include "jounce/profiles/detail/extremal.hpp"
#include "jounce/profiles/move.hpp"

namespace jounce::detail {

/// One move between two states inside the bounds, third order: both families of extremals, the one
/// that goes as far up as it can in every duration and the one that goes as far down (as the
/// mirror image of an upward one). docs/generators/move.md.
class PointToPoint {
 public:
  PointToPoint(const MotionState& from, const MotionState& to, const Bounds& bounds) noexcept;

  /// Appends the phases of the shortest motion.
  void shortest(Profile& out) const noexcept;
  /// Appends the phases of a motion of exactly this duration, which must be permitted.
  void lasting(double t, Profile& out) const noexcept;
  [[nodiscard]] double minimum() const noexcept;
  [[nodiscard]] Durations durations() const noexcept;
  /// Whether a duration >= minimum() is permitted.
  [[nodiscard]] bool reachable(double t) const noexcept;

 private:
  using Branch = Extremals::Branch;

  PointToPoint(const MotionState& from, const MotionState& to, const Bounds& bounds,
               const Extremals::Jerks& jerks) noexcept;
  PointToPoint(const MotionState& from, const MotionState& to, const Bounds& b,
               const Extremals::Jerks& jerks, double n0, double n1) noexcept;

  /// A member of one of the two families.
  struct Choice {
    bool upwards = true;
    Extremal extremal;
  };

  [[nodiscard]] const Extremals& family(bool upwards) const noexcept {
    return upwards ? up_ : down_;
  }
  /// The distance in the family's own direction.
  [[nodiscard]] double towards(bool upwards) const noexcept { return upwards ? d_ : -d_; }
  [[nodiscard]] bool covered_early(Choice& out) const noexcept;
  [[nodiscard]] Choice fastest() const noexcept;
  [[nodiscard]] bool reachable(Branch b, double t) const noexcept;
  [[nodiscard]] std::array<double, 2> jerks(bool upwards) const noexcept;
  void append(const Choice& c, Profile& out) const noexcept;
  void append_blend(const Choice& a, const Choice& b, double share, Profile& out) const noexcept;

  double rise_, fall_;  ///< the jerks, signed
  double d_;
  Extremals up_, down_;
  bool early_;
  Extremal direct_;  ///< of up_
  double direct_distance_;
  double rounding_;  ///< of positions: a distance is not known better
};

}  // namespace jounce::detail
