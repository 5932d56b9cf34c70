// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "jounce/profiles/limits/limits.hpp"
#include "jounce/spec/axis_drive.hpp"

namespace jounce {

/// Filter of a measured master, in its unit u and in s. See TrackerSpec in jounce/axis/tracker.hpp
/// and docs/executor/masters.md.
struct TrackingSpec {
  double velocity = 0;      ///< u/s, required: greatest velocity of the master
  double acceleration = 0;  ///< u/s^2, required: greatest acceleration of the master
  int order = 3;            ///< 2: no lag at constant velocity; 3: no lag at constant acceleration
  double time_constant = 0.01;  ///< s, time constant of the filter
  double settle = 0.01;         ///< s, time in which the output returns to the estimate
  double latency = 0;           ///< s, additional age of each measurement when it arrives
  double longest_age = 0.1;     ///< s, time without a measurement after which the master is lost
  double modulo = 0;            ///< u, period of the measured position; 0: it does not repeat
  /// u, greatest deviation of a measurement or of the output from the estimate; 0: velocity *
  /// longest_age
  double jump = 0;
};

/// A master of a machine: section [master.NAME] of a spec of kind "machine".
///
///     [master.line]
///     kind = "external"
///     unit = "mm"
///     velocity = 1500          # mm/s
///     acceleration = 20000     # mm/s^2
struct MachineMasterSpec {
  /// A master whose samples arrive over the network under the name of the master: from `jounce
  /// master`, or from a line that uses the protocol.
  struct External {
    TrackingSpec tracking = {};
  };
  /// An encoder that is read in every cycle: the actual position of an axis' drive, or a drive in
  /// shared memory that is only read.
  struct Encoder {
    TrackingSpec tracking = {};
    std::string axis = {};  ///< the axis of the machine whose drive is read; empty: `drive` is read
    std::optional<AxisDriveSpec::Shared> drive = {};  ///< the drive in shared memory
    double resolution = 0;                            ///< u, size of one count; 0: no quantization
    double noise = 0;                                 ///< u, rms of simulated noise; 0: none
    std::uint64_t seed = 1;                           ///< seed of the noise
  };
  /// A virtual axis with the name of the master. It plays a file when a command starts it.
  struct FromTable {
    /// A spec or a table over time; its path is relative to the machine's spec.
    std::string file = {};
    Limits limits = {};  ///< velocity and acceleration of the axis; jerk if it is given
  };

  std::string name = {};                            ///< name in the file and in the network
  std::string unit = {};                            ///< unit u of its position
  std::variant<External, Encoder, FromTable> what;  ///< source of its position
  std::string key = {};                             ///< full key for messages: "master.line"
};

}  // namespace jounce
