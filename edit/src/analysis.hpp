// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/report/detail/diagnostic.hpp"

#include "edit/src/json_reader.hpp"

namespace jounce::edit_detail {

/// Everything that the page shows for one text.
struct Analysis {
  FileResult result;                     ///< kind and findings, without most notes
  std::vector<std::string> charts = {};  ///< chart_data() of each axis; empty: no motion
  std::string check = {};                ///< the output of `jounce check`
  std::string cam = "null";              ///< cam_json()
  std::string edit = "null";             ///< editable_json()
  bool can_optimize = false;             ///< true: the spec leaves something free
};

/// Analyzes the text of a file of any kind. `path` is the name of the file; the files that the text
/// names are read from the disk.
Analysis analysis_of(const std::string& path, const std::string& text);

/// Adds the analysis to a JSON object.
void add_to(Json& object, const Analysis& analysis);

}  // namespace jounce::edit_detail
