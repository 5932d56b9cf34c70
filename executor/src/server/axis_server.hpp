// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "executor/src/server/motion_server.hpp"

namespace jounce {

/// The server of one axis: gears, cams and cuts on its live master, and its own table.
class AxisServer final : public MotionServer {
 public:
  using MotionServer::MotionServer;
  [[nodiscard]] wire::Status status() const override;

 private:
  [[nodiscard]] std::optional<Refusal> unfit(const ArmRequested& arm) const override;
  void obey(const CommandRequested& requested, const Request& request) override;
  template <class What>
  void obey(const What& what, const CommandRequested& requested, const Request& request);
  void obey(const command::GearIn& gear, const CommandRequested& requested, const Request& request);
  void obey(const command::GearInPos& gear, const CommandRequested& requested,
            const Request& request);
  void obey(const command::CombineAxes& gear, const CommandRequested& requested,
            const Request& request);
  void obey(const command::StartTable& it, const CommandRequested& requested,
            const Request& request);
  void couple(const CommandRequested& requested, const Request& request);
  void couple(MadeMovement made, std::int64_t at, const Request& request);
  void start_cuts(const CommandRequested& requested, const Request& request);
  [[nodiscard]] wire::GearState gear() const;
};

}  // namespace jounce
