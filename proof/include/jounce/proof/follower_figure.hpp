// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "jounce/design/input.hpp"
#include "jounce/plot/figure.hpp"
#include "jounce/validate/follower.hpp"

namespace jounce {

/// The input's table as lift of the [follower] of its spec. Throws InputError for an input without one.
FollowerResult followed(const Input& input, std::size_t samples = 0);

/// Lift of cam and mass, and the contact force with its limits. Flights of the follower are shaded.
Figure follower_figure(const FollowerResult& run, const FollowerSpec& spec,
                       const std::string& unit);

/// The same of an input, with its name. Throws InputError like followed().
Figure follower_figure(const Input& input);

}  // namespace jounce
