// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "jounce/stream/detail/sender.hpp"
#include "jounce/stream/sender/stream_group.hpp"

namespace jounce {

/// Streams to several axes of one machine whose motions start together: a pure state machine that
/// contains a Sender for each axis. It has no thread, clock or link.
///
///     Group group({plan_of("x"), plan_of("y")}, 11);
///     while (!group.ended()) {
///       for (const auto& message : group.poll(now)) ...   // send each one; call poll() every ms
///       group.receive(message, now);                      // replies and statuses of all axes
///     }
///
/// The group sends all tables, arms all axes, and starts them in the same tick. If one axis rejects
/// a message, no axis starts; the outcome of each axis has its own reason. Axes of different
/// machines cannot start in the same tick, and are rejected.
///
/// If one axis then cannot start, stops, or fails, the others stop, too. The executor stops them in
/// the same cycle or the next one, because their motions were started in one session. If the
/// executor is too old for this, the group stops them.
class Group {
 public:
  /// `session` > 0: a random number. Throws InputError like Sender, for fewer than 2 plans, a
  /// duplicate name, or a plan with swaps. The goal and the start tick of each plan are replaced by
  /// the goal and the tick of the group.
  Group(std::vector<StreamPlan> plans, std::int64_t session, GroupOptions options = {});

  /// Returns the messages to send now.
  [[nodiscard]] std::vector<wire::Message> poll(Nanos now);
  /// Processes a message that has arrived.
  void receive(const wire::Message& message, Nanos now);

  /// Stops all axes and ends.
  void stop(wire::StopMode mode);
  /// Ends with this error: releases armed axes, and stops axes in motion.
  void fail(StreamError error, const std::string& reason);

  /// True if the group has ended.
  [[nodiscard]] bool ended() const;
  /// True if all motions have begun.
  [[nodiscard]] bool started() const { return phase_ >= Phase::playing; }
  /// Outcome of each axis, in the order of the plans.
  [[nodiscard]] std::vector<StreamOutcome> outcomes() const;
  /// Common tick of the start; -1: not known yet.
  [[nodiscard]] std::int64_t tick() const { return tick_; }

 private:
  enum class Phase { arming, starting, playing, leaving };
  struct Axis {
    std::string name = {};
    Sender sender;
    std::optional<wire::Status> status{};  // newest status of the axis in this session
    std::optional<StreamOutcome> own{};    // outcome of the axis before the group ended its stream
    bool over = false;
  };

  void go_on();
  void start();
  void watch();
  [[nodiscard]] bool all_at_goal() const;
  [[nodiscard]] const Axis* failed() const;
  void leave(const Axis& because);
  void leave_broken(Axis& axis);
  void release();

  GroupOptions options_;
  std::vector<Axis> axes_;
  Phase phase_ = Phase::arming;
  std::int64_t tick_ = -1;
};

}  // namespace jounce
