// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/plot/input_figure.hpp"
#include "jounce/plot/picture_file.hpp"

namespace jounce::cli {

/// Calls require_picture_name() for the path of an option. Call it before long work.
void require_picture(const char* option, const std::string& path);

/// Calls write_figure(); errors name --output.
void write_picture(const std::string& path, const Figure& figure, const SvgOptions& options = {});

/// The same for a picture that is SVG already.
void write_svg(const std::string& path, const std::string& picture);

}  // namespace jounce::cli
