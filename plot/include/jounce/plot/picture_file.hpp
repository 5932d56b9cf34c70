// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/plot/figure.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {

/// Throws InputError with this key unless the path is the name of a picture: it must end in .svg or
/// .png, or be "-".
void require_picture_name(const std::string& key, const std::string& path);

/// Writes an SVG text to a file. If the path ends in ".png", converts it to PNG (by rsvg-convert);
/// for "-", writes SVG to standard output. Throws InputError (key "path") for another name, and
/// std::system_error if rsvg-convert is missing or fails.
void write_svg_file(const std::string& path, const std::string& svg);

/// Writes a figure to a file.
void write_figure(const std::string& path, const Figure& figure, const SvgOptions& options = {});

}  // namespace jounce
