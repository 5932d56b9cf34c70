// SPDX-License-Identifier: Apache-2.0
#include "path/src/timing/turn_chains.hpp"

#include <algorithm>

#include "path/src/timing/not_limited.hpp"
#include "path/src/timing/stretch.hpp"

// On a turn, let R, S and T be the greatest |r'|, |r''| and |r'''| of an axis with the limits A and J. The axis stays
// within its limits at v, with the acceleration a and the jerk j along the path, if
//
//   (1)  R a + S v^2 <= A,     R j + 3 S a v + T v^3 <= J
//
// With the greatest constant velocity reduced by the share s, at least 1 - (1 - s)^3 of J remains, and at least
// 1 - (1 - s)^2 of A.

namespace jounce {
namespace {

using path_detail::none;

constexpr double reduction = 0.03;      ///< the share s
constexpr std::size_t least_chain = 4;  ///< turns
constexpr double most_between = 0.3;  ///< length of the line between two turns, by the lesser trim

/// The box of a turn in which the law may change its velocity. `rates`: reserved. `fastest`: greatest constant
/// velocity. Half of what remains of each jerk limit is for j, half for a.
Box open_box(const Rates& rates, const Path& path, std::size_t piece,
             std::span<const PathSettings> settings, double fastest) {
  const Derivatives bounds = derivatives_of(path, piece, rates.path_axes);
  const PathPiece& turn = path.pieces()[piece];
  const Box before = path_box(rates, settings[turn.settings_before]);
  Box box = path_box(rates, settings[turn.settings]);
  const double v = std::min(fastest, velocity_with(rates, bounds, 0, 0) * (1 - reduction));
  double a = rates.path.total_acceleration - bounds.bend * v * v;  // r' r'' is at most |r''|
  double j = std::min(box.jerk, before.jerk);
  for (std::size_t i = 0; i < rates.axes; ++i) {
    const double first = bounds.first[i];
    const double second = bounds.second[i];
    if (!(first > 0)) continue;
    a = std::min(a, (rates.acceleration[i] - second * v * v) / first);
    const double left = rates.jerk[i] - bounds.third[i] * v * v * v;
    if (!(left < none)) continue;
    j = std::min(j, left / 2 / first);
    if (second > 0) a = std::min(a, left / 2 / (3 * second * v));
  }
  box.velocity = v;
  box.acceleration = std::min({box.acceleration, before.acceleration, a});
  box.deceleration = std::min({box.deceleration, before.deceleration, a});
  box.jerk = j;
  return box;
}

/// Finds the turns of chains among the units of a path.
class Chains {
 public:
  Chains(std::span<const Unit> units, const Path& path) : units_(units), path_(path) {}

  /// Calls `open` for each turn in a chain, in their order.
  template <class Open>
  void each(Open open) {
    std::size_t first = 0;
    std::size_t last = 0;
    std::size_t count = 0;
    const auto close = [&] {
      for (std::size_t k = first; count > 0 && k <= last; ++k)
        if (is_turn(k) && (count >= least_chain || is_held_up(k))) open(k);
    };
    for (std::size_t k = 0; k < units_.size(); ++k) {
      if (!is_turn(k)) continue;
      if (count > 0 && !meet(last, k)) {
        close();
        count = 0;
      }
      if (count++ == 0) first = k;
      last = k;
    }
    close();
  }

 private:
  [[nodiscard]] bool is_turn(std::size_t k) const {
    return k < units_.size() && path_.pieces()[units_[k].piece].kind == PieceKind::turn;
  }
  [[nodiscard]] bool is_line(std::size_t k) const {
    return k < units_.size() && path_.pieces()[units_[k].piece].kind == PieceKind::line &&
           units_[k].entry == none;
  }

  /// True if two turns leave nearly nothing of the line that they share.
  [[nodiscard]] bool meet(std::size_t k, std::size_t next) const {
    if (next == k + 1) return true;
    return next == k + 2 && is_line(k + 1) &&
           units_[k + 1].length <=
               most_between * std::min(units_[k].length, units_[next].length) / 2;
  }

  /// True if the turn before or behind is so slow that this turn cannot be passed at its own reduced velocity.
  [[nodiscard]] bool is_held_up(std::size_t k) const {
    const auto slows = [&](std::size_t next, std::size_t other, bool before) {
      const double v = units_[k].box.velocity * (1 - reduction);
      if (is_turn(next)) return units_[next].box.velocity < v;
      if (!is_line(next) || !is_turn(other)) return false;
      const double slow = units_[other].box.velocity;
      const Box& box = units_[next].box;
      return slow < v && ramp_distance(slow, v, before ? box.acceleration : box.deceleration,
                                       box.jerk) > units_[next].length;
    };
    return slows(k - 1, k - 2, true) || slows(k + 1, k + 2, false);
  }

  std::span<const Unit> units_;
  const Path& path_;
};

}  // namespace

void open_chains(std::span<Unit> units, const Path& path, const Rates& rates,
                 std::span<const PathSettings> settings) {
  const Rates curved = reserved(rates);
  std::vector<std::size_t> open;
  Chains(units, path).each([&](std::size_t k) { open.push_back(k); });
  for (const std::size_t k : open)
    units[k].box = open_box(curved, path, units[k].piece, settings, units[k].box.velocity);
}

}  // namespace jounce
