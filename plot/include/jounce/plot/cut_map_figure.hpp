// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/detail/cut_map.hpp"
#include "jounce/plot/figure.hpp"

namespace jounce {

/// Returns a figure of the greatest line speed and the cuts per minute over the cut length. It
/// shows the limit that applies, the marked lengths, and the shortest possible cut.
Figure cut_map_figure(const CutMap& map);

}  // namespace jounce
