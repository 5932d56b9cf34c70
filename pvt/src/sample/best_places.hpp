// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "jounce/pvt/reduce.hpp"

#include "pvt/src/sample/interval.hpp"
#include "pvt/src/sample/stretches.hpp"

namespace jounce::pvt_detail {

/// The knots of a table, and the greatest share of the tolerances that an interval uses.
struct BestTable {
  std::vector<Knot> knots;
  double share = 0;  ///< at most 1
};

/// The search over places is used only for tables of at most so many knots, and curves of at most
/// so many segments.
constexpr std::size_t most_searched_knots = 64;
constexpr std::size_t most_searched_segments = 128;

/// The best table over places, found by dynamic programming; its knots are then moved. The places
/// are the breaks of the curve, the `known` knots, and equal parts of the curve; or all multiples
/// of x_step if they are few. See best_places.cpp. Returns nothing if no table of at most `most`
/// knots is within the tolerances, if there are more knots or segments than the constants above,
/// and for quadratic pieces.
///
/// `fewest`: the table with the fewest knots; otherwise the table with the least share.
template <class Over>
std::optional<BestTable> best_over_places(const Curve<Over>& f, const Target& target,
                                          const Tolerances& tolerances,
                                          const std::vector<Straight>& kept,
                                          const std::vector<Knot>& known, std::size_t most,
                                          bool fewest);

}  // namespace jounce::pvt_detail
