// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

#include "jounce/axis/movement.hpp"

namespace jounce::test {

/// p = p0 + reach (1 - cos w t), of which more and more becomes known: a rolling stream. It begins
/// at rest and never ends by itself.
class Feed final : public Movement {
 public:
  Feed(std::uint64_t id, double from, double reach, double w)
      : Movement(id, Course::path), from_(from), reach_(reach), w_(w) {}

  double supply = 0;      ///< s of path that come in a step; 0: the source has dried up
  bool complete = false;  ///< no more path will come

  Cause begin(const MotionState& axis, const Moment& /*now*/) noexcept override {
    return std::abs(axis.position - from_) < 1e-9 ? Cause::none : Cause::not_at_start;
  }
  Setpoint at(const Moment& now) noexcept override {
    known_ += supply;
    const double t = now.t;
    return {0,
            0,
            {from_ + reach_ * (1 - std::cos(w_ * t)), reach_ * w_ * std::sin(w_ * t),
             reach_ * w_ * w_ * std::cos(w_ * t), -reach_ * w_ * w_ * w_ * std::sin(w_ * t)}};
  }
  [[nodiscard]] Progress progress() const noexcept override { return Progress::running; }
  [[nodiscard]] double known() const noexcept override { return known_; }
  [[nodiscard]] bool growing() const noexcept override { return !complete; }
  [[nodiscard]] Peaks peaks() const noexcept override {
    const double r = std::abs(reach_);
    return {r * w_, r * w_ * w_, r * w_ * w_ * w_, 0};
  }
  void prefill(double known) { known_ = known; }

 private:
  double from_, reach_, w_;
  double known_ = 0;
};

/// A slave in a gear: p - p0 = ratio (m - m0). Refuses to begin at a velocity that is far from it.
class Gear final : public Movement {
 public:
  Gear(std::uint64_t id, double ratio) : Movement(id, Course::live), ratio_(ratio) {}

  Cause begin(const MotionState& axis, const Moment& now) noexcept override {
    if (!std::isfinite(now.master[0])) return Cause::master_lost;
    offset_ = axis.position - ratio_ * now.master[0];
    const bool in_step = std::abs(axis.velocity - ratio_ * now.master[1]) < 15;  // u/s: in a tick
    return in_step ? Cause::none : Cause::start_velocity;
  }
  Setpoint at(const Moment& now) noexcept override {
    const auto& [m, v, a, j] = now.master;
    if (!std::isfinite(m)) progress_ = Progress::broken;
    if (ends_at > 0 && now.t >= ends_at) progress_ = Progress::done;
    return {m, v, {offset_ + ratio_ * m, ratio_ * v, ratio_ * a, ratio_ * j}};
  }
  [[nodiscard]] Progress progress() const noexcept override { return progress_; }
  [[nodiscard]] Cause cause() const noexcept override { return Cause::master_lost; }

  double ends_at = 0;  ///< s; 0: it does not

 private:
  double ratio_;
  double offset_ = 0;
  Progress progress_ = Progress::running;
};

}  // namespace jounce::test
