// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cam/src/fit/refine.hpp"

namespace jounce::cam_detail {

/// Greatest number of decimals of a rounded value, from the first one of its scale.
inline constexpr int most_decimals = 12;
/// Decimal of the leading digit of a number: 0 for 5, -2 for 360.
int first_decimal(double scale);
/// Returns a value with this number of decimals; negative: a multiple of a power of 10.
double with_decimals(double value, int decimals);
/// True if rounded values stay within the tolerances, and hardly increase the rms distance.
bool is_as_good(const Deviation& after, const Deviation& before);

/// Rounds the parameters to as few decimals as the points permit: the cam stays within the
/// tolerances, and its rms distance hardly increases.
void round_values(CamSpec& spec, const std::vector<Parameter>& parameters,
                  const MeasuredCam& measured);

}  // namespace jounce::cam_detail
