// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "jounce/profiles/limits/limits.hpp"
#include "jounce/spec/axis_drive.hpp"

namespace jounce {

/// Smoothing of a measured master, in its unit u and s; docs/executor/masters.md.
struct TrackingSpec {
  double velocity = 0;      ///< u/s: required
  double acceleration = 0;  ///< u/s^2: required
  int order = 3;
  double time_constant = 0.01;
  double settle = 0.01;
  double latency = 0;
  double longest_age = 0.1;
  double jump = 0;  ///< u; 0: velocity * longest_age
};

/// A master of a machine: [master.NAME] of a spec of kind "machine".
///
///     [master.line]
///     kind = "external"
///     unit = "mm"
///     velocity = 1500          # mm/s
///     acceleration = 20000     # mm/s^2
struct MachineMasterSpec {
  /// Samples from the bus under the name of the master: `jounce master`, or a line with the protocol.
  struct External {
    TrackingSpec tracking = {};
  };
  /// Read in every cycle: the actual position of an axis's drive, or of a passive drive in shared memory.
  struct Encoder {
    TrackingSpec tracking = {};
    std::string axis = {};                            ///< axis of the machine; empty: `drive`
    std::optional<AxisDriveSpec::Shared> drive = {};  ///< behind shared memory
    double resolution = 0;                            ///< u of a count; 0: none
    double noise = 0;                                 ///< u rms; 0: none
    std::uint64_t seed = 1;                           ///< seed of the noise
  };
  /// A virtual axis of this name, which plays a file when it is ordered to start.
  struct FromTable {
    std::string file = {};  ///< spec or table over time, beside the machine's spec
    Limits limits = {};     ///< of the axis: velocity, acceleration; jerk if it is given
  };

  std::string name;
  std::string unit;
  std::variant<External, Encoder, FromTable> what;
  std::string key = {};  ///< "master.line", for messages
};

}  // namespace jounce
