// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "validate/src/drive/drive_model.hpp"
#include "validate/src/linear/course.hpp"

namespace jounce::validate_detail {
namespace {

/// The greatest static torque on the bodies, without motion.
double standing(const DriveModel& model) {
  double sum = 0;
  for (const Body& body : model.train()) {
    sum += std::abs(body.load);
    for (const Gravity& g : body.gravity) sum += std::abs(g.torque);
    for (const Friction& f : body.dry) sum += f.breakaway;
  }
  return sum;
}

}  // namespace

DriveScales::DriveScales(const DriveModel& model, const Scales& reference) {
  const double radians = model.radians_per_unit();
  const Jet& peak = reference.peak;
  angle = usable(radians * reference.range);
  speed = usable(radians * peak[1]);
  torque =
      usable(radians * (model.inertia() * peak[2] + model.friction() * peak[1]) + standing(model));
}

}  // namespace jounce::validate_detail
