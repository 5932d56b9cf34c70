// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/design/input.hpp"
#include "jounce/design/law_guide.hpp"
#include "jounce/plot/figure.hpp"

namespace jounce {

/// The exact curve of an input with its limits and the zones in which a slave is in step; over a paler curve of
/// `before`, in the units of `input`. Throws InputError (key "before") if one runs over time and the other over a
/// master.
Figure figure_of(const Input& input, const std::optional<Input>& before = std::nullopt);

/// All axes in one figure, distinguished by color; a limit is drawn where all have the same. Throws InputError (key
/// "axis") if they differ in their units.
Figure figure_of(const std::vector<Input>& axes);

/// The rise of a law from 0 to 1 with its derivatives. Throws InputError (key "law") for a law whose
/// points define its shape.
Figure law_figure(Law law);

}  // namespace jounce
