// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/move_player.hpp"

#include <algorithm>

namespace jounce {

bool MovePlayer::begin(const TimedState& from, const Goal& goal, double factor,
                       const AxisConfig& config, double ahead) noexcept {
  return adopt(jounce::plan(from.state, goal, factor, config), from, goal, ahead);
}

bool MovePlayer::pause(const TimedState& from, const Goal& goal,
                       const AxisConfig& config) noexcept {
  const Goal rest{Goal::Kind::rest, 0, goal.dynamics};
  return adopt(jounce::plan(from.state, rest, 1, config), from, goal, 0);
}

bool MovePlayer::adopt(const std::optional<Profile>& profile, const TimedState& from,
                       const Goal& goal, double ahead) noexcept {
  if (!profile) return false;
  plan_ = *profile;
  goal_ = goal;
  origin_ = from.tick;
  ahead_ = ahead;
  return true;
}

double MovePlayer::time(std::int64_t tick) const noexcept {
  return seconds((tick - origin_) * period_) + ahead_;
}

double MovePlayer::beyond(std::int64_t tick) const noexcept {
  return time(tick) - plan_.duration();
}

Jet MovePlayer::at(std::int64_t tick) const noexcept {
  const auto [p, v, a, j] = plan_.at(time(tick));
  return {p + v * std::max(beyond(tick), 0.0), v, a, j};
}

std::optional<double> MovePlayer::passed(double position, Direction direction, std::int64_t from,
                                         std::int64_t to) const noexcept {
  const double end = time(to);
  double early = std::max(time(from), 0.0);
  double late = end;
  const double before = this->position(early);
  const double now = this->position(late);
  const bool up = before < position && position <= now;
  const bool down = before > position && position >= now;
  if (!(up && direction != Direction::negative) && !(down && direction != Direction::positive))
    return std::nullopt;
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = early + (late - early) / 2;
    const double there = this->position(middle);
    ((up ? there < position : there > position) ? early : late) = middle;
  }
  return end - late;
}

MotionState MovePlayer::state(std::int64_t tick, double ago) const noexcept {
  const double t = time(tick) - ago;
  const Motion motion = plan_.at(t);
  return {position(t), motion.velocity, motion.acceleration};
}

double MovePlayer::position(double t) const noexcept {
  const Motion motion = plan_.at(t);
  return motion.position + motion.velocity * std::max(t - plan_.duration(), 0.0);
}

/// The state at its start may take a move beyond its own dynamics.
Peaks MovePlayer::peaks_up_to(double factor) const noexcept {
  const MoveDynamics& d = goal_.dynamics;
  const Peaks planned = peaks(plan_);
  return {std::max(planned.velocity, d.velocity * std::max(1.0, factor)),
          std::max({planned.acceleration, d.acceleration, d.deceleration}),
          std::max(planned.jerk, d.jerk)};
}

}  // namespace jounce
