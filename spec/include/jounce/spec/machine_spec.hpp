// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/base/document.hpp"
#include "jounce/spec/machine_master.hpp"

namespace jounce {

/// The leader of an axis: [follow] of a spec of kind "axis".
struct FollowWhom {
  std::string axis = {};    ///< another axis of the same machine
  bool actual = false;      ///< actual position of its drive instead of its setpoint
  std::string master = {};  ///< or a master of the machine
};

/// A spec of kind "machine": the axes that `jounce run` steps in one cycle.
///
///     jounce = 1
///     kind = "machine"
///     watchdog = "500 ms"               # of the communication; 0: none
///     [[axis]]
///     spec = "feeder.toml"
///     [[axis]]
///     spec = "knife.toml"
///     follow = { axis = "feeder" }      # or { master = "line" } with [master.line]
struct MachineSpec {
  struct Axis {
    std::string spec = {};                  ///< its file; relative to the machine's own
    std::optional<FollowWhom> follow = {};  ///< replaces the entry of its file
    std::string key = {};                   ///< "axis[1]", for messages
  };
  Document document;
  std::vector<Axis> axes;
  std::vector<MachineMasterSpec> masters = {};
  std::optional<double> watchdog = {};  ///< s; 0: never
};

/// Nothing if the file is a spec of another kind, or not a spec. Throws InputError, placed, like
/// read_spec(), for an unknown key, an axis without a spec, and an axis that occurs twice.
std::optional<MachineSpec> read_machine(const std::string& path);
std::optional<MachineSpec> parse_machine(std::string text, std::string name);

}  // namespace jounce
