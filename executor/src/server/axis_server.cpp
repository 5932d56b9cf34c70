// SPDX-License-Identifier: Apache-2.0
#include "executor/src/server/axis_server.hpp"

#include <utility>
#include <variant>

#include "jounce/executor/detail/recorder.hpp"
#include "jounce/profiles/error.hpp"

#include "executor/src/server/executed_command.hpp"

namespace jounce {
namespace {

constexpr std::int64_t no_group = 0;  // an axis that starts alone

}  // namespace

std::optional<Refusal> AxisServer::unfit(const ArmRequested& arm) const {
  if (arm.mode == wire::ArmMode::path) return Refusal{.cause = Cause::not_a_group};
  const bool live = arm.mode == wire::ArmMode::follow_input;
  if (live && options_.follow.what == Follow::What::nothing)
    return Refusal{.cause = Cause::no_master_input};
  return std::nullopt;
}

void AxisServer::obey(const CommandRequested& requested, const Request& request) {
  std::visit([&](const auto& what) { obey(what, requested, request); }, requested.what);
}

/// Commands of groups are rejected.
template <class What>
void AxisServer::obey(const What& /*what*/, const CommandRequested& requested,
                      const Request& request) {
  if (!pass_on(requested, request)) answer(request, Refusal{.cause = Cause::not_a_group});
}

void AxisServer::obey(const command::GearIn& /*gear*/, const CommandRequested& requested,
                      const Request& request) {
  couple(requested, request);
}

void AxisServer::obey(const command::GearInPos& /*gear*/, const CommandRequested& requested,
                      const Request& request) {
  couple(requested, request);
}

void AxisServer::obey(const command::CombineAxes& /*gear*/, const CommandRequested& requested,
                      const Request& request) {
  if (options_.follow.what != Follow::What::nothing &&
      options_.second.what == Follow::What::nothing)
    return decline(
        requested, Cause::no_master_input,
        "the axis follows one master only: add second = { axis = \"NAME\" } to its follow, in "
        "[[axis]] of the machine spec or in its own spec");
  couple(requested, request);
}

void AxisServer::couple(const CommandRequested& requested, const Request& request) {
  motion_session_ = requested.session;
  if (options_.follow.what == Follow::What::nothing)
    return answer(request, Refusal{.cause = Cause::no_master_input});
  try {
    const std::uint64_t id = ++numbers_;
    MadeMovement gear{.movement = gear_of(requested.what, id, options_.axis, last_.position)};
    if (options_.recorder != nullptr)
      options_.recorder->note(RecordedGear{axis_, id, requested.what, last_.position});
    couple(std::move(gear), requested.at, request);
  } catch (const InputError& error) {
    receiver_.refuse(requested.session, requested.command, error.what(),
                     static_cast<std::int32_t>(Cause::no_value));
  }
}

void AxisServer::couple(MadeMovement made, std::int64_t at, const Request& request) {
  record(made);
  commands_.send({command::Couple{made.movement.get(), at}}, request);
  const std::uint64_t id = made.movement->id();
  movements_[id] = {std::move(made), {}};
}

/// Starts the plan of cuts of the axis's own cutter.
void AxisServer::start_cuts(const CommandRequested& requested, const Request& request) {
  motion_session_ = requested.session;
  if (options_.follow.what == Follow::What::nothing)
    return answer(request, Refusal{.cause = Cause::no_master_input});
  if (moving()) return answer(request, Refusal{.cause = Cause::in_motion});
  couple(movement_of(*options_.cutter, ++numbers_, options_.axis), requested.at, request);
}

/// Arms and starts the axis's own table. It is accepted when it is armed: nothing can prevent the
/// start then.
void AxisServer::obey(const command::StartTable& /*it*/, const CommandRequested& requested,
                      const Request& request) {
  if (options_.cutter) return start_cuts(requested, request);
  if (!options_.table)
    return decline(
        requested, Cause::nothing_to_start,
        "the spec of the axis has no table and no cutter to start: send a table with `jounce "
        "stream`, or add cutter = \"FILE\" (kind knife or shear) to [axis]");
  const Request armed{requested.session, requested.command, CommandKind::arm};
  if (moving()) return answer(armed, Refusal{.cause = Cause::in_motion});
  const ArmRequested own{.session = requested.session,
                         .command = requested.command,
                         .mode = wire::ArmMode::play,
                         .slave = *options_.table,
                         .master = {}};
  motion_session_ = requested.session;
  commands_.send({command::Disarm{}});  // if the arm fails, the start then starts nothing else
  arm(armed, movement_of(own, ++numbers_, options_.axis.period, last_.position),
      options_.table->hash, no_group);
  commands_.send({command::Start{.tick = requested.at}});
}

wire::Status AxisServer::status() const {
  wire::Status status = MotionServer::status();
  status.gear = gear();
  const bool has_master = options_.follow.what != Follow::What::nothing;
  if (has_master && last_.job == 0) status.master_position = last_.live_master[0];
  return status;
}

/// State of the pair of the axis and its live master.
wire::GearState AxisServer::gear() const {
  if (options_.follow.what == Follow::What::nothing) return wire::GearState::none;
  const bool follows = last_.state == State::synchronized_motion && last_.job != 0;
  if (!follows) return wire::GearState::disengaged;
  if (last_.ratio == 0) return wire::GearState::in_cam;
  return last_.progress == Progress::running ? wire::GearState::in_gear : wire::GearState::engaging;
}

}  // namespace jounce
