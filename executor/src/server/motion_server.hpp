// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "jounce/executor/detail/cycle.hpp"
#include "jounce/executor/detail/log.hpp"
#include "jounce/executor/detail/queues.hpp"
#include "jounce/executor/detail/worker.hpp"
#include "jounce/executor/executor_options.hpp"
#include "jounce/stream/detail/receiver.hpp"
#include "jounce/stream/message/message.hpp"

#include "executor/src/server/command_queue.hpp"
#include "executor/src/server/last_start.hpp"
#include "executor/src/server/made_movement.hpp"
#include "executor/src/server/movement_builder.hpp"

namespace jounce {

/// Text of a rejection that fits into its field of the answer. The compiler rejects a longer one.
struct FixedReason {
  // NOLINTNEXTLINE(google-explicit-constructor): a literal is such a text
  consteval FixedReason(const char* literal) : text(literal) {
    if (std::string_view(literal).size() >= wire::reason_bytes) throw "longer than reason_bytes";
  }
  const char* text;
};

/// The part of the communication thread that serves one axis, or one group. It passes the requests of
/// streamers to the axis and returns the answers, owns the movements of the axis, writes its tick log
/// and reports its status. If the log cannot be written, the log ends and the motion continues.
///
/// If a streamer arms a motion in a later session than the session of the fault, the fault is
/// reset. In the same session, the streamer must reset the fault by a command.
///
/// AxisServer and GroupServer add what only an axis, or only a group, can do.
class MotionServer {
 public:
  /// All references must outlive the server. `axis`: index of the axis in the machine. Throws
  /// InputError for invalid options, and std::system_error if the log cannot be created.
  MotionServer(ExecutorOptions options, Receiver& receiver, MachineExchange& exchange,
               std::size_t axis, Worker& worker);
  virtual ~MotionServer() = default;
  MotionServer(const MotionServer&) = delete;
  MotionServer& operator=(const MotionServer&) = delete;

  /// Executes one iteration: processes the requests from the receiver, the answers of the axis, and
  /// its ticks.
  void turn();

  /// Stops the axis, as a stop by an operator does, and rejects every later arm.
  void retire();

  /// Processes all remaining items, and closes the log.
  void close();

  /// The newest tick of the axis.
  [[nodiscard]] const Tick& last() const { return last_; }
  /// True if the axis moves, or will move later without a further command (in_motion()).
  [[nodiscard]] bool moving() const { return in_motion(last_); }
  /// True if the axis is at rest and no command is in transit.
  [[nodiscard]] bool settled() const { return !moving() && !busy(); }
  /// True if a command is in transit: its answer arrives after one of the next cycles.
  [[nodiscard]] bool busy() const { return !commands_.idle(); }
  /// True if a streamer owns the axis in a session.
  [[nodiscard]] bool owned() const { return receiver_.session() != 0; }
  /// True if the log ended before the end of the run, because it could not be written.
  [[nodiscard]] bool log_truncated() const { return log_truncated_; }
  /// Number of motions that the axis ended as an axis of a group, which reports them.
  [[nodiscard]] std::uint64_t ended_with_group() const { return ended_with_group_; }
  /// The options of the axis.
  [[nodiscard]] const ExecutorOptions& options() const { return options_; }
  /// The status message of the axis.
  [[nodiscard]] virtual wire::Status status() const;
  /// The place of a group on its path; nullopt for a single axis.
  [[nodiscard]] virtual std::optional<wire::GroupStatus> group_status() { return std::nullopt; }
  /// Returns the output changes since the last call.
  [[nodiscard]] std::vector<wire::Event> take_events() { return std::exchange(events_, {}); }

 protected:
  using Request = CommandQueue::Request;
  struct Kept {
    MadeMovement made;
    Sha256 hash{};
    double origin = 0;  // position of a group at the start of its program
    double shift = 0;   // path time of the program before at which this one begins, s
  };

  /// Executes a command of a client. pass_on() executes those that an axis and a group have in common.
  virtual void obey(const CommandRequested& requested, const Request& request) = 0;
  /// The reason why this axis, or group, cannot play what the streamer arms; nullopt: none.
  [[nodiscard]] virtual std::optional<Refusal> unfit(const ArmRequested& arm) const = 0;
  /// True: a group plays the commands of a program one by one.
  [[nodiscard]] virtual bool single_step() const { return false; }
  /// An armed movement is about to start.
  virtual void begins(const Kept& /*armed*/) {}
  /// A halt has arrived.
  virtual void halts() {}
  /// The session has ended: drops the commands that are not yet planned.
  virtual void cancel() {}
  /// Drops all commands that the group does not play.
  virtual void drop() {}
  /// A hold-to-run jog was released.
  virtual void release() {}
  /// Drops the commands that have not reached the axis.
  virtual void clear_commands();
  /// Receives an answer of the axis to a request. Returns true if the request needs no answer yet.
  virtual bool takes_answer(const CommandQueue::Reply& /*reply*/) { return false; }
  /// Receives a tick of the axis, after last().
  virtual void follow(const Tick& /*tick*/) {}
  /// Executes the steps of a group in each iteration.
  virtual void take_steps() {}

  /// Executes a command for the queues of rows, or one that the axis executes as it is. Returns false
  /// for any other command.
  [[nodiscard]] bool pass_on(const CommandRequested& requested, const Request& request);
  void arm(const Request& request, MadeMovement made, const Sha256& hash, std::int64_t group);
  void record(const MadeMovement& made);
  /// True if the movement that was armed last follows a live master.
  [[nodiscard]] bool armed_is_live() const;
  void answer(const Request& request, const std::optional<Refusal>& refused);
  void decline(const CommandRequested& requested, Cause cause, FixedReason reason);
  /// `reason`: a text with names, which ends with "..." if it is too long.
  void decline_with(const CommandRequested& requested, Cause cause, const std::string& reason);
  [[nodiscard]] bool reject_at_tick(const CommandRequested& requested);
  void refuse_crowd(std::int64_t session, std::int32_t command);
  void notify(const std::string& notice) const;

  ExecutorOptions options_;
  std::size_t axis_;
  Receiver& receiver_;
  CommandQueue commands_;
  std::map<std::uint64_t, Kept> movements_;  // by the movement's id
  std::uint64_t numbers_ = 0;                // numbers of movements
  std::vector<wire::Event> events_;
  std::int64_t event_count_ = 0;
  std::int64_t motion_session_ = 0;  // session of the last start
  std::int64_t held_session_ = 0;    // session of the last hold-to-run jog
  Tick last_;

 private:
  void handle(const TableReady& ready);
  void handle(const ArmRequested& arm);
  void handle(const StartRequested& start);
  void handle(const StopRequested& stop);
  void handle(const SessionEnded& ended);
  void handle(const CommandRequested& requested);
  void handle(const QueueArmRequested& arm);
  void handle(const QueueOpened& opened);
  void handle(const RowsArrived& arrived);
  template <class What>
  bool pass_on(const What& what, const CommandRequested& requested, const Request& request);
  bool pass_on(const command::QueueSwitch& what, const CommandRequested& requested,
               const Request& request);
  bool pass_on(const command::QueueClear& what, const CommandRequested& requested,
               const Request& request);
  bool pass_on(const command::QueueEnd& what, const CommandRequested& requested,
               const Request& request);
  void answer_queue(const Request& request, bool done);
  bool reject_if_full(std::int64_t session, std::int32_t command);
  [[nodiscard]] std::optional<Refusal> refusal_of(const ArmRequested& arm) const;
  void refuse_units(const ArmRequested& arm);
  [[nodiscard]] double next_rest() const;
  [[nodiscard]] ArmRequested on_axis(ArmRequested arm) const;
  void build(const ArmRequested& arm);
  void take_built();
  void arm(MovementBuilder::Built built);
  [[nodiscard]] Queues::Record recorded_rows() const;
  void take_answers();
  void take_ticks();
  void write(const Tick& tick);
  [[nodiscard]] std::uint8_t unwritten() const;

  AxisExchange& exchange_;
  CycleStatus& cycle_;
  std::optional<TickLog> log_;
  Queues queues_;
  MovementBuilder builder_;
  bool retired_ = false;
  bool log_truncated_ = false;
  std::uint64_t ended_with_group_ = 0;
  std::int64_t fault_session_ = 0;
  std::uint64_t armed_ = 0;  // id of the last armed movement
  LastStart start_;
};

}  // namespace jounce
