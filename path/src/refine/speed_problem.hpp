// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace jounce {

/// A linear limit on the squared velocities of three successive nodes: -low <= c B <= 1.
struct SpeedRow {
  std::array<double, 3> c{};
  double low = 1;
  std::uint32_t first = 0;  ///< index of the first node
};

/// The least duration of a motion along a path of cells, by the squared velocity B at the nodes. B
/// is linear over each cell, and 0 at both ends. The problem is convex.
struct SpeedProblem {
  std::vector<double> cells;  ///< lengths
  std::vector<double> most;   ///< greatest B of each node; the first and the last do not count
  std::vector<SpeedRow> rows;

  [[nodiscard]] double duration(const std::vector<double>& b) const;
  /// The greatest share of a limit that B uses.
  [[nodiscard]] double use(const std::vector<double>& b) const;
};

/// Returns a B whose duration is at most (1 + gap) times the least one. `b`: a start within all
/// limits; the result is at least as fast. By a primal-dual interior-point method.
std::vector<double> fastest_speeds(const SpeedProblem& problem, std::vector<double> b, double gap);

}  // namespace jounce
