// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "jounce/base/document.hpp"
#include "jounce/spec/machine_master.hpp"

namespace jounce {

/// The leader that an axis follows: [follow] of a spec of kind "axis".
struct FollowWhom {
  std::string axis = {};    ///< another axis of the same machine
  bool actual = false;      ///< true: the actual position of its drive; false: its setpoint
  std::string master = {};  ///< a master of the machine, instead of `axis`
  /// The second leader, for `jounce order NAME combine`: the key `second`, with the same keys. At
  /// most one.
  std::vector<FollowWhom> second = {};
};

/// A spec of kind "machine": the axes that `jounce run` computes in one cycle.
///
///     jounce = 1
///     kind = "machine"
///     watchdog = "500 ms"               # greatest time without communication; 0: not supervised
///     [[axis]]
///     spec = "feeder.toml"
///     [[axis]]
///     spec = "knife.toml"
///     follow = { axis = "feeder" }      # or { master = "line" } with [master.line]
///     [[group]]                         # axes that move together on a path
///     name = "plotter"
///     axes = ["x", "y"]
///     program = "part.toml"             # a spec of kind "path"
///     m_words = [0, 6]                  # wait for an acknowledgment
struct MachineSpec {
  struct Axis {
    std::string spec = {};                  ///< file of the axis; relative to the machine's file
    std::optional<FollowWhom> follow = {};  ///< replaces [follow] in the file of the axis
    std::string key = {};                   ///< full key for messages: "axis[1]"
  };
  /// Axes that move together along a path: [[group]].
  struct Group {
    std::string name = {};               ///< name for commands
    std::vector<std::string> axes = {};  ///< names of its axes
    /// Names of its followers, which add nothing to the length of a path.
    std::vector<std::string> followers = {};
    /// Spec of the path that `jounce order NAME start` plays; relative to the machine's file; "":
    /// none.
    std::string program = {};
    /// Spec of kind "path" whose [kinematics] moves the axes as joints; "": none.
    std::string kinematics = {};
    /// Greatest distance of an axis from its place at a start, in the unit of the axes.
    std::optional<std::string> tolerance = {};
    /// M words of a program that wait for their acknowledgment; nullopt: all.
    std::optional<std::vector<std::int32_t>> m_words = std::vector<std::int32_t>{0};
    double m_word_timeout = 0;  ///< greatest time of this wait, s; 0: no limit
    std::string key = {};       ///< full key for messages: "group[1]"
  };
  Document document = {};
  std::vector<Axis> axes = {};
  std::vector<Group> groups = {};
  std::vector<MachineMasterSpec> masters = {};
  /// s, 0.01 to 3600; 0: not supervised; nullopt: as set for `jounce run`.
  std::optional<double> watchdog = {};
};

/// Reads a machine. Returns nullopt if the file is a spec of another kind, or not a spec. Throws
/// InputError, with the place, like read_spec() (spec.hpp), and for an unknown key, an axis without
/// a spec, and an axis that occurs twice.
std::optional<MachineSpec> read_machine(const std::string& path);
/// Reads a machine spec from text; messages use `name` as the file name.
std::optional<MachineSpec> parse_machine(std::string text, std::string name);

}  // namespace jounce
