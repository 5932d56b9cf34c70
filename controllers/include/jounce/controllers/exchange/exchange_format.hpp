// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>

#include "jounce/pvt/table.hpp"

namespace jounce {

/// Interpolation between two knots of a table in a controller.
enum class KnotJoin {
  quintic,    ///< polynomial of degree 5 through position, velocity and acceleration of both knots
  cubic,      ///< polynomial of degree 3 through position and velocity of both knots
  quadratic,  ///< polynomial of degree 2: the velocity is linear between the knots
  lines,      ///< straight lines
  spline,     ///< cubic spline with continuous acceleration; its end conditions are not documented
  clamped_spline,  ///< cubic spline with continuous acceleration and given slopes at both ends
};

/// Numbers of a column in a file.
enum class Numbers {
  of_unit,  ///< numbers in the unit of the table
  counts,   ///< counts of the controller (pulses, encoder edges); fractions of a count are possible
  whole,    ///< whole counts of the controller only
};

/// A text format for tables, of a controller or of another maker's tool. exchange_formats() returns
/// all formats; `jounce convert`, its help and the reference list them. To add a format, add one
/// source file, and one row in `controllers/src/exchange/formats.cpp`.
struct ExchangeFormat {
  const char* name;    ///< word of the command line: "codesys"
  const char* maker;   ///< controller or tool, and its data type or file
  const char* knot;    ///< contents of one knot in the file
  const char* source;  ///< manual or public file that defines the format
  /// Ending of the format's files: ".st"; "" if the ending does not identify the format.
  const char* extension;
  KnotJoin join;                 ///< interpolation between the knots
  Domain axis = Domain::master;  ///< first column: master position, or time
  const char* x_unit = "";       ///< unit of the first column in the file: "s"; "": any
  /// Units of the position in the file, separated by spaces; the first one that converts is used.
  /// "": any.
  const char* position_units = "";
  Numbers x = Numbers::of_unit;  ///< numbers of the first column
  Numbers p = Numbers::of_unit;  ///< numbers of the position and its derivatives
  /// The values of the first column are whole multiples of this step, in x_unit; 0: any values.
  double x_step = 0;
  double x_rounding = 0;  ///< size of the last digit of the first column, in x_unit; 0: all digits
  bool equal_steps = false;  ///< true if all intervals are equal
  bool readable = true;      ///< true if Jounce can also read the format
  /// True if comments can hold the units, the policy outside the table (Extrapolation), the number
  /// of knots and the hash.
  bool keeps_notes = false;
  bool keeps_units = false;    ///< true if the format defines or states the units
  bool states_period = false;  ///< true if the file states whether the cam repeats
  bool single = false;         ///< true if numbers are REAL: 24 bits of precision
  bool rests = false;          ///< true if the motion must begin and end at rest
  std::size_t fewest = 2;      ///< least number of knots
  std::size_t most = std::numeric_limits<std::size_t>::max();  ///< greatest number of knots
  double most_step =
      std::numeric_limits<double>::infinity();  ///< greatest interval, in counts of x
  const char* limits_from = "";  ///< reason for `fewest` or `most`: "nElements is an INT"
  const char* not_kept = "";     ///< sentence on other contents of a table that the file loses
};

/// Returns all formats, in the order in which exchange_format_of_text() tries them.
std::span<const ExchangeFormat* const> exchange_formats();

/// Returns the format with this name; null if no format has the name.
const ExchangeFormat* exchange_format_named(const std::string& word);
/// Returns the format of a path by its ending, in any letter case; null if no format has the
/// ending.
const ExchangeFormat* exchange_format_of_path(const std::string& path);
/// Returns the format that the content of a file has; null if it has none of these formats. If the
/// content fits several formats, the ending of `path` selects one. A spec does not have one of
/// these formats, nor does a table of Jounce in CSV or JSON (is_table() in
/// jounce/io/table_file.hpp).
const ExchangeFormat* exchange_format_of_text(const std::string& text,
                                              const std::string& path = "");

/// Returns the interpolation rule of the tables that can be written in the format. Straight lines,
/// and splines without documented end conditions, need only positions (linear). A clamped spline
/// needs slopes (cubic_hermite). Pieces of degree 2 are cubic_hermite tables, too.
Interpolation rule_of(const ExchangeFormat& format);

}  // namespace jounce
