// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/cut_map.hpp"
#include "jounce/plot/figure.hpp"

namespace jounce {

/// Speed of the line and cuts per minute over the cut length, with the limit that binds, the marked lengths, and the
/// shortest cut.
Figure cut_map_figure(const CutMap& map);

}  // namespace jounce
