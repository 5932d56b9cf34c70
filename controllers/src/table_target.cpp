// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/table_target.hpp"

#include <array>

#include "jounce/base/units.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

// Capacity of each target. Googol: a FIFO holds 32 or 1024 PT segments, or 16 or 512 follow
// segments (GTS manual 7.4, 7.6). Times and master positions are `long`, all other numbers
// `double`. In a NORMAL segment the velocity is linear and the position quadratic. A table has one
// knot more than segments: the origin.
//
// HMPL: 50 points of time, position and velocity (MovePVT, 5.2.8).
//
// SEW: 1024 points in a curve point table (MOVI-C).
constexpr std::array known{
    ControllerTable{"googol_pt", Domain::time, Interpolation::cubic_hermite, 33, "ms", true},
    ControllerTable{"googol_pt_1024", Domain::time, Interpolation::cubic_hermite, 1025, "ms", true},
    ControllerTable{"googol_follow", Domain::master, Interpolation::cubic_hermite, 17, "pulse",
                    true},
    ControllerTable{"googol_follow_512", Domain::master, Interpolation::cubic_hermite, 513, "pulse",
                    true},
    ControllerTable{"hmpl_pvt", Domain::time, Interpolation::cubic_hermite, 50, ""},
    ControllerTable{"sew", Domain::master, Interpolation::linear, 1024, ""},
};

}  // namespace

std::vector<std::string> controller_names() {
  std::vector<std::string> names;
  for (const ControllerTable& each : controller_tables()) names.emplace_back(each.name);
  return names;
}

std::span<const ControllerTable> controller_tables() {
  return known;
}

const ControllerTable* controller_table(const std::string& name) {
  for (const ControllerTable& each : known)
    if (each.name == name) return &each;
  return nullptr;
}

Target target_of(const ControllerTable& controller, const Units& units,
                 std::optional<double> x_step, const std::string& key) {
  Target target{.rule = controller.rule,
                .quadratic = controller.quadratic,
                .most = controller.most,
                .x_step = x_step.value_or(0)};
  if (*controller.step == '\0' || x_step) return target;
  try {
    target.x_step = conversion(controller.step, units.x);
  } catch (const InputError&) {
    throw InputError("controller", std::string("\"") + controller.name + '"',
                     std::string("counts in whole ") + controller.step + ", not in " + units.x +
                         ": give the size of one count with " + key + ", such as \"0.01 " +
                         units.x + '"');
  }
  return target;
}

std::string spec_key(Domain axis, const std::string& member) {
  const bool over_time = axis == Domain::time;
  if (member == "x_step") return over_time ? "time_resolution" : "master_resolution";
  if (member == "p_step") return "position_resolution";
  const std::string velocity = over_time ? "velocity" : "geo_velocity";
  if (member == "v_step") return velocity + "_resolution";
  if (member == "velocity_tolerance") return velocity + "_tolerance";
  return member;
}

}  // namespace jounce
