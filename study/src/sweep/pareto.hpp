// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace jounce {

/// Returns the indices of the points that no other point dominates, ascending. All numbers of a
/// point are objectives to be minimized.
///
///     const std::vector<std::vector<double>> designs{{1, 5}, {2, 3}, {2, 4}, {4, 1}};
///     pareto_front(designs);                                              // 0, 1, 3
///
/// A point dominates another point if it is greater in no objective and less in at least one. Equal
/// points do not dominate each other, so all of them are in the result. A point with a NaN is never
/// in the result; infinities are ordinary numbers. Requires points with the same number of
/// objectives, at least one. The effort is O(n log n) for one and two objectives; for more, it is
/// O(n f) with f points in the result.
std::vector<std::size_t> pareto_front(std::span<const std::vector<double>> points);

}  // namespace jounce
