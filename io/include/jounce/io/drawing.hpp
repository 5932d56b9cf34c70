// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "jounce/cam/disc/disc_contour.hpp"

namespace jounce {

/// One curve of a drawing (DXF or SVG), such as the outline of a cam plate. y points upwards.
///
///     Outline plate = read_outline("plate.dxf#CAM");      // the curve on the layer CAM
///     plate.closed; plate.pieces;                          // lines and arcs
///
/// **DXF** (ASCII): LINE, ARC, CIRCLE, LWPOLYLINE and POLYLINE with bulges, ELLIPSE, SPLINE with
/// control points. Other objects without a curve (texts, dimensions, hatches, points) are ignored.
/// $INSUNITS gives the unit.
///
/// **SVG**: path with all its commands, line, polyline, polygon, rect, circle, ellipse, with
/// `transform` and `viewBox`. A width in mm, cm, in, pt or pc gives the unit. The layer of an
/// element is its id, its inkscape:label or its class, or the one of the group around it.
///
/// Lines and circular arcs are exact. Other curves (splines, ellipses) become arcs. The distance
/// between a curve and its arcs, measured at two places of each arc, is at most 1e-7 of the size of
/// the curve.
struct Outline {
  std::string document = {};  ///< name of the file
  std::string unit = {};  ///< unit of the coordinates, such as mm; "" if the file does not state it
  /// True: the piece of the last vertex leads to the first. False: the last vertex is the end.
  bool closed = false;
  Contour pieces = {};  ///< the curve; `master` of the vertices is 0
};

/// True if a path names a drawing, by its ending: "plate.dxf", "plate.svg#cam".
bool is_drawing(std::string_view path);

/// Return the curve of a file, and of the text of a file with the name `document`. The name of a
/// layer after # selects the curves of this layer. Curves whose ends meet (within 1e-5 of the size
/// of the drawing) become one. If one closed curve encloses all others, it is the outline: the
/// others are holes.
///
/// Throws InputError, with the place in the file, for a text that is not a drawing; for several
/// layers, if none is selected; for several separate curves; for three curves that meet in one
/// point; and for an object of the layer that has a curve but is not supported (a block).
Outline read_outline(const std::string& path);
Outline parse_outline(std::string_view text, const std::string& document);

}  // namespace jounce
