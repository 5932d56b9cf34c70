// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/cam/design/design.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// The text of a cam spec with the numbers of its knots replaced by those of `cam`, and nothing
/// else touched: comments, order and layout stay, so that a diff shows just what the optimiser
/// changed. A derivative that the spec left out is added only if it is free there. `cam` has as
/// many segments as the spec.
std::string with_knots(const Spec& spec, const CamSpec& cam);

/// The same with the laws of its free shapes replaced by those of `cam`, hermite with their points:
/// a list in place of `points`, or below the law. Of the knots, only numbers that stand in the text
/// change. The keys of the old law are removed: inflection, straight, shares.
std::string with_shapes(const Spec& spec, const CamSpec& cam);

}  // namespace jounce
