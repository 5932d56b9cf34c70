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
  std::shared_ptr<AxisDrive> drive = {};  ///< behind its setpoints; none: they are the end of it
  Units units{};               ///< units of the axis: a table in another one is refused; empty: any
  ReceiverOptions receiver{};  ///< includes the name of the axis
  bool enable = true;          ///< at the start; otherwise it waits for an order
  std::optional<StoredTable> table = {};  ///< over time, what the order `start` plays
  bool adopt_start =
      false;  ///< at standstill, the start of an armed table defines the position of the axis
  bool stop_when_silent = true;  ///< a motion whose owner falls silent is stopped
  /// Tables of more knots become jobs in a thread of their own: a stop does not wait for them.
  std::size_t build_apart = std::size_t{1} << 62U;
  Nanos status_period = std::chrono::milliseconds(50);
  std::optional<std::filesystem::path> log{};               ///< CSV of all ticks
  std::function<void(const std::string& notice)> notify{};  ///< events as text
  Recorder* recorder = nullptr;  ///< recorder of the whole machine; null: nothing is recorded
};

/// Connects one axis with the stream: takes its requests, returns its answers, keeps its jobs,
/// writes its log and reports its status. If the log fails, it ends, and the motion continues.
///
/// The arm of a later session resets a latched fault: the
/// owner at the time of the fault cannot simply continue.
class Desk {
 public:
  /// All but the options must outlive it. Throws InputError, std::system_error for the log.
  Desk(ExecutorOptions options, Receiver& receiver, Post& post, std::size_t axis, Worker& worker);

  /// One turn: what the receiver has for the axis, what the axis has answered, what it did.
  void turn();

  /// Stops the axis, as an operator would, and refuses to arm anything from now on.
  void retire();

  /// Takes what is left, and closes the log.
  void close();

  [[nodiscard]] const Tick& last() const { return last_; }
  [[nodiscard]] bool moving() const { return in_motion(last_); }
  /// At rest, and no command is on its way that could change that.
  [[nodiscard]] bool settled() const { return !moving() && !busy(); }
  /// A command is on its way, whose answer comes with one of the next cycles.
  [[nodiscard]] bool busy() const { return !outbox_.idle(); }
  [[nodiscard]] bool owned() const { return receiver_.session() != 0; }
  /// The log ended before the run did.
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
    bool void_ = false;  // cancelled by a stop, or by the end of the session
  };

  /// The last start of a stream, and what became of it.
  struct Start {
    std::int64_t session = 0;
    std::int32_t command = 0;
    std::uint64_t movement = 0;
    wire::StartOutcome outcome = wire::StartOutcome::none;
    Refusal why{};

    [[nodiscard]] bool is(const Request& request) const {
      return request.kind == Command::Kind::start && request.session == session &&
             request.command == command;
    }
  };

  void handle(const TableReady& ready);
  void handle(const ArmRequested& arm);
  void handle(const StartRequested& start);
  void handle(const StopRequested& stop);
  void handle(const SessionEnded& ended);
  void handle(const OrderRequested& requested);
  void handle(const QueueArmRequested& arm);
  void handle(const QueueOpened& opened);
  void handle(const RowsArrived& arrived);
  void handle_queue_order(const OrderRequested& requested);
  void start_own(const OrderRequested& requested);
  void decline(const OrderRequested& requested, const std::string& reason);
  bool crowded(std::int64_t session, std::int32_t command);
  void record_gear(const OrderRequested& requested, std::uint64_t id);
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
  std::map<std::uint64_t, Kept> movements_;  // by the movement's
  Queues queues_;
  std::vector<wire::Event> events_;
  std::int64_t event_count_ = 0;
  std::optional<Building> building_;      // one at a time
  std::optional<ArmRequested> next_arm_;  // came while another was built; the newest
  std::uint64_t numbers_ = 0;             // numbers of movements
  bool retired_ = false;
  bool log_truncated_ = false;
  std::int64_t fault_session_ = 0;
  std::uint64_t armed_ = 0;  // the movement that was handed over last
  Start start_;
  std::int64_t motion_session_ = 0;  // the one that asked for the last start
  std::int64_t held_session_ = 0;    // the one that ordered a hold-to-run jog
  Tick last_;
};

}  // namespace jounce
