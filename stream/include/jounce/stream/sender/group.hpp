// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "jounce/stream/sender/driver.hpp"
#include "jounce/stream/sender/sender.hpp"

namespace jounce {

struct GroupOptions {
  SenderOptions sender = {};
  std::int64_t tick = -1;  ///< start tick of all; -1: as soon as all can have accepted it
  Nanos lead = std::chrono::milliseconds(300);  ///< for tick -1: distance from the newest tick
  bool watch = true;  ///< ends when all motions have ended; false: when all have begun
};

/// Several axes of one machine as one: a pure state machine over a Sender each, without thread,
/// clock or link.
///
///     Group group({plan_of("x"), plan_of("y")}, 11);
///     while (!group.ended()) {
///       for (const auto& message : group.poll(now)) ...   // to be sent; calls every ms
///       group.receive(message, now);                      // replies and statuses of all axes
///     }
///
/// The group downloads and arms all. If one axis rejects, none starts, and each outcome has its own
/// reason. They start at one common tick, so axes of different machines are rejected. If one then
/// cannot start, stops during its motion, or fails, the others stop too: the executor stops them in
/// that cycle or the next one, because one session has started them; the group stops those that
/// continue (an older executor).
class Group {
 public:
  /// Throws InputError like Sender, and for fewer than 2 plans or a duplicate name.
  Group(std::vector<StreamPlan> plans, std::int64_t session, GroupOptions options = {});

  [[nodiscard]] std::vector<wire::Message> poll(Nanos now);
  void receive(const wire::Message& message, Nanos now);

  /// Stops all axes and ends.
  void stop(wire::StopMode mode);
  /// Fails: releases armed axes, stops moving ones.
  void fail(StreamError error, const std::string& reason);

  [[nodiscard]] bool ended() const;
  /// True if all have begun.
  [[nodiscard]] bool started() const { return phase_ >= Phase::playing; }
  /// The outcome of each axis, in the order of the plans.
  [[nodiscard]] std::vector<StreamOutcome> outcomes() const;
  [[nodiscard]] std::int64_t tick() const {
    return tick_;
  }  ///< common start tick; -1: not yet available

 private:
  enum class Phase { arming, starting, playing, leaving };
  struct Axis {
    std::string name;
    Sender sender;
    std::optional<wire::Status> status{};  // the newest status in its session
    std::optional<StreamOutcome> own{};    // outcome before the group ended it
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

/// Runs a Group over a link. `options.total` bounds the time until all have begun; `cancelled`
/// stops all.
std::vector<StreamOutcome> stream_group(Transport& link, std::vector<StreamPlan> plans,
                                        const GroupOptions& group,
                                        const StreamOptions& options = {},
                                        const Clock& clock = steady_now);

}  // namespace jounce
