// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/cam/design/design.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// The text of a cam spec with the numbers of its knots replaced by those of `cam`, and nothing
/// else changed: comments, order and layout stay, so a diff shows only the changes of the
/// optimiser. A derivative that the spec omits is added only if it is free there. `cam` has as many
/// segments as the spec.
std::string with_knots(const Spec& spec, const CamSpec& cam);

/// The same with the laws of its free shapes replaced by those of `cam`, hermite with their points:
/// a list in place of `points`, or below the law. Of the knots, only numbers in the text change.
/// The keys of the old law are removed: inflection, straight, shares.
std::string with_shapes(const Spec& spec, const CamSpec& cam);

}  // namespace jounce
