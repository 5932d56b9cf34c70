// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "jounce/io/points.hpp"

namespace jounce::io_detail {

/// True if the bytes are those of a zip archive, such as a workbook (.xlsx).
bool is_archive(std::string_view bytes);
/// Returns the path of the file in "cams.xlsx#Sheet"; any other path is returned unchanged.
std::string workbook_path(const std::string& path);
/// Reads the points of a workbook; see Points. `document`: its path, with "#" and the name of a
/// sheet if not the first one is meant.
Points sheet_points(std::string_view bytes, const std::string& document);

}  // namespace jounce::io_detail
