// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "jounce/controllers/table_target.hpp"

#include "edit/src/json_reader.hpp"

namespace jounce::edit_detail {

/// The functions read the text of a spec with the file name `path`. They throw InputError for a text
/// without a motion, and for an axis (counted from 0) that the spec does not have.

/// A table as a file, converted as by `jounce convert`.
struct Exported {
  std::string file;    ///< contents of the file; may be binary
  std::string ending;  ///< usual ending of its name: ".csv"
  std::string text;    ///< the output of `jounce convert`: knots, error, and what the file loses
  bool fits = true;    ///< false: the error exceeds its limit, so `jounce convert` writes no file
};
/// Options of `jounce convert`.
struct ExportRequest {
  std::string form = "csv";  ///< one of form_names(); "points" gets straight lines
  std::size_t axis = 0;      ///< number of the axis of the spec
  std::string over = {};     ///< "master", "time"; "": as the spec describes the motion
  TargetTexts target = {};   ///< requirements for new knots; all empty: the knots stay
};
Exported exported_table(const std::string& path, const std::string& text,
                        const ExportRequest& request);
/// Returns the page of `jounce report` for an axis.
std::string exported_report(const std::string& path, const std::string& text, std::size_t axis);

/// Adds the differences of two texts to a JSON object: "difference", the output of `jounce diff`, and
/// "charts", each with both curves. If one of the texts describes no motion, "difference" is its
/// error.
void add_difference(Json& object, const std::string& path, const std::string& before,
                    const std::string& after);

}  // namespace jounce::edit_detail
