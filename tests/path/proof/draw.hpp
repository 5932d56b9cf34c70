// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "path/proof/case.hpp"
#include "support/random.hpp"

namespace jounce::path_proof {

using test::Random;

/// Lines in one to four axes, with settings that change, dwells, stops and reversals.
Case lines(Random& r);
/// Lines and arcs of any plane; some continue in the direction of the previous command.
Case arcs(Random& r);
/// Lines, arcs and splines, also with axes that follow the path.
Case curves(Random& r);
/// Many short lines along a curve, averaged.
Case averages(Random& r);
/// The same lines, with rounded corners that share their sides.
Case dense(Random& r);
/// Lines, short beside their coordinates, with points that nearly coincide, corners that nearly turn back or nearly go
/// straight, and corners larger than their sides.
Case narrow(Random& r);

/// Lines, arcs or averages whose commands change the limits of the axes; `only_lines`: lines.
Case limited(Random& r, bool only_lines = false);

/// Steps of an override; the last factor is 1.
std::vector<FactorRequest> steps(Random& r, double duration);

}  // namespace jounce::path_proof
