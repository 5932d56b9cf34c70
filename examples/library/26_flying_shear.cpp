// SPDX-License-Identifier: Apache-2.0
// A flying shear from ten numbers: what is left out is computed, and what cannot be is named.
#include <cstdio>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/cam/coupling/master_limits.hpp"
#include "jounce/gear/flying_shear.hpp"
#include "jounce/profiles/error.hpp"

using namespace jounce;

int main() {
  // Meters and seconds: 1 m pieces at 1 m/s, 0.15 s in step.
  FlyingShear shear{.cut_length = 1, .line_speed = 1, .sync_time = 0.15};
  shear.limits = {.velocity = 2, .acceleration = 10};

  const ShearPlan plan = shear_plan(shear);
  std::printf("%.4f + %.4f + %.4f + %.4f m of the line, stroke %.4f m\n", plan.accelerate,
              plan.sync, plan.decelerate, plan.back, plan.stroke);
  const ShearBound least = least_cut_length(shear);
  const ShearBound fastest = greatest_line_speed(shear);
  std::printf("from %.4f m on (%s); up to %.4f m/s (%s)\n", least.value, least.quantity.c_str(),
              fastest.value, fastest.quantity.c_str());

  const SyncCam made = flying_shear(shear);
  const double middle = (made.zones[0].from + made.zones[0].to) / 2;
  std::printf("in step the slope is %g; cycle 1000 begins at %g\n",
              made.cam.at(middle).geo_velocity, made.cam.at(1000).position);

  // While the line itself accelerates with 0.5 m/s^2, the limits hold up to a lower speed.
  const MasterLimit live = greatest_master_velocity(made.cam, shear.limits, {.acceleration = 0.5});
  std::printf("an accelerating line: %.4f m/s (%s)\n", live.value, live.quantity.c_str());

  shear.ramp = shear.return_law = Law::poly4567;
  try {
    flying_shear(shear);
  } catch (const InputError& error) {
    std::printf("%.60s...\n", error.what());
  }
}
// > 0.1875 + 0.1500 + 0.1875 + 0.4750 m of the line, stroke 0.3375 m
// > from 0.9664 m on (return acceleration); up to 1.0198 m/s (return acceleration)
// > in step the slope is 1; cycle 1000 begins at 0
// > an accelerating line: 0.9873 m/s (acceleration)
// > cut_length = 1: must be at least 1.11386 at line_speed = 1, ...
