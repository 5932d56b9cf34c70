// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jounce/axis/machine.hpp"
#include "jounce/drive/drive.hpp"
#include "jounce/executor/program_options.hpp"
#include "jounce/gear/cut_plan.hpp"
#include "jounce/path/axis_map.hpp"
#include "jounce/path/group_limits.hpp"
#include "jounce/stream/receiver/receiver_options.hpp"
#include "jounce/stream/receiver/stored_table.hpp"

namespace jounce {

class Recorder;
class Trace;

/// Kinematics of a group whose axes are the joints of a machine.
struct GroupKinematics {
  std::vector<std::string> names =
      {};                     ///< names of the axes of the tool: the coordinates of commands
  std::size_t path_axes = 0;  ///< number of path axes among them; the others are followers
  /// From the axes of the tool to the joints. Each limit of a joint is the lower of two limits:
  /// that of the kinematics, and that of the axis of the group.
  JointSpace joints = {};
  GroupLimits limits = {};  ///< limits of the axes of the tool, and of its path
  std::string unit = {};    ///< unit of the path axes; "": not known
  /// Units of the axes of the tool; empty: not known.
  std::vector<std::string> units = {};
};

/// A group of an executor (docs/executor/groups.md).
struct ExecutorGroup {
  AxisGroup of = {};                     ///< its axes in the machine
  std::vector<std::string> names = {};   ///< names of these axes
  std::vector<AxisConfig> configs = {};  ///< configurations of these axes
  std::size_t followers = 0;             ///< number of followers, which are the last axes; only
                                         ///< without kinematics
  std::string unit = {};                 ///< unit of the path axes; "": not known, or several units
  std::vector<std::string> units = {};   ///< unit of each of these axes; empty: not known
  std::shared_ptr<const SentProgram> sent = {};    ///< path that StartTable plays; null: none
  std::optional<GroupKinematics> kinematics = {};  ///< nullopt: commands address the axes
  MWordHandshake m_words = {};                     ///< M words of programs that wait
  PlanWindow window = {};                          ///< lengths of the windows in which a long
                                                   ///< program is planned
  bool along = false;  ///< true: position compare along the path (ExecutorOptions::compare)

  /// Names of the coordinates of commands: the axes of the tool, or of the group.
  [[nodiscard]] const std::vector<std::string>& coordinates() const {
    return kinematics ? kinematics->names : names;
  }
  /// Number of the coordinates in which the length of a path is measured; the others are followers.
  [[nodiscard]] std::size_t path_axes() const {
    return kinematics ? kinematics->path_axes : names.size() - followers;
  }
  /// Units of the coordinates of commands, one for each; "": not known.
  [[nodiscard]] std::vector<std::string> coordinate_units() const {
    if (kinematics && kinematics->units.size() == kinematics->names.size())
      return kinematics->units;
    if (!kinematics && units.size() == names.size()) return units;
    return std::vector<std::string>(coordinates().size(), kinematics ? kinematics->unit : unit);
  }
};

/// The cutter of an axis (docs/gear/cuts.md).
struct ExecutorCutter {
  std::shared_ptr<const CutTask> task = {};  ///< the cutter and its list
  StoredTable numbers = {};  ///< numbers_of() the task in the column p, for the record
};
/// Makes a cutter. `units`: units of the axis. Throws InputError like the constructor of CutTask.
ExecutorCutter executor_cutter(const CutJob& job, const Units& units);

/// Options of one axis, or of one group, of an executor.
struct ExecutorOptions {
  AxisConfig axis = {};                      ///< configuration
  AxisSwitches switches = {};                ///< cam switches
  AxisCompare compare = {};                  ///< position compare
  Follow follow = {};                        ///< live master of the axis
  Follow second = {};                        ///< its second live master, for command::CombineAxes
  std::vector<std::size_t> references = {};  ///< references of its compensation, see MachineAxis
  bool leads = false;  ///< true: another axis of the machine has this axis as its live master
  std::shared_ptr<AxisDrive> drive = {};  ///< drive that receives the setpoints; null: no drive
  Units units{};  ///< units of the axis; tables in other units are rejected; empty: not checked
  ReceiverOptions receiver{};  ///< options of its receiver, with the name of the axis
  bool enable = true;          ///< true: the axis is enabled at the start; false: a command must
                               ///< enable it
  std::optional<StoredTable> table = {};  ///< table over time that the command StartTable plays;
                                          ///< nullopt: none
  /// Cutter whose plan the command StartTable starts; nullopt: none.
  std::optional<ExecutorCutter> cutter = {};
  /// for a group: its axes; nullopt: the options are for a single axis
  std::optional<ExecutorGroup> group = {};
  /// True: at standstill, arming a table sets the position of the axis to the start of the table.
  bool adopt_start = false;
  bool stop_when_silent = true;  ///< true: stop a motion if its session times out
  /// Tables with more knots than this are prepared in a separate thread, so that a stop need not
  /// wait for the preparation. Default: no table is prepared in a separate thread.
  std::size_t build_apart = std::size_t{1} << 62U;
  Nanos status_period = std::chrono::milliseconds(50);  ///< time between two status messages
  std::optional<std::filesystem::path> log{};           ///< tick log, a CSV file; nullopt: none
  bool logs_probes = false;  ///< true: the log has a column for the captures of the touch probes
  bool logs_profile =
      false;  ///< true: the log has a column for the events of cams and follow tables
  std::function<void(const std::string& notice)> notify{};  ///< receives notices as text
  Recorder* recorder = nullptr;  ///< recorder of the whole machine; null: no record
  /// Names of the groups that move this axis. These groups report the motions of their axes.
  std::vector<std::string> groups = {};
  Trace* trace = nullptr;  ///< receives the ticks and tables of the axis; null: no trace
};

}  // namespace jounce
