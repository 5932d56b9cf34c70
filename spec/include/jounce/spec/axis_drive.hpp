// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "jounce/validate/drive.hpp"
#include "jounce/validate/machine_sensors.hpp"

namespace jounce {

/// The drive of an axis: section [drive] of a spec of kind "axis".
///
///     [drive]
///     type = "simulated"        # or "null", "shared_memory"
///     spec = "drive.toml"       # the model; or its keys in [drive]
struct AxisDriveSpec {
  enum class Type : std::uint8_t {
    null,           ///< follows the setpoint exactly, one cycle later
    simulated,      ///< a simulation of `model`
    shared_memory,  ///< a CiA 402 drive in another process; see `shared`
  };
  /// A drive in shared memory; see jounce/drive/shared_drive.hpp and cia402_axis.hpp. u is the
  /// axis' unit.
  struct Shared {
    std::string name = {};          ///< name of the shared memory
    double increments_per_rev = 0;  ///< increments of the encoder in one turn; a whole number, > 0
    double position_per_rev = 0;    ///< u, > 0: travel in one turn
    bool reversed = false;          ///< true: the drive counts in the opposite direction
    /// u: greatest distance between setpoint and actual position at which the drive is enabled; 0:
    /// a hundredth of a turn.
    double window = 0;
    int touch_probes = 0;  ///< number of touch probe inputs, 0 to 2
    /// Number of cycles, >= 1, without new data after which the drive has a fault.
    int silent_cycles = 50;
  };

  Type type = Type::simulated;
  std::optional<Drive> model = {};                 ///< model of the drive; for simulated
  std::optional<Shared> shared = {};               ///< for shared_memory
  std::optional<MachineSensorsSpec> machine = {};  ///< [drive.machine], for null and simulated
};

struct Spec;

/// Returns [drive] of a spec of kind "axis", read from its document; nullopt if the spec has no
/// [drive]. Throws InputError, with the place in the document, like read_spec() (spec.hpp), because
/// the file of the model may have changed since the spec was read.
std::optional<AxisDriveSpec> axis_drive(const Spec& spec);

}  // namespace jounce
