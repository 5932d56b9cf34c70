// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// An interval of the master in which slave and master are in step, as a report or picture names it.
struct SyncZone {
  double from = 0;  ///< master unit
  double to = 0;
  std::string name = {};  ///< "sync", "cut", ...
};

/// The cam of a slave that works with its master: the result of gears, follow tables, knives and
/// shears. All functions of a cam (check, table, stream, coupling, switches) accept its `cam`.
struct SyncCam {
  Cam cam;
  std::vector<std::string> segments = {};  ///< a name for each segment of the cam; none: numbered
  std::vector<SyncZone> zones = {};
};

}  // namespace jounce
