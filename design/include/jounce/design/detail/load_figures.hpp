// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/spec/spec.hpp"

namespace jounce {

/// A figure of the motor that moves a cam's slave.
struct LoadFigure {
  std::string name = {};             ///< "peak torque", ...
  double value = 0;                  ///< magnitude, in `unit`
  std::string unit = {};             ///< "N m" or "W"
  std::optional<double> where = {};  ///< master position of a peak
};

/// Returns the torque, power and heating of the motor, from [load] and the velocity of [master]
/// (docs/optimize/cams.md, equations (4) to (6) and (9)): "peak torque", "rms torque", "peak power"
/// (not with friction or a lever), "motor heating" (if winding_loss is given). Empty for a spec
/// without [load] or [master]. The peak of the torque is exact; with the sine of a lever it is
/// within 1e-8 of its value. The peak of the power is within 1e-9. The rms is a quadrature with a
/// relative error of about 1e-10.
std::vector<LoadFigure> load_figures(const Spec& spec, const Cam& cam);

/// The motor's torque and mechanical power over the master.
struct LoadCurves {
  Cam torque;  ///< N m, without friction and the sine of a lever
  /// W; nullopt with friction or a lever, or if a segment has sines or a high degree: their product
  /// is no segment.
  std::optional<Cam> power = {};
};

/// Returns the exact curves of the load; nullopt for a spec without [load] or [master].
std::optional<LoadCurves> load_curves(const Spec& spec, const Cam& cam);

}  // namespace jounce
