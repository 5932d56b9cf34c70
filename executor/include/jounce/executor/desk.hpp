// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jounce/executor/cycle.hpp"
#include "jounce/executor/log.hpp"
#include "jounce/executor/made_movement.hpp"
#include "jounce/executor/outbox.hpp"
#include "jounce/executor/queues.hpp"
#include "jounce/executor/worker.hpp"
#include "jounce/stream/receiver/receiver.hpp"

namespace jounce {

class Recorder;

/// Options of one axis of an executor.
struct ExecutorOptions {
  AxisConfig axis;
  AxisSwitches switches = {};
  AxisCompare compare = {};
  Follow follow = {};                     ///< its live master
  std::shared_ptr<AxisDrive> drive = {};  ///< receives the setpoints; null: no drive
  Units units{};               ///< units of the axis: a table in others is rejected; empty: any
  ReceiverOptions receiver{};  ///< includes the name of the axis
  bool enable = true;          ///< at the start; otherwise a command enables it
  std::optional<StoredTable> table = {};  ///< over time; played by the command `start`
  bool adopt_start =
      false;  ///< at standstill, the start of an armed table defines the position of the axis
  bool stop_when_silent = true;  ///< stops a motion whose session times out
  /// Tables of more knots become jobs in a separate thread: a stop does not wait for them.
  std::size_t build_apart = std::size_t{1} << 62U;
  Nanos status_period = std::chrono::milliseconds(50);
  std::optional<std::filesystem::path> log{};               ///< CSV of all ticks
  std::function<void(const std::string& notice)> notify{};  ///< events as text
  Recorder* recorder = nullptr;  ///< recorder of the whole machine; null: no record
};

/// Connects one axis with the stream: takes its requests, returns its answers, keeps its jobs,
/// writes its log and reports its status. If the log fails, the log ends, and the motion continues.
///
/// The arm of a later session resets a latched fault: the owner at the time of the fault cannot
/// simply continue.
class Desk {
 public:
  /// All references must outlive it. Throws InputError, and std::system_error for the log.
  Desk(ExecutorOptions options, Receiver& receiver, Post& post, std::size_t axis, Worker& worker);

  /// One iteration: handles requests from the receiver, answers of the axis, and its ticks.
  void turn();

  /// Stops the axis, like an operator's stop, and rejects every later arm.
  void retire();

  /// Handles all remaining items, and closes the log.
  void close();

  [[nodiscard]] const Tick& last() const { return last_; }
  [[nodiscard]] bool moving() const { return in_motion(last_); }
  /// True if it is at rest, and no command in transit could change that.
  [[nodiscard]] bool settled() const { return !moving() && !busy(); }
  /// True if a command is in transit: its answer comes with one of the next cycles.
  [[nodiscard]] bool busy() const { return !outbox_.idle(); }
  [[nodiscard]] bool owned() const { return receiver_.session() != 0; }
  /// True if the log ended before the run.
  [[nodiscard]] bool log_truncated() const { return log_truncated_; }
  [[nodiscard]] const ExecutorOptions& options() const { return options_; }
  [[nodiscard]] wire::Status status() const;
  /// Changes of the outputs since the last call.
  [[nodiscard]] std::vector<wire::Event> take_events() { return std::exchange(events_, {}); }

 private:
  using Request = Outbox::Request;
  struct Kept {
    MadeMovement made;
    Sha256 hash{};
  };
  struct Building {
    ArmRequested arm;
    std::future<MadeMovement> made;
    bool void_ = false;  // canceled by a stop, or by the end of the session
  };

  /// The last start of a stream, and its outcome.
  struct Start {
    std::int64_t session = 0;
    std::int32_t command = 0;
    std::uint64_t movement = 0;
    wire::StartOutcome outcome = wire::StartOutcome::none;
    Refusal why{};

    [[nodiscard]] bool is(const Request& request) const {
      return request.kind == CommandKind::start && request.session == session &&
             request.command == command;
    }
  };

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
  void obey(const What& what, const CommandRequested& requested, const Request& request);
  void obey(const command::GearIn& gear, const CommandRequested& requested, const Request& request);
  void obey(const command::GearInPos& gear, const CommandRequested& requested,
            const Request& request);
  void obey(const command::QueueSwitch& what, const CommandRequested& requested,
            const Request& request);
  void obey(const command::QueueClear& what, const CommandRequested& requested,
            const Request& request);
  void obey(const command::QueueEnd& what, const CommandRequested& requested,
            const Request& request);
  void obey(const command::StartTable& it, const CommandRequested& requested,
            const Request& request);
  void couple(const CommandRequested& requested, const Request& request);
  [[nodiscard]] bool untimed(const CommandRequested& requested);
  void answer_queue(const Request& request, bool done);
  void decline(const CommandRequested& requested, const std::string& reason);
  bool crowded(std::int64_t session, std::int32_t command);
  [[nodiscard]] std::optional<Refusal> unfit(const ArmRequested& arm) const;
  [[nodiscard]] double next_rest() const;
  [[nodiscard]] ArmRequested on_axis(ArmRequested arm) const;
  void follow_start(const Tick& tick);
  void build(const ArmRequested& arm);
  void take_built();
  void arm(const Request& request, MadeMovement made, const Sha256& hash, std::int64_t group);
  void record(const MadeFrom& source);
  [[nodiscard]] Queues::Record recorded_rows() const;
  void drop_builds();

  void clear_outbox();
  void take_answers();
  void answer(const Request& request, const std::optional<Refusal>& refused);
  void take_ticks();
  void write(const Tick& tick);
  void compare(const Tick& tick);
  [[nodiscard]] std::uint8_t unwritten() const;
  void notify(const std::string& notice) const;

  ExecutorOptions options_;
  std::size_t axis_;
  Receiver& receiver_;
  Mail& mail_;
  Vitals& vitals_;
  Worker& worker_;
  std::optional<TickLog> log_;
  Outbox outbox_;
  std::map<std::uint64_t, Kept> movements_;  // by the movement's id
  Queues queues_;
  std::vector<wire::Event> events_;
  std::int64_t event_count_ = 0;
  std::optional<Building> building_;      // one at a time
  std::optional<ArmRequested> next_arm_;  // arrived during the build of another; the newest
  std::uint64_t numbers_ = 0;             // numbers of movements
  bool retired_ = false;
  bool log_truncated_ = false;
  std::int64_t fault_session_ = 0;
  std::uint64_t armed_ = 0;  // id of the last armed movement
  Start start_;
  std::int64_t motion_session_ = 0;  // session of the last start
  std::int64_t held_session_ = 0;    // session of the last hold-to-run jog
  Tick last_;
};

}  // namespace jounce
