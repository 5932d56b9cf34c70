// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jounce/axis/master.hpp"
#include "jounce/executor/cycle.hpp"
#include "jounce/stream/receiver/master_intake.hpp"
#include "jounce/stream/sender/driver.hpp"

namespace jounce {

/// A master of a machine, as an option of its executor. Follow::index counts these.
struct MachineMaster {
  std::string name;  ///< an ExternalMaster receives the channel of this name
  std::string unit;  ///< unit of its position
  std::shared_ptr<Master> source;
};

/// The work of the communication thread for the masters: receives samples of external ones, and
/// reports the state of each in the cycle.
///
///     MasterServer masters({{"line", "mm", line}}, {0}, pump, exchange, clock);
///     pump.run(2ms);                   // passes new samples to the cycle
///     masters.turn();                  // reports masters lost or found
///     masters.publish(axis);           // with the status of this axis
class MasterServer {
 public:
  struct Options {
    std::vector<MachineMaster> masters = {};
    std::vector<Follow> follows = {};  ///< masters of the axes, whose statuses report them
    bool keyed = false;                ///< see MasterIntake
    std::function<void(const std::string& notice)> notify{};
  };
  /// Subscribes. `pump` and `exchange` must outlive it, and `clock` must be the one of the cycle's
  /// pacer.
  MasterServer(Options options, ReceiverPump& pump, MachineExchange& exchange, Clock clock);
  MasterServer(const MasterServer&) = delete;  // the pump keeps its address
  MasterServer& operator=(const MasterServer&) = delete;

  void turn();
  /// Publishes the masters that this axis follows; for the first axis also those without a
  /// follower.
  void publish(std::size_t axis);

  [[nodiscard]] std::size_t size() const { return masters_.size(); }
  /// Value in the last cycle.
  [[nodiscard]] const MasterSight& last(std::size_t master) const { return masters_[master].last; }
  [[nodiscard]] wire::MasterStatus status(std::size_t master) const;

 private:
  struct One {
    MachineMaster master;
    std::optional<MasterIntake> intake = {};  // intake of an external one
    MasterSight last = {};
    bool was_there = false;
    bool told_unit = false;
    std::optional<std::int32_t> epoch = {};       // the newest received
    std::optional<std::int32_t> told_epoch = {};  // the epoch of the last notice about an older one
    std::vector<bool> said_by = {};               // axes
  };

  void hear(One& one, ExternalMaster& master);
  void refused(One& one, const wire::Master& said);
  void compare(One& one, const MasterSight& now);

  Options options_;
  ReceiverPump& pump_;
  MachineExchange& exchange_;
  Clock clock_;
  std::deque<One> masters_;
};

}  // namespace jounce
