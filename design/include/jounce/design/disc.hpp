// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "jounce/cam/disc/disc_contour.hpp"
#include "jounce/design/input.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// Makes the disc of a spec with [disc], in the spec's units. Throws InputError, with the place in
/// the document, for an invalid disc, and for a spec without [disc].
Disc make_disc(const Spec& spec, const Cam& cam);

/// Returns the spec of an input that is a cam. Throws InputError for a table (key "SPEC", with the name of
/// the file), and for a spec of another kind.
const Spec& cam_with_disc(const Input& input, const std::string& file);

/// Returns check() of the disc, with the units of its findings.
Report check_disc(const Spec& spec, const Cam& cam);

/// True if the report of check_disc() shows that the disc cannot be cut: the contour crosses
/// itself, or the cutter does not reach a part of the contour.
bool cannot_be_cut(const Report& report);

/// Returns lines with the extremes of the pressure angle (deg) and the least radii of the profile,
/// each with its place.
std::string extremes_text(const Spec& spec, const Disc& disc);

/// Drawing of a disc in mm, for a cam at master 0.
struct DiscDrawing {
  std::string name = {};
  Contour profile = {};
  Contour pitch = {};                     ///< pitch curve; empty if the roller has radius 0
  Contour cutter = {};                    ///< path of the cutter's center; empty without a cutter
  double tolerance = 0;                   ///< mm, greatest distance of contours from their curves
  double base_radius = 0;                 ///< mm
  std::optional<double> hub_radius = {};  ///< mm
  double roller_radius = 0;               ///< mm
  Place roller = {};                      ///< center of the roller at the cam's start
  std::optional<Place> pivot = {};        ///< pivot of the arm, for an oscillating follower
};
/// Returns the drawing of a disc.
DiscDrawing drawing_of(const Spec& spec, const Disc& disc);

/// Returns the drawing as DXF R12 (ASCII), in mm: closed polylines with arcs on the layers CAM,
/// PITCH and CUTTER, circles on BASE, HUB and ROLLER. Coordinates are rounded to 1e-9 mm.
std::string contour_dxf(const DiscDrawing& drawing);

/// Returns the drawing as an SVG document that prints at scale 1:1.
std::string contour_svg(const DiscDrawing& drawing);

/// Returns the profile as points, for a controller without arcs. The CSV has the master position
/// (spec's unit), x and y (mm). The last point equals the first. Straight lines between the points
/// are within the tolerance of the spec.
std::string contour_csv(const Spec& spec, const Disc& disc);

/// Returns the drawing as the contents of a file; the ending of the path selects the format: .dxf,
/// .svg or .csv. Throws InputError (key "output") for any other ending.
std::string contour_file(const std::string& path, const Spec& spec, const Disc& disc);

}  // namespace jounce
