// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/path/plan.hpp"

#include "path/src/geometry/route.hpp"
#include "path/src/timing/stations.hpp"

namespace jounce {

/// Directions (one number for each axis) and boxes of the lines of a route; the entries of other
/// pieces are empty.
struct Lines {
  std::vector<double> directions;
  std::vector<Box> boxes;
};
Lines lines_of(const Route& route, const Program& program, const Rates& rates);

/// A route with its corners rounded, and the limits for its timing law.
struct Rounded {
  std::optional<Path> path;  ///< nullopt: no corner is rounded, so the path of the route applies
  std::vector<Unit> units;
  std::vector<JointMark> joints;
};

/// Rounds the corners. `stop`: junctions at which the plan rests although their corners could be
/// rounded.
Rounded rounded(const Route& route, const Lines& lines, const Program& program, const Rates& rates,
                const std::vector<bool>& stop);

/// Receives the units of a route one after another.
class UnitSink {
 public:
  virtual void add(const Unit& unit) = 0;

 protected:
  ~UnitSink() = default;
};

/// Sends the units of a motion that rests at each corner. No corner is rounded, so the path of the
/// route applies.
void send_stopping_units(const Route& route, const Lines& lines, const Program& program,
                         const Rates& rates, UnitSink& to);

}  // namespace jounce
