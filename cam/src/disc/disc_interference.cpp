// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "jounce/cam/disc/disc.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/src/disc/pitch.hpp"

// A circle of radius R touches the profile p at t2 from outside; its center is q(t2). It cuts into
// the profile at t1 if
//
//   (1)  |q(t2) - p(t1)| < R
//
// If the tangent turns by at most pi/2 between t1 and t2, this is impossible for a regular profile
// that is nowhere more hollow than the circle. Proof: with the tangent at t2 as the x axis, the
// profile is a graph whose slope angle f obeys d(sin f)/dx = curvature <= 1/R towards the circle.
// Equality holds for the circle, so the profile stays on its far side. All other pairs are
// enclosed:
//
//   (2)  |q(t2) - p(t1)| >= |q(m2) - p(m1)| - r2 max|q'| - r1 max|p'|     m middles, r half-widths

namespace jounce {
namespace {

using cam_detail::Interval;
using cam_detail::SegmentPart;

constexpr double shortest_part = 1e-9;  ///< share of a segment: a shorter part is not divided
constexpr double touching = 1e-5;       // relative to the radius: a clearance that counts as none
constexpr double precision = 1e-3;      // relative to the radius: precision of the depth

/// An interval of the turn, with a circle that contains all its contact points, and one that
/// contains all centers of the rolled circle.
struct Arc {
  SegmentPart over;
  Place contact, center;
  double contact_radius = 0;
  double center_radius = 0;
  double turning = 0;  ///< rad, upper bound of the rotation of the tangent
};

class Search {
 public:
  Search(const Disc& disc, double radius)
      : disc_(disc), radius_(radius), least_((1 + touching / 2) * radius) {
    for (std::size_t i = 0; i < disc.lift().segments().size(); ++i) divide({i, 0, 1});
  }

  std::optional<Interference> run() {
    for (std::size_t i = 0; i < arcs_.size(); ++i)
      for (std::size_t k = 0; k < arcs_.size(); ++k)
        if (!near(i, k)) search(arcs_[i], arcs_[k]);
    return found_;
  }

 private:
  [[nodiscard]] Arc arc(const SegmentPart& over) const {
    const cam_detail::Pitch whole = cam_detail::pitch(disc_, over);
    const SegmentPart middle = over.at(over.middle());
    const cam_detail::Pitch there = cam_detail::pitch(disc_, middle);
    const auto place = [&](double distance) {
      const auto p = cam_detail::seen_from_cam(there.parallel(distance).to<0>(),
                                               cam_detail::turned<0>(disc_, middle), there.sigma);
      return Place{p.x.c[0].middle(), p.y.c[0].middle()};
    };
    const double half = (over.s1 - over.s0) / 2 * length(over) * disc_.spec().angle;
    const auto speed = [&](double distance) {  // parallel curve: |T| (1 + distance kappa)
      const Interval v =
          whole.speed().c[0] * (Interval(1) + Interval(distance) * whole.curvature().c[0]);
      return v.magnitude();
    };
    const double roller = disc_.spec().roller_radius;
    const Interval turning = whole.speed().c[0] * whole.curvature().c[0];
    return {over,
            place(-roller),
            place(radius_ - roller),
            half * speed(-roller),
            half * speed(radius_ - roller),
            2 * half * turning.magnitude()};
  }

  [[nodiscard]] double length(const SegmentPart& over) const {
    return disc_.lift().segments()[over.segment].length;
  }

  /// Divides into arcs of at most a twentieth of a turn.
  void divide(const SegmentPart& over) {
    const Arc whole = arc(over);
    if (whole.turning <= std::numbers::pi / 10 || over.s1 - over.s0 < shortest_part) {
      arcs_.push_back(whole);
      return;
    }
    divide(over.left());
    divide(over.right());
  }

  /// True if the tangent turns by at most a quarter turn from arc i to arc k, in either direction.
  [[nodiscard]] bool near(std::size_t i, std::size_t k) const {
    return turning(i, k) <= std::numbers::pi / 2 || turning(k, i) <= std::numbers::pi / 2;
  }
  [[nodiscard]] double turning(std::size_t from, std::size_t to) const {
    double sum = arcs_[to].turning;
    for (std::size_t i = from; i != to && sum <= 2; i = (i + 1) % arcs_.size())
      sum += arcs_[i].turning;
    return sum;
  }

  /// The least distance (1) of the two, if it is less than the best so far.
  void search(const Arc& circle, const Arc& covered) {
    const double apart =
        std::hypot(circle.center.x - covered.contact.x, circle.center.y - covered.contact.y);
    const double reach = circle.center_radius + covered.contact_radius;
    const bool is_small = reach <= touching / 2 * radius_;
    if (apart < least_ || (is_small && apart - reach < least_ && !found_)) {
      least_ = apart;
      found_ = Interference{place(circle), place(covered), std::max(0.0, radius_ - apart)};
    }
    const double slack = found_ ? precision * radius_ : 0;
    if (apart - reach >= least_ - slack || is_small) return;  // (2)
    if (circle.center_radius > covered.contact_radius) {
      search(arc(circle.over.left()), covered);
      search(arc(circle.over.right()), covered);
    } else {
      search(circle, arc(covered.over.left()));
      search(circle, arc(covered.over.right()));
    }
  }
  [[nodiscard]] double place(const Arc& a) const {
    return cam_detail::position(disc_.lift(), a.over.segment, a.over.middle());
  }

  const Disc& disc_;
  double radius_;
  double least_;  ///< least distance so far, or the initial bound
  std::vector<Arc> arcs_;
  std::optional<Interference> found_;
};

}  // namespace

std::optional<Interference> interference(const Disc& disc, double radius) {
  require_not_negative("radius", radius);
  return Search(disc, radius).run();
}

}  // namespace jounce
