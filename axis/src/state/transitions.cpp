// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/transitions.hpp"

#include <array>

namespace jounce {
namespace {

constexpr Cause ok = Cause::none;
constexpr Cause off = Cause::not_enabled;
constexpr Cause err = Cause::in_error;
constexpr Cause mov = Cause::in_motion;
constexpr Cause syn = Cause::synchronized;
constexpr Cause uns = Cause::not_synchronized;
constexpr Cause stp = Cause::stopping;
constexpr Cause nil = Cause::no_movement;

struct Row {
  const char* name;
  std::array<Cause, states> by_state;
};

// clang-format off
constexpr std::array<Row, command_kinds> rows{{
    //                    dis  sta  dsc  syn  stp  err  cnt  hom
    {"none",              {ok,  ok,  ok,  ok,  ok,  ok,  ok,  ok}},
    {"enable",            {ok,  ok,  ok,  ok,  ok,  ok,  ok,  ok}},
    {"disable",           {ok,  ok,  ok,  ok,  ok,  ok,  ok,  ok}},
    {"arm",               {off, ok,  ok,  ok,  stp, err, ok,  mov}},
    {"disarm",            {ok,  ok,  ok,  ok,  ok,  ok,  ok,  ok}},
    {"start",             {off, ok,  ok,  ok,  stp, err, ok,  mov}},
    {"stop",              {ok,  ok,  ok,  ok,  ok,  err, ok,  ok}},
    {"abort",             {ok,  ok,  ok,  ok,  ok,  ok,  ok,  ok}},
    {"reset",             {ok,  ok,  ok,  ok,  ok,  ok,  ok,  ok}},
    {"set_position",      {ok,  ok,  mov, syn, mov, err, mov, mov}},
    {"home",              {off, ok,  mov, syn, stp, err, mov, mov}},
    {"hold",              {off, nil, ok,  ok,  stp, err, ok,  mov}},
    {"resume",            {off, nil, ok,  ok,  stp, err, ok,  mov}},
    {"override",          {ok,  ok,  ok,  ok,  ok,  ok,  ok,  ok}},
    {"finish",            {off, nil, ok,  ok,  stp, err, nil, mov}},
    {"move_absolute",     {off, ok,  ok,  ok,  stp, err, ok,  mov}},
    {"move_relative",     {off, ok,  ok,  ok,  stp, err, ok,  mov}},
    {"move_additive",     {off, ok,  ok,  ok,  stp, err, ok,  mov}},
    {"move_superimposed", {off, ok,  ok,  ok,  stp, err, ok,  mov}},
    {"move_velocity",     {off, ok,  ok,  ok,  stp, err, ok,  mov}},
    {"halt",              {off, ok,  ok,  ok,  stp, err, ok,  ok}},
    {"gear_in",           {off, ok,  ok,  ok,  stp, err, ok,  mov}},
    {"gear_out",          {off, uns, uns, ok,  stp, err, uns, uns}},
    {"cam_out",           {off, uns, uns, ok,  stp, err, uns, uns}},
    {"release",           {ok,  ok,  ok,  ok,  ok,  err, ok,  ok}},
}};
// clang-format on

constexpr std::array<const char*, states> state_names{
    "disabled", "standstill", "discrete_motion",   "synchronized_motion",
    "stopping", "error_stop", "continuous_motion", "homing"};

}  // namespace

const char* name(State state) {
  return state_names[static_cast<std::size_t>(state)];
}

const char* name(Command::Kind kind) {
  return rows[static_cast<std::size_t>(kind)].name;
}

Cause permitted(State state, Command::Kind kind) noexcept {
  return rows[static_cast<std::size_t>(kind)].by_state[static_cast<std::size_t>(state)];
}

}  // namespace jounce
