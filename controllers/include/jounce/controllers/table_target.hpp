// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "jounce/base/hash.hpp"
#include "jounce/pvt/reduce.hpp"

/// Target of a table, in the terms of specs and of the command line.
///
///     Target target = target_of(*controller_table("googol_follow"), {"pulse", "pulse"});
///     target.tolerance = 0.5;
///     Sampled table = reduced(cam, target);
namespace jounce {

/// Capacity of a controller, from its manual.
struct ControllerTable {
  const char* name;
  Domain axis;
  Interpolation rule;
  std::size_t most;  ///< knots, including the first one of the table
  const char*
      step;  ///< the unit whose whole numbers the first column takes; "" if it takes any number
  bool quadratic = false;  ///< pieces of linear velocity (Target::quadratic)
};

/// googol_pt, googol_pt_1024, googol_follow, googol_follow_512 (NORMAL segments), hmpl_pvt, sew.
std::span<const ControllerTable> controller_tables();

/// The table of this name; null if there is none.
const ControllerTable* controller_table(const std::string& name);

/// Its target in these units. `x_step`, in units.x: the size of one unit of the controller, such as
/// 0.01 deg for a pulse. Throws InputError "controller" if the controller's unit does not convert
/// into units.x and there is no x_step; the rule asks for it by the name `key`.
Target target_of(const ControllerTable& controller, const Units& units,
                 std::optional<double> x_step = {}, const std::string& key = "x_step");

/// Name of a member of Target in a spec, by its name in reduce.hpp: over the master, velocities are
/// "geo_velocity..."; x_step is "time_resolution" or "master_resolution".
std::string spec_key(Domain axis, const std::string& member);

/// A Target in texts, with or without units; empty: not given.
struct TargetTexts {
  std::string controller = {};  ///< name of a ControllerTable
  std::string tolerance = {};
  std::string velocity_tolerance = {};
  std::optional<std::size_t> most = {};
  std::string spacing = {};
  std::string x_step = {};
  std::string p_step = {};
  std::string v_step = {};

  [[nodiscard]] bool any() const;
};

/// The name of a member in a message; the member's own by default.
using MemberName = std::function<std::string(const std::string& member)>;

/// The target of the texts in these units, within the limits of the controller. Throws InputError,
/// with the name of the member as key: not a positive quantity of this unit, an unknown controller,
/// or one that needs another axis or rule.
Target target_of(const TargetTexts& texts, Domain axis, Interpolation rule, const Units& units,
                 const MemberName& name_of = {});

}  // namespace jounce
