// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "controllers/src/exchange/structured_text.hpp"

namespace jounce::controllers_detail {

/// A structure of Structured Text (IEC 61131-3) or SCL; an array of it is a cam. Names are compared
/// without regard to case.
struct KnotType {
  std::string_view name;                   ///< name without its library
  std::array<std::string_view, 4> fields;  ///< x, p, v, a; empty for a field that it does not have
  std::vector<std::string_view> others = {};  ///< further fields; their values are not converted
};

/// One element of such an array.
struct Knot {
  std::array<double, 4> values{};  ///< x, p, v, a; 0 if not given, as the language defines
  std::array<bool, 4> given{};     ///< true for the values that the file gives
  /// Values of the further fields, by the names in KnotType.
  std::map<std::string, std::string> others;
  int line = 0;  ///< its line in the file
};

/// One such array.
struct KnotArray {
  std::string name;    ///< name of its variable
  std::size_t at = 0;  ///< offset of its end in the text
  std::vector<Knot> knots = {};
};

/// Returns all arrays of this type, in the order of the file. Two forms are read. Arrays with
/// initial values:
///
///     Cam_A : ARRAY[0..1] OF SMC_CAMXYVA := [(dX := 0, dY := 0), (dX := 360, dY := 40)];
///
/// Arrays whose elements are assigned one by one. The index is a number or a variable with a
/// constant value:
///
///     points[1].leadingValue := 0.0;    i := 2;  points[i].leadingValue := 120.0;
///
/// Throws InputError for a field that the type does not have, for a missing element, and if the
/// number of elements does not match the declared range.
std::vector<KnotArray> knot_arrays(const std::string& text, const KnotType& type,
                                   const Place& place);

/// Returns the knots as a cam. It has the columns v and a only if `type` has these fields.
Exchanged cam_of_knots(const KnotArray& array, const KnotType& type, Interpolation rule);

/// Returns the initial values, with one line `    (dX := 0.0, ...),` for each knot.
std::string knots_text(const Columns& columns, const KnotType& type);

/// Returns the value of a further field in lower case; "" if it is not given.
std::string word_of(const Knot& knot, const char* field);

/// True if the quintic through both knots is the straight line between them, except for digits of
/// the slope that a program leaves out.
bool is_line(const Knot& from, const Knot& to);

/// Returns a REAL or LREAL literal of IEC 61131-3, which has a decimal point.
std::string real_literal(double value);

/// Returns the name without libraries, lists and enumerations, which precede its last point.
std::string unqualified(const std::string& name);

/// True if the text has `OF type`, as the declaration of an array has it. `type`: in lower case.
bool declares_array(const std::string& text, std::string_view type);

}  // namespace jounce::controllers_detail
