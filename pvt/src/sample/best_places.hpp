// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "jounce/pvt/reduce.hpp"

#include "pvt/src/sample/interval.hpp"
#include "pvt/src/sample/stretches.hpp"

namespace jounce::pvt_detail {

/// The knots of a table, and the greatest share of the tolerances that one of its intervals uses up.
struct BestTable {
  std::vector<Knot> knots;
  double share = 0;  ///< at most 1
};

/// The search over places is limited to tables of so many knots, of curves of so many segments.
constexpr std::size_t most_searched_knots = 64;
constexpr std::size_t most_searched_segments = 128;

/// The best table over places by a dynamic programme, then with its knots moved. The places are the
/// breaks of the curve, `known` knots and equal parts of it, or all multiples of x_step where they are
/// few; see best_places.cpp. Nothing where no table of at most `most` knots keeps the tolerances, or where
/// the knots or segments are more than above; nothing for quadratic pieces.
///
/// `fewest`: the table of the fewest knots; otherwise that of the least share.
template <class Over>
std::optional<BestTable> best_over_places(const Curve<Over>& f, const Target& target,
                                          const Tolerances& tolerances,
                                          const std::vector<Straight>& kept,
                                          const std::vector<Knot>& known, std::size_t most,
                                          bool fewest);

}  // namespace jounce::pvt_detail
