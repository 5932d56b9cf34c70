// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/spec/detail/drawn_cam.hpp"
#include "jounce/spec/detail/toml_reader.hpp"

namespace jounce::spec_detail {

/// Reads the points of a segment whose key `points` names a drawing, with its table `drawing`;
/// nullopt for any other file.
std::optional<Points> read_drawn_points(TomlReader& segment, const Units& units);

}  // namespace jounce::spec_detail
