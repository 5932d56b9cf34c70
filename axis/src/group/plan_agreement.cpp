// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/detail/plan_agreement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "jounce/path/law.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_sum;

bool near(double a, double b, double scale) {
  return a == b || std::abs(a - b) <= rounded_sum * scale;
}

/// The paths of both plans, piece by piece.
class Geometry {
 public:
  Geometry(const Path& before, const Path& after)
      : before_(before),
        after_(after),
        scale_(std::max({before.length(), after.length(), reach(before), reach(after)})) {}

  /// Finds the first pair of pieces at the same place. Returns the q of `before` minus the q of
  /// `after`; nullopt: none.
  std::optional<double> align() {
    constexpr std::size_t most = 8;  // the first pieces of a shorter program may lack their corner
    const auto mine = before_.pieces();
    const auto theirs = after_.pieces();
    for (std::size_t k = 0; k < std::min(most, theirs.size()); ++k)
      for (std::size_t i = 0; i < mine.size(); ++i) {
        if (const auto u = place_on(i, k)) {
          first_ = i;
          other_ = k;
          return offset_ = mine[i].start + *u - theirs[k].start;
        }
      }
    return std::nullopt;
  }

  /// The q of `before` up to which both paths are equal.
  [[nodiscard]] double equal_to() const {
    const auto mine = before_.pieces();
    const auto theirs = after_.pieces();
    std::size_t i = first_;
    std::size_t k = other_;
    while (i < mine.size() && k < theirs.size()) {
      const double end = mine[i].start + mine[i].length;
      const double their_end = theirs[k].start + theirs[k].length + offset_;
      if (!place_on(i, k)) return mine[i].start;
      if (!near(end, their_end, scale_)) return std::min(end, their_end);
      ++i;
      ++k;
    }
    return i < mine.size() ? mine[i].start : before_.length();
  }

  [[nodiscard]] double scale() const { return scale_; }

 private:
  static double reach(const Path& path) {
    std::array<Jet, max_axes> at;
    double most = 0;
    for (std::size_t i = 0; i < path.pieces().size(); ++i) {
      path.jets(i, 0, std::span(at).first(path.axes()));
      for (std::size_t k = 0; k < path.axes(); ++k) most = std::max(most, std::abs(at[k][0]));
    }
    return most;
  }

  /// True if the pieces have the same position and derivatives at these distances from their starts.
  [[nodiscard]] bool same_at(std::size_t i, double u, std::size_t k, double w) const {
    const std::size_t n = before_.axes();
    std::array<Jet, max_axes> mine;
    std::array<Jet, max_axes> theirs;
    before_.jets(i, u, std::span(mine).first(n));
    after_.jets(k, w, std::span(theirs).first(n));
    double bend = 1;  // scale of the derivatives; that of the first one is 1
    for (std::size_t a = 0; a < n; ++a)
      bend = std::max({bend, std::abs(mine[a][2]), std::abs(mine[a][3])});
    for (std::size_t a = 0; a < n; ++a)
      if (!near(mine[a][0], theirs[a][0], scale_) || !near(mine[a][1], theirs[a][1], 1) ||
          !near(mine[a][2], theirs[a][2], bend) || !near(mine[a][3], theirs[a][3], bend))
        return false;
    return true;
  }

  /// The distance from the start of piece i at which piece k begins, if it is then the same curve.
  /// Jets at the start, the middle and the end determine a curve of degree 9 or less, and an arc.
  [[nodiscard]] std::optional<double> place_on(std::size_t i, std::size_t k) const {
    const PathPiece& mine = before_.pieces()[i];
    const PathPiece& theirs = after_.pieces()[k];
    if (mine.kind != theirs.kind) return std::nullopt;
    if (mine.kind == PieceKind::line) {
      const double u = along(i, k);
      const bool on_it = u >= -rounded_sum * scale_ && u < mine.length;
      if (on_it && same_at(i, std::max(u, 0.0), k, 0)) return std::max(u, 0.0);
      return std::nullopt;
    }
    if (mine.line != theirs.line || !near(mine.length, theirs.length, scale_)) return std::nullopt;
    for (const double share : {0.0, 0.5, 1.0})
      if (!same_at(i, share * mine.length, k, share * theirs.length)) return std::nullopt;
    return 0;
  }

  /// The distance of the start of line k from that of line i, in the direction of line i.
  [[nodiscard]] double along(std::size_t i, std::size_t k) const {
    const std::size_t n = before_.axes();
    std::array<Jet, max_axes> mine;
    std::array<Jet, max_axes> theirs;
    before_.jets(i, 0, std::span(mine).first(n));
    after_.jets(k, 0, std::span(theirs).first(n));
    double u = 0;
    double square = 0;
    for (std::size_t a = 0; a < n; ++a) {
      u += (theirs[a][0] - mine[a][0]) * mine[a][1];
      square += mine[a][1] * mine[a][1];
    }
    return square > 0 ? u / square : 0;
  }

  const Path& before_;
  const Path& after_;
  double scale_;
  std::size_t first_ = 0, other_ = 0;
  double offset_ = 0;
};

/// The duration from their starts in which two stretches that begin alike are equal.
double common_time(const LawInterval& a, const LawInterval& b, double velocity) {
  if ((a.pieces == 0) != (b.pieces == 0)) return 0;
  if (a.pieces == 0) return std::min(a.duration, b.duration);
  std::array<LawPhase, 7> mine;
  std::array<LawPhase, 7> theirs;
  const std::size_t n = phases(a, mine);
  const std::size_t m = phases(b, theirs);
  double time = 0;
  for (std::size_t k = 0; k < std::min(n, m); ++k) {
    const LawPhase& p = mine[k];
    const LawPhase& q = theirs[k];
    if (!near(p.velocity, q.velocity, velocity) ||
        !near(p.acceleration, q.acceleration, std::max(a.acceleration, a.deceleration)) ||
        !near(p.jerk, q.jerk, a.jerk))
      return time;
    time += std::min(p.duration, q.duration);
    if (!near(p.duration, q.duration, p.duration)) return time;
  }
  return time;
}

/// The laws of both plans, stretch by stretch.
class Times {
 public:
  Times(const TimingLaw& before, const TimingLaw& after, double offset, double scale)
      : before_(before.stretches().unpacked()),
        after_(after.stretches().unpacked()),
        offset_(offset),
        scale_(scale) {
    for (const LawInterval& s : before_) velocity_ = std::max(velocity_, s.peak);
  }

  /// Compares from the last station at or before q at which both laws have the same velocity.
  std::optional<Agreement> compare(double q) const {
    std::optional<Agreement> found;
    std::size_t k = 0;
    for (std::size_t i = 0; i < before_.size() && before_[i].start <= q; ++i) {
      while (k < after_.size() && after_[k].start + offset_ < before_[i].start - slack()) ++k;
      std::size_t other = k;  // a rest and the stretch after it begin at the same place
      while (other < after_.size() && !begins_alike(i, other) &&
             near(after_[other].start + offset_, before_[i].start, scale_))
        ++other;
      if (other < after_.size() && begins_alike(i, other)) found = from(i, other);
    }
    return found;
  }

 private:
  [[nodiscard]] double slack() const { return rounded_sum * scale_; }

  [[nodiscard]] bool begins_alike(std::size_t i, std::size_t k) const {
    const LawInterval& a = before_[i];
    const LawInterval& b = after_[k];
    return near(a.start, b.start + offset_, scale_) && near(a.v0, b.v0, velocity_) &&
           (a.pieces == 0) == (b.pieces == 0) && !a.is_phase() && !b.is_phase();
  }

  [[nodiscard]] Agreement from(std::size_t i, std::size_t k) const {
    Agreement equal{.position = offset_, .shift = before_[i].time - after_[k].time};
    equal.until = before_[i].time;
    for (; i < before_.size() && k < after_.size() && begins_alike(i, k); ++i, ++k) {
      const LawInterval& a = before_[i];
      const LawInterval& b = after_[k];
      const bool same = near(a.length, b.length, scale_) && near(a.v1, b.v1, velocity_) &&
                        near(a.peak, b.peak, velocity_) && near(a.duration, b.duration, a.duration);
      equal.until = a.time + (same ? a.duration : common_time(a, b, velocity_));
      if (!same) break;
    }
    return equal;
  }

  std::vector<LawInterval> before_, after_;
  double offset_, scale_;
  double velocity_ = 0;
};

/// The time at which a law reaches q, by bisection.
double time_at(const TimingLaw& law, double q) {
  double low = 0;
  double high = law.duration();
  for (int i = 0; i < 100 && low < high; ++i) {
    const double middle = low + (high - low) / 2;
    (law.at(middle).position < q ? low : high) = middle;
  }
  return low;
}

}  // namespace

std::optional<Agreement> agreement(const Plan& before, const Plan& after, double q) {
  Geometry paths(before.path(), after.path());
  const auto offset = paths.align();
  if (!offset) return std::nullopt;
  auto found = Times(before.law(), after.law(), *offset, paths.scale()).compare(q);
  if (!found) return std::nullopt;
  const double end = paths.equal_to();
  if (!(end > q)) return std::nullopt;
  if (end < before.path().length())
    found->until = std::min(found->until, time_at(before.law(), end));
  return found;
}

}  // namespace jounce
