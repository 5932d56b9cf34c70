// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jounce/executor/desk.hpp"
#include "jounce/executor/masters.hpp"
#include "jounce/stream/message/claim.hpp"
#include "jounce/stream/sender/driver.hpp"

namespace jounce {

/// The work of the communication thread: it takes requests from one link to all axes of a machine and
/// answers back, each axis under its own name and in its own sessions, at a Desk each.
///
///     Dispatcher dispatcher(link, {feeder, knife}, post);
///     while (...) dispatcher.turn(2ms);
///     dispatcher.close();
class Dispatcher {
 public:
  /// `axes` as in the machine; `link` and `post` must outlive it. `claim`: of the axes' names, which
  /// is kept up from now on; none: other executors are not looked for. Throws InputError,
  /// std::system_error for a log.
  Dispatcher(Transport& link, const std::vector<ExecutorOptions>& axes, Post& post,
             Clock clock = steady_now, std::vector<MachineMaster> masters = {},
             std::optional<Claim> claim = {});

  /// Does what there is to do, waiting for the link at most `timeout`, and gives a sign of life.
  void turn(Nanos timeout);

  /// Stops all axes, as an operator would, and refuses to arm anything from now on.
  void retire();

  /// Writes what is left into the logs, and closes them.
  void close();

  [[nodiscard]] const MasterDesk& masters() const { return masters_; }
  [[nodiscard]] const Desk& desk(std::size_t axis = 0) const { return desks_[axis]; }
  [[nodiscard]] std::size_t size() const { return desks_.size(); }
  [[nodiscard]] const Tick& last(std::size_t axis = 0) const { return desks_[axis].last(); }
  [[nodiscard]] bool moving() const;   ///< any of them
  [[nodiscard]] bool settled() const;  ///< all of them: see Desk
  [[nodiscard]] bool owned() const;    ///< any of them
  /// A name that another executor has: this one must leave. Empty: none.
  [[nodiscard]] std::string lost_name() const;

 private:
  [[nodiscard]] bool busy() const;
  void publish(std::size_t axis);
  void announce(const wire::Event& event, std::size_t axis);

  Vitals& vitals_;
  Nanos a_while_;  // a part of a cycle: the longest wait while an axis's answer is due
  Clock clock_;
  std::optional<Claim> claim_;
  ReceiverPump pump_;
  MasterDesk masters_;
  std::deque<Desk> desks_;
  Recorder* recorder_;
  std::vector<Nanos> published_;                            // when each axis's status was
  std::vector<std::pair<std::size_t, wire::Event>> again_;  // to be sent again, by axis
  Worker worker_;  // last: what it builds is waited for before the rest goes
};

/// The same axes as a machine has them. Each is named as its receiver is.
std::vector<MachineAxis> machine_of(const std::vector<ExecutorOptions>& axes);

}  // namespace jounce
