// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>

#include "executor/src/group/group_stages.hpp"
#include "executor/src/group/group_step.hpp"
#include "executor/src/group/planned_motion.hpp"

namespace jounce {

/// The motion of a program that was sent as a whole. Its rest is in the stages: the parts from one M
/// word that waits to the next and, in single step, from one command to the next. The group continues
/// its path with a longer plan (the next window of a long program) or a shorter one (a single step),
/// which equals the present plan up to where it takes over.
class SentMotion {
 public:
  /// `stages` and `planner` must outlive this object. `group`: the group with its own limits.
  SentMotion(GroupStages& stages, MotionPlanner& planner,
             std::shared_ptr<const ExecutorGroup> group)
      : stages_(stages), planner_(planner), group_(std::move(group)) {}

  /// The group has begun the first motion of a program; see GroupQueue::begins().
  void begins(std::uint64_t movement, std::shared_ptr<const GroupProgram> motion,
              std::shared_ptr<const SentProgram> sent, std::size_t last, const Tick& group);
  /// The group has begun a stage of the program.
  void begins(std::uint64_t movement, const Stage& stage);
  /// Plans the first stage: one command in single step, otherwise all of its commands, or the first
  /// window. Returns false if the plan is not ready, or if the stages were dropped.
  [[nodiscard]] bool prepare();
  /// Returns the step that shortens the present plan for single step, or that continues it with the
  /// next window; nullopt: none now.
  [[nodiscard]] std::optional<GroupStep> next(const Tick& group);
  /// Takes the answer to such a step; false: it belongs to another step. `finished`: motions of the
  /// group that have ended.
  [[nodiscard]] bool answered(bool accepted, std::uint64_t movement, std::uint64_t finished);

  /// True if the group plays a part of the program.
  [[nodiscard]] bool plays(const Tick& group) const {
    return playing_ && group.job == playing_->movement;
  }
  /// The coordinates at the end of this part. Requires plays().
  [[nodiscard]] Point end() const {
    return playing_->part.of->sent.program.place_before(playing_->part.last);
  }
  /// The rest of a long program after the plan that the group plays.
  [[nodiscard]] WindowRest beyond(const Tick& group) const;

 private:
  /// The part that the group plays.
  struct Playing {
    std::uint64_t movement = 0;
    std::shared_ptr<const GroupProgram> program;
    SentPart part;
    /// It cannot come to rest earlier, or it is the last command before a rest.
    bool is_step = false;
    double origin = 0;   // position of the group at the start of the program
    bool rests = false;  // it cannot continue in the next window, and rests at its end
  };
  /// The next window, which takes over where the group has passed half of the commands that both windows
  /// contain.
  struct Window {
    std::size_t first = 0;  // its first command
    std::size_t last = 0;   // the command after its last one
    std::future<PlannedMotion> planned;
    std::optional<PlannedMotion> made = {};
    std::shared_ptr<const GroupProgram> program = {};  // set: the group has the step
    double position = 0;  // place of the group at the start of its program
  };
  /// A shorter plan, which ends earlier: for single step.
  struct Cut {
    std::size_t last = 0;  // the command after its last one
    std::future<PlannedMotion> planned;
    std::shared_ptr<const GroupProgram> program = {};  // set: the group has the step
    double position = 0;  // place of the group at the start of its program
  };

  [[nodiscard]] Stage stage_of(SentPart part, std::optional<Gate> gate) const;
  [[nodiscard]] bool divide(const SentPart& part);
  [[nodiscard]] std::optional<GroupStep> cut(const Tick& group);
  [[nodiscard]] bool begin_cut(const Tick& group);
  void cut_answered(bool accepted, std::uint64_t movement, std::uint64_t finished);
  [[nodiscard]] bool has_rest() const;
  [[nodiscard]] std::optional<GroupStep> next_window(const Tick& group);
  void begin_window();
  void window_answered(bool accepted, std::uint64_t movement, std::uint64_t finished);

  GroupStages& stages_;
  MotionPlanner& planner_;
  std::shared_ptr<const ExecutorGroup> group_;
  std::optional<Playing> playing_;
  std::optional<Cut> cut_;
  std::size_t cut_skips_ = 0;  // commands at whose end the next cut must not end: it comes too late
  std::optional<Window> window_;
};

}  // namespace jounce
