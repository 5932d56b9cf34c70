// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/command/commands.hpp"
#include "jounce/profiles/moves/profile.hpp"

#include "axis/src/motion/move_goal.hpp"
#include "axis/src/motion/move_plan.hpp"
#include "axis/src/motion/move_player.hpp"
#include "axis/src/motion/repetition.hpp"
#include "axis/src/motion/waiting_moves.hpp"

namespace jounce {

/// The conditions of a tick under which a move is planned. u is the unit of the axis.
struct MoveConditions {
  std::int64_t tick = 0;         ///< the present tick
  std::int64_t last_tick = -1;   ///< the tick before it
  const AxisConfig& rules;       ///< limits in effect
  bool searches = false;         ///< a homing: a pause uses the acceleration of the move
  bool positive_switch = false;  ///< the positive limit switch is active
  bool negative_switch = false;  ///< the negative limit switch is active
  double factor = 1;             ///< the override
  double rate = 1;               ///< the requested rate: the override; 0: held, or at a stop
  bool stopping = false;         ///< the motion comes to its end
  bool added = false;            ///< a superimposed move is in progress
  bool shifted = false;          ///< it, or one that has finished, shifts the setpoint
  double shift = 0;              ///< distance of finished superimposed moves, u
};

/// The move that an axis plans itself, with the commands that change it later: the moves that wait
/// for its end (BufferMode), the strokes of a repetitive move, and a new velocity from a position on.
///
///     OwnMove move(config);
///     if (!move.plan(from, goal, 1, now)) ...                     // no such move exists
///     if (auto no = move.buffer(next, end, from, true, now)) ...  // rejected
///     const OwnMove::Step step = move.advance(now);               // once a tick
///     const Jet next = move.player().at(tick);
///
/// Always true: the move passes its target at a nonzero velocity only if the first waiting move begins
/// there. A waiting move is planned to end at rest until it is in progress, so if the moves after it are
/// withdrawn, it can still stop at its target.
///
/// An OwnMove has a fixed size. It does not allocate, lock or throw.
class OwnMove {
 public:
  explicit OwnMove(const AxisConfig& config) : config_(config), player_(config.period) {}

  /// Result of one tick.
  struct Step {
    Cause fault = Cause::none;            ///< the move cannot continue
    int passed = 0;                       ///< targets that were passed
    std::optional<Refusal> dropped = {};  ///< a change of the velocity that was not possible
  };

  // ---- the move

  /// Plans the move to the goal, like MovePlayer::begin() and, in a homing at rate 0,
  /// MovePlayer::pause(). Returns false, and changes nothing, if no such move exists.
  bool plan(const TimedState& from, const Goal& goal, double factor, const MoveConditions& now,
            double ahead = 0) noexcept;
  /// Applies what is due in this tick: a change of the velocity, strokes, and passed targets. A late
  /// tick may pass several targets.
  Step advance(const MoveConditions& now) noexcept;
  /// The goal and the plan of the move.
  [[nodiscard]] const MovePlayer& player() const noexcept { return player_; }
  [[nodiscard]] const Goal& goal() const noexcept { return player_.goal(); }
  /// True if the move passes its target.
  [[nodiscard]] bool passes() const noexcept { return !next_.empty() && player_.passes(); }

  // ---- strokes, and another velocity

  /// Sets `there` to the goal of the first stroke, or returns the reason to reject the command.
  std::optional<Refusal> first_stroke(const command::MoveRepetitive& what, const MotionState& from,
                                      const MoveConditions& now, Goal& there) const noexcept;
  /// The move is the first stroke of this command, from the position `from`, u.
  void repeat(const command::MoveRepetitive& what, double from) noexcept {
    repetition_.emplace(from, goal().value, what.wait, what.strokes);
  }
  /// True if the move is a stroke of a repetitive move, also of one that ends with this stroke.
  [[nodiscard]] bool is_stroke() const noexcept { return repetition_.has_value(); }
  /// True if another stroke follows.
  [[nodiscard]] bool repeats() const noexcept { return repetition_ && repetition_->goes_on(); }
  /// The present stroke is the last one. Requires a stroke.
  void finish_strokes() noexcept { repetition_->finish(); }
  /// Changes the velocity of the move at once, or when it passes a position. `from`: the present
  /// state of the move. Returns the reason to reject the command, or nullopt.
  std::optional<Refusal> change(const command::ChangeVelocity& what, const TimedState& from,
                                const MoveConditions& now) noexcept;
  /// True if a change waits for its position.
  [[nodiscard]] bool changes_later() const noexcept { return change_.has_value(); }
  /// Another motion takes over: no strokes, and no change.
  void forget_changes() noexcept;

  // ---- moves that wait for the end of the motion

  /// Adds a waiting move. `end`: the state after the present motion, if it is known; otherwise the move
  /// is checked against the state `last`, and again at its beginning. `planned`: the present motion
  /// is this move, from the state `bare`.
  std::optional<Refusal> buffer(const BufferedMove& move, std::optional<MotionState> end,
                                const MotionState& last, const TimedState* planned,
                                const MoveConditions& now) noexcept;
  /// Withdraws all waiting moves: the present move ends at its target. Returns false, and changes
  /// nothing, if it is too late for that. `planned`: see buffer().
  bool withdraw(const TimedState* planned, const MoveConditions& now) noexcept;
  /// Removes the first waiting move and returns it. Requires that a move waits.
  BufferedMove take_next() noexcept;
  /// Removes the waiting moves and returns them; keep() puts them back.
  WaitingMoves take_all() noexcept;
  void keep(const WaitingMoves& moves) noexcept { next_ = moves; }
  /// The moves that wait.
  [[nodiscard]] const WaitingMoves& waiting() const noexcept { return next_; }

 private:
  [[nodiscard]] MoveRules rules(const MoveConditions& now) const noexcept {
    return {config_, now.positive_switch, now.negative_switch};
  }
  [[nodiscard]] double through(const MotionState& from, const Goal& goal, double factor,
                               const MoveConditions& now) const noexcept;
  std::optional<Refusal> change_velocity(double velocity, const TimedState& from, double ahead,
                                         const MoveConditions& now) noexcept;
  std::optional<Refusal> change_if_passed(const MoveConditions& now) noexcept;
  Cause begin_strokes(const MoveConditions& now) noexcept;
  Cause pass_target(const MoveConditions& now) noexcept;

  AxisConfig config_;
  MovePlayer player_;
  WaitingMoves next_;
  std::optional<Repetition> repetition_;
  std::optional<command::ChangeVelocity> change_;  // waits until the move passes its position
};

/// Returns the reason for the sender of the first of these moves: another motion has replaced them.
/// nullopt: no move waited.
std::optional<Refusal> replaced(const WaitingMoves& moves) noexcept;

}  // namespace jounce
