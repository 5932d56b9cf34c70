#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/plot/figure.hpp"

#include "input.hpp"

namespace jounce::cli {

/// The standard figure of an input's exact curve, with its limits and its stretches in step; over a
/// paler one of `before` if there is one. Throws InputError if the two run over different axes.
Figure figure_of(const Input& input, const std::optional<Input>& before = std::nullopt);

/// All axes in one figure, told apart by colour; limits are drawn where all have the same. Throws
/// InputError if they differ in their units.
Figure figure_of(const std::vector<Input>& axes);

/// SVG as PNG, by rsvg-convert. Throws std::runtime_error where that is not installed or fails.
void write_png(const std::string& path, const std::string& svg);

}  // namespace jounce::cli
