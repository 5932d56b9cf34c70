// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
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

/// The shape of the path at a junction of a route.
struct CornerShape {
  enum class How : std::uint8_t {
    through,  ///< not rounded, and passed without a stop
    rest,     ///< not rounded: the motion rests
    turn,
    blend
  };

  double trim = 0;
  double wanted = 0;  ///< trim if there were no corners at the other ends of its sides
  double share = 0;   ///< share b of a turn
  double velocity = PathSettings::none;
  How how = How::through;
  JunctionNote note = JunctionNote::none;

  [[nodiscard]] bool is_round() const { return how == How::turn || how == How::blend; }
};

/// Chooses the shape of each junction. `stop`: junctions at which the plan rests although their
/// corners could be rounded; they get the note `note_of_stop`.
std::vector<CornerShape> shapes_of(const Route& route, const Lines& lines, const Program& program,
                                   const Rates& rates, const std::vector<bool>& stop,
                                   JunctionNote note_of_stop);

/// A route with its corners rounded, and the limits for its timing law.
struct Rounded {
  std::optional<Path> path;  ///< nullopt: no corner is rounded, so the path of the route applies
  std::vector<Unit> units;
  std::vector<JunctionMark> junctions;
};

/// Rounds the corners.
Rounded rounded(const Route& route, const Lines& lines, const Program& program, const Rates& rates,
                std::span<const CornerShape> shapes);

/// Receives the units of a route one after another.
class UnitSink {
 public:
  virtual void add(const Unit& unit) = 0;

 protected:
  ~UnitSink() = default;
};

/// Sends the units of a motion that rests at each corner, with the same shapes. No corner is
/// rounded, so the path of the route applies.
void send_stopping_units(const Route& route, const Lines& lines, const Program& program,
                         const Rates& rates, std::span<const CornerShape> shapes, UnitSink& to);

}  // namespace jounce
