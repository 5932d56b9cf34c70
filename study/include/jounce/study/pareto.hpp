// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace jounce {

/// The points that no other point dominates, all numbers to be minimized: their indices, ascending.
///
///     const std::vector<std::vector<double>> designs{{1, 5}, {2, 3}, {2, 4}, {4, 1}};
///     pareto_front(designs);                                              // 0, 1, 3
///
/// One point dominates another if it is greater in no objective and less in at least one. Equal
/// points do not dominate each other: all of them are in the front. A point with a NaN is not a
/// design and never in the front; infinities are numbers. All points have the same number of
/// objectives, at least one. O(n log n) for one and two objectives; for more, O(n f) with f points
/// in the front.
std::vector<std::size_t> pareto_front(std::span<const std::vector<double>> points);

}  // namespace jounce
