// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>

#include "jounce/pvt/table.hpp"

namespace jounce {

/// Interpolation between two knots of a cam in a controller.
enum class KnotJoin {
  quintic,  ///< polynomial of degree 5 through position, velocity and acceleration of both knots
  lines,    ///< straight lines
  spline,   ///< cubic spline with continuous acceleration; its end conditions are not documented
  clamped_spline,  ///< cubic spline with continuous acceleration and given slopes at both ends
};

/// A text format for cams, of a controller or of another maker's tool. cam_formats() returns all
/// formats; `jounce convert`, its help and the reference list them. To add a format, add one
/// source, and one row in `controllers/src/exchange/formats.cpp`.
struct CamFormat {
  const char* name;    ///< word of the command line: "codesys"
  const char* maker;   ///< controller or tool, and its data type or file
  const char* knot;    ///< content of a knot in the file
  const char* source;  ///< manual or public file that defines the format
  /// Ending of the format's files: ".st"; "" if the ending does not identify the format.
  const char* extension;
  KnotJoin join;         ///< interpolation between the knots
  bool readable = true;  ///< true if Jounce can also read the format
  /// True if comments can hold the units, the policy outside, the number of knots and the hash.
  bool keeps_notes = false;
  bool states_period = false;  ///< true if the file states whether the cam repeats
  bool single = false;         ///< true if numbers are REAL: 24 bits of precision
  std::size_t fewest = 2;      ///< least number of knots
  std::size_t most = std::numeric_limits<std::size_t>::max();  ///< greatest number of knots
  const char* limits_from = "";  ///< reason for `fewest` or `most`: "nElements is an INT"
};

/// Returns all formats, in the order in which cam_format_of_text() tries them.
std::span<const CamFormat* const> cam_formats();

/// Returns the format with this name; null if no format has the name.
const CamFormat* cam_format_named(const std::string& word);
/// Returns the format of a path by its ending, in any letter case; null if no format has the
/// ending.
const CamFormat* cam_format_of_path(const std::string& path);
/// Returns the format of the content of a file; null if it is none of these formats. A spec, and a
/// table of Jounce in CSV or JSON (is_table()), are none of these formats.
const CamFormat* cam_format_of_text(const std::string& text);

/// Returns the interpolation rule of the tables that can be written in the format. Straight lines,
/// and splines without documented end conditions, need positions only (linear). A clamped spline
/// needs slopes (cubic_hermite).
Interpolation rule_of(const CamFormat& format);

}  // namespace jounce
