// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "jounce/cam/disc/disc_contour.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// The disc of a spec with [disc], in the spec's units. Throws InputError, placed in the document,
/// even if the spec has no [disc].
Disc make_disc(const Spec& spec, const Cam& cam);

/// check() of it, with the units of its findings.
Report check_disc(const Spec& spec, const Cam& cam);

/// True if the report of check_disc() excludes that the contour can be cut: the contour crosses itself, or the cutter
/// does not reach it.
bool cannot_be_cut(const Report& report);

/// Extremes of the pressure angle, deg, and the sharpest radii of the profile, in lines, each with its place.
std::string extremes_text(const Spec& spec, const Disc& disc);

/// Drawing of a disc, in mm for every unit of its spec, in its position at master 0.
struct DiscDrawing {
  std::string name;
  Contour profile;
  Contour pitch;   ///< empty if the roller has no radius
  Contour cutter;  ///< the path of the cutter's centre; empty without a cutter
  double tolerance = 0;
  double base_radius = 0;
  std::optional<double> hub_radius;
  double roller_radius = 0;
  Place roller;                ///< its centre at the cam's start
  std::optional<Place> pivot;  ///< pivot of the arm
};
DiscDrawing drawing_of(const Spec& spec, const Disc& disc);

/// DXF R12 (ASCII), in mm: closed polylines with arcs on the layers CAM, PITCH and CUTTER, circles on
/// BASE, HUB and ROLLER. Coordinates are rounded to 1e-9 mm.
std::string contour_dxf(const DiscDrawing& drawing);

/// The same as an SVG document that prints 1:1.
std::string contour_svg(const DiscDrawing& drawing);

/// The profile as points for a controller without arcs: CSV with master position (spec's unit), x,
/// y (mm); the last equals the first. Straight lines between them keep the spec's tolerance.
std::string contour_csv(const Spec& spec, const Disc& disc);

/// The drawing in the format of the ending of a path: .dxf, .svg or .csv. Throws InputError (key
/// "output") for any other.
std::string contour_file(const std::string& path, const Spec& spec, const Disc& disc);

}  // namespace jounce
