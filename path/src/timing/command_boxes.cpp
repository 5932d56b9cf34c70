// SPDX-License-Identifier: Apache-2.0
#include "path/src/timing/command_boxes.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "path/src/timing/not_limited.hpp"

namespace jounce {

using path_detail::unlimited;

CommandBoxes::CommandBoxes(const Path& path, const Rates& rates, const Program& program)
    : path_(path), rates_(rates), program_(program), limited_(limit_axes(program.settings())) {}

bool CommandBoxes::applies_to(const Unit& unit) const {
  const PathPiece& piece = path_.pieces()[unit.piece];
  const auto settings = program_.settings();
  return !settings[piece.settings].axes.empty() ||
         (unit.box.constant && !settings[piece.settings_before].axes.empty());
}

double CommandBoxes::corner_velocity(std::size_t piece) const {
  const PathPiece& corner = path_.pieces()[piece];
  const Rates rates = rates_on(rates_, corner, program_.settings(), true);
  return velocity_with(corner.kind == PieceKind::turn ? rates : reserved(rates),
                       derivatives_of(path_, piece, rates_.path_axes), 0, 0);
}

Box CommandBoxes::line(const Unit& unit) const {
  const PathPiece& piece = path_.pieces()[unit.piece];
  const PathSettings& settings = program_.settings()[piece.settings];
  Point direction{};
  for (std::size_t i = 0; i < rates_.axes; ++i)
    direction[i] = path_.numbers(unit.piece)[rates_.axes + i] / piece.length;
  Box box =
      line_box(rates_on(rates_, piece, program_.settings(), false), settings, direction.data());
  // The box of a line between two directions that differ by rounding was reduced by a share.
  const Box whole = line_box(rates_, settings, direction.data());
  const double share = std::min(1.0, unit.box.acceleration / whole.acceleration);
  for (double* limit : {&box.acceleration, &box.deceleration, &box.jerk}) *limit *= share;
  return box;
}

std::vector<Unit> CommandBoxes::lowered(std::vector<Unit> units) const {
  for (Unit& unit : units)
    if (unit.box.constant && applies_to(unit))
      unit.box.velocity = std::min(unit.box.velocity, corner_velocity(unit.piece));
  const auto at_corner = [](const Unit& unit) {
    return unit.box.constant ? unit.box.velocity : unlimited;
  };
  std::vector<Unit> out;
  out.reserve(units.size());
  for (std::size_t k = 0; k < units.size(); ++k) {
    Unit unit = units[k];
    const PathPiece& piece = path_.pieces()[unit.piece];
    if (unit.box.constant || !applies_to(unit)) {
      out.push_back(unit);
      continue;
    }
    rates_.require_wanted();
    const PathSettings& settings = program_.settings()[piece.settings];
    if (piece.kind == PieceKind::line) {
      unit.box = line(unit);
      out.push_back(unit);
      continue;
    }
    const Rates rates = reserved(rates_on(rates_, piece, program_.settings(), false));
    if (piece.kind != PieceKind::arc) {
      unit.box = curve_box(rates, settings, derivatives_of(path_, unit.piece, rates.path_axes),
                           20 * piece.length);
      out.push_back(unit);
      continue;
    }
    const double entry = k == 0 || !(unit.entry > 0) ? 0 : at_corner(units[k - 1]);
    while (k + 1 < units.size() && units[k + 1].piece == unit.piece) ++k;  // its zones
    const bool rests = k + 1 == units.size() || !(units[k + 1].entry > 0);
    const ArcZones zones = arc_zones(rates, settings, path_.numbers(unit.piece), piece.length,
                                     piece.length, entry, rests ? 0 : at_corner(units[k + 1]));
    for (std::size_t i = 0; i < zones.count; ++i) {
      unit.length = zones.zone[i].length;
      unit.box = zones.zone[i].box;
      out.push_back(unit);
      unit.entry = unlimited;
      unit.dwell = 0;
    }
  }
  return out;
}

}  // namespace jounce
