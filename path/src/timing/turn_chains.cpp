// SPDX-License-Identifier: Apache-2.0
#include "path/src/timing/turn_chains.hpp"

#include <algorithm>
#include <utility>

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

using path_detail::unlimited;

constexpr double reduction = 0.03;      ///< the share s
constexpr std::size_t least_chain = 4;  ///< turns
constexpr double most_between = 0.3;  ///< length of the line between two turns, by the lesser trim

/// The limits of a turn for the law, and the box in which the law may change its velocity.
class OpenTurn {
 public:
  /// `rates`: reserved. `fastest`: greatest constant velocity.
  OpenTurn(const Rates& rates, const Path& path, std::size_t piece,
           std::span<const PathSettings> settings, double fastest)
      : rates_(rates),
        bounds_(derivatives_of(path, piece, rates.path_axes)),
        trim_(path.pieces()[piece].length / 2),
        box_(path_box(rates, settings[path.pieces()[piece].settings])) {
    const Box before = path_box(rates, settings[path.pieces()[piece].settings_before]);
    box_.velocity = std::min(fastest, velocity_with(rates, bounds_, 0, 0) * (1 - reduction));
    box_.acceleration = std::min(box_.acceleration, before.acceleration);
    box_.deceleration = std::min(box_.deceleration, before.deceleration);
    box_.jerk = std::min(box_.jerk, before.jerk);
  }

  /// True if the law can reach the velocity of the turn from a rest within the trim. Then a rest holds up no chain.
  [[nodiscard]] bool is_near_rest() const {
    double a = std::min(box_.acceleration, box_.deceleration);
    double j = box_.jerk;
    for (std::size_t i = 0; i < rates_.axes; ++i) {
      if (!(bounds_.first[i] > 0)) continue;
      a = std::min(a, rates_.acceleration[i] / bounds_.first[i]);
      j = std::min(j, rates_.jerk[i] / bounds_.first[i]);
    }
    return ramp_distance(0, box_.velocity, a, j) <= trim_;
  }

  /// Half of what remains of each jerk limit is for the jerk along the path, half for the acceleration.
  [[nodiscard]] Box box() const {
    const double v = box_.velocity;
    double a = rates_.path.total_acceleration - bounds_.bend * v * v;  // r' r'' is at most |r''|
    Box box = box_;
    for (std::size_t i = 0; i < rates_.axes; ++i) {
      const double first = bounds_.first[i];
      const double second = bounds_.second[i];
      if (!(first > 0)) continue;
      a = std::min(a, (rates_.acceleration[i] - second * v * v) / first);
      const double left = rates_.jerk[i] - bounds_.third[i] * v * v * v;
      if (!(left < unlimited)) continue;
      box.jerk = std::min(box.jerk, left / 2 / first);
      if (second > 0) a = std::min(a, left / 2 / (3 * second * v));
    }
    box.acceleration = std::min(box.acceleration, a);
    box.deceleration = std::min(box.deceleration, a);
    return box;
  }

 private:
  const Rates& rates_;
  Derivatives bounds_;
  double trim_;
  Box box_;
};

/// Finds the turns of chains among the units of a path.
class Chains {
 public:
  Chains(std::span<const Unit> units, const Path& path) : units_(units), path_(path) {}

  /// Calls `open` with each turn in a chain, in their order, and whether its neighbors hold it up.
  template <class Open>
  void each(Open open) {
    std::size_t first = 0;
    std::size_t last = 0;
    std::size_t count = 0;
    const auto close = [&] {
      for (std::size_t k = first; count > 0 && k <= last; ++k)
        if (const bool held_up = is_turn(k) && is_held_up(k);
            held_up || (is_turn(k) && count >= least_chain))
          open(k, held_up);
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
           units_[k].entry == unlimited;
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
  const bool limited = limit_axes(settings);
  std::vector<std::pair<std::size_t, Box>> open;
  Chains(units, path).each([&](std::size_t k, bool held_up) {
    const std::size_t piece = units[k].piece;
    const Rates here = limited ? rates_on(curved, path.pieces()[piece], settings, true) : curved;
    const OpenTurn turn(here, path, piece, settings, units[k].box.velocity);
    if (held_up || !turn.is_near_rest()) open.emplace_back(k, turn.box());
  });
  for (const auto& [k, box] : open) units[k].box = box;
}

}  // namespace jounce
