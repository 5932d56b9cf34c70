// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jounce/executor/detail/cycle.hpp"
#include "jounce/executor/machine_master.hpp"
#include "jounce/stream/detail/master_intake.hpp"
#include "jounce/stream/detail/receiver_pump.hpp"

namespace jounce {

/// The part of the communication thread that serves the masters. It receives the samples of
/// external masters, and reports the state of each master in the cycle.
///
///     MasterServer masters({{{"line", "mm", line}}, {Follow{}}}, pump, exchange, clock);
///     pump.run(2ms);                   // passes new samples to the cycle
///     masters.turn();                  // reports masters that are lost or have returned
///     masters.publish(axis);           // with the status of this axis
class MasterServer {
 public:
  /// Options of the masters of a machine.
  struct Options {
    std::vector<MachineMaster> masters = {};  ///< the masters of the machine
    /// For each axis, the master that it follows; the status of the axis includes the status of
    /// this master.
    std::vector<Follow> follows = {};
    bool keyed = false;  ///< true: samples must be authenticated, see MasterIntake
    std::function<void(const std::string& notice)> notify{};  ///< receives notices as text
  };
  /// Subscribes to the channels of the masters. `pump` and `exchange` must outlive the server.
  /// `clock`: the clock of the cycle's Pacer.
  MasterServer(Options options, ReceiverPump& pump, MachineExchange& exchange, Clock clock);
  MasterServer(const MasterServer&) = delete;  // the pump keeps its address
  MasterServer& operator=(const MasterServer&) = delete;

  /// Reports masters that were lost or have returned.
  void turn();
  /// Publishes the state of the masters that this axis follows. With the first axis, also publishes
  /// the masters that no axis follows.
  void publish(std::size_t axis);

  /// Number of masters.
  [[nodiscard]] std::size_t size() const { return masters_.size(); }
  /// Returns the value of a master in the last cycle.
  [[nodiscard]] const MasterReading& last(std::size_t master) const {
    return masters_[master].last;
  }
  /// Returns the status message of a master.
  [[nodiscard]] wire::MasterStatus status(std::size_t master) const;

 private:
  struct One {
    MachineMaster master = {};
    std::optional<MasterIntake> intake = {};  // for an external master
    MasterReading last = {};
    bool was_there = false;
    bool told_unit = false;
    bool told_lag = false;                        // the present lag was reported
    std::optional<std::int32_t> epoch = {};       // newest epoch that was received
    std::optional<std::int32_t> told_epoch = {};  // newest epoch at the last notice
    std::vector<bool> said_by = {};               // axes that send the status of the master
  };

  void subscribe(One& one, ExternalMaster& master);
  void refused(One& one, const wire::Master& said);
  void compare(One& one, const MasterReading& now);
  void compare_lag(One& one, const MasterReading& now);

  Options options_;
  ReceiverPump& pump_;
  MachineExchange& exchange_;
  Clock clock_;
  std::deque<One> masters_;
};

}  // namespace jounce
