#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "jounce/executor/cycle.hpp"
#include "jounce/executor/job.hpp"
#include "jounce/executor/log.hpp"
#include "jounce/stream/driver.hpp"

namespace jounce {

/// What an executor is started with.
struct ExecutorOptions {
  AxisConfig axis;
  AxisSwitches switches = {};
  Units units{};                 ///< of the axis: a table in another one is refused; empty: any
  ReceiverOptions receiver{};    ///< with the executor's name
  bool adopt_start = false;      ///< a table that is armed at standstill says where the axis stands
  bool stop_when_silent = true;  ///< a motion whose owner falls silent is stopped
  Nanos status_period = std::chrono::milliseconds(50);
  std::optional<std::filesystem::path> log{};               ///< CSV of all ticks
  std::function<void(const std::string& notice)> notify{};  ///< what happens, in words
};

/// What the communication thread does: it takes requests from the stream to the axis and answers
/// back, keeps the jobs that the axis plays, writes the log, and publishes the status.
///
///     Dispatcher dispatcher(link, options, mail);
///     while (...) dispatcher.turn(2ms);
///     dispatcher.close();
///
/// Its first command enables the axis. A latched fault is reset by the arm of another session than
/// the one in which it came: whoever owned the axis then cannot go on as if nothing had happened.
class Dispatcher {
 public:
  /// `link` and `mail` must outlive it. Throws InputError, std::system_error for the log.
  Dispatcher(Transport& link, const ExecutorOptions& options, Mail& mail, Clock clock = steady_now);

  /// Does what there is to do, waiting for the link at most `timeout`.
  void turn(Nanos timeout);

  /// Stops the axis, as an operator would, and refuses to arm anything from now on.
  void retire();

  /// Writes what is left into the log, and closes it.
  void close();

  [[nodiscard]] const Tick& last() const { return last_; }
  [[nodiscard]] bool moving() const { return last_.job != 0 || last_.waiting; }
  /// At rest, and no command is on its way that could change that.
  [[nodiscard]] bool settled() const { return !moving() && outbox_.empty() && under_way_ == 0; }
  [[nodiscard]] bool owned() { return pump_.receiver().session() != 0; }

 private:
  struct Request {
    std::int64_t session = 0;
    std::int32_t command = 0;
    Command::Kind kind = Command::Kind::none;
  };
  struct Kept {
    std::unique_ptr<Job> job;
    Sha256 hash{};
  };

  void handle(const TableReady& ready);
  void handle(const ArmRequested& arm);
  void handle(const StartRequested& start);
  void handle(const StopRequested& stop);
  void handle(const SessionEnded& ended);
  [[nodiscard]] std::optional<Refusal> unfit(const ArmRequested& arm) const;
  [[nodiscard]] double next_rest() const;

  void order(Command command);
  void order(const Command& command, const Request& request);
  void clear_outbox();
  void flush();
  void take_answers();
  void answer(const Request& request, const std::optional<Refusal>& refused);
  void take_ticks();
  void compare(const Tick& tick);
  void publish();
  void notify(const std::string& notice) const;

  ExecutorOptions options_;
  Mail& mail_;
  Clock clock_;
  ReceiverPump pump_;
  std::optional<TickLog> log_;
  std::deque<Command> outbox_;
  std::map<std::uint64_t, Request> unanswered_;  // by the command's number
  std::map<std::uint64_t, Kept> jobs_;           // by the job's
  std::uint64_t numbers_ = 0;
  std::size_t under_way_ = 0;
  bool retired_ = false;
  std::int64_t fault_session_ = 0;
  std::int64_t motion_session_ = 0;  // the one that asked for the last start
  std::int64_t late_ = 0;
  Nanos published_{};
  Tick last_;
};

}  // namespace jounce
