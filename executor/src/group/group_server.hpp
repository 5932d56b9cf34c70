// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "executor/src/group/group_dynamics.hpp"
#include "executor/src/group/group_queue.hpp"
#include "executor/src/group/group_report.hpp"
#include "executor/src/group/passed_m_words.hpp"
#include "executor/src/server/motion_server.hpp"

namespace jounce {

/// The server of one group: its single commands, the programs that are sent as a whole, its override
/// and its further limits.
class GroupServer final : public MotionServer {
 public:
  /// See MotionServer. `position_of`: present position of another axis of the machine.
  GroupServer(ExecutorOptions options, Receiver& receiver, MachineExchange& exchange,
              std::size_t axis, Worker& worker,
              std::function<double(std::size_t axis)> position_of);

  [[nodiscard]] wire::Status status() const override;
  [[nodiscard]] std::optional<wire::GroupStatus> group_status() override;

 private:
  void obey(const CommandRequested& requested, const Request& request) override;
  [[nodiscard]] std::optional<Refusal> unfit(const ArmRequested& arm) const override;
  [[nodiscard]] bool single_step() const override { return queue_.single_step(); }
  void begins(const Kept& armed) override;
  void halts() override;
  void cancel() override { queue_.cancel(); }
  void drop() override { queue_.clear(); }
  void release() override { queue_.release(); }
  void clear_commands() override;
  bool takes_answer(const CommandQueue::Reply& reply) override;
  void follow(const Tick& tick) override;
  void take_steps() override;

  template <class What>
  void obey(const What& what, const CommandRequested& requested, const Request& request);
  void obey(const command::StartTable& it, const CommandRequested& requested,
            const Request& request);
  void obey(const command::GroupAcknowledge& what, const CommandRequested& requested,
            const Request& request);
  void obey(const command::GroupSingleStep& what, const CommandRequested& requested,
            const Request& request);
  void obey(const command::Resume& what, const CommandRequested& requested, const Request& request);
  void obey(const command::Override& what, const CommandRequested& requested,
            const Request& request);
  void obey(const command::GroupSetOverride& what, const CommandRequested& requested,
            const Request& request);
  void obey(const command::GroupSetLimits& what, const CommandRequested& requested,
            const Request& request);
  /// `own_limits`: the commands of the path contain their limits (GroupDynamics::begin()).
  void play(MadeMovement path, const Request& request, std::int64_t at, bool own_limits = false);
  void take_step(const group_step::Halt& halt);
  void take_step(const group_step::Play& step);
  void take_step(const group_step::Extend& step);
  void take_step(const group_step::SetLimits& step);
  void take_step(const group_step::Announce& step);
  void take_step(const group_step::Note& step);
  void take_step(const group_step::Reply& reply);
  /// `continues`: commands with queued limits may continue the present motion.
  void set_limits(const command::GroupSetLimits& what, const Request& request,
                  bool continues = false);
  void limit(bool from_rest);
  [[nodiscard]] double present_rate() const;
  [[nodiscard]] double rate_of(const Kept& kept, double position) const;
  void set_rate(double rate, const std::optional<Request>& request = {}, std::int64_t at = -1);
  void pass_m_words(const Tick& tick);

  GroupDynamics dynamics_;      // its override and further limits
  GroupQueue queue_;            // its single commands
  double rate_ = 1;             // override factor that it has
  std::uint64_t movement_ = 0;  // id of its last movement
  GroupReport report_;
  PassedMWords m_words_;                        // M words of the program that it plays
  std::shared_ptr<const GroupProgram> traced_;  // the last program whose path is in the trace
};

}  // namespace jounce
