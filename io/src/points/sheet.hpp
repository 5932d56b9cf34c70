// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "jounce/io/points.hpp"

namespace jounce::io_detail {

/// True if the bytes are a zip archive, such as a workbook (.xlsx).
bool is_archive(std::string_view bytes);
/// Returns the path of the file in "cams.xlsx#Sheet"; any other path is returned unchanged.
std::string workbook_path(const std::string& path);
/// Reads the points of a workbook; see Points. `document`: its path, followed by "#" and the name
/// of a sheet; without a name, the first sheet that is not empty.
Points sheet_points(std::string_view bytes, const std::string& document);

}  // namespace jounce::io_detail
