// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jounce/executor/detail/masters.hpp"
#include "jounce/executor/detail/worker.hpp"
#include "jounce/executor/executor_options.hpp"
#include "jounce/stream/detail/claim.hpp"
#include "jounce/stream/detail/receiver_pump.hpp"

namespace jounce {

class MotionServer;

/// The communication thread of an executor. It passes requests from one link to the axes of a
/// machine, and returns their answers. Each axis, or group, has its own name, its own sessions and
/// its own server.
///
///     Dispatcher dispatcher(link, {feeder, knife}, exchange);
///     while (!quit) dispatcher.turn(2ms);
///     dispatcher.close();
class Dispatcher {
 public:
  /// `axes` is in the order of the machine. `link` and `exchange` must outlive the dispatcher.
  /// `clock` is the clock of the cycle's Pacer. `masters` are the masters of the machine. `claim`
  /// is the claim to the names of the axes, which the dispatcher maintains; without it, other
  /// executors of the same name are not detected. Throws InputError, and std::system_error if a log
  /// cannot be created.
  Dispatcher(Transport& link, const std::vector<ExecutorOptions>& axes, MachineExchange& exchange,
             Clock clock = steady_now, std::vector<MachineMaster> masters = {},
             std::optional<Claim> claim = {});
  ~Dispatcher();
  Dispatcher(const Dispatcher&) = delete;
  Dispatcher& operator=(const Dispatcher&) = delete;

  /// Executes one iteration: waits for messages for at most `timeout`, does all pending work, and
  /// sends a heartbeat to the cycle.
  void turn(Nanos timeout);

  /// Stops all axes, as a stop by an operator does, and rejects every later arm.
  void retire();

  /// Writes all remaining ticks into the logs, and closes the logs.
  void close();

  /// The masters of the machine.
  [[nodiscard]] const MasterServer& masters() const { return masters_; }
  /// Returns the server of an axis.
  [[nodiscard]] const MotionServer& server(std::size_t axis = 0) const { return *servers_[axis]; }
  /// Number of axes.
  [[nodiscard]] std::size_t size() const { return servers_.size(); }
  /// Returns the newest tick of an axis.
  [[nodiscard]] const Tick& last(std::size_t axis = 0) const;
  [[nodiscard]] bool moving() const;  ///< true if any axis moves
  [[nodiscard]] bool settled()
      const;                         ///< true if all axes are at rest and no command is in transit
  [[nodiscard]] bool owned() const;  ///< true if any axis has a session
  /// A name of this executor that another executor also owns; this executor must then end. "" if no
  /// name is lost.
  [[nodiscard]] std::string lost_name() const;

 private:
  [[nodiscard]] bool busy() const;
  void publish(std::size_t axis);
  void announce(const wire::Event& event, std::size_t axis);

  CycleStatus& cycle_;
  Nanos a_while_;  // longest wait while the answer of an axis is pending: a fraction of a cycle
  Clock clock_;
  std::optional<Claim> claim_;
  ReceiverPump pump_;
  MasterServer masters_;
  std::vector<std::unique_ptr<MotionServer>> servers_;
  Recorder* recorder_;
  std::vector<Nanos> published_;                            // time of each axis's last status
  std::vector<std::pair<std::size_t, wire::Event>> again_;  // events to send again, by axis
  Worker worker_;  // declared last: its work must end before other members are destroyed
};

/// Returns the axes in the form that Machine needs, each with the name of its receiver.
std::vector<MachineAxis> machine_of(const std::vector<ExecutorOptions>& axes);

}  // namespace jounce
