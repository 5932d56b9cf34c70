// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/plot/figure.hpp"

#include "cli/common/input.hpp"

namespace jounce::cli {

/// The standard figure of an input's exact curve, with its limits and its stretches in step; over a
/// paler one of `before` if there is one. Throws InputError if the two run over different axes.
Figure figure_of(const Input& input, const std::optional<Input>& before = std::nullopt);

/// All axes in one figure, distinguished by colour; limits are drawn where all have the same. Throws
/// InputError if they differ in their units.
Figure figure_of(const std::vector<Input>& axes);

/// The stretches in which the slave runs in step with the master: a constant velocity that is not
/// zero, under the name of their segment.
std::vector<Shade> in_step(const Cam& cam, const Labels& labels);

/// Throws InputError for a path, given with `option`, that names no picture: before the work that it shows.
void require_picture(const char* option, const std::string& path);

/// Writes SVG, or PNG where the path ends in ".png" (by rsvg-convert); "-" is SVG on standard output.
/// Throws InputError for any other name, std::system_error where rsvg-convert is missing or fails.
void write_picture(const std::string& path, const Figure& figure, const SvgOptions& options = {});

/// The same for a picture that is SVG already.
void write_svg(const std::string& path, const std::string& picture);

}  // namespace jounce::cli
