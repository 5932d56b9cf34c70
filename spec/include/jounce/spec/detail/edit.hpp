// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/cam/design/design.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// Returns the text of a cam spec with the numbers of its knots replaced by the numbers of `cam`.
/// Nothing else changes, so a diff shows only the changes of the optimizer. A derivative that the
/// spec omits is added only if it is free at that knot. Requires that `cam` has as many segments as
/// the spec.
std::string with_knots(const Spec& spec, const CamSpec& cam);

/// Like with_knots(), but also replaces the laws of free shapes by the laws of `cam`. The points of
/// a hermite law replace `points`, or are added after the law. The keys of the old law (inflection,
/// straight, shares) are removed. At the knots, only numbers that the text contains change.
std::string with_shapes(const Spec& spec, const CamSpec& cam);

}  // namespace jounce
