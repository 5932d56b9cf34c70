// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/gear/cutter.hpp"

namespace jounce::gear_detail {

/// Throws InputError if run-up, braking or return_length of the shear are too short for the changes
/// of the speed of the line. The error has the key of the length, and its least value. `cutter` is
/// the cutter of the shear.
void require_reserve(const FlyingShear& shear, const Cutter& cutter, const CutLine& line);

}  // namespace jounce::gear_detail
