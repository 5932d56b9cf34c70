// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "jounce/design/input.hpp"
#include "jounce/plot/figure.hpp"
#include "jounce/validate/follower.hpp"

namespace jounce {

/// Simulates the [follower] of a spec, with the table of the input as the lift. `samples` is the
/// number of equally spaced samples; 0: none. Throws InputError for an input without a [follower].
FollowerResult followed(const Input& input, std::size_t samples = 0);

/// Returns the lift of the cam and of the mass, and the contact force with its limits. Times
/// without contact are shaded. `unit`: unit of the position.
Figure follower_figure(const FollowerResult& run, const FollowerSpec& spec,
                       const std::string& unit);

/// Returns the figure of the follower of an input, with the input's name. Throws InputError like
/// followed().
Figure follower_figure(const Input& input);

}  // namespace jounce
