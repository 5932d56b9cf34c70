// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jounce/base/hash.hpp"
#include "jounce/pvt/reduce.hpp"

/// The tables of controllers, with their capacity, as targets for reduced().
///
///     Target target = target_of(*controller_table("googol_follow"), {"pulse", "pulse"});
///     target.tolerance = 0.5;
///     Sampled table = reduced(cam, target);
namespace jounce {

/// Capacity of a controller for tables, from its manual.
struct ControllerTable {
  const char* name;    ///< name in specs and on the command line: "googol_pt"
  Domain axis;         ///< variable of the table: time or master position
  Interpolation rule;  ///< interpolation between the knots
  std::size_t most;    ///< greatest number of knots, including the first one
  const char* step;  ///< unit that the first column counts in whole numbers: "ms"; "": any numbers
  bool quadratic = false;  ///< true if the velocity is linear between knots (Target::quadratic)
};

/// Returns all controller tables: googol_pt, googol_pt_1024, googol_follow, googol_follow_512,
/// hmpl_pvt, and sew (the curve point table of the MOVI-C controllers of SEW). The four tables of
/// Googol have segments of the type NORMAL (GTS manual 7.4): linear velocity, quadratic position.
std::span<const ControllerTable> controller_tables();
/// Returns their names.
std::vector<std::string> controller_names();

/// Returns the controller table with this name; null if no table has the name.
const ControllerTable* controller_table(const std::string& name);

/// Returns the target for reduced() in these units. `x_step`: size of one unit of the controller in
/// units.x, such as 0.01 deg for a pulse. Throws InputError "controller" if x_step is missing and
/// the controller's unit does not convert into units.x; the message refers to x_step by `key`, the
/// name that the user sees.
Target target_of(const ControllerTable& controller, const Units& units,
                 std::optional<double> x_step = {}, const std::string& key = "x_step");

/// Returns the key in a spec for a member of Target. For a cam, the velocities have keys
/// "geo_velocity..."; x_step has the key "time_resolution" or "master_resolution".
std::string spec_key(Domain axis, const std::string& member);

/// A Target as the user writes it. Each text except `controller` is a quantity with or without its
/// unit. An empty text means that the quantity is not given.
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

/// Returns the name of a member for messages; by default, the name in TargetTexts.
using MemberName = std::function<std::string(const std::string& member)>;

/// Returns the target of the texts in these units, with the capacity and the counts of
/// texts.controller. `most` and x_step, if given, replace the values of the controller. Throws
/// InputError, with the name of the member as key, for a text that is not a positive quantity in
/// the unit of the member, for a controller that is not in controller_tables(), and for a
/// controller whose table needs another variable (time or master position) or another
/// interpolation.
Target target_of(const TargetTexts& texts, Domain axis, Interpolation rule, const Units& units,
                 const MemberName& name_of = {});

}  // namespace jounce
