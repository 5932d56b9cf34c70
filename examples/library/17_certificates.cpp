// SPDX-License-Identifier: Apache-2.0
// Quality of a cam: characteristic values, distance from the best possible, warnings,
// and how fast its master may run.
#include <cstdio>

#include "jounce/cam/coupling/master_limits.hpp"
#include "jounce/cam/design/certificate.hpp"
#include "jounce/cam/design/characteristics.hpp"
#include "jounce/cam/design/design.hpp"
#include "jounce/cam/design/warnings.hpp"

using namespace jounce;

int main() {
  // Up 50 mm over 120 deg, stay, down over 150 deg.
  CamSpec spec;
  spec.start = {0, 0, {}, {}};
  spec.segments = {{Law::poly345, {120, 50, {}, {}}, "rise"},
                   {Law::dwell, {210, 50, {}, {}}, "hold"},
                   {Law::modified_sine, {360, 0, {}, {}}, "return"}};
  spec.periodic = true;
  const CamDesign made = design(spec);

  for (const Rise& rise : rises(made.cam)) {
    const Characteristics c = characteristics(rise);
    std::printf("%g to %g: Cv %.6g, Ca %.6g, Cj %.6g, Cm %.6g\n", rise.cam.start(), rise.cam.end(),
                c.cv.value, c.ca.value, c.cj.value, c.cm.value);
    for (const Finding& f : certificates(rise).findings)
      if (f.rule == "bound/acceleration_for_jerk")
        std::printf("  Ca is %.1f %% above %.5g, the least for its jerk\n", 100 * f.margin,
                    f.limit);
  }
  std::printf("warnings: %zu\n", warnings(made.cam, made.origin).warnings());

  const Limits slave{.velocity = 400, .acceleration = 6000};  // mm/s, mm/s^2
  const MasterLimit steady = greatest_master_velocity(made.cam, slave);
  std::printf("master: %.6g deg/s, the slave's %s binds at %.5g deg\n", steady.value,
              steady.quantity.c_str(), steady.where);
  const MasterLimit ramp = greatest_master_acceleration(made.cam, slave, 400);
  std::printf("at 400 deg/s it may accelerate with %.6g deg/s^2 (%s, %.5g deg)\n", ramp.value,
              ramp.quantity.c_str(), ramp.where);

  // The default cam of a well-known editor: 0, 120, 240, 360 with slopes 0, 1, 1, 0.
  const Cam first({quintic(120, 0, 0, 0, 120, 1, 0)});
  for (const Finding& f : warnings(first).findings)
    std::printf("%s: %.4g instead of %g at %g\n  %s\n", f.rule.text().c_str(), f.value, f.limit,
                f.where, f.advice.c_str());
}
// > 0 to 120: Cv 1.875, Ca 5.7735, Cj 60, Cm 6.69427
// >   Ca is 21.5 % above 4.753, the least for its jerk
// > 210 to 360: Cv 1.7596, Ca 5.52796, Cj 69.4664, Cm 5.45775
// >   Ca is 19.8 % above 4.6125, the least for its jerk
// > warnings: 0
// > master: 512 deg/s, the slave's velocity binds at 60 deg
// > at 400 deg/s it may accelerate with 5718.07 deg/s^2 (acceleration, 39.453 deg)
// > warning/velocity_overshoot: 1.512 instead of 1 at 72
// >   a quintic overshoots unless the slope of the moving end * length / stroke is 5/3 to 5/2, here 1: use a length from 200 to 300, or a stroke from 48 to 72
