// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace jounce::pvt_detail {

/// lo <= v <= hi.
struct Gap {
  double lo = 0;
  double hi = 0;
};

/// a v0 + b v1 <= c for the velocities at the two ends of a piece.
struct HalfPlane {
  double a = 0;
  double b = 0;
  double c = 0;
};

/// The demand of one piece on the velocities at its ends: they lie in all of some half planes.
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

/// The velocities v1 in `to` that some v0 in `from` permits; nothing if there is none.
std::optional<Gap> reached(const Demand& demand, Gap from, Gap to);

/// The velocities v0 in `from` that permit a v1 that reached() found. Where rounding leaves none: the one
/// with the least error.
Gap leading_to(const Demand& demand, Gap from, double v1);

/// A way through the gaps that every piece's demand permits, and the pieces without one.
struct Corridor {
  std::vector<Gap> gaps;  ///< at each knot, the part of its gap that the knots before permit
  std::vector<std::size_t> closed;  ///< pieces whose demand no velocity keeps: it is dropped there
};

/// Follows the pieces upwards: the rest of each gap. demand_of(i) makes the Demand of piece i,
/// between the knots i and i + 1.
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

/// Replaces the velocities by a way through the corridor: from the last knot back, each by the nearest
/// one that leads on.
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
