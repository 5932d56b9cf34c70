// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/plot/figure.hpp"

namespace jounce {

/// Throws InputError with this key for a path that names no picture: it must end in .svg or .png, or be "-".
void require_picture_name(const std::string& key, const std::string& path);

/// Writes SVG text, or its picture as PNG (by rsvg-convert) if the path ends in ".png"; "-" is SVG on standard output.
/// Throws InputError (key "path") for any other name, std::system_error if rsvg-convert is missing or fails.
void write_svg_file(const std::string& path, const std::string& svg);

/// The same for a figure.
void write_figure(const std::string& path, const Figure& figure, const SvgOptions& options = {});

}  // namespace jounce
