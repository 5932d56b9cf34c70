// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "jounce/validate/drive.hpp"
#include "jounce/validate/machine_sensors.hpp"

namespace jounce {

/// The drive of an axis: [drive] of a spec of kind "axis".
///
///     [drive]
///     type = "simulated"        # or "null", "shared_memory"
///     spec = "drive.toml"       # or the model itself, as in any other spec
struct AxisDriveSpec {
  enum class Type : std::uint8_t {
    null,           ///< follows exactly, a cycle later
    simulated,      ///< `model`
    shared_memory,  ///< `shared`: a CiA 402 drive in another process
  };
  /// In shared memory of this name; see jounce/drive/shared_drive.hpp.
  struct Shared {
    std::string name = {};
    double increments_per_rev = 0;  ///< whole, > 0
    double position_per_rev = 0;    ///< u/rev, > 0
    bool reversed = false;
    double window = 0;       ///< u; 0: a hundredth of a turn
    int silent_cycles = 50;  ///< >= 1
  };

  Type type = Type::simulated;
  std::optional<Drive> model = {};
  std::optional<Shared> shared = {};
  std::optional<MachineSensorsSpec> machine = {};  ///< [drive.machine], of null and simulated
};

struct Spec;

/// [drive] of a spec of kind "axis", read from its document; nothing: it has none. Throws InputError,
/// placed, as read_spec(), which has read it before: a model's file may have changed since.
std::optional<AxisDriveSpec> axis_drive(const Spec& spec);

}  // namespace jounce
