// SPDX-License-Identifier: Apache-2.0
#include "jounce/command/detail/command_table.hpp"

#include <algorithm>
#include <array>

namespace jounce {
namespace {

using Kind = CommandKind;
using ByState = std::array<Cause, states>;

constexpr Cause ok = Cause::none;
constexpr Cause off = Cause::not_enabled;
constexpr Cause err = Cause::in_error;
constexpr Cause mov = Cause::in_motion;
constexpr Cause syn = Cause::synchronized;
constexpr Cause uns = Cause::not_synchronized;
constexpr Cause stp = Cause::stopping;
constexpr Cause nil = Cause::no_movement;
constexpr Cause ncp = Cause::no_cut_plan;
constexpr Cause ena = Cause::enabled;

// clang-format off
//                          dis  sta  dsc  syn  stp  err  cnt  hom
constexpr ByState always   {ok,  ok,  ok,  ok,  ok,  ok,  ok,  ok};
constexpr ByState stops    {ok,  ok,  ok,  ok,  ok,  err, ok,  ok};
constexpr ByState halts    {off, ok,  ok,  ok,  stp, err, ok,  ok};
constexpr ByState begins   {off, ok,  ok,  ok,  stp, err, ok,  mov};
constexpr ByState from_rest{off, ok,  mov, mov, stp, err, mov, mov};
constexpr ByState homes    {off, ok,  mov, syn, stp, err, mov, mov};
constexpr ByState places   {ok,  ok,  mov, syn, mov, err, mov, mov};
constexpr ByState holds    {off, nil, ok,  ok,  stp, err, ok,  mov};
constexpr ByState finishes {off, nil, ok,  ok,  stp, err, nil, mov};
constexpr ByState changes  {off, nil, ok,  syn, stp, err, ok,  mov};
constexpr ByState uncouples{off, uns, uns, ok,  stp, err, uns, uns};
constexpr ByState cuts     {off, ncp, ncp, ok,  stp, err, ncp, ncp};
constexpr ByState while_off{ok,  ena, mov, syn, stp, ena, mov, mov};
// clang-format on

constexpr CommandSender own = CommandSender::owner;
constexpr CommandSender any = CommandSender::anyone;
constexpr bool moves = true;

/// A command of the executor.
constexpr CommandInfo inner(Kind kind, const char* name, const ByState& by_state) {
  return {.kind = kind, .name = name, .by_state = by_state};
}

/// A command of a client.
template <class C>
constexpr CommandInfo sent(const char* name, std::int8_t number, const char* word,
                           const char* plcopen, CommandSender sender, const ByState& by_state,
                           bool sets_in_motion = false) {
  return {.kind = C::kind,
          .name = name,
          .number = number,
          .word = word,
          .plcopen = plcopen,
          .sender = sender,
          .moves = sets_in_motion,
          .by_state = by_state,
          .fields = fields_of<C>()};
}

// clang-format off
constexpr std::array rows{
    inner(Kind::none, "none", always),
    sent<command::Enable>("enable", 0, "enable", "MC_Power", own, always),
    sent<command::Disable>("disable", 1, "disable", "MC_Power", own, always),
    inner(Kind::arm, "arm", begins),
    inner(Kind::disarm, "disarm", always),
    inner(Kind::start, "start", begins),
    inner(Kind::stop, "stop", stops),
    inner(Kind::abort, "abort", always),
    sent<command::Reset>("reset", 2, "reset", "MC_Reset", own, always),
    sent<command::SetPosition>("set_position", 3, "set-position", "MC_SetPosition", own, places),
    sent<command::Home>("home", 4, "home", "MC_Home", own, homes, moves),
    sent<command::Hold>("hold", 5, "hold", "", any, holds),
    sent<command::Resume>("resume", 6, "resume", "", any, holds, moves),
    sent<command::Override>("override", 7, "override", "MC_SetOverride", any, always),
    sent<command::Finish>("finish", 40, "finish", "", own, finishes),
    sent<command::MoveAbsolute>("move_absolute", 8, "move", "MC_MoveAbsolute", own, begins, moves),
    sent<command::MoveRelative>("move_relative", 9, "move", "MC_MoveRelative", own, begins, moves),
    sent<command::MoveAdditive>("move_additive", 10, "move", "MC_MoveAdditive", own, begins, moves),
    sent<command::MoveSuperimposed>("move_superimposed", 11, "move", "MC_MoveSuperimposed", own, begins, moves),
    sent<command::MoveVelocity>("move_velocity", 12, "jog", "MC_MoveVelocity", own, begins, moves),
    sent<command::Halt>("halt", 13, "halt", "MC_Halt", own, halts),
    sent<command::GearIn>("gear_in", 14, "gear-in", "MC_GearIn", own, begins, moves),
    sent<command::GearOut>("gear_out", 16, "gear-out", "MC_GearOut", own, uncouples),
    sent<command::CamOut>("cam_out", 17, "cam-out", "MC_CamOut", own, uncouples),
    inner(Kind::release, "release", stops),
    sent<command::GearInPos>("gear_in_pos", 15, "gear-in-pos", "MC_GearInPos", own, begins, moves),
    sent<command::QueueSwitch>("queue_switch", 18, "", "", own, always),
    sent<command::QueueClear>("queue_clear", 19, "", "", own, always),
    sent<command::QueueEnd>("queue_end", 20, "", "", own, always),
    sent<command::StartTable>("start_table", 21, "start", "", own, from_rest, moves),
    inner(Kind::extend, "extend", holds),
    sent<command::MoveLinearAbsolute>("move_linear_absolute", 22, "move-linear",
        "MC_MoveLinearAbsolute", own, begins, moves),
    sent<command::MoveLinearRelative>("move_linear_relative", 23, "move-linear",
        "MC_MoveLinearRelative", own, begins, moves),
    sent<command::MoveCircularAbsolute>("move_circular_absolute", 24, "move-circular",
        "MC_MoveCircularAbsolute", own, begins, moves),
    sent<command::MoveCircularRelative>("move_circular_relative", 25, "move-circular",
        "MC_MoveCircularRelative", own, begins, moves),
    sent<command::MoveDirectAbsolute>("move_direct_absolute", 26, "move-direct",
        "MC_MoveDirectAbsolute", own, begins, moves),
    sent<command::MoveDirectRelative>("move_direct_relative", 27, "move-direct",
        "MC_MoveDirectRelative", own, begins, moves),
    sent<command::GroupWait>("group_wait", 28, "wait", "", own, begins, moves),
    sent<command::GroupJog>("group_jog", 29, "jog", "", own, begins, moves),
    sent<command::PhasingAbsolute>("phasing_absolute", 41, "phasing", "MC_PhasingAbsolute", own, uncouples),
    sent<command::PhasingRelative>("phasing_relative", 42, "phasing", "MC_PhasingRelative", own, uncouples),
    sent<command::CombineAxes>("combine_axes", 43, "combine", "MC_CombineAxes", own, begins, moves),
    sent<command::ChangeVelocity>("change_velocity", 44, "change-velocity", "", own, changes),
    sent<command::MoveRepetitive>("move_repetitive", 45, "repeat", "", own, from_rest, moves),
    sent<command::Cut>("cut", 32, "cut", "", own, cuts),
    sent<command::Park>("park", 33, "park", "", own, cuts),
    sent<command::TouchProbe>("touch_probe", 30, "touch-probe", "MC_TouchProbe", own, always),
    sent<command::AbortTrigger>("abort_trigger", 31, "abort-trigger", "MC_AbortTrigger", own, always),
    sent<command::EnableCompensation>("enable_compensation", 46, "enable-compensation", "", own, while_off),
    sent<command::DisableCompensation>("disable_compensation", 47, "disable-compensation", "", own, while_off),
    sent<command::SetCoordinateTransform>("set_coordinate_transform", 60, "set-coordinate-transform",
        "MC_SetCoordinateTransform", own, begins),
    sent<command::GroupSetPosition>("group_set_position", 61, "set-position", "MC_GroupSetPosition", own, begins),
    sent<command::GroupSetLimits>("group_set_limits", 62, "set-limits", "", own, begins),
    sent<command::GroupMWord>("group_m_word", 64, "m-word", "", own, begins),
    sent<command::GroupSetOverride>("group_set_override", 63, "set-override", "MC_GroupSetOverride", any, always),
    sent<command::GroupAcknowledge>("group_acknowledge", 65, "acknowledge", "", any, always),
    sent<command::GroupSingleStep>("group_single_step", 66, "single-step", "", own, always),
};
// clang-format on

constexpr bool in_order() {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (static_cast<std::size_t>(rows[i].kind) != i) return false;
  return true;
}
static_assert(rows.size() == command_kinds && in_order());

constexpr std::size_t sent_count = std::variant_size_v<ClientCommand>;

constexpr std::array<const CommandInfo*, sent_count> sent_rows = [] {
  std::array<const CommandInfo*, sent_count> all{};
  std::size_t count = 0;
  for (const CommandInfo& row : rows)
    if (row.number >= 0) all.at(count++) = &row;
  std::sort(all.begin(), all.end(),
            [](const CommandInfo* a, const CommandInfo* b) { return a->number < b->number; });
  return all;
}();

constexpr std::array<const char*, states> state_names{
    "disabled", "standstill", "discrete_motion",   "synchronized_motion",
    "stopping", "error_stop", "continuous_motion", "homing"};

}  // namespace

std::span<const CommandInfo> all_commands() {
  return rows;
}

std::span<const CommandInfo* const> sent_commands() {
  return sent_rows;
}

const CommandInfo& info(CommandKind kind) {
  return rows[static_cast<std::size_t>(kind)];
}

const char* name(CommandKind kind) {
  return info(kind).name;
}

const char* name(State state) {
  return state_names[static_cast<std::size_t>(state)];
}

std::optional<State> state_of(std::string_view name) {
  const auto found = std::find(state_names.begin(), state_names.end(), name);
  if (found == state_names.end()) return std::nullopt;
  return static_cast<State>(found - state_names.begin());
}

std::optional<CommandKind> kind_of_number(int number) {
  const auto* const found = std::find_if(rows.begin(), rows.end(), [&](const CommandInfo& row) {
    return number >= 0 && row.number == number;
  });
  return found == rows.end() ? std::nullopt : std::optional(found->kind);
}

Cause permitted(State state, CommandKind kind) noexcept {
  return info(kind).by_state[static_cast<std::size_t>(state)];
}

bool is_operators(CommandKind kind) {
  return info(kind).sender == CommandSender::anyone;
}

}  // namespace jounce
