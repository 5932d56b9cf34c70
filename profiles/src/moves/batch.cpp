// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/moves/batch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "profiles/src/moves/batch_kernel.hpp"

// The formulas are those of a single move (solver/span.hpp), applied to vectors of moves: each
// formula takes a whole block. The same source is compiled for each vector width, and the program
// queries the processor once for the width to use. The rare moves that do not converge in the usual
// number of steps are solved separately.

namespace jounce {
namespace {

using profiles_detail::Block;
const profiles_detail::Kernels& best_kernels() {
#ifdef JOUNCE_WIDE_KERNELS
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    return profiles_detail::kernels_avx512;
  if (avx2) return profiles_detail::kernels_avx2;
#endif
  return profiles_detail::kernels_anywhere;
}

/// Copies the values [first, first + n) of a column that has one value for each move, one for all
/// moves, or none (zero). The last value fills the rest of the block.
void fill(std::span<const double> column, std::size_t first, std::size_t n, double* lanes) {
  if (column.size() <= 1) {
    std::fill_n(lanes, Block::size, column.empty() ? 0.0 : column[0]);
    return;
  }
  std::copy_n(column.data() + first, n, lanes);
  std::fill(lanes + n, lanes + Block::size, lanes[n - 1]);
}

bool sound(const Block& b, std::size_t i) {
  const double ends = std::max(std::abs(b.entry[i]), std::abs(b.exit[i]));
  return profiles_detail::is_way(b.distance[i]) && profiles_detail::is_moderate(b.entry[i]) &&
         profiles_detail::is_moderate(b.exit[i]) && ends <= b.velocity[i] &&
         profiles_detail::is_limit(b.velocity[i]) &&
         profiles_detail::is_magnitude(b.acceleration[i]) && profiles_detail::is_limit(b.jerk[i]);
}

profiles_detail::Way<double> one_by_one(const Block& b, std::size_t i) {
  const profiles_detail::Rates<double> rates(b.acceleration[i], b.jerk[i]);
  const profiles_detail::Span<double> s(b.distance[i], b.entry[i], b.exit[i], rates);
  const auto [duration, peak] = profiles_detail::fastest(s, b.velocity[i]);
  return {duration, s.mirrored ? -peak : peak};
}

profiles_detail::Way<double> answer(const Block& b, std::size_t i) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (b.settled[i] > 0) return {b.duration[i], b.peak[i]};
  return sound(b, i) ? one_by_one(b, i) : profiles_detail::Way<double>{none, none};
}

bool fits(std::span<const double> column, std::size_t size, bool optional) {
  return column.size() == size || column.size() == 1 || (optional && column.empty());
}

bool fits(const MoveColumns& moves, std::size_t size, std::size_t peaks) {
  return fits(moves.distance, size, false) && fits(moves.velocity, size, false) &&
         fits(moves.acceleration, size, false) && fits(moves.jerk, size, false) &&
         fits(moves.entry, size, true) && fits(moves.exit, size, true) &&
         (peaks == 0 || peaks == size);
}

}  // namespace

void minimum_durations(const MoveColumns& moves, std::span<double> durations,
                       std::span<double> peak) noexcept {
  const std::size_t size = durations.size();
  if (!fits(moves, size, peak.size())) {
    std::ranges::fill(durations, std::numeric_limits<double>::quiet_NaN());
    std::ranges::fill(peak, std::numeric_limits<double>::quiet_NaN());
    return;
  }
  static const profiles_detail::Kernels& best = best_kernels();
  const auto solve = moves.entry.empty() && moves.exit.empty() ? best.rests : best.ways;
  Block block;
  for (std::size_t first = 0; first < size; first += Block::size) {
    const std::size_t n = std::min(Block::size, size - first);
    fill(moves.distance, first, n, block.distance);
    fill(moves.entry, first, n, block.entry);
    fill(moves.exit, first, n, block.exit);
    fill(moves.velocity, first, n, block.velocity);
    fill(moves.acceleration, first, n, block.acceleration);
    fill(moves.jerk, first, n, block.jerk);
    solve(block);
    for (std::size_t i = 0; i < n; ++i) {
      const auto way = answer(block, i);
      durations[first + i] = way.duration;
      if (!peak.empty()) peak[first + i] = way.peak;
    }
  }
}

}  // namespace jounce
