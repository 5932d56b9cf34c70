// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace jounce::pvt_detail {

/// Permitted velocities at a knot: lo <= v <= hi.
struct Gap {
  double lo = 0;
  double hi = 0;
};

/// A condition on the velocities at both ends of a piece: a v0 + b v1 <= c.
struct HalfPlane {
  double a = 0;
  double b = 0;
  double c = 0;
};

/// The demand of one piece on the velocities at its ends: the intersection of half planes.
class Demand {
 public:
  static constexpr std::size_t most = 28;

  void add(HalfPlane plane) {
    assert(size_ < most);
    planes_[size_++] = plane;
  }
  [[nodiscard]] std::span<const HalfPlane> planes() const { return {planes_.data(), size_}; }

 private:
  std::array<HalfPlane, most> planes_;
  std::size_t size_ = 0;
};

/// The velocities v1 in `to` that are permitted together with some v0 in `from`; nullopt if there
/// are none.
std::optional<Gap> reached(const Demand& demand, Gap from, Gap to);

/// The velocities v0 in `from` that are permitted together with v1, which reached() has found. If
/// rounding leaves none: the velocity with the least error.
Gap leading_to(const Demand& demand, Gap from, double v1);

/// The velocities that the demands of all pieces permit, and the pieces whose demand cannot be met.
struct Corridor {
  /// For each knot, the part of its gap that is reached through the previous knots.
  std::vector<Gap> gaps;
  std::vector<std::size_t> closed;  ///< pieces whose demand no velocities meet; it is ignored
};

/// Restricts the gaps, piece by piece in ascending order. demand_of(i) returns the Demand of piece
/// i, between the knots i and i + 1.
template <class DemandOf>
Corridor corridor(std::vector<Gap> gaps, const DemandOf& demand_of) {
  Corridor all{std::move(gaps), {}};
  for (std::size_t i = 0; i + 1 < all.gaps.size(); ++i) {
    if (const auto next = reached(demand_of(i), all.gaps[i], all.gaps[i + 1]))
      all.gaps[i + 1] = *next;
    else
      all.closed.push_back(i);
  }
  return all;
}

/// Replaces the velocities by permitted ones, from the last knot back: each by the nearest velocity
/// from which the next velocity is permitted.
template <class DemandOf>
void follow(const Corridor& corridor, const DemandOf& demand_of, std::span<double> v) {
  const auto nearest = [](Gap gap, double wanted) {
    return wanted < gap.lo ? gap.lo : wanted > gap.hi ? gap.hi : wanted;
  };
  auto closed = corridor.closed.rbegin();
  v.back() = nearest(corridor.gaps.back(), v.back());
  for (std::size_t i = v.size() - 1; i-- > 0;) {
    Gap gap = corridor.gaps[i];
    if (closed != corridor.closed.rend() && *closed == i)
      ++closed;
    else
      gap = leading_to(demand_of(i), gap, v[i + 1]);
    v[i] = nearest(gap, v[i]);
  }
}

}  // namespace jounce::pvt_detail
