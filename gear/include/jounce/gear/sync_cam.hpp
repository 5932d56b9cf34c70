// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// An interval of the master in which slave and master are in step. m is the unit of the master.
struct SyncZone {
  double from = 0;        ///< m
  double to = 0;          ///< m
  std::string name = {};  ///< name in reports and pictures: "sync", "cut", ...
};

/// The cam of a slave that works in step with its master. Gears, follow tables, knives and shears
/// return it. All functions for cams (check, table, stream, coupling, switches) accept its member
/// `cam`.
struct SyncCam {
  Cam cam;
  /// Name of each segment of the cam; empty: segments have numbers.
  std::vector<std::string> segments = {};
  std::vector<SyncZone> zones = {};  ///< in ascending order
};

}  // namespace jounce
