// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "jounce/optimize/shape.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// The greatest magnitude of a figure of the load, with its sign and place.
struct LoadPeak {
  double value = 0;
  double where = 0;         ///< master position
  std::size_t segment = 0;  ///< index in the cam
};

/// Returns the peak of a figure of the load (TorqueOf, PowerOf). `tolerance`: greatest error with
/// the sine of a lever; 0: 1e-8 of the peak.
LoadPeak load_peak(const ShapeFigure& figure, const Cam& cam, double tolerance);
/// Returns the rms value of a figure of the load (RmsTorqueOf).
double load_rms(const ShapeFigure& figure, const Cam& cam);

/// Compares the motor's torque, from [load] and the velocity of [master], with [load.limits].
/// Findings: `limit/load_torque` at the worst place of the curve, and `limit/load_rms_torque`. The
/// peak is exact; with the sine of a lever it is within 1e-8 of its value. The rms is a quadrature
/// with a relative error of about 1e-10. Empty if there are no limits.
Report check_load(const Spec& spec, const Cam& cam);

}  // namespace jounce
