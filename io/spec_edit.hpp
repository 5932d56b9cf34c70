#pragma once

#include <string>

#include "jounce/cam/design.hpp"
#include "jounce/io/spec.hpp"

namespace jounce {

/// The text of a cam spec with the numbers of its knots replaced by those of `cam`, and nothing
/// else touched: comments, order and layout stay, so that a diff shows just what the optimiser
/// changed. A derivative that the spec left out is added only if it is free there. `cam` has as
/// many segments as the spec.
std::string with_knots(const Spec& spec, const CamSpec& cam);

}  // namespace jounce
