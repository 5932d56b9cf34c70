// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/profiles/vibration/vibration_band.hpp"

namespace jounce::optimizer {

/// Returns the local peaks of the residual that a motion leaves in the modes of a band, each exact to rounding,
/// and the ends of the sides of the band. All peaks lie on the edge of the band
/// (profiles/src/vibration/vibration_band.cpp). worst_residual() proves its result to a share of the travel.
/// For a motion whose residual is a millionth of the travel, that does not determine the place of a peak.
///
/// Each side is sampled at 25 places for each lobe of the spectrum, and each peak of the samples is refined.
/// Peaks that are closer together than two samples count as one.
std::vector<WorstMode> band_peaks(const Trajectory& motion, const ModeBand& band);

}  // namespace jounce::optimizer
