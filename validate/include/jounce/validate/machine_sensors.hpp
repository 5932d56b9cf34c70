// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace jounce {

/// A switch of a simulated machine. It is on in the range of `width` that begins at `position`. u
/// is the unit of the axis.
struct MachineSwitch {
  double position = 0;  ///< start of the range, in the coordinate of the machine, u
  /// Length of the range, u, > 0; infinite: no end.
  double width = std::numeric_limits<double>::infinity();
  bool inverted = false;  ///< true: off in the range, and on everywhere else
  double bounce = 0;      ///< time for which the contact bounces after each edge, s
};

/// The index of a simulated encoder: a pulse at `offset`, and further pulses at every `period` in
/// both directions.
struct MachineIndex {
  double period = 0;  ///< distance between two pulses, u (unit of the axis), > 0
  double offset = 0;  ///< position of a pulse, in the coordinate of the machine, u
};

/// Marks on the material of a simulated machine, and the sensor that detects them. The sensor is
/// wired to a trigger input of the drive. Mark k = 0, 1, ... is on from
///
///     first + k distance + wander sin(2 pi k / wander_marks)
///
/// over the length `width`. Positions are in the unit of the axis (u) or, with `on_master`, in the
/// unit of its master.
struct MachineMarks {
  int input = 1;            ///< trigger input, 1 to 4
  bool on_master = false;   ///< false: positions of the motor, u; true: positions of the master
  double first = 0;         ///< position of mark 0
  double distance = 0;      ///< > 0
  double width = 0;         ///< > 0, less than distance / 2
  double wander = 0;        ///< amplitude of a periodic drift, less than distance / 4
  double wander_marks = 1;  ///< > 0: period of this drift, in marks
  std::optional<std::int64_t> count = {};  ///< number of marks; nullopt: no end
  std::vector<std::int64_t> missing = {};  ///< numbers of marks that are missing, ascending
  std::vector<double> extra = {};          ///< positions of further, false marks
};

/// The sensors of a simulated machine. nullopt: the machine does not have the sensor.
struct MachineSensorsSpec {
  /// Position of the machine when the encoder counts 0, u (unit of the axis).
  double encoder_offset = 0;
  std::optional<MachineSwitch> home = {};      ///< home switch
  std::optional<MachineSwitch> negative = {};  ///< negative limit switch
  std::optional<MachineSwitch> positive = {};  ///< positive limit switch
  std::optional<MachineIndex> index = {};      ///< index of the encoder
  std::vector<MachineMarks> marks = {};        ///< marks on the material
};

/// Returns a negative limit switch: on at positions below `position`, u. For `bounce`, see
/// MachineSwitch.
constexpr MachineSwitch negative_switch(double position, double bounce = 0) {
  return {.position = position, .inverted = true, .bounce = bounce};
}
/// Returns a positive limit switch: on at and above `position`, u. For `bounce`, see MachineSwitch.
constexpr MachineSwitch positive_switch(double position, double bounce = 0) {
  return {.position = position, .bounce = bounce};
}

}  // namespace jounce
