// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/inputs.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/command/commands.hpp"

#include "axis/src/homing/homing.hpp"

namespace jounce {

/// A homing that a command requests: its method and its numbers.
struct HomeOrder {
  HomingMethod method = {};
  HomingSpec spec = {};
};

/// Sets `order` to the homing that the command requests. Returns nullopt, or the reason to reject the
/// command: an unknown method, or a number beyond its limit.
std::optional<Refusal> home_order_of(const command::Home& what, const AxisConfig& config,
                                     HomeOrder& order);

/// The homing of an axis, and the limits in effect during it. The class Homing computes the velocity;
/// the axis plans the motion to that velocity as for any other move.
///
///     HomeSearch search(config);
///     search.begin(order, seen);
///     const HomeSearch::Step next = search.step(seen);       // once a tick
///     if (next.velocity) go(*next.velocity, search.rules());
///     search.end();                                          // the axis is at rest
///
/// Always true: the position range applies if and only if no search runs. It refers to the home
/// position, which is not known during a search.
class HomeSearch {
 public:
  explicit HomeSearch(const AxisConfig& config);

  /// Result of one tick of the search.
  struct Step {
    Cause fault = Cause::none;            ///< the fault that ends the search
    double exceeded = 0;                  ///< Homing::exceeded() at the fault
    bool done = false;                    ///< the axis stands beyond its home position
    std::optional<double> velocity = {};  ///< a new velocity, u/s; 0: to rest
  };

  /// Begins the search.
  void begin(const HomeOrder& order, const Homing::Seen& now) noexcept {
    homing_.emplace(order.method, order.spec, now);
  }
  /// Computes one tick. Requires a search that runs.
  Step step(const Homing::Seen& now) noexcept;
  /// Ends the search, if one runs.
  void end() noexcept { homing_.reset(); }

  /// True if a search runs.
  [[nodiscard]] bool running() const noexcept { return homing_.has_value(); }
  /// Home position in the coordinate of the drive, u. Requires a search that is done.
  [[nodiscard]] double home() const noexcept { return homing_->home(); }
  /// Position that the axis gets there, u. Requires a search that runs.
  [[nodiscard]] double position_at_home() const noexcept { return homing_->offset(); }
  /// The limits in effect.
  [[nodiscard]] const AxisConfig& rules() const noexcept { return homing_ ? unranged_ : config_; }

 private:
  AxisConfig config_;
  AxisConfig unranged_;  // config_ without the position range
  std::optional<Homing> homing_;
};

}  // namespace jounce
