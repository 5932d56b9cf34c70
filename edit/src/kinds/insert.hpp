// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace jounce::edit_detail {

/// Returns the text of a spec with one more point, which is on the curve at the position x of the
/// axis x. In a cam, this is a point of a segment through points, or a knot that divides the segment.
/// Throws InputError for a position outside, one at a point, and for a kind without such points.
std::string with_point(const std::string& path, const std::string& text, double x);

/// Returns the text with one more point at a place of the plane, with a coordinate for each axis. It
/// comes before the point or the command with this number, from 1. In a path, it is the end of a
/// line; the line to the next point becomes two lines.
std::string with_plane_point(const std::string& path, const std::string& text, std::size_t before,
                             const std::vector<double>& place);

}  // namespace jounce::edit_detail
