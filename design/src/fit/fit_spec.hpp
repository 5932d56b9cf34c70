// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/detail/fit.hpp"

namespace jounce::design_detail {

/// Returns the text of the spec of a fitted cam. `comment`: its first lines, without "# ". `disc`:
/// its plate, for [disc].
std::string fit_spec_text(const CamSpec& spec, const Units& units, const std::string& name,
                          const std::string& comment, double table_tolerance,
                          const std::optional<DiscPart>& disc);

}  // namespace jounce::design_detail
