// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <functional>
#include <map>
#include <string>
#include <vector>

/// The curves of a drawing, before they are joined.
namespace jounce::io_detail {

using PlanePoint = std::complex<double>;

/// A line, or an arc with bulge = tan(angle / 4), positive counterclockwise.
struct Stroke {
  PlanePoint from, to;
  double bulge = 0;
};

/// The curves of one layer, and its first object that is not supported.
struct Layer {
  std::vector<Stroke> strokes = {};
  std::string unsupported = {};  ///< name of the object; "": none
  int line = 0;                  ///< its line in the file
};

/// A drawing. Layers are in the order of their names.
struct Layers {
  std::string unit;  ///< unit of the coordinates; "": not stated
  std::map<std::string, Layer> layers;
};

/// Read a drawing. Throw InputError with the place in the document.
Layers read_dxf(std::string_view text, const std::string& document);
Layers read_svg(std::string_view text, const std::string& document);

/// Adds a smooth curve as arcs. `at` is the curve, over a parameter from `from` to `to`.
void add_curve(std::vector<Stroke>& strokes, const std::function<PlanePoint(double)>& at,
               double from, double to);
/// Adds straight lines through the points.
void add_lines(std::vector<Stroke>& strokes, const std::vector<PlanePoint>& points, bool closed);

}  // namespace jounce::io_detail
