// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "executor/src/group/group_step.hpp"
#include "executor/src/group/planned_motion.hpp"

namespace jounce {

/// A condition for the commands after it: an M word, or a single step.
struct Gate {
  std::int32_t m_word = 0;
  double timeout = 0;  ///< s; 0: none
  bool is_step = false;
};

/// Commands that begin at rest when the motion before them has ended, and their gate is open.
struct Stage {
  PathCommands commands;
  std::shared_ptr<const GroupProgram> program;  ///< null: no command moves yet
  std::shared_ptr<const ExecutorGroup> group;
  /// Motions of the group before the motion before this stage ends; nullopt: it rests already.
  std::optional<std::uint64_t> finished = {};
  std::optional<Gate> gate = {};
  std::optional<SentPart> sent = {};  ///< set: `commands` has only the end of the stage
  std::size_t planned = 0;            ///< the command of `sent` after the last one of `program`
  std::future<PlannedMotion> preparing = {};  ///< valid: its next part is being planned
  std::size_t prepared_last = 0;              ///< the command after this part

  /// Number of its commands; the gate counts as one.
  [[nodiscard]] std::size_t size() const {
    return (sent ? sent->last - sent->first : commands.size()) + (gate ? 1 : 0);
  }
};

/// The stages after the present motion of a group, in their order, and the gate at which the group
/// waits. Stages that are dropped leave a notice for the operator.
class GroupStages {
 public:
  [[nodiscard]] bool empty() const { return stages_.empty(); }
  [[nodiscard]] std::size_t size() const { return stages_.size(); }
  [[nodiscard]] Stage& first() { return stages_.front(); }
  [[nodiscard]] const Stage& first() const { return stages_.front(); }
  [[nodiscard]] Stage& last() { return stages_.back(); }
  [[nodiscard]] const Stage& last() const { return stages_.back(); }

  void add(Stage stage) { stages_.push_back(std::move(stage)); }
  /// Inserts a stage after the first one.
  void add_second(Stage stage) { stages_.insert(stages_.begin() + 1, std::move(stage)); }
  /// Inserts a stage before the first one. `finished`: as in Stage.
  void add_first(Stage stage, std::uint64_t finished);
  /// Removes the first stage: it has begun, or has no motion. `finished`: that of the next one.
  void end_first(std::optional<std::uint64_t> finished);
  /// Drops all stages but the one whose beginning the group has already. Returns the number of their
  /// commands.
  std::size_t drop();
  /// Drops them, and leaves the notice "REASON: 2 commands were dropped" if there were commands.
  void drop(const std::string& reason);
  /// Leaves a notice for the operator.
  void notify(std::string notice) { notice_ = std::move(notice); }
  /// Returns the notice, and removes it; empty: none.
  [[nodiscard]] std::string take_notice() { return std::exchange(notice_, {}); }

  /// Number of the commands of all stages that have not begun.
  [[nodiscard]] std::size_t commands() const;
  /// The same number, in which the commands up to the next M word of a program that was sent as a whole
  /// count as one.
  [[nodiscard]] std::size_t taken() const;

  /// The group has the step that begins the first stage.
  void start() { starts_ = true; }
  [[nodiscard]] bool starts() const { return starts_; }
  /// Returns starts(): the group has answered this step.
  [[nodiscard]] bool take_start() { return std::exchange(starts_, false); }
  /// A motion of the group has begun: an M word that was not acknowledged is no reason to rest now.
  void begin_motion() { unacknowledged_ = false; }

  /// True if the gate of the first stage is not open.
  [[nodiscard]] bool closed() const {
    return !stages_.empty() && stages_.front().gate && !acknowledged_;
  }
  /// The group rests at the closed gate. Returns the event of its arrival, or of a timeout, which drops
  /// all stages; nullopt: the group waits. `cycle`: time of a tick, s.
  [[nodiscard]] std::optional<group_step::Announce> wait_at_gate(std::int64_t tick, double cycle);
  /// Number of the M word at which the group waits; nullopt: none.
  [[nodiscard]] std::optional<std::int32_t> m_word() const;
  /// Opens the gate; see GroupQueue::acknowledge().
  [[nodiscard]] Cause acknowledge(std::int32_t number);
  /// The reason why a group rests: it waits at a gate, or waited in vain; or none.
  [[nodiscard]] Cause rests_because(bool moves) const;

  /// Sets single step; see GroupQueue::single_step().
  void single_step(bool on) { single_step_ = on; }
  [[nodiscard]] bool single_step() const { return single_step_; }
  /// The gate before a command in single step; otherwise nullopt.
  [[nodiscard]] std::optional<Gate> step_gate() const {
    return single_step_ ? std::optional(Gate{.is_step = true}) : std::nullopt;
  }

 private:
  [[nodiscard]] bool waits() const { return gate_since_ >= 0 && closed(); }

  std::deque<Stage> stages_;
  bool starts_ = false;
  std::int64_t gate_since_ = -1;  // tick in which the group came to the gate; -1: it did not
  bool acknowledged_ = false;     // the gate is open
  bool unacknowledged_ = false;   // the last gate was not acknowledged in time
  bool single_step_ = false;
  std::string notice_;
};

}  // namespace jounce
