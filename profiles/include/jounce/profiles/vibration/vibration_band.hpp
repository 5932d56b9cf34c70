// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>

#include "jounce/profiles/vibration/vibration.hpp"

namespace jounce {

/// residual_vibration() with its phase: that is its magnitude. Linear in the motion, so that of a sum
/// of motions over the same time is the sum of theirs. u.
std::complex<double> residual_phasor(const Trajectory& motion, const Mode& mode);

/// The modes that a machine may turn out to have: every frequency and damping between.
struct ModeBand {
  double low = 0;           ///< Hz, > 0
  double high = 0;          ///< Hz, >= low; equal: one frequency
  double damping_low = 0;   ///< D, a ratio
  double damping_high = 0;  ///< >= damping_low, < 1
};

/// The mode of a band that is left swinging most.
struct WorstMode {
  double residual = 0;  ///< residual_vibration(motion, mode), u
  Mode mode;
};

/// The worst residual_vibration() over a band.
///
///     const WorstMode worst = worst_residual(move, {.low = 14.5, .high = 19.5, .damping_high = 0.05});
///
/// Not sampled: no mode of the band leaves more than the answer and `tolerance` of the motion's
/// travel (the sum of all its ways) on top. The search runs round the edge of the band, since
/// nowhere inside can be worse (see vibration_band.cpp). Throws InputError for a band or
/// tolerance out of range.
WorstMode worst_residual(const Trajectory& motion, const ModeBand& band, double tolerance = 1e-6);

}  // namespace jounce
