// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>

#include "jounce/pvt/table.hpp"

namespace jounce {

/// Curve of a controller between two knots of its cam.
enum class KnotJoin {
  quintic,         ///< polynomial of degree 5 through position, velocity, acceleration of both
  lines,           ///< straight lines
  spline,          ///< C2 cubic spline whose ends are not documented
  clamped_spline,  ///< C2 cubic spline with given slopes at both ends
};

/// A text format for cams of a controller or a tool of another maker. `cam_formats()` lists all: `convert`, its help
/// and the reference iterate over it. A new format is one source and one row in `src/exchange/formats.cpp`.
struct CamFormat {
  const char* name;       ///< word of the command line: "codesys"
  const char* maker;      ///< controller or tool, and the data type or file
  const char* knot;       ///< a knot in the file
  const char* source;     ///< manual or public file that defines it
  const char* extension;  ///< ".st", or "" if the path does not determine the format
  KnotJoin join;
  bool readable = true;
  bool keeps_notes = false;    ///< comments hold units, policy outside, number of knots and hash
  bool states_period = false;  ///< the file states whether the cam repeats
  bool single = false;         ///< numbers are REAL, of 24 bits
  std::size_t fewest = 2;      ///< knots
  std::size_t most = std::numeric_limits<std::size_t>::max();
  const char* limits_from = "";  ///< origin of `fewest` or `most`: "nElements is an INT"
};

/// All formats, in the order of their detection.
std::span<const CamFormat* const> cam_formats();

/// Finds a format by its name, by the end of a path (in any letter case), or by the content of a
/// file; null for any other. A spec, or a table of Jounce in CSV or JSON (see is_table), is in none
/// of these formats.
const CamFormat* cam_format_named(const std::string& word);
const CamFormat* cam_format_of_path(const std::string& path);
const CamFormat* cam_format_of_text(const std::string& text);

/// Content of the knots of the format: the rule that a table needs to be written in it. Lines and undocumented splines
/// need positions only (linear), a clamped spline needs its slopes (cubic_hermite).
Interpolation rule_of(const CamFormat& format);

}  // namespace jounce
