// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/design/detail/law_guide.hpp"
#include "jounce/design/input.hpp"
#include "jounce/plot/figure.hpp"

namespace jounce {

/// Returns the exact curve of an input with its limits and sync zones. If `before` is given, its
/// curve is drawn behind, in a pale color. Units are the units of `input`. Throws InputError (key
/// "before") if one of the inputs is over time and the other over a master.
Figure figure_of(const Input& input, const std::optional<Input>& before = std::nullopt);

/// Returns all axes in one figure, in different colors. A limit is drawn if it is equal for all
/// axes. Throws InputError (key "axis") if their units differ.
Figure figure_of(const std::vector<Input>& axes);

/// Returns the rise of a law from 0 to 1 with its derivatives. Throws InputError (key "law") for a
/// law through points, which has no shape of its own.
Figure law_figure(Law law);

}  // namespace jounce
